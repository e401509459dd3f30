// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "master/exchange/slave_batch.h"
#include "master/mailbox/mailbox_transfer.h"
#include "master/startup/startup_messages.h"
#include "protocol/coe.h"

namespace syncline {

/// Start-up messages of one slave that are no CoE objects, sent one after the other, each with its answer awaited. The
/// first that fails or is refused ends the list: kMailboxTimeout, kMailboxProtocol.
class StartupMessageWork final : public SlaveWork {
 public:
  using EmergencyHandler = std::function<void(const coe::Emergency&)>;

  /// `counter`: the slave's mailbox counter, which outlives the work.
  StartupMessageWork(MailboxPort port, std::vector<StartupMessage> messages, std::uint8_t& counter,
                     EmergencyHandler on_emergency);

  Datagram* next(Nanoseconds now) override;
  void take(Nanoseconds now) override;
  [[nodiscard]] bool over() const override { return failed_ || index_ >= messages_.size(); }
  [[nodiscard]] const Status& result() const override { return result_; }

 private:
  void begin(Nanoseconds now);
  void take_message(const MailboxMessage& message, Nanoseconds now);
  void done();
  void fail_with(Error error);
  [[nodiscard]] std::string subject() const;
  [[nodiscard]] const StartupMessage& message() const { return messages_[index_]; }

  MailboxTransfer transfer_;
  Nanoseconds response_timeout_;  // the slave's, for messages without one of their own
  std::vector<StartupMessage> messages_;
  EmergencyHandler on_emergency_;
  std::size_t index_ = 0;
  bool begun_ = false, failed_ = false;
  int unasked_ = 0;  // messages that were no answer
  Status result_;
};

}  // namespace syncline
