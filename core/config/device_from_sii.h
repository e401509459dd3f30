// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "config/device_description.h"
#include "protocol/sii.h"

namespace syncline {

/// Project slave from the SII alone, for a device without an ESI.
[[nodiscard]] DeviceDescription device_from_sii(const sii::Image& image);

}  // namespace syncline
