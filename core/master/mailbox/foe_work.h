// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "master/exchange/slave_batch.h"
#include "master/mailbox/mailbox_transfer.h"

namespace syncline::foe {
struct MessageView;
}  // namespace syncline::foe

namespace syncline {

/// File access over EtherCAT (ETG.1000.6, 5.8) with one slave, one file at a time. A slave that is busy is asked again
/// for a minute; one that miscounts its packets gets an error. Allocates in use() alone, and where what comes has no
/// room in the caller's bytes.
class FoeWork final : public SlaveWork {
 public:
  FoeWork() = default;
  explicit FoeWork(SlaveMailbox& mailbox) { use(mailbox); }

  void use(SlaveMailbox& mailbox);
  void set_response_timeout(Nanoseconds timeout) { transfer_.set_response_timeout(timeout); }
  /// Told of the bytes that have been transferred; may be empty.
  void set_progress(std::function<void(std::size_t bytes)> progress) { progress_ = std::move(progress); }

  /// What is there comes behind what `into` holds; more than `limit` bytes are refused. `name` and `into` outlive it.
  void read(std::string_view name, std::uint32_t password, std::vector<std::uint8_t>& into, std::size_t limit);
  /// `name` and `file` outlive it.
  void write(std::string_view name, std::uint32_t password, std::span<const std::uint8_t> file);
  /// Tells the slave that nothing more comes; over when that is said.
  void cancel();
  /// Ends it now, without a word to the slave.
  void give_up(const BriefError& why);

  Datagram* next(Nanoseconds now) override;
  void take(Nanoseconds now) override;
  [[nodiscard]] bool over() const override { return step_ == Step::kOver; }
  [[nodiscard]] Status result() const override;
  [[nodiscard]] bool in_a_hurry() const override { return step_ != Step::kPause && transfer_.in_a_hurry(); }

  /// kFileTransfer with the slave's FoE error, kMailboxTimeout, kMailboxProtocol, kCancelled.
  [[nodiscard]] const std::optional<BriefError>& failure() const { return failure_; }
  /// The slave's own words to kFileTransfer.
  [[nodiscard]] std::span<const std::uint8_t> words() const { return words_; }
  /// "drive, file "name"".
  [[nodiscard]] std::string subject() const;

 private:
  enum class Step : std::uint8_t { kOver, kBegin, kPacket, kPause, kLastAck, kError };

  void begin(bool writes, std::string_view name, std::uint32_t password);
  void send(const foe::MessageView& message, Nanoseconds now);
  void send_again(Nanoseconds now);
  void go_on(Nanoseconds now);
  void take_answer(Nanoseconds now);
  void take_busy(Nanoseconds now);
  void take_data(const foe::MessageView& packet, Nanoseconds now);
  void take_ack(const foe::MessageView& ack, Nanoseconds now);
  void send_packet(Nanoseconds now);
  void refuse(std::uint32_t code, const BriefError& why, Nanoseconds now);
  void fail_with(const BriefError& why);

  MailboxTransfer transfer_;
  std::function<void(std::size_t)> progress_;
  std::vector<std::uint8_t> message_, words_;
  Step step_ = Step::kOver;
  bool writes_ = false, cancelled_ = false, last_sent_ = false;
  std::string_view name_;
  std::uint32_t password_ = 0, packet_no_ = 0;  // the packet that is to come, or was sent
  std::vector<std::uint8_t>* into_ = nullptr;
  std::size_t limit_ = 0, begin_ = 0, sent_ = 0;
  std::span<const std::uint8_t> file_;
  int duplicates_ = 0;
  Nanoseconds busy_until_ = 0, not_before_ = 0;
  std::optional<BriefError> failure_;
};

}  // namespace syncline
