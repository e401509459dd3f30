// SPDX-License-Identifier: Apache-2.0
#include "protocol/foe.h"

#include <fmt/format.h>

#include "reasons/brief_reason.h"
#include "support/brief_error.h"
#include "support/byte_order.h"
#include "support/text_bytes.h"

namespace syncline::foe {
namespace {

/// Text without the zeros that some devices put behind it.
std::string text_of(std::span<const std::uint8_t> bytes) {
  std::string text(bytes.begin(), bytes.end());
  return text.substr(0, text.find('\0'));
}

struct Viewer {
  MessageView operator()(const ReadRequest& m) const { return {OpCode::kRead, m.password, bytes_of(m.name)}; }
  MessageView operator()(const WriteRequest& m) const { return {OpCode::kWrite, m.password, bytes_of(m.name)}; }
  MessageView operator()(const Data& m) const { return {OpCode::kData, m.packet_no, m.bytes}; }
  MessageView operator()(const Ack& m) const { return {OpCode::kAck, m.packet_no, {}}; }
  MessageView operator()(const FileError& m) const { return {OpCode::kError, m.code, bytes_of(m.text)}; }
  MessageView operator()(const Busy& m) const {
    return {OpCode::kBusy, m.done | std::uint32_t{m.entire} << 16, bytes_of(m.text)};
  }
};

}  // namespace

void append(std::vector<std::uint8_t>& out, const MessageView& message) {
  ByteWriter(out).u8(static_cast<std::uint8_t>(message.code)).u8(0).u32(message.value).bytes(message.rest);
}

std::vector<std::uint8_t> encode(const Message& message) {
  std::vector<std::uint8_t> bytes;
  append(bytes, std::visit(Viewer{}, message));
  return bytes;
}

tl::expected<MessageView, BriefError> view(std::span<const std::uint8_t> data) {
  const auto bad = [](BriefReason why) {
    return tl::unexpected(BriefError{.code = ErrorCode::kMalformedData, .why = why});
  };
  ByteReader reader(data);
  const auto opcode = reader.u8();
  reader.skip(1);
  const auto value = reader.u32();
  if (!reader.ok()) return bad(brief("only {bytes} bytes", data.size()));
  if (opcode < static_cast<unsigned>(OpCode::kRead) || opcode > static_cast<unsigned>(OpCode::kBusy))
    return bad(brief("opcode {number} does not exist", opcode));
  return MessageView{static_cast<OpCode>(opcode), value, reader.take(reader.remaining())};
}

Result<Message> decode(std::span<const std::uint8_t> data) {
  const auto message = view(data);
  if (!message) return fail(message.error().about("FoE message"));
  const auto& [code, value, rest] = *message;
  switch (code) {
    case OpCode::kRead:
      return ReadRequest{value, text_of(rest)};
    case OpCode::kWrite:
      return WriteRequest{value, text_of(rest)};
    case OpCode::kData:
      return Data{value, {rest.begin(), rest.end()}};
    case OpCode::kAck:
      return Ack{value};
    case OpCode::kError:
      return FileError{value, text_of(rest)};
    case OpCode::kBusy:
      break;
  }
  return Busy{static_cast<std::uint16_t>(value), static_cast<std::uint16_t>(value >> 16), text_of(rest)};
}

std::string_view error_text(std::uint32_t code) {
  switch (code) {
    case error::kNotDefined:
      return "not defined";
    case error::kNotFound:
      return "file not found";
    case error::kAccessDenied:
      return "access denied; is the password right?";
    case error::kDiskFull:
      return "no room left in the device";
    case error::kIllegal:
      return "illegal operation";
    case error::kPacketNumber:
      return "wrong packet number";
    case error::kExists:
      return "the file exists already";
    case error::kNoUser:
      return "no user";
    case error::kBootstrapOnly:
      return "only in BOOT state";
    case error::kNotInBootstrap:
      return "not in BOOT state";
    case error::kNoRights:
      return "no rights for this file";
    case error::kProgramError:
      return "the device's program failed";
    default:
      return "unknown error of the device";
  }
}

}  // namespace syncline::foe
