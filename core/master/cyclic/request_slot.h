// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "channels/slave_request.h"
#include "master/exchange/register_work.h"
#include "master/exchange/slave_mailbox.h"
#include "master/mailbox/foe_work.h"
#include "master/mailbox/sdo_work.h"
#include "master/sii/sii_work.h"

namespace syncline {

struct NetworkConfig;
struct RequestTicket;

/// What a request needs for itself while it is carried out.
enum class RequestPlace : std::uint8_t { kMailbox, kEeprom, kRegisters, kState };
[[nodiscard]] RequestPlace place_of(const SlaveRequest& request);

/// Carries out one request of somebody outside at a time: chooses the work for it and brings its result back into the
/// ticket. Allocates at construction alone.
class RequestSlot {
 public:
  RequestSlot(const NetworkConfig& config, std::span<SlaveMailbox> mailboxes);
  RequestSlot(RequestSlot&&) = delete;

  /// Not of RequestPlace::kState. `slave`: for registers and EEPROM.
  void begin(RequestTicket& ticket, const SlaveAddress& slave);
  /// Null when nothing is under way.
  [[nodiscard]] RequestTicket* ticket() const { return ticket_; }
  [[nodiscard]] SlaveWork& work() { return *work_; }
  /// What was asked for is not wanted any more.
  void cancel();
  /// It cannot go on; over at once.
  void give_up(const BriefError& why);
  /// After its work is over: the ticket with its result.
  RequestTicket& finish();

 private:
  std::span<SlaveMailbox> mailboxes_;
  SdoWork sdo_;
  FoeWork foe_;
  RegisterWork registers_;
  SiiWork eeprom_;
  SlaveWork* work_ = nullptr;
  RequestTicket* ticket_ = nullptr;
};

}  // namespace syncline
