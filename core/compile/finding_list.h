// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "compile/compile.h"

namespace syncline::compiler {

/// Appends findings about one slave (or the master, position -1); `key` is the settings key without "master." or
/// "slave.N.", "" where no setting cures it.
class FindingList {
 public:
  FindingList(std::vector<Finding>& out, int slave) : out_(out), slave_(slave) {}
  void error(const std::string& key, std::string text) { add(FindingSeverity::kError, key, std::move(text)); }
  void warning(const std::string& key, std::string text) { add(FindingSeverity::kWarning, key, std::move(text)); }
  void info(const std::string& key, std::string text) { add(FindingSeverity::kInfo, key, std::move(text)); }

 private:
  void add(FindingSeverity severity, const std::string& key, std::string text) {
    const std::string prefix = slave_ < 0 ? "master." : "slave." + std::to_string(slave_) + ".";
    out_.push_back({severity, slave_, key.empty() ? "" : prefix + key, std::move(text)});
  }

  std::vector<Finding>& out_;
  int slave_;
};

}  // namespace syncline::compiler
