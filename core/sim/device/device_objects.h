// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "config/sim_config.h"
#include "sim/objects/object_dictionary.h"

namespace syncline::sim {

/// Objects that every device has: device type, name, identity, SyncManager types, what its PDOs map, and the
/// dictionary of its description.
void add_device_objects(const SimSlaveConfig& config, ObjectDictionary& dictionary);

}  // namespace syncline::sim
