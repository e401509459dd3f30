// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "support/result.h"

namespace syncline {

class Bus;
struct BusMatch;
struct FoundDevice;
struct NetworkConfig;
struct WantedDevice;

/// Who stands at each of the first `count` places of the bus. The EEPROM is read of those devices only whose
/// station address `known` does not know; the others' identity stays empty. Bus errors; a device
/// whose EEPROM cannot be read has no identity.
[[nodiscard]] Result<std::vector<FoundDevice>> survey_bus(Bus& bus, std::uint16_t count,
                                                          const std::function<bool(std::uint16_t station)>& known = {});

/// The slave as match_bus() wants it.
[[nodiscard]] WantedDevice wanted_device(const NetworkConfig& config, std::size_t slave);

/// What a match says, as errors in frame order: kSlavesSwapped, kIdentityMismatch, kSlaveMissing, kSlaveExtra.
[[nodiscard]] std::vector<Error> explain(const BusMatch& match, const NetworkConfig& config,
                                         const std::vector<FoundDevice>& found);

}  // namespace syncline
