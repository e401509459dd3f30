// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "config/watched_variable.h"

namespace syncline {

struct CycleSample;
struct WatchCommand;

/// Which variables a run's samples tell, one list after the other: whoever changes what is watched adds a list, and
/// each sample says of which one it is, so that no value is ever taken for another variable's.
class WatchLists {
 public:
  /// Of all lists together, each counted once.
  static constexpr std::size_t kMostVariables = 32;

  struct List {
    std::uint32_t number = 0;         // CycleSample::watch_list; 1, 2, 3 ...
    std::vector<std::size_t> places;  // of each place which of variables() stands there
    bool operator==(const List&) const = default;
  };

  /// The next list: kMostWatched variables at most, each once. What lists before it had keeps its number; what is new
  /// comes behind. False, and nothing is added, where it is more than that or than kMostVariables in all.
  bool add(std::span<const WatchedVariable> variables);
  /// Tells the master the latest one; of none where there is none.
  [[nodiscard]] WatchCommand command() const;

  [[nodiscard]] const std::vector<WatchedVariable>& variables() const { return variables_; }
  [[nodiscard]] const std::vector<List>& lists() const { return lists_; }
  /// Those of the latest list.
  [[nodiscard]] std::vector<WatchedVariable> latest() const;
  /// Bits of a variable in this cycle, the lowest first; nothing where it was not watched or not known.
  [[nodiscard]] std::optional<std::uint64_t> bits(const CycleSample& sample, std::size_t variable) const;
  /// The same as it is drawn; not-a-number where there is none, or it is no finite one.
  [[nodiscard]] float drawn(const CycleSample& sample, std::size_t variable) const;
  /// Where a variable stands in a list, by its number; nothing where it does not.
  [[nodiscard]] std::optional<std::size_t> place(std::uint32_t list, std::size_t variable) const;

  bool operator==(const WatchLists& other) const { return variables_ == other.variables_ && lists_ == other.lists_; }

 private:
  static constexpr std::uint8_t kNowhere = 0xFF;

  std::vector<WatchedVariable> variables_;
  std::vector<List> lists_;
  std::vector<std::array<std::uint8_t, kMostVariables>> places_;  // of each list, by variable
};

}  // namespace syncline
