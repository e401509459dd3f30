// SPDX-License-Identifier: Apache-2.0
#include "compile/product_revision.h"

#include <fmt/format.h>

#include "config/device_description.h"

namespace syncline::compiler {

std::string product_revision(const DeviceDescription& device) {
  constexpr std::uint32_t kBeckhoff = 2;
  if (device.identity.vendor_id != kBeckhoff || device.type.empty()) return {};
  // "EL7211-0010": the variant is the low word already.
  const std::string base = device.type.substr(0, device.type.find('-'));
  const std::uint32_t revision = device.identity.revision_no;
  return fmt::format("{}-{:04}-{:04}", base, revision & 0xFFFFU, revision >> 16);
}

}  // namespace syncline::compiler
