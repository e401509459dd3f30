// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "support/byte_order.h"
#include "support/result.h"

/// Vendor specific protocol over EtherCAT: only whose it is can be known.
namespace syncline::voe {

struct Header {
  std::uint32_t vendor_id = 0;
  std::uint16_t vendor_type = 0;
  bool operator==(const Header&) const = default;
};

/// kMalformedData when shorter than the header.
[[nodiscard]] inline Result<Header> decode(std::span<const std::uint8_t> data) {
  ByteReader reader(data);
  Header header;
  header.vendor_id = reader.u32();
  header.vendor_type = reader.u16();
  if (!reader.ok()) return fail(ErrorCode::kMalformedData, "VoE message");
  return header;
}

}  // namespace syncline::voe
