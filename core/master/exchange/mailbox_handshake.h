// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/mailbox_config.h"
#include "master/exchange/frame_exchange.h"
#include "protocol/registers.h"
#include "protocol/sync_manager.h"

namespace syncline {

struct SlaveConfig;

/// Status of SyncManager 1, the mailbox from the slave: bit 3 is set while it is full (ESC data sheet, section II).
inline constexpr std::uint16_t kSm1Status = reg::kSyncManager + SyncManager::kSize + 5;

/// Where a slave's mailbox is and how patient one must be with it.
struct MailboxPort {
  std::string name;  // subject of errors
  std::uint16_t station_address = 0;
  MailboxChannel send, receive;                      // master to slave (SM0), slave to master (SM1)
  Nanoseconds request_timeout = 100 * kMillisecond;  // until the slave has emptied its mailbox; ESI defaults
  Nanoseconds response_timeout = 2 * kSecond;
  /// What the process image says about the slave's full mailbox (FMMU of type 3); empty, or nothing when it
  /// does not know: then the SyncManager's status is read.
  std::function<std::optional<bool>()> full{};
};
/// With the time-outs of the slave's configuration.
[[nodiscard]] MailboxPort mailbox_port(const SlaveConfig& slave);

/// The hand-shake by which one message goes into a slave's mailbox and one comes out of it, cut into datagrams; the
/// bytes' meaning is for others. No single lost or late frame ends it: a lost write goes out again with the same
/// counter, by which a slave knows it; a lost read is asked for again by the repeat request (0x080E bit 1), so that
/// no message is lost or taken twice. Where the slave has none to repeat, the answer is lost for good and the request
/// must be made anew. Whoever sends the datagrams may repeat them or not. Allocates nothing but at construction and in
/// use().
class MailboxHandshake {
 public:
  /// kEmpty: only of fetch(). kAnswerLost: only of send() and send_anew().
  enum class End : std::uint8_t {
    kUnderWay,
    kMessage,
    kSent,
    kEmpty,
    kTimeout,
    kAnswerLost,
    kTooLong,
    kNoRoom,
    kMalformed
  };
  /// What is known of a slave's counting, for telling a repeated message from a new one.
  struct Receipt {
    std::uint8_t last = 0;  // counter of the slave's last message
    bool counts = false;    // its messages carry different counters
  };

  /// The port (and the receipt) must outlive the hand-shake or the next use().
  void use(const MailboxPort& port, Receipt& receipt);

  /// `message` with its header and counter. Sends, then waits for a message unless not `answered`.
  void send(std::span<const std::uint8_t> message, bool answered, Nanoseconds now);
  /// The last message that was sent, as a new one with this counter: a slave passes over one that it has counted
  /// already.
  void send_anew(std::uint8_t counter, Nanoseconds now);
  /// Another patience with answers than the port's, until use() is called again.
  void set_response_timeout(Nanoseconds timeout) { response_timeout_ = timeout; }
  /// Waits for another message, with new patience or (because the last one was not the answer) with what is left.
  void await(Nanoseconds now);
  void await_further(Nanoseconds now);
  /// Takes what should lie in the mailbox now.
  void fetch(Nanoseconds now);
  void give_up() { end_with(End::kTimeout); }

  /// The datagram to send now; nullptr while it waits, and when it is over.
  Datagram* next(Nanoseconds now);
  /// After it was sent; answered or not.
  void take(Nanoseconds now);
  [[nodiscard]] bool over() const { return step_ == Step::kOver; }
  [[nodiscard]] End end() const { return end_reason_; }
  /// With its header, as long as the mailbox.
  [[nodiscard]] std::span<const std::uint8_t> message() const { return bytes_; }
  /// The slave has a message or was asked for one again: no pause before the next datagram.
  [[nodiscard]] bool in_a_hurry() const {
    return step_ != Step::kOver && step_ != Step::kPoll && step_ != Step::kWrite;
  }

 private:
  enum class Step : std::uint8_t { kOver, kWrite, kPoll, kRead, kReadRepeat, kWriteRepeat, kAwaitRepeat };
  Datagram* poll(Nanoseconds now);
  Datagram* read();
  void take_write(Nanoseconds now);
  void take_poll(Nanoseconds now);
  void take_read(Nanoseconds now);
  void take_repeat(Nanoseconds now);
  void begin_write(bool answered, Nanoseconds now);
  bool out_of_time(Nanoseconds now);
  void end_with(End end);

  const MailboxPort* port_ = nullptr;
  Receipt* receipt_ = nullptr;
  Step step_ = Step::kOver;
  End end_reason_ = End::kUnderWay;
  bool wants_answer_ = true;
  bool only_fetch_ = false;
  bool write_unanswered_ = false;          // an earlier copy of the request may lie in the mailbox
  bool write_uncertain_ = false;           // the mailbox was full when the write was repeated
  bool read_repeated_ = false;             // the next message may be one that was seen already
  std::optional<Nanoseconds> repeat_due_;  // the slave has said that it repeats its answer: there by then, or never
  Nanoseconds response_timeout_ = 0;
  Nanoseconds end_ = 0, rewrite_at_ = 0, look_at_ = 0, repeat_end_ = 0;
  std::vector<std::uint8_t> request_, bytes_;
  std::array<std::uint8_t, 2> status_{};
  std::uint8_t repeat_bit_ = 0;
  Datagram datagram_;
};

}  // namespace syncline
