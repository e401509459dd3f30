// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "master/bus.h"

namespace syncline {

/// What one slave's EEPROM gave.
struct SiiContent {
  std::vector<std::uint8_t> bytes;  // from word 0 to the end marker of the categories
  std::optional<Error> error;
};

/// Reads the EEPROMs of all stations at the same time (a datagram per slave, many slaves a frame) and
/// only as far as the categories go. A slave that fails has its error in its place; the result is an
/// error only when the bus fails or the scan is cancelled. `progress` is told how many are done.
[[nodiscard]] Result<std::vector<SiiContent>> read_sii(Bus& bus, std::span<const std::uint16_t> stations,
                                                       const std::function<void(std::size_t)>& progress = {});

}  // namespace syncline
