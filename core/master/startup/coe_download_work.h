// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "master/exchange/slave_batch.h"
#include "master/mailbox/sdo_work.h"

namespace syncline {

/// CoE init commands of one slave, downloaded one after the other. The first that fails ends the list: kSdoAbort,
/// kMailboxTimeout, kMailboxProtocol.
class CoeDownloadWork final : public SlaveWork {
 public:
  /// The mailbox and the commands outlive the work.
  CoeDownloadWork(SlaveMailbox& mailbox, std::vector<const StartupCommand*> commands);

  Datagram* next(Nanoseconds now) override;
  void take(Nanoseconds now) override;
  [[nodiscard]] bool over() const override { return !result_ || index_ >= commands_.size(); }
  [[nodiscard]] Status result() const override { return result_; }
  [[nodiscard]] bool in_a_hurry() const override { return !begun_ || sdo_.in_a_hurry(); }

 private:
  void go_on();

  SdoWork sdo_;
  Nanoseconds response_timeout_;  // the slave's, for commands without one of their own
  std::vector<const StartupCommand*> commands_;
  std::size_t index_ = 0;
  bool begun_ = false;
  Status result_;
};

}  // namespace syncline
