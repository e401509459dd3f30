// SPDX-License-Identifier: Apache-2.0
#include "master/startup/history_collector.h"

#include "master/mailbox/diagnosis_history_reader.h"
#include "master/startup/slave_commands.h"

namespace syncline {

HistoryCollector::HistoryCollector(Bus& bus, RunState& run, CyclicTaskRunner& task, Esm& esm)
    : bus_(bus), run_(run), task_(task), esm_(esm) {}

Status HistoryCollector::after_cycle() {
  const auto slave = task_.mailboxes().news();
  if (!slave) return {};
  if (auto status = esm_.quiet_mailboxes(); !status) return status;
  auto status = read(*slave);
  task_.mailbox().set_enabled(bus_.cyclic());
  return status;
}

Status HistoryCollector::read(std::size_t slave) {
  MailboxClient mailbox(bus_, run_.mailboxes[slave]);
  const auto told = task_.mailboxes().told(slave);
  const auto history = read_diagnosis_history(mailbox, told);
  if (!history) {
    const auto& error = history.error();
    if (ends_everything(error)) return tl::unexpected(error);
    // No such object after all, or not now: the next poll finds it again.
    task_.mailboxes().note_told(slave, error.code == ErrorCode::kSdoAbort ? std::nullopt : std::optional(told));
    return {};
  }
  for (const auto& [sub_index, message] : history->messages) {
    run_.event(bus_.clock().now(), static_cast<int>(slave),
               events::DiagnosisTold{message.code, message.type, message.text_id, message.time_stamp});
  }
  task_.mailboxes().note_told(slave, history->newest);
  return {};
}

}  // namespace syncline
