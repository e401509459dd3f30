// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline {

struct DeviceDescription;

/// What is plugged into a port.
enum class PortKind : std::uint8_t {
  kNone,     // there is no such port
  kCable,    // MII: 'Y', 'H'
  kEbus,     // LVDS between terminals: 'K', 'B'
  kUnknown,  // nobody said; fits everything
};

/// ESI Device@Physics, a letter a port (0..3 = A..D). A device that says nothing has ports A and B.
[[nodiscard]] PortKind port_kind(const DeviceDescription& device, std::uint8_t port);

/// Whether one can be plugged into the other.
[[nodiscard]] bool ports_fit(PortKind left, PortKind right);

}  // namespace syncline
