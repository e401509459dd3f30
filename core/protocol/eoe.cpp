// SPDX-License-Identifier: Apache-2.0
#include "protocol/eoe.h"

#include <fmt/format.h>

#include <array>

#include "reasons/because.h"
#include "support/byte_order.h"

namespace syncline::eoe {

std::vector<std::uint8_t> encode(const Header& header) {
  const auto first = static_cast<std::uint16_t>(
      (static_cast<unsigned>(header.kind) & 0x0FU) | (header.port & 0x0FU) << 4 | (header.last_fragment ? 1U << 8 : 0) |
      (header.time_appended ? 1U << 9 : 0) | (header.time_requested ? 1U << 10 : 0));
  const auto second = static_cast<std::uint16_t>((header.fragment_no & 0x3FU) | (header.offset & 0x3FU) << 6 |
                                                 (header.frame_no & 0x0FU) << 12);
  std::vector<std::uint8_t> bytes;
  ByteWriter(bytes).u16(first).u16(header.is_response() ? header.result : second);
  return bytes;
}

Result<Header> decode(std::span<const std::uint8_t> data) {
  ByteReader reader(data);
  const auto first = reader.u16();
  const auto second = reader.u16();
  if (!reader.ok()) return fail(ErrorCode::kMalformedData, "EoE message", because("only {bytes} bytes", data.size()));
  if ((first & 0x0F) > static_cast<unsigned>(Kind::kGetFilterResponse)) {
    return fail(ErrorCode::kMalformedData, "EoE message", because("type {number} does not exist", first & 0x0F));
  }
  Header header;
  header.kind = static_cast<Kind>(first & 0x0F);
  header.port = static_cast<std::uint8_t>((first >> 4) & 0x0F);
  header.last_fragment = (first & 1U << 8) != 0;
  header.time_appended = (first & 1U << 9) != 0;
  header.time_requested = (first & 1U << 10) != 0;
  if (header.is_response()) {
    header.result = second;
    return header;
  }
  header.fragment_no = second & 0x3F;
  header.offset = static_cast<std::uint8_t>((second >> 6) & 0x3F);
  header.frame_no = static_cast<std::uint8_t>(second >> 12);
  return header;
}

bool is_ip_parameters(std::span<const std::uint8_t> data) {
  constexpr std::array<std::size_t, 6> kSizes{6, 4, 4, 4, 4, 32};
  ByteReader reader(data);
  const auto flags = reader.u32();
  if (!reader.ok() || flags == 0 || flags >= 1U << kSizes.size()) return false;
  std::size_t size = 0;
  for (unsigned i = 0; i < kSizes.size(); ++i) size += (flags >> i & 1U) != 0 ? kSizes[i] : 0;
  // Tools write all of them, whatever the flags announce.
  constexpr std::size_t kAll = 6 + 4 * 4 + 32;
  return size == reader.remaining() || reader.remaining() == kAll;
}

}  // namespace syncline::eoe
