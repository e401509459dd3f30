// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "config/network_config.h"
#include "support/result.h"

namespace syncline {

/// Settings of the distributed clocks that cannot work, found before anything is sent: kBadValue with the setting's key,
/// its value and the range, or with the reference clock that cannot be one.
[[nodiscard]] Status check_dc(const NetworkConfig& config);

}  // namespace syncline
