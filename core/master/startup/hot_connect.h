// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "support/result.h"

/// Which device on the bus is the first slave of which hot-connect group. That one came or went is told by
/// EventTeller::hot_connect().
namespace syncline {

class Bus;
struct FoundDevice;
struct NetworkConfig;

/// Asks devices that a hot-connect group's first slave may be by the group's identify commands, as far as these do not
/// just compare the alias; of the devices that `known` does not know. Bus errors.
[[nodiscard]] Status identify_groups(Bus& bus, const NetworkConfig& config, std::vector<FoundDevice>& devices,
                                     const std::function<bool(std::uint16_t station)>& known = {});

}  // namespace syncline
