// SPDX-License-Identifier: Apache-2.0
#include "protocol/mailbox.h"

#include <fmt/format.h>

#include <algorithm>

#include "reasons/because.h"
#include "reasons/brief_reason.h"
#include "support/brief_error.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr std::uint16_t kErrorService = 1;

BriefReason lies(std::size_t promised, std::size_t came) {
  return brief("its header promises {promised} bytes of data, {count} bytes came with the header", promised, came);
}

}  // namespace

std::vector<std::uint8_t> MailboxMessage::encode(std::size_t mailbox_size) const {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(std::max(kHeaderSize + data.size(), mailbox_size));
  ByteWriter(bytes)
      .u16(static_cast<std::uint16_t>(data.size()))
      .u16(address)
      .u8(static_cast<std::uint8_t>((channel & 0x3F) | ((priority & 0x03) << 6)))
      .u8(static_cast<std::uint8_t>((static_cast<std::uint8_t>(type) & 0x0F) | ((counter & 0x07) << 4)))
      .bytes(data);
  if (bytes.size() < mailbox_size) bytes.resize(mailbox_size, 0);
  return bytes;
}

Result<MailboxMessage> MailboxMessage::decode(std::span<const std::uint8_t> bytes) {
  ByteReader reader(bytes);
  const auto length = reader.u16();
  MailboxMessage message;
  message.address = reader.u16();
  const auto channel = reader.u8();
  message.channel = channel & 0x3F;
  message.priority = channel >> 6;
  const auto type = reader.u8();
  message.type = static_cast<MailboxType>(type & 0x0F);
  message.counter = (type >> 4) & 0x07;
  const auto data = reader.take(length);
  if (!reader.ok()) {
    return fail(ErrorCode::kMalformedData, "mailbox message", lies(length, bytes.size()).in_full());
  }
  message.data.assign(data.begin(), data.end());
  return message;
}

tl::expected<MailboxMessageView, BriefError> view_mailbox_message(std::span<const std::uint8_t> bytes) {
  ByteReader reader(bytes);
  const auto length = reader.u16();
  reader.skip(3);
  const auto type = reader.u8();
  const auto data = reader.take(length);
  if (!reader.ok()) {
    return tl::unexpected(BriefError{.code = ErrorCode::kMalformedData, .why = lies(length, bytes.size())});
  }
  return MailboxMessageView{static_cast<MailboxType>(type & 0x0F), static_cast<std::uint8_t>((type >> 4) & 7U), data};
}

void append(std::vector<std::uint8_t>& out, const MailboxMessageView& message) {
  ByteWriter(out)
      .u16(static_cast<std::uint16_t>(message.data.size()))
      .zeros(3)
      .u8(static_cast<std::uint8_t>((static_cast<std::uint8_t>(message.type) & 0x0F) | ((message.counter & 0x07) << 4)))
      .bytes(message.data);
}

std::vector<std::uint8_t> MailboxError::encode() const {
  std::vector<std::uint8_t> bytes;
  ByteWriter(bytes).u16(kErrorService).u16(static_cast<std::uint16_t>(detail));
  return bytes;
}

Result<MailboxError> MailboxError::decode(std::span<const std::uint8_t> data) {
  ByteReader reader(data);
  const auto service = reader.u16();
  const auto detail = reader.u16();
  if (!reader.ok() || service != kErrorService) {
    return fail(ErrorCode::kMalformedData, "mailbox error reply",
                because("{bytes} bytes, service {number}", data.size(), service));
  }
  return MailboxError{static_cast<MailboxErrorDetail>(detail)};
}

std::string_view mailbox_error_text(MailboxErrorDetail detail) {
  switch (detail) {
    case MailboxErrorDetail::kSyntax:
      return reason_words("syntax of the mailbox header");
    case MailboxErrorDetail::kUnsupportedProtocol:
      return reason_words("the slave does not support this protocol");
    case MailboxErrorDetail::kInvalidChannel:
      return reason_words("the channel does not exist");
    case MailboxErrorDetail::kServiceNotSupported:
      return reason_words("the slave does not support this service of the protocol");
    case MailboxErrorDetail::kInvalidHeader:
      return reason_words("the protocol's header is wrong");
    case MailboxErrorDetail::kSizeTooShort:
      return reason_words("the message is too short");
    case MailboxErrorDetail::kNoMoreMemory:
      return reason_words("the slave is out of memory");
    case MailboxErrorDetail::kInvalidSize:
      return reason_words("the length in the message is inconsistent");
    case MailboxErrorDetail::kServiceInWork:
      return reason_words("the slave is still busy with another service");
  }
  return reason_words("unknown mailbox error");
}

std::string_view mailbox_type_name(MailboxType type) {
  switch (type) {
    case MailboxType::kError:
      return "error";
    case MailboxType::kAoe:
      return "AoE";
    case MailboxType::kEoe:
      return "EoE";
    case MailboxType::kCoe:
      return "CoE";
    case MailboxType::kFoe:
      return "FoE";
    case MailboxType::kSoe:
      return "SoE";
    case MailboxType::kVoe:
      return "VoE";
  }
  return "unknown";
}

}  // namespace syncline
