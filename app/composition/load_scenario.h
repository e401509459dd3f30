// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "support/result.h"

namespace syncline {

struct SimConfig;

/// Reads a scenario with the ESI files that it names; each ESI file is read once. Errors name the file,
/// line and key of the scenario or of the ESI. An ENI (.xml) or a project (.syncline) gives the bus that it describes.
[[nodiscard]] Result<SimConfig> load_scenario_file(const std::string& path);

/// The segment `network` of the scenario, with another seed where one is given. kBadValue when the scenario has
/// fewer networks.
[[nodiscard]] Result<SimConfig> load_network(const std::string& path, unsigned network,
                                             const std::optional<std::uint64_t>& seed);

}  // namespace syncline
