// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline::sii {
struct Image;
}  // namespace syncline::sii

namespace syncline {

struct DeviceDescription;

/// Project slave from the SII alone, for a device without an ESI.
[[nodiscard]] DeviceDescription device_from_sii(const sii::Image& image);

}  // namespace syncline
