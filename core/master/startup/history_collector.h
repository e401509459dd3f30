// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "master/exchange/slave_mailbox.h"
#include "support/result.h"

namespace syncline {

class Bus;
class CyclicTaskRunner;
class EventTeller;

/// Reads what is new in the slaves' diagnosis histories and tells each message by an event, oldest first. Changes
/// nothing in the slaves: their messages stay unacknowledged. Messages that a ring lost before it was read (as many
/// as it has places, within MailboxWatch::kHistoryPeriod) are not told.
class HistoryCollector {
 public:
  HistoryCollector(Bus& bus, std::span<SlaveMailbox> mailboxes, EventTeller& teller, CyclicTaskRunner& task);

  /// After a bus cycle; does nothing as long as there is no news. Cycles go on while it reads. Bus errors;
  /// kCancelled when a command of the user came in between (then it is read the next time).
  Status after_cycle();

 private:
  Status read(std::size_t slave);

  Bus& bus_;
  std::span<SlaveMailbox> mailboxes_;
  EventTeller& teller_;
  CyclicTaskRunner& task_;
};

}  // namespace syncline
