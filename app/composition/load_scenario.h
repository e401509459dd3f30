// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "config/sim_config.h"
#include "support/result.h"

namespace syncline {

/// Reads a scenario with the ESI files that it names; each ESI file is read once. Errors name the file,
/// line and key of the scenario or of the ESI.
[[nodiscard]] Result<SimConfig> load_scenario_file(const std::string& path);

}  // namespace syncline
