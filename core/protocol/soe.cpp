// SPDX-License-Identifier: Apache-2.0
#include "protocol/soe.h"

#include <fmt/format.h>

#include "reasons/because.h"
#include "support/byte_order.h"

namespace syncline::soe {

std::vector<std::uint8_t> encode(const Header& header) {
  const auto first = (static_cast<unsigned>(header.op_code) & 0x07U) | (header.incomplete ? 0x08U : 0U) |
                     (header.error ? 0x10U : 0U) | (header.drive_no & 0x07U) << 5;
  std::vector<std::uint8_t> bytes;
  ByteWriter(bytes).u8(static_cast<std::uint8_t>(first)).u8(header.elements).u16(header.idn);
  return bytes;
}

Result<Header> decode(std::span<const std::uint8_t> data) {
  ByteReader reader(data);
  const unsigned first = reader.u8();
  Header header;
  header.elements = reader.u8();
  header.idn = reader.u16();
  if (!reader.ok()) return fail(ErrorCode::kMalformedData, "SoE message", because("only {bytes} bytes", data.size()));
  if ((first & 0x07U) == 0 || (first & 0x07U) == 7) {
    return fail(ErrorCode::kMalformedData, "SoE message", because("operation {number} does not exist", first & 0x07U));
  }
  header.op_code = static_cast<OpCode>(first & 0x07U);
  header.incomplete = (first & 0x08U) != 0;
  header.error = (first & 0x10U) != 0;
  header.drive_no = static_cast<std::uint8_t>(first >> 5);
  return header;
}

std::string idn_text(std::uint16_t idn) {
  return fmt::format("{}-{}-{:04}", (idn & 0x8000U) != 0 ? 'P' : 'S', idn >> 12 & 7U, idn & 0x0FFFU);
}

}  // namespace syncline::soe
