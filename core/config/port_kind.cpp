// SPDX-License-Identifier: Apache-2.0
#include "config/port_kind.h"

#include "config/device_description.h"
#include "protocol/dl_status.h"

namespace syncline {

PortKind port_kind(const DeviceDescription& device, std::uint8_t port) {
  if (port >= kPortCount) return PortKind::kNone;
  if (device.physics.empty()) return port < 2 ? PortKind::kUnknown : PortKind::kNone;
  if (port >= device.physics.size()) return PortKind::kNone;
  switch (device.physics[port]) {
    case 'Y':
    case 'H':
      return PortKind::kCable;
    case 'K':
    case 'B':
      return PortKind::kEbus;
    case ' ':
    case '-':
      return PortKind::kNone;
    default:
      return PortKind::kUnknown;
  }
}

bool ports_fit(PortKind left, PortKind right) {
  if (left == PortKind::kNone || right == PortKind::kNone) return false;
  return left == right || left == PortKind::kUnknown || right == PortKind::kUnknown;
}

}  // namespace syncline
