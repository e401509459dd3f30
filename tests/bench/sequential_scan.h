// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "master/exchange/bus.h"
#include "protocol/sii.h"

namespace syncline::bench {

/// The scan that everybody writes first: one datagram a frame, one slave at a time, the EEPROM in steps of
/// eight bytes with command, status and data in a frame each. The baseline for the real one.
[[nodiscard]] Result<std::vector<sii::Image>> sequential_scan(Bus& bus);

}  // namespace syncline::bench
