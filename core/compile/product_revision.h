// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace syncline {
struct DeviceDescription;
}  // namespace syncline

namespace syncline::compiler {

/// The readable revision that Beckhoff's tools put beside the numbers of Beckhoff devices: "EL2008-0000-0018" from the
/// type and the low and high word of the revision. "" for other vendors, whose rule nobody knows.
[[nodiscard]] std::string product_revision(const DeviceDescription& device);

}  // namespace syncline::compiler
