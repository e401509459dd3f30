// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "support/types.h"

namespace syncline {
struct PortErrors;
}  // namespace syncline

namespace syncline::ui {

/// Totals over the last seconds, for how fast they grow.
class CountHistory {
 public:
  static constexpr Nanoseconds kSpan = 10 * kSecond;

  void clear() { kept_.clear(); }
  /// As many numbers each time, in the same order.
  void add(Nanoseconds time, std::vector<std::uint32_t> totals);
  /// How much number `n` has grown in the last kSpan, or since the first was added.
  [[nodiscard]] std::uint32_t growth(std::size_t n) const;

 private:
  struct Kept {
    Nanoseconds time = 0;
    std::vector<std::uint32_t> totals;
  };
  std::deque<Kept> kept_;
};

/// Counters of a port, in the order of portTotals().
inline constexpr std::size_t kCountersOfPort = 4;
/// Invalid frames, receive errors, forwarded errors, lost links of port A, then of B ...
[[nodiscard]] std::vector<std::uint32_t> portTotals(const std::array<PortErrors, 4>& ports);

/// "2.4 s ago".
[[nodiscard]] QString agoText(Nanoseconds age);

/// "12", "at least 255", with "+3 in 10 s" behind it where it grows.
[[nodiscard]] QString growingText(std::uint32_t total, bool at_least, std::uint32_t growth);

}  // namespace syncline::ui
