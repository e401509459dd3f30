// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "protocol/mailbox.h"
#include "support/result.h"

namespace syncline {
struct BriefError;
}  // namespace syncline

/// File access over EtherCAT (ETG.1000.6, 5.8): the bytes behind the mailbox header, both directions. A transfer
/// ends with a data packet that does not fill the mailbox; it may be empty.
namespace syncline::foe {

struct ReadRequest {
  std::uint32_t password = 0;
  std::string name;
  bool operator==(const ReadRequest&) const = default;
};
struct WriteRequest {
  std::uint32_t password = 0;
  std::string name;
  bool operator==(const WriteRequest&) const = default;
};
struct Data {
  std::uint32_t packet_no = 1;  // from 1
  std::vector<std::uint8_t> bytes;
  bool operator==(const Data&) const = default;
};
struct Ack {
  std::uint32_t packet_no = 0;  // 0 answers a write request
  bool operator==(const Ack&) const = default;
};
struct FileError {
  std::uint32_t code = 0;
  std::string text;
  bool operator==(const FileError&) const = default;
};
/// The packet before must be sent again later.
struct Busy {
  std::uint16_t done = 0;
  std::uint16_t entire = 0;  // done of entire; 0: not told
  std::string text;
  bool operator==(const Busy&) const = default;
};
using Message = std::variant<ReadRequest, WriteRequest, Data, Ack, FileError, Busy>;

/// Error codes (ETG.1000.6, table 92).
namespace error {
inline constexpr std::uint32_t kNotDefined = 0x8000, kNotFound = 0x8001, kAccessDenied = 0x8002, kDiskFull = 0x8003,
                               kIllegal = 0x8004, kPacketNumber = 0x8005, kExists = 0x8006, kNoUser = 0x8007,
                               kBootstrapOnly = 0x8008, kNotInBootstrap = 0x8009, kNoRights = 0x800A,
                               kProgramError = 0x800B;
}  // namespace error

[[nodiscard]] std::string_view error_text(std::uint32_t code);

enum class OpCode : std::uint8_t { kRead = 1, kWrite = 2, kData = 3, kAck = 4, kError = 5, kBusy = 6 };

/// A message as it lies in the mailbox, for a client that must not allocate.
struct MessageView {
  OpCode code = OpCode::kError;
  std::uint32_t value = 0;             // password, packet number, error code; of kBusy: done, and entire from bit 16
  std::span<const std::uint8_t> rest;  // name, bytes, or words
};
/// kMalformedData.
[[nodiscard]] tl::expected<MessageView, BriefError> view(std::span<const std::uint8_t> data);
/// Behind what `out` holds; allocates only where `out` has no room.
void append(std::vector<std::uint8_t>& out, const MessageView& message);

[[nodiscard]] std::vector<std::uint8_t> encode(const Message& message);
/// kMalformedData.
[[nodiscard]] Result<Message> decode(std::span<const std::uint8_t> data);

/// Bytes of file that a full data packet carries in a mailbox of `mailbox_size` bytes.
[[nodiscard]] constexpr std::size_t data_capacity(std::size_t mailbox_size) {
  constexpr std::size_t kOverhead = MailboxMessage::kHeaderSize + 6;
  return mailbox_size > kOverhead ? mailbox_size - kOverhead : 0;
}

}  // namespace syncline::foe
