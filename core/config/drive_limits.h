// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "config/device_description.h"
#include "support/types.h"

namespace syncline {

/// What a device accepts beyond its ESI's SyncManagers and operation modes: known families of drives (their manuals), and
/// the object dictionary. Empty: nothing is known.
struct DeviceLimits {
  std::optional<unsigned> objects_per_direction;   // PDO entries, padding not counted
  std::optional<Nanoseconds> cycle_step;           // the cycle is a multiple of this
  std::optional<Nanoseconds> shortest_cycle, longest_cycle;
  std::string family;                              // whose manual says so; "" = the object dictionary
};
[[nodiscard]] DeviceLimits device_limits(const DeviceDescription& device);

}  // namespace syncline
