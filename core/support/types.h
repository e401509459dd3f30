// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>

namespace syncline {

/// A time or a difference of times in nanoseconds. Absolute times count from the
/// distributed-clocks epoch 2000-01-01 00:00:00 UTC (ETG.1000.4, 6.1.3 system time).
/// Signed on purpose: differences are the common case and never reach 2^63 ns (292 years).
using Nanoseconds = std::int64_t;

inline constexpr Nanoseconds kMicrosecond = 1'000;
inline constexpr Nanoseconds kMillisecond = 1'000'000;
inline constexpr Nanoseconds kSecond = 1'000'000'000;

[[nodiscard]] constexpr double to_milliseconds(Nanoseconds time) {
  return static_cast<double>(time) / static_cast<double>(kMillisecond);
}

/// Seconds between the Unix epoch and the distributed-clocks epoch.
inline constexpr std::int64_t kDcEpochUnixSeconds = 946'684'800;

/// Place of a slave in frame order, 0 = first slave behind the master.
struct Position {
  std::uint16_t value = 0;
  constexpr auto operator<=>(const Position&) const = default;

  /// Auto-increment address as the master puts it on the wire: 0, 0xFFFF, 0xFFFE ...
  [[nodiscard]] constexpr std::uint16_t auto_increment_address() const {
    return static_cast<std::uint16_t>(0U - value);
  }
};

}  // namespace syncline
