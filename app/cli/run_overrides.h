// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "config/network_config.h"
#include "support/result.h"

namespace syncline::cli {

/// Settings for one run, "KEY=VALUE" each, of those that are not part of the frames: master.dc.*, for which dcm.* is
/// short. kUnknownKey, kBadValue.
[[nodiscard]] Status override_settings(NetworkConfig& config, std::span<const std::string> overrides);

}  // namespace syncline::cli
