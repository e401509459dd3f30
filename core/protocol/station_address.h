// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace syncline {

/// Configured station address (register 0x0010) of the first slave, as ET9000, TwinCAT and EC-Engineer count.
inline constexpr std::uint16_t kFirstStationAddress = 1001;

/// Which a slave gets that has none: by its position, 0 the first slave behind the master.
[[nodiscard]] constexpr std::uint16_t usual_station_address(std::size_t position) {
  return static_cast<std::uint16_t>(kFirstStationAddress + position);
}

}  // namespace syncline
