// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "config/sim_config.h"
#include "support/result.h"

namespace syncline::sim {

/// Finds the device `type` (ESI Type text; empty = the only one) in an ESI file. Given by the
/// composition, because core reads no XML. `esi_path` is already relative to the scenario's folder.
using DeviceSource = std::function<Result<DeviceDescription>(const std::string& esi_path, const std::string& type)>;

/// Reads a TOML scenario. Errors are kTomlMalformed or kScenarioKey with file, line and key.
[[nodiscard]] Result<SimConfig> load_scenario(const std::string& path, const DeviceSource& devices);

}  // namespace syncline::sim
