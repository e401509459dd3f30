// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string_view>

#include "channels/background_master.h"
#include "config/project.h"
#include "support/result.h"

namespace syncline {

/// A master on the bus that `link` names (see open_link(), whose errors these are). Nothing runs yet.
[[nodiscard]] Result<std::unique_ptr<BackgroundMaster>> open_master(std::string_view link);
/// On the simulated bus that `machine` describes, on the virtual clock.
[[nodiscard]] Result<std::unique_ptr<BackgroundMaster>> open_master(const Project& machine);

}  // namespace syncline
