// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline {

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

/// Largest system time difference that a sync window of exponent n allows: 2^n - 1 ns.
/// Only such limits are exact on a wire-ored value.
[[nodiscard]] constexpr std::uint32_t sync_window_limit_ns(unsigned exponent) {
  return exponent >= 31 ? 0x7FFF'FFFFU : (1U << exponent) - 1U;
}

}  // namespace syncline
