// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline {
struct SimSlaveConfig;
}  // namespace syncline

namespace syncline::sim {

class ObjectDictionary;

/// Objects that every device has: device type, name, identity, SyncManager types, what its PDOs map, and the
/// dictionary of its description.
void add_device_objects(const SimSlaveConfig& config, ObjectDictionary& dictionary);

}  // namespace syncline::sim
