// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "config/network_config.h"
#include "master/exchange/slave_batch.h"
#include "master/mailbox/mailbox_transfer.h"
#include "protocol/coe.h"

namespace syncline {

/// CoE init commands of one slave, downloaded one after the other (expedited, normal, segmented). The
/// first that fails ends the list: kSdoAbort, kMailboxTimeout, kMailboxProtocol.
class CoeDownloadWork final : public SlaveWork {
 public:
  using EmergencyHandler = std::function<void(const coe::Emergency&)>;

  /// `counter`: the slave's mailbox counter, which outlives the work, as do the commands.
  CoeDownloadWork(MailboxPort port, std::vector<const StartupCommand*> commands, std::uint8_t& counter,
                  EmergencyHandler on_emergency);

  Datagram* next(Nanoseconds now) override;
  void take(Nanoseconds now) override;
  [[nodiscard]] bool over() const override { return failed_ || index_ >= commands_.size(); }
  [[nodiscard]] const Status& result() const override { return result_; }

 private:
  void begin_command(Nanoseconds now);
  void ask(const coe::Request& request, Nanoseconds now);
  void take_message(const MailboxMessage& message, Nanoseconds now);
  void take_response(const coe::Response& response, Nanoseconds now);
  void send_segment(Nanoseconds now);
  void fail_with(Error error);
  [[nodiscard]] Error error(ErrorCode code, std::string detail = {}) const;
  [[nodiscard]] const StartupCommand& command() const { return *commands_[index_]; }
  [[nodiscard]] std::string subject() const;

  MailboxTransfer transfer_;
  Nanoseconds response_timeout_;  // the slave's, for commands without one of their own
  std::vector<const StartupCommand*> commands_;
  EmergencyHandler on_emergency_;
  std::size_t index_ = 0;
  bool begun_ = false, failed_ = false;
  std::size_t sent_ = 0;  // bytes of the object that are with the slave
  bool segmented_ = false, toggle_ = false;
  int unasked_ = 0;  // messages that were no answer
  Status result_;
};

}  // namespace syncline
