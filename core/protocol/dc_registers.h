// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

namespace syncline {

/// Speed counter start 0x0930 after reset (ESC data sheet, section II); writing it starts the loop anew.
inline constexpr std::uint16_t kSpeedCounterDefault = 0x1000;
/// Processing minus forwarding latency, ns (tDiff), of slaves nothing else is known of, where a frame leaves by a port
/// with a PHY; by E-bus (docs/distributed-clocks.md, Initialisation, says where the numbers come from).
inline constexpr std::uint32_t kUsualDelayDifference = 40;
inline constexpr std::uint32_t kEbusDelayDifference = 20;

/// SystemTimeDifference 0x092C: sign and magnitude. Bit 31 is kept raw because data sheet
/// editions disagree on its meaning; limits use the magnitude only.
struct SystemTimeDifference {
  std::uint32_t raw = 0;
  bool operator==(const SystemTimeDifference&) const = default;
  [[nodiscard]] constexpr std::uint32_t magnitude() const { return raw & 0x7FFF'FFFFU; }
  [[nodiscard]] constexpr bool sign_bit() const { return (raw >> 31) != 0; }
  /// Newer edition: bit 31 = local copy greater than or equal to the received time. Positive = slave ahead.
  [[nodiscard]] constexpr std::int64_t signed_value() const {
    return sign_bit() ? static_cast<std::int64_t>(magnitude()) : -static_cast<std::int64_t>(magnitude());
  }
  [[nodiscard]] static constexpr SystemTimeDifference from_signed(std::int64_t local_minus_received) {
    const auto magnitude =
        static_cast<std::uint32_t>(local_minus_received < 0 ? -local_minus_received : local_minus_received) &
        0x7FFF'FFFFU;
    return {magnitude | static_cast<std::uint32_t>(local_minus_received >= 0 && magnitude != 0) << 31U};
  }
};

/// AssignActivate: ESI word written to 0x0980/0x0981 (ETG.2000, Dc/OpMode).
struct AssignActivate {
  std::uint16_t value = 0;
  bool operator==(const AssignActivate&) const = default;
  [[nodiscard]] constexpr bool unit_on() const { return (value & 0x0100) != 0; }
  [[nodiscard]] constexpr bool sync0() const { return (value & 0x0200) != 0; }
  [[nodiscard]] constexpr bool sync1() const { return (value & 0x0400) != 0; }
  /// True where latch units are handed to the PDI (no "DC latch cfg" command then).
  [[nodiscard]] constexpr bool latch_to_pdi() const { return (value & 0x0030) != 0; }
};

/// Relative rate by which the time control loop slows a clock, from 0x0930 and 0x0932
/// (ESC data sheet I, 9.1.4: D / (5 (S+D+2)(S-D+2))).
[[nodiscard]] constexpr double speed_counter_rate(std::uint16_t start, std::int32_t diff) {
  const double s = start;
  const double d = diff;
  return d / (5.0 * (s + d + 2.0) * (s - d + 2.0));
}

/// Largest system time difference that a sync window of exponent n allows: 2^n - 1 ns.
/// Only such limits are exact on a wire-ored value.
[[nodiscard]] constexpr std::uint32_t sync_window_limit_ns(unsigned exponent) {
  return exponent >= 31 ? 0x7FFF'FFFFU : (1U << exponent) - 1U;
}

}  // namespace syncline
