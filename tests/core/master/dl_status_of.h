// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>

#include "protocol/registers.h"

namespace syncline::test {

/// What DL Status (0x0110) says of a slave with links at these ports alone: the others are closed.
inline DlStatus open_ports(std::initializer_list<unsigned> ports) {
  std::uint16_t value = 0x0001;
  for (unsigned port = 0; port < kPortCount; ++port) value |= static_cast<std::uint16_t>(1U << (8 + 2 * port));
  for (const auto port : ports) {
    value = static_cast<std::uint16_t>(value & ~(1U << (8 + 2 * port)));
    value = static_cast<std::uint16_t>(value | (1U << (9 + 2 * port)) | (1U << (4 + port)));
  }
  return {value};
}

}  // namespace syncline::test
