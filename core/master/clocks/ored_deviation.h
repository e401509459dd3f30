// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline {

/// 0x092C of all slaves by one BRD.
struct OredDeviation {
  std::uint32_t magnitude_ns = 0;  // wire-ored
  std::uint16_t wkc = 0;           // slaves that have the register
};

}  // namespace syncline
