// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "master/exchange/slave_batch.h"
#include "master/mailbox/mailbox_transfer.h"

namespace syncline {

/// Takes one message that nobody asked for out of a slave's mailbox; emergencies are handed on, others dropped.
class FetchWork final : public SlaveWork {
 public:
  FetchWork() = default;
  explicit FetchWork(SlaveMailbox& mailbox) { use(mailbox); }

  void use(SlaveMailbox& mailbox) {
    transfer_.use(mailbox);
    begun_ = false;
  }
  void set_response_timeout(Nanoseconds timeout) { transfer_.set_response_timeout(timeout); }
  void give_up() {
    begun_ = true;
    transfer_.give_up();
  }

  Datagram* next(Nanoseconds now) override {
    if (!std::exchange(begun_, true)) transfer_.fetch(now);
    return transfer_.next(now);
  }
  void take(Nanoseconds now) override { transfer_.take(now); }
  [[nodiscard]] bool over() const override { return begun_ && transfer_.over(); }
  [[nodiscard]] Status result() const override {
    if (!transfer_.failure()) return {};
    return fail(transfer_.failure()->about(transfer_.mailbox()->port.name));
  }
  [[nodiscard]] bool in_a_hurry() const override { return transfer_.in_a_hurry(); }
  /// There was a message.
  [[nodiscard]] bool found() const { return over() && !transfer_.failure() && !transfer_.empty(); }
  [[nodiscard]] bool emergency() const { return transfer_.emergency(); }

 private:
  MailboxTransfer transfer_;
  bool begun_ = false;
};

}  // namespace syncline
