// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "config/device_description.h"

/// Devices of our own ESI files.
namespace syncline::sample {

/// The first device of resources/esi/TYPE.xml; an empty description where the file cannot be read.
[[nodiscard]] DeviceDescription own(const std::string& type);

}  // namespace syncline::sample
