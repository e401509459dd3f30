// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "config/dc_description.h"
#include "config/dc_settings.h"
#include "config/device_description.h"

namespace syncline {
struct SlaveConfig;
}  // namespace syncline

namespace syncline::recover {

/// Name of the operation mode that is made from an ENI.
inline constexpr const char* kOpMode = "DC";

/// The one operation mode that can be seen; nothing when the slave has no DC line.
[[nodiscard]] std::optional<DcDescription> recovered_dc(const SlaveConfig& slave, Nanoseconds bus_cycle);

/// Operation mode of the device and the user's times with which compile() sets what the ENI sets. `exact` is false when
/// no mode of the device has the ENI's AssignActivate: then DC is off in the settings.
struct DcChoice {
  DcSlaveSettings settings;
  bool exact = true;
};
[[nodiscard]] DcChoice recovered_dc_settings(const SlaveConfig& slave, const DeviceDescription& device,
                                             Nanoseconds bus_cycle);

}  // namespace syncline::recover
