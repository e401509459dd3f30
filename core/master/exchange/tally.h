// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "support/types.h"

namespace syncline {

/// Turns things that may come one by one or by the thousand into few reports: the first one is told at once, those
/// that follow soon are told together, the more seldom the longer it goes on. Each is in exactly one report.
class Tally {
 public:
  struct Report {
    Nanoseconds time = 0;  // of the first one
    std::int64_t count = 0;
    Nanoseconds largest = 0;
    std::int64_t special = 0;
  };

  void add(std::int64_t count, Nanoseconds size, Nanoseconds time, std::int64_t special = 0) {
    if (count <= 0) return;
    if (sum_.count == 0) sum_.time = time;
    sum_.count += count;
    sum_.special += special;
    sum_.largest = std::max(sum_.largest, size);
  }
  /// What is to be told now; ask often.
  std::optional<Report> due(Nanoseconds now) {
    if (told_ && now - *told_ < wait_) return std::nullopt;
    if (sum_.count == 0) {
      wait_ = kShortest;
      return std::nullopt;
    }
    wait_ = told_ && now - *told_ < 2 * wait_ ? std::min(2 * wait_, kLongest) : kShortest;
    told_ = now;
    return std::exchange(sum_, {});
  }
  /// All that is left, at the end.
  std::optional<Report> rest() { return sum_.count == 0 ? std::nullopt : std::optional(std::exchange(sum_, {})); }

 private:
  static constexpr Nanoseconds kShortest = 100 * kMillisecond, kLongest = 5 * kSecond;
  Report sum_;
  std::optional<Nanoseconds> told_;
  Nanoseconds wait_ = kShortest;
};

}  // namespace syncline
