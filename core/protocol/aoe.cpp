// SPDX-License-Identifier: Apache-2.0
#include "protocol/aoe.h"

#include <fmt/format.h>

#include "reasons/because.h"
#include "support/byte_order.h"

namespace syncline::aoe {
namespace {

Address read_address(ByteReader& reader) {
  Address address;
  for (auto& byte : address.net_id) byte = reader.u8();
  address.port = reader.u16();
  return address;
}

void write_address(ByteWriter& writer, const Address& address) {
  for (const auto byte : address.net_id) writer.u8(byte);
  writer.u16(address.port);
}

}  // namespace

std::vector<std::uint8_t> encode(const Header& header) {
  std::vector<std::uint8_t> bytes;
  ByteWriter writer(bytes);
  write_address(writer, header.target);
  write_address(writer, header.source);
  writer.u16(header.command).u16(header.state_flags).u32(header.length).u32(header.error_code).u32(header.invoke_id);
  return bytes;
}

Result<Header> decode(std::span<const std::uint8_t> data) {
  ByteReader reader(data);
  Header header;
  header.target = read_address(reader);
  header.source = read_address(reader);
  header.command = reader.u16();
  header.state_flags = reader.u16();
  header.length = reader.u32();
  header.error_code = reader.u32();
  header.invoke_id = reader.u32();
  if (!reader.ok()) return fail(ErrorCode::kMalformedData, "AoE message", because("only {bytes} bytes", data.size()));
  return header;
}

}  // namespace syncline::aoe
