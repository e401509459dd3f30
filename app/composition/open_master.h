// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string_view>

#include "support/result.h"

namespace syncline {

class BackgroundMaster;
struct Project;

/// A master on the bus that `link` names (see open_link(), whose errors these are). Nothing runs yet.
[[nodiscard]] Result<std::unique_ptr<BackgroundMaster>> open_master(std::string_view link);
/// On the simulated bus that `machine` describes, on the virtual clock.
[[nodiscard]] Result<std::unique_ptr<BackgroundMaster>> open_master(const Project& machine);

}  // namespace syncline
