// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/result.h"
#include "support/types.h"

/// Numbers of a configuration, also of one that came from a file, against the ranges of the table of settings.
namespace syncline {

struct DcmSettings;
struct NetworkConfig;

/// Settings of the distributed clocks that cannot work, found before anything is sent: kBadValue with the setting's
/// key, its value and the range, or with the reference clock that cannot be one. Those of the DCM:
/// check_dcm_settings().
[[nodiscard]] Status check_dc(const NetworkConfig& config);

/// kBadValue when a parameter is outside its range. The error names parameter, value and range.
[[nodiscard]] Status check_dcm_settings(const DcmSettings& settings, Nanoseconds cycle_time);

}  // namespace syncline
