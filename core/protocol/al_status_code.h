// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline {

/// A slave gives up for missed SM2 events by this AL status code: 0x001A synchronisation error, 0x002C fatal, 0x0033
/// and 0x0034 DC sync errors (ETG.1020, table 11).
[[nodiscard]] constexpr bool is_about_outputs(std::uint16_t al_status_code) {
  return al_status_code == 0x001A || al_status_code == 0x002C || al_status_code == 0x0033 || al_status_code == 0x0034;
}

}  // namespace syncline
