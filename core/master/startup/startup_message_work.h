// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "master/exchange/slave_batch.h"
#include "master/mailbox/mailbox_transfer.h"
#include "master/startup/startup_messages.h"

namespace syncline {

/// Start-up messages of one slave that are no CoE objects, sent one after the other, each with its answer awaited. The
/// first that fails or is refused ends the list: kMailboxTimeout, kMailboxProtocol.
class StartupMessageWork final : public SlaveWork {
 public:
  /// The mailbox outlives the work.
  StartupMessageWork(SlaveMailbox& mailbox, std::vector<StartupMessage> messages);

  Datagram* next(Nanoseconds now) override;
  void take(Nanoseconds now) override;
  [[nodiscard]] bool over() const override { return failed_ || index_ >= messages_.size(); }
  [[nodiscard]] Status result() const override { return result_; }
  [[nodiscard]] bool in_a_hurry() const override { return !begun_ || transfer_.in_a_hurry(); }

 private:
  void begin(Nanoseconds now);
  void go_on(Nanoseconds now);
  void take_message(Nanoseconds now);
  void done();
  void fail_with(const BriefError& error);
  [[nodiscard]] std::string subject() const;
  [[nodiscard]] const StartupMessage& message() const { return messages_[index_]; }

  MailboxTransfer transfer_;
  Nanoseconds response_timeout_;  // the slave's, for messages without one of their own
  std::vector<StartupMessage> messages_;
  std::size_t index_ = 0;
  bool begun_ = false, failed_ = false;
  int unasked_ = 0;  // messages of the protocol that were no answer
  Status result_;
};

}  // namespace syncline
