// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "master/exchange/bus.h"
#include "master/mailbox/mailbox_transfer.h"
#include "protocol/coe.h"

namespace syncline {

/// A slave's mailbox in blocking style, shared by the clients of its protocols (CoE, FoE): owns the order of
/// requests and hands what comes unasked to whom it concerns. One request at a time.
class MailboxClient {
 public:
  using EmergencyHandler = std::function<void(const coe::Emergency&)>;

  /// `counter`: the slave's mailbox counter, which outlives the client.
  MailboxClient(Bus& bus, MailboxPort port, std::uint8_t& counter, EmergencyHandler on_emergency = {});

  /// Sends a message and returns the data of the next one of the same protocol. Emergencies in between are handed
  /// on, other protocols' messages are dropped. kMailboxTimeout; kMailboxProtocol with the words of a mailbox error.
  Result<std::vector<std::uint8_t>> ask(MailboxType type, std::span<const std::uint8_t> data);
  /// A further message: of an answer in parts with new patience, or because the last one was no answer.
  Result<std::vector<std::uint8_t>> receive(MailboxType type);
  Result<std::vector<std::uint8_t>> receive_instead(MailboxType type);
  /// What needs no answer: an abort.
  Status tell(MailboxType type, std::span<const std::uint8_t> data);
  /// Takes what lies in the mailbox and hands emergencies on; returns at once when it is empty.
  Status collect();

  [[nodiscard]] Bus& bus() { return bus_; }
  [[nodiscard]] const MailboxPort& port() const { return transfer_.port(); }
  void set_response_timeout(Nanoseconds timeout) { transfer_.set_response_timeout(timeout); }

 private:
  Status run();
  Result<std::vector<std::uint8_t>> answer(MailboxType type);

  Bus& bus_;
  MailboxTransfer transfer_;
  EmergencyHandler on_emergency_;
};

/// The emergency in a mailbox message, if it is one.
[[nodiscard]] std::optional<coe::Emergency> emergency_in(const MailboxMessage& message);
/// kMailboxProtocol with the words of a mailbox error reply.
[[nodiscard]] Error mailbox_error(const std::string& subject, const MailboxMessage& message);

}  // namespace syncline
