// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "findings/project_words.h"
#include "findings/sentence.h"

namespace syncline::compiler {

/// Appends findings about one slave (or the master, position -1). Words and usual setting stand in words::kProject.
class FindingList {
 public:
  template <FigureName... kNames>
  using Sentence = std::type_identity_t<FindingSentence<words::kProject, kNames...>>;

  FindingList(std::vector<Finding>& out, int slave) : out_(out), slave_(slave) {}

  template <FigureName... kNames>
  void add(Sentence<kNames...> code, Named<kNames>... figures) {
    out_.push_back(make_finding<words::kProject, kNames...>(code, slave_, std::move(figures)...));
  }
  template <FigureName... kNames>
  void add_as(Severity severity, Sentence<kNames...> code, Named<kNames>... figures) {
    add<kNames...>(code, std::move(figures)...);
    out_.back().severity = severity;
  }
  /// `key`: the setting without "master." or "slave.N.".
  template <FigureName... kNames>
  void add_at(const std::string& key, Sentence<kNames...> code, Named<kNames>... figures) {
    out_.push_back(make_finding<words::kProject, kNames...>(code, {slave_, full(key)}, std::move(figures)...));
  }
  /// One that somebody else made; "" keeps its setting.
  void take(Finding finding, const std::string& key = {}) {
    finding.place.slave = slave_;
    if (!key.empty()) finding.place.key = full(key);
    out_.push_back(std::move(finding));
  }

 private:
  [[nodiscard]] std::string full(const std::string& key) const {
    if (key.empty()) return {};
    return (slave_ < 0 ? "master." : "slave." + std::to_string(slave_) + ".") + key;
  }

  std::vector<Finding>& out_;
  int slave_;
};

}  // namespace syncline::compiler
