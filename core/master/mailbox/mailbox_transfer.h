// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "master/exchange/mailbox_handshake.h"
#include "protocol/mailbox.h"

namespace syncline {

/// One message into a slave's mailbox and the next one out of it, cut into datagrams, so that many slaves can be
/// served in the same frames. No single lost or late frame ends it (see MailboxHandshake); a slave that has lost its
/// answer and cannot repeat it is asked anew, at most three times for a message.
class MailboxTransfer {
 public:
  /// `counter`: the slave's mailbox counter, which outlives the transfer.
  MailboxTransfer(MailboxPort port, std::uint8_t& counter);
  MailboxTransfer(MailboxTransfer&& other) noexcept;
  MailboxTransfer& operator=(MailboxTransfer&&) = delete;

  /// Sends, then waits for a message. One that is longer than the mailbox fails with kMailboxProtocol.
  void send(MailboxType type, std::span<const std::uint8_t> data, Nanoseconds now) { begin(type, data, now, true); }
  /// Only sends: over when the slave's mailbox has it.
  void send_only(MailboxType type, std::span<const std::uint8_t> data, Nanoseconds now) {
    begin(type, data, now, false);
  }
  /// Waits for another message, with new patience or (because the last one was not the answer) with what is left.
  void await(Nanoseconds now);
  void await_further(Nanoseconds now);

  /// The datagram to send now; nullptr while it waits, and when it is over.
  Datagram* next(Nanoseconds now);
  void take(Nanoseconds now);
  [[nodiscard]] bool over() const { return handshake_.over(); }
  /// The message (nothing in it after send_only()); kMailboxTimeout, kMailboxProtocol.
  [[nodiscard]] const Result<MailboxMessage>& result() const { return result_; }
  /// The slave has a message or was asked for one again: no pause before the next datagram.
  [[nodiscard]] bool in_a_hurry() const { return handshake_.in_a_hurry(); }

  [[nodiscard]] const MailboxPort& port() const { return port_; }
  void set_response_timeout(Nanoseconds timeout) { port_.response_timeout = timeout; }

 private:
  void begin(MailboxType type, std::span<const std::uint8_t> data, Nanoseconds now, bool answered);
  void note_end(Nanoseconds now);

  MailboxPort port_;
  std::uint8_t& counter_;
  MailboxHandshake::Receipt receipt_;
  MailboxHandshake handshake_;
  bool noted_ = true;
  int asked_anew_ = 0;
  Result<MailboxMessage> result_;
};

}  // namespace syncline
