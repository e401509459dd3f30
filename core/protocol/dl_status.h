// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace syncline {

inline constexpr unsigned kPortCount = 4;
/// Order in which a frame leaves the ports behind the processing unit (ESC data sheet I, 3.2).
inline constexpr std::array<unsigned, 4> kPortOrder{0, 3, 1, 2};

/// DL status register 0x0110.
struct DlStatus {
  std::uint16_t value = 0;
  bool operator==(const DlStatus&) const = default;
  [[nodiscard]] bool physical_link(unsigned port) const { return ((value >> (4 + port)) & 1U) != 0; }
  [[nodiscard]] bool loop_closed(unsigned port) const { return ((value >> (8 + 2 * port)) & 1U) != 0; }
  [[nodiscard]] bool communication(unsigned port) const { return ((value >> (9 + 2 * port)) & 1U) != 0; }
  /// Loop open and communication established: frames pass this port.
  [[nodiscard]] bool active(unsigned port) const { return !loop_closed(port) && communication(port); }
};

}  // namespace syncline
