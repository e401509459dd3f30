// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "config/mailbox_description.h"
#include "protocol/mailbox.h"
#include "sim/mailbox/aoe_server.h"
#include "sim/mailbox/eoe_server.h"
#include "sim/mailbox/file_server.h"
#include "sim/mailbox/information_server.h"
#include "sim/mailbox/sdo_server.h"
#include "sim/mailbox/soe_server.h"

namespace syncline::sim {

/// The slave's side of the mailbox: takes requests, keeps answers and emergencies until the master fetches
/// them, and can give the last one again (ETG.1000.6, 5.4). Protocols that the device does not have are
/// answered with a mailbox error.
class MailboxServer {
 public:
  MailboxServer(ObjectDictionary& dictionary, const MailboxDescription& mailbox, std::uint32_t foe_password);

  /// One message as it stands in the receive mailbox; `reply_size` of the send mailbox.
  void receive(std::span<const std::uint8_t> bytes, std::size_t reply_size, bool in_preop);
  /// Sent when the send mailbox is free, before answers that are not under way yet. At most a few wait.
  void queue_emergency(const coe::Emergency& emergency);
  /// The next message for the send mailbox, padded to its size; nothing when none waits.
  [[nodiscard]] std::optional<std::vector<std::uint8_t>> next(std::size_t reply_size);
  /// The message that the master has fetched last and did not get; empty when there was none. `loaded`: another
  /// one is in the send mailbox already; it waits again.
  [[nodiscard]] const std::vector<std::uint8_t>& repeat(bool loaded);
  [[nodiscard]] bool waiting() const { return !queue_.empty(); }
  void reset();

  [[nodiscard]] FileServer& files() { return files_; }

 private:
  void receive_coe(const MailboxMessage& request, std::size_t reply_size, bool in_preop);
  void receive_information(const MailboxMessage& request, std::size_t reply_size);
  void receive_foe(const MailboxMessage& request, std::size_t reply_size);
  void queue(MailboxType type, std::vector<std::uint8_t> data);
  void queue_answer(MailboxType type, std::vector<std::uint8_t> data);  // nothing, when there is none
  void queue_error(MailboxErrorDetail detail);

  MailboxDescription mailbox_;
  SdoServer sdo_;
  InformationServer information_;
  FileServer files_;
  EoeServer eoe_;
  SoeServer soe_;
  AoeServer aoe_;
  std::deque<std::vector<std::uint8_t>> queue_;
  std::vector<std::uint8_t> last_, before_last_;  // as they were loaded
  std::uint8_t last_request_ = 0, counter_ = 0;
};

}  // namespace syncline::sim
