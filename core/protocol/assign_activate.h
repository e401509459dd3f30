// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline {

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

}  // namespace syncline
