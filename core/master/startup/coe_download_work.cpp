// SPDX-License-Identifier: Apache-2.0
#include "master/startup/coe_download_work.h"

#include <utility>

namespace syncline {

CoeDownloadWork::CoeDownloadWork(SlaveMailbox& mailbox, std::vector<const StartupCommand*> commands)
    : sdo_(mailbox), response_timeout_(mailbox.port.response_timeout), commands_(std::move(commands)) {}

Datagram* CoeDownloadWork::next(Nanoseconds now) {
  if (over()) return nullptr;
  if (!std::exchange(begun_, true)) {
    const auto& command = *commands_[index_];
    sdo_.set_response_timeout(command.timeout_ms == 0 ? response_timeout_ : command.timeout_ms * kMillisecond);
    sdo_.download({command.index, command.sub_index}, command.complete_access, command.data);
  }
  auto* datagram = sdo_.next(now);
  go_on();
  return datagram;
}

void CoeDownloadWork::take(Nanoseconds now) {
  sdo_.take(now);
  go_on();
}

void CoeDownloadWork::go_on() {
  if (over() || !sdo_.over()) return;
  result_ = sdo_.result();
  if (!result_) return;
  ++index_;
  begun_ = false;
}

}  // namespace syncline
