// SPDX-License-Identifier: Apache-2.0
#include "protocol/mailbox.h"

#include <fmt/format.h>

#include <algorithm>

#include "support/byte_order.h"

namespace syncline {

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
    return fail(ErrorCode::kMalformedData, "mailbox message",
                fmt::format("its header promises {} bytes of data, {} bytes came with the header", length, bytes.size()));
  }
  message.data.assign(data.begin(), data.end());
  return message;
}

}  // namespace syncline
