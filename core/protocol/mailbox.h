// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "support/result.h"

namespace syncline {

struct BriefError;

enum class MailboxType : std::uint8_t { kError = 0, kAoe = 1, kEoe = 2, kCoe = 3, kFoe = 4, kSoe = 5, kVoe = 15 };
enum class MailboxErrorDetail : std::uint16_t {
  kSyntax = 1,
  kUnsupportedProtocol = 2,
  kInvalidChannel = 3,
  kServiceNotSupported = 4,
  kInvalidHeader = 5,
  kSizeTooShort = 6,
  kNoMoreMemory = 7,
  kInvalidSize = 8,
  kServiceInWork = 9,
};

/// Mailbox message: 6-byte header and data (ETG.1000.4, table 29).
struct MailboxMessage {
  static constexpr std::size_t kHeaderSize = 6;
  std::uint16_t address = 0;
  std::uint8_t channel = 0;   // 0..63
  std::uint8_t priority = 0;  // 0..3
  MailboxType type = MailboxType::kCoe;
  std::uint8_t counter = 0;  // 1..7, 0 = not used
  std::vector<std::uint8_t> data;

  bool operator==(const MailboxMessage&) const = default;
  /// Header and data, padded with zeros to `mailbox_size` when it is larger.
  [[nodiscard]] std::vector<std::uint8_t> encode(std::size_t mailbox_size = 0) const;
  /// Fails when the length field lies about the bytes that are there.
  [[nodiscard]] static Result<MailboxMessage> decode(std::span<const std::uint8_t> bytes);
};

/// The same as it lies in the mailbox, for a client that must not allocate.
struct MailboxMessageView {
  MailboxType type = MailboxType::kCoe;
  std::uint8_t counter = 0;
  std::span<const std::uint8_t> data;
};
/// kMalformedData when the length field lies about the bytes that are there.
[[nodiscard]] tl::expected<MailboxMessageView, BriefError> view_mailbox_message(std::span<const std::uint8_t> bytes);
/// Header and data behind what `out` holds; allocates only where `out` has no room.
void append(std::vector<std::uint8_t>& out, const MailboxMessageView& message);

/// Reply of a slave that cannot take a message as it is: mailbox type 0 (ETG.1000.4, table 32).
struct MailboxError {
  MailboxErrorDetail detail = MailboxErrorDetail::kSyntax;
  bool operator==(const MailboxError&) const = default;
  [[nodiscard]] std::vector<std::uint8_t> encode() const;
  /// The data behind the mailbox header. A detail that no table knows is kept as it is.
  [[nodiscard]] static Result<MailboxError> decode(std::span<const std::uint8_t> data);
};
/// A row of the table of reasons.
[[nodiscard]] std::string_view mailbox_error_text(MailboxErrorDetail detail);
[[nodiscard]] std::string_view mailbox_type_name(MailboxType type);  // "CoE"; "unknown"

[[nodiscard]] constexpr std::uint8_t next_mailbox_counter(std::uint8_t counter) {
  return counter >= 7 ? std::uint8_t{1} : static_cast<std::uint8_t>(counter + 1);
}

}  // namespace syncline
