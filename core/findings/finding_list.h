// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "findings/finding.h"

namespace syncline {

/// How many findings of each severity.
class SeverityCounts {
 public:
  void add(Severity severity, std::size_t more = 1) { counts_[static_cast<std::size_t>(severity)] += more; }
  [[nodiscard]] std::size_t operator[](Severity severity) const { return counts_[static_cast<std::size_t>(severity)]; }
  [[nodiscard]] std::size_t all() const { return counts_[0] + counts_[1] + counts_[2]; }
  bool operator==(const SeverityCounts&) const = default;

 private:
  std::array<std::size_t, 3> counts_{};
};

/// Findings about a file that others wrote. A mistake that stands in each element of a large file makes a finding each,
/// and each takes a hundred times the element's bytes: so many are kept that nobody reads more, the others are counted,
/// and one finding says how many they are. One thread.
class FindingList {
 public:
  static constexpr std::string_view kRest = "ENI-XML-10";  // says how many are not listed
  static constexpr std::size_t kMostOfRule = 1000;
  static constexpr std::size_t kMostInAll = 10'000;  // the first of a rule is kept beyond it

  FindingList() = default;
  /// For what is ours, and as large as we made it.
  [[nodiscard]] static FindingList unbounded();

  /// Whether add() would keep one more of this rule: if not, nobody need put it together to leave_out() it.
  [[nodiscard]] bool has_room(std::string_view code) const;
  void add(Finding finding);
  void leave_out(const FindingWords& words, std::size_t count = 1) { left_out_.add(words.severity, count); }

  [[nodiscard]] const std::vector<Finding>& kept() const { return kept_; }
  [[nodiscard]] Finding& last() { return kept_.back(); }
  [[nodiscard]] Finding& operator[](std::size_t index) { return kept_[index]; }
  [[nodiscard]] const SeverityCounts& left_out() const { return left_out_; }

  /// What was kept; the list is empty then but for its counts.
  [[nodiscard]] std::vector<Finding> take_kept();
  /// kRest with the worst severity of those that were left out; nothing where none was.
  [[nodiscard]] std::optional<Finding> rest() const;

 private:
  std::size_t most_of_rule_ = kMostOfRule, most_in_all_ = kMostInAll;
  std::vector<Finding> kept_;
  std::map<std::string_view, std::size_t> of_rule_;  // kept ones
  SeverityCounts left_out_;
};

}  // namespace syncline
