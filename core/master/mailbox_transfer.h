// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/network_config.h"
#include "master/frame_exchange.h"
#include "protocol/mailbox.h"

namespace syncline {

/// Where a slave's mailbox is and how patient one must be with it.
struct MailboxPort {
  std::string name;                                  // subject of errors
  std::uint16_t station_address = 0;
  MailboxChannel send, receive;                      // master to slave (SM0), slave to master (SM1)
  Nanoseconds request_timeout = 1 * kSecond;         // until the slave has emptied its mailbox
  Nanoseconds response_timeout = 2 * kSecond;        // ESI default
  /// What the process image says about the slave's full mailbox (FMMU of type 3); empty, or nothing when it
  /// does not know: then the SyncManager's status is read.
  std::function<std::optional<bool>()> full{};
};
[[nodiscard]] MailboxPort mailbox_port(const SlaveConfig& slave);

/// One message into a slave's mailbox and the next one out of it, cut into datagrams, so that many slaves can be
/// served in the same frames. No single lost or late frame ends it: a lost write goes out again with the same
/// counter, by which a slave knows it; a lost read is asked for again by the repeat request (0x080E bit 1), so that
/// no message is lost or taken twice.
class MailboxTransfer {
 public:
  /// `counter`: the slave's mailbox counter, which outlives the transfer.
  MailboxTransfer(MailboxPort port, std::uint8_t& counter) : port_(std::move(port)), counter_(counter) {}

  /// Sends, then waits for a message. One that is longer than the mailbox fails with kMailboxProtocol.
  void send(MailboxType type, std::span<const std::uint8_t> data, Nanoseconds now);
  /// Only sends: over when the slave's mailbox has it.
  void send_only(MailboxType type, std::span<const std::uint8_t> data, Nanoseconds now);
  /// Waits for another message, with new patience or (because the last one was not the answer) with what is left.
  void await(Nanoseconds now);
  void await_further(Nanoseconds now);

  /// The datagram to send now; nullptr while it waits, and when it is over.
  Datagram* next(Nanoseconds now);
  void take(Nanoseconds now);
  [[nodiscard]] bool over() const { return step_ == Step::kOver; }
  /// The message (nothing in it after send_only()); kMailboxTimeout, kMailboxProtocol.
  [[nodiscard]] const Result<MailboxMessage>& result() const { return result_; }

  /// The slave has a message or was asked for one again: no pause before the next datagram.
  [[nodiscard]] bool in_a_hurry() const { return step_ != Step::kOver && step_ != Step::kPoll && step_ != Step::kWrite; }

  [[nodiscard]] const MailboxPort& port() const { return port_; }
  void set_response_timeout(Nanoseconds timeout) { port_.response_timeout = timeout; }

 private:
  enum class Step : std::uint8_t { kOver, kWrite, kPoll, kRead, kReadRepeat, kWriteRepeat, kAwaitRepeat };
  void begin(MailboxType type, std::span<const std::uint8_t> data, Nanoseconds now, bool answered);
  void take_write(Nanoseconds now);
  void take_poll(Nanoseconds now);
  void take_read(Nanoseconds now);
  void take_repeat(Nanoseconds now);
  bool out_of_time(Nanoseconds now);
  void end_with(Result<MailboxMessage> result);

  MailboxPort port_;
  std::uint8_t& counter_;
  Step step_ = Step::kOver;
  bool wants_answer_ = true;
  bool write_uncertain_ = false;      // the mailbox was full when the write was repeated
  bool read_repeated_ = false;        // the next message may be one that was seen already
  bool slave_counts_ = false;         // its messages carry different counters
  std::uint8_t last_received_ = 0;    // counter of the slave's last message
  Nanoseconds end_ = 0, rewrite_at_ = 0, look_at_ = 0, repeat_end_ = 0;
  std::vector<std::uint8_t> request_, bytes_;
  std::array<std::uint8_t, 2> status_{};
  std::uint8_t repeat_bit_ = 0;
  Datagram datagram_;
  Result<MailboxMessage> result_;
};

}  // namespace syncline
