// SPDX-License-Identifier: Apache-2.0
#include "config/device_description.h"

#include <fmt/format.h>

namespace syncline {

std::string to_string(const Identity& identity) {
  return fmt::format("0x{:08x}:0x{:08x}:0x{:08x}", identity.vendor_id, identity.product_code, identity.revision_no);
}

std::uint32_t Pdo::bit_length() const {
  std::uint32_t bits = 0;
  for (const PdoEntry& entry : entries) bits += entry.bit_length;
  return bits;
}

}  // namespace syncline
