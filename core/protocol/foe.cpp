// SPDX-License-Identifier: Apache-2.0
#include "protocol/foe.h"

#include <fmt/format.h>

#include "support/byte_order.h"

namespace syncline::foe {
namespace {

enum Opcode : std::uint8_t { kRead = 1, kWrite = 2, kData = 3, kAck = 4, kError = 5, kBusy = 6 };

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Text without the zeros that some devices put behind it.
std::string read_text(ByteReader& reader) {
  const auto bytes = reader.take(reader.remaining());
  std::string text(bytes.begin(), bytes.end());
  return text.substr(0, text.find('\0'));
}

struct Writer {
  ByteWriter& out;

  void head(Opcode opcode, std::uint32_t value) const { out.u8(opcode).u8(0).u32(value); }
  void operator()(const ReadRequest& m) const {
    head(kRead, m.password);
    out.bytes(bytes_of(m.name));
  }
  void operator()(const WriteRequest& m) const {
    head(kWrite, m.password);
    out.bytes(bytes_of(m.name));
  }
  void operator()(const Data& m) const {
    head(kData, m.packet_no);
    out.bytes(m.bytes);
  }
  void operator()(const Ack& m) const { head(kAck, m.packet_no); }
  void operator()(const FileError& m) const {
    head(kError, m.code);
    out.bytes(bytes_of(m.text));
  }
  void operator()(const Busy& m) const { out.u8(kBusy).u8(0).u16(m.done).u16(m.entire).bytes(bytes_of(m.text)); }
};

}  // namespace

std::vector<std::uint8_t> encode(const Message& message) {
  std::vector<std::uint8_t> bytes;
  ByteWriter out(bytes);
  std::visit(Writer{out}, message);
  return bytes;
}

Result<Message> decode(std::span<const std::uint8_t> data) {
  ByteReader reader(data);
  const auto opcode = reader.u8();
  reader.skip(1);
  const auto value = reader.u32();
  if (!reader.ok()) return fail(ErrorCode::kMalformedData, "FoE message", fmt::format("only {} bytes", data.size()));
  switch (opcode) {
    case kRead:
      return ReadRequest{value, read_text(reader)};
    case kWrite:
      return WriteRequest{value, read_text(reader)};
    case kData: {
      const auto bytes = reader.take(reader.remaining());
      return Data{value, {bytes.begin(), bytes.end()}};
    }
    case kAck:
      return Ack{value};
    case kError:
      return FileError{value, read_text(reader)};
    case kBusy:
      return Busy{static_cast<std::uint16_t>(value), static_cast<std::uint16_t>(value >> 16), read_text(reader)};
    default:
      return fail(ErrorCode::kMalformedData, "FoE message", fmt::format("opcode {} does not exist", opcode));
  }
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
