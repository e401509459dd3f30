// SPDX-License-Identifier: Apache-2.0
#include "master/startup/history_collector.h"

#include "master/cyclic/cyclic_task.h"
#include "master/cyclic/mailbox_hold.h"
#include "master/exchange/event_teller.h"
#include "master/exchange/slave_mailbox.h"
#include "master/mailbox/diagnosis_history_reader.h"
#include "master/mailbox/mailbox_client.h"
#include "master/startup/slave_commands.h"

namespace syncline {

HistoryCollector::HistoryCollector(Bus& bus, std::span<SlaveMailbox> mailboxes, EventTeller& teller,
                                   CyclicTaskRunner& task)
    : bus_(bus), mailboxes_(mailboxes), teller_(teller), task_(task) {}

Status HistoryCollector::after_cycle() {
  const auto slave = task_.acyclic().mailboxes().news();
  if (!slave || mailboxes_[*slave].taken) return {};  // a long transfer goes on; the news stay
  MailboxHold hold(mailboxes_, task_.acyclic().mailbox(), std::span(&*slave, 1));
  if (auto status = hold.settle(bus_); !status) return status;
  return read(*slave);
}

Status HistoryCollector::read(std::size_t slave) {
  MailboxClient mailbox(bus_, mailboxes_[slave]);
  const auto told = task_.acyclic().mailboxes().told(slave);
  const auto history = read_diagnosis_history(mailbox, told);
  if (!history) {
    const auto& error = history.error();
    if (ends_everything(error)) return tl::unexpected(error);
    // No such object after all, or not now: the next poll finds it again.
    task_.acyclic().mailboxes().note_told(slave,
                                          error.code == ErrorCode::kSdoAbort ? std::nullopt : std::optional(told));
    return {};
  }
  for (const auto& [sub_index, message] : history->messages) {
    teller_.tell(bus_.clock().now(), static_cast<int>(slave),
                 events::DiagnosisTold{message.code, message.type, message.text_id, message.time_stamp});
  }
  task_.acyclic().mailboxes().note_told(slave, history->newest);
  return {};
}

}  // namespace syncline
