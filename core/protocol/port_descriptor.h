// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline {

/// What a port is, 2 bits a port in register 0x0007 (ESC data sheet II).
enum class PortDescriptor : std::uint8_t { kNone = 0, kNotConfigured = 1, kEbus = 2, kMii = 3 };

/// Of the register's value, port 0 to 3.
[[nodiscard]] constexpr PortDescriptor port_descriptor(std::uint8_t value, unsigned port) {
  return static_cast<PortDescriptor>((value >> (2 * port)) & 3U);
}
/// As a part of the register's value.
[[nodiscard]] constexpr std::uint8_t port_descriptor_bits(PortDescriptor what, unsigned port) {
  return static_cast<std::uint8_t>(static_cast<unsigned>(what) << (2 * port));
}

}  // namespace syncline
