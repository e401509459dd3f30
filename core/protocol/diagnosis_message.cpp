// SPDX-License-Identifier: Apache-2.0
#include "protocol/diagnosis_message.h"

#include <fmt/format.h>

#include "reasons/because.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr std::uint16_t kTypeMask = 0x000F;

/// Bytes of a parameter: a basic data type tells its own size, all else its flags.
std::size_t parameter_size(std::uint16_t flags) {
  const auto low = static_cast<std::uint16_t>(flags & 0x0FFF);
  if ((flags >> 12) != 0) return low;
  switch (low) {  // ETG.1020, table of data types
    case 0x0001:
    case 0x0002:
    case 0x0005:
    case 0x001E:
      return 1;
    case 0x0003:
    case 0x0006:
    case 0x001F:
      return 2;
    case 0x0010:
    case 0x0016:
      return 3;
    case 0x0004:
    case 0x0007:
    case 0x0008:
    case 0x0020:
      return 4;
    case 0x0012:
    case 0x0018:
      return 5;
    case 0x0013:
    case 0x0019:
      return 6;
    case 0x0014:
    case 0x001A:
      return 7;
    case 0x0011:
    case 0x0015:
    case 0x001B:
    case 0x0021:
      return 8;
    default:
      return 0;
  }
}

}  // namespace

std::vector<std::uint8_t> DiagnosisMessage::encode() const {
  std::vector<std::uint8_t> bytes;
  ByteWriter out(bytes);
  const auto flags = static_cast<std::uint16_t>(static_cast<unsigned>(type) | (parameters.size() << 8));
  out.u32(code).u16(flags).u16(text_id).u64(time_stamp);
  for (const auto& parameter : parameters) out.u16(parameter.flags).bytes(parameter.data);
  return bytes;
}

Result<DiagnosisMessage> DiagnosisMessage::decode(std::span<const std::uint8_t> bytes) {
  ByteReader reader(bytes);
  DiagnosisMessage message;
  message.code = reader.u32();
  const auto flags = reader.u16();
  message.text_id = reader.u16();
  message.time_stamp = reader.u64();
  message.type = static_cast<Type>(flags & kTypeMask);
  for (unsigned i = 0; i < (flags >> 8) && reader.ok(); ++i) {
    Parameter parameter;
    parameter.flags = reader.u16();
    const auto data = reader.take(parameter_size(parameter.flags));
    parameter.data.assign(data.begin(), data.end());
    message.parameters.push_back(std::move(parameter));
  }
  if (!reader.ok()) {
    return fail(ErrorCode::kMalformedData, "diagnosis message", because("only {bytes} bytes", bytes.size()));
  }
  return message;
}

}  // namespace syncline
