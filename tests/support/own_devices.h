// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "config/device_description.h"

/// The devices of resources/esi, without reading a file: tests of rooms that know no XML use them. tests/eni holds them
/// against the files.
namespace syncline::sample {

[[nodiscard]] std::vector<DeviceDescription> own_devices();
/// The one with that ESI Type, e.g. "SL-SV7"; an empty description where there is none.
[[nodiscard]] DeviceDescription own(const std::string& type);

}  // namespace syncline::sample
