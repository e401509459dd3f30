// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "master/exchange/bus.h"
#include "master/exchange/slave_batch.h"
#include "master/exchange/slave_mailbox.h"

namespace syncline {

/// A slave's mailbox for those who wait: gives the clients of its protocols (CoE, FoE) the bus and the mailbox, and
/// runs what they ask to its end. One request at a time.
class MailboxClient {
 public:
  MailboxClient(Bus& bus, SlaveMailbox& mailbox) : bus_(bus), mailbox_(mailbox) {}

  /// A work on mailbox(): to its end, with this client's patience.
  template <class Work>
  Status run(Work& work) {
    if (response_timeout_) work.set_response_timeout(*response_timeout_);
    return run_to_end(bus_, work);
  }
  /// Takes what lies in the mailbox and hands emergencies on; returns at once when it is empty.
  Status collect();

  [[nodiscard]] Bus& bus() { return bus_; }
  [[nodiscard]] SlaveMailbox& mailbox() { return mailbox_; }
  [[nodiscard]] const MailboxPort& port() const { return mailbox_.port; }
  void set_response_timeout(Nanoseconds timeout) { response_timeout_ = timeout; }

 private:
  Bus& bus_;
  SlaveMailbox& mailbox_;
  std::optional<Nanoseconds> response_timeout_;
};

}  // namespace syncline
