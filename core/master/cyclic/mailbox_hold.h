// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "master/cyclic/cyclic_mailbox.h"
#include "master/exchange/bus.h"
#include "master/exchange/slave_mailbox.h"

namespace syncline {

/// As long as it lives these slaves' mailboxes are somebody's alone, and the master's own work in mailboxes rests:
/// nothing new is begun in them. May be nested.
class MailboxHold {
 public:
  MailboxHold(std::span<SlaveMailbox> mailboxes, CyclicMailbox& watch, std::span<const std::size_t> slaves)
      : mailboxes_(mailboxes), watch_(watch), slaves_(slaves.begin(), slaves.end()) {
    watch_.hold();
    for (const auto slave : slaves_) ++mailboxes_[slave].reserved;
  }
  ~MailboxHold() {
    watch_.release();
    for (const auto slave : slaves_) --mailboxes_[slave].reserved;
  }
  MailboxHold(const MailboxHold&) = delete;
  MailboxHold& operator=(const MailboxHold&) = delete;

  /// Cycles until what is under way there has ended.
  Status settle(Bus& bus) {
    const auto taken = [this](std::size_t slave) { return mailboxes_[slave].taken; };
    while (bus.cyclic() && (!watch_.idle() || std::ranges::any_of(slaves_, taken))) {
      if (auto status = bus.wait_a_little(); !status) return status;
    }
    return {};
  }

 private:
  std::span<SlaveMailbox> mailboxes_;
  CyclicMailbox& watch_;
  std::vector<std::size_t> slaves_;
};

}  // namespace syncline
