// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "master/exchange/slave_mailbox.h"
#include "protocol/mailbox.h"
#include "reasons/brief_reason.h"
#include "support/brief_error.h"

namespace syncline {

/// Messages that nobody asked for before a request is given up: more than the mailbox queue of any slave; one that
/// talks without end is not listened to for ever.
inline constexpr int kMostUnasked = 64;

/// What a slave says is against the protocol.
template <std::integral... Numbers>
[[nodiscard]] BriefError protocol_error(std::type_identity_t<BriefRow<sizeof...(Numbers)>> row, Numbers... numbers) {
  return {.code = ErrorCode::kMailboxProtocol, .why = brief(row, numbers...)};
}

/// One request into a slave's mailbox and its answer out of it, cut into datagrams: the one place for what all
/// protocols share. Counts the requests; hands emergencies on; passes over messages of other protocols, as many as a
/// mailbox may hold; takes a mailbox error for an answer; asks a slave anew, at most three times, that has lost its
/// answer and cannot repeat it. No single lost or late frame ends it (see MailboxHandshake). Allocates in use() alone.
class MailboxTransfer {
 public:
  MailboxTransfer() = default;
  explicit MailboxTransfer(SlaveMailbox& mailbox) { use(mailbox); }

  void use(SlaveMailbox& mailbox);
  /// For slaves or commands with a patience of their own; holds until use().
  void set_response_timeout(Nanoseconds timeout) { handshake_.set_response_timeout(timeout); }

  /// Sends, then waits for a message of the same protocol.
  void ask(MailboxType type, std::span<const std::uint8_t> data, Nanoseconds now);
  /// Only sends: over when the slave's mailbox has it.
  void tell(MailboxType type, std::span<const std::uint8_t> data, Nanoseconds now);
  /// Waits for a further part of the answer with new patience, or for the answer itself with what is left of it.
  void receive(Nanoseconds now);
  void receive_instead(Nanoseconds now);
  /// Takes what lies in the mailbox, whatever it is.
  void fetch(Nanoseconds now);
  void give_up() { end_with({.code = ErrorCode::kMailboxTimeout}); }

  /// The datagram to send now; nullptr while it waits, and when it is over.
  Datagram* next(Nanoseconds now);
  /// After it was sent; answered or not.
  void take(Nanoseconds now);
  [[nodiscard]] bool over() const { return over_; }
  /// The slave has a message or was asked for one again: no pause before the next datagram.
  [[nodiscard]] bool in_a_hurry() const { return over_ || handshake_.in_a_hurry(); }

  /// kMailboxTimeout, kMailboxProtocol; nothing after success.
  [[nodiscard]] const std::optional<BriefError>& failure() const { return failure_; }
  /// Behind the mailbox header, until the next request. Empty after tell().
  [[nodiscard]] std::span<const std::uint8_t> data() const { return data_; }
  /// fetch() found the mailbox empty.
  [[nodiscard]] bool empty() const { return empty_; }
  /// Since the request an emergency has come.
  [[nodiscard]] bool emergency() const { return emergency_; }
  [[nodiscard]] const SlaveMailbox* mailbox() const { return mailbox_; }

 private:
  void send(MailboxType type, std::span<const std::uint8_t> data, Nanoseconds now, bool answered);
  void begin();
  void note_end(Nanoseconds now);
  void take_message(Nanoseconds now);
  bool hand_on_emergency(const MailboxMessageView& message, Nanoseconds now);
  void end_with(const BriefError& failure);

  SlaveMailbox* mailbox_ = nullptr;
  MailboxHandshake handshake_;
  std::vector<std::uint8_t> request_;
  MailboxType type_ = MailboxType::kCoe;
  bool over_ = true, fetching_ = false, empty_ = false, emergency_ = false;
  int asked_anew_ = 0, unasked_ = 0;
  std::optional<BriefError> failure_;
  std::span<const std::uint8_t> data_;
};

}  // namespace syncline
