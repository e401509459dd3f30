// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "master/exchange/slave_address.h"
#include "master/mailbox/mailbox_client.h"
#include "protocol/al_state.h"
#include "protocol/coe.h"
#include "protocol/sync_manager.h"

namespace syncline {

/// One slave on a bus that no configuration of ours runs: reads how it is, leads it through its states, gives access
/// to its mailbox, and leaves it as it was found. Other slaves are not touched.
class SlaveVisit {
 public:
  SlaveVisit(Bus& bus, std::uint16_t position);
  SlaveVisit(const SlaveVisit&) = delete;
  SlaveVisit& operator=(const SlaveVisit&) = delete;

  /// Reads AL status, station address and mailbox. kNoResponse when there is no such slave.
  Status look();
  [[nodiscard]] AlState found() const { return al_state_of(found_status_); }
  [[nodiscard]] AlState state() const { return al_state_of(status_); }
  [[nodiscard]] const std::string& name() const { return name_; }

  /// Leads the slave step by step, with its mailbox set up from the EEPROM on the way out of INIT, and acknowledges
  /// an error first. kAlState with the code of the step that it refuses, kAlTimeout, kSii.
  Status lead_to(AlState target);
  /// Makes the mailbox usable: leads a slave in INIT to PREOP. kNotSupported when the slave has no mailbox.
  Status open_mailbox();
  /// After open_mailbox().
  [[nodiscard]] MailboxClient& mailbox() { return *mailbox_; }
  void set_emergency_handler(std::function<void(const coe::Emergency&)> handler) {
    mailbox_of_slave_.on_emergency = [handler = std::move(handler)](const auto& emergency, Nanoseconds) {
      if (handler) handler(emergency);
    };
  }

  /// Back to the state, SyncManagers and station address that look() saw.
  Status leave();

 private:
  static constexpr std::size_t kMailboxManagers = 2 * SyncManager::kSize;
  Status read(std::uint16_t ado, std::span<std::uint8_t> bytes);
  Status write(std::uint16_t ado, std::span<std::uint8_t> bytes);
  Status read_status();
  Status step_to(AlState target);
  Status acknowledge();
  Status set_up_mailbox(bool bootstrap);
  [[nodiscard]] bool had_mailbox() const;
  Status set_managers(std::array<std::uint8_t, kMailboxManagers>& managers);
  Status take_station_address();
  Error refused(AlState target, ErrorCode code);

  Bus& bus_;
  SlaveAddress slave_;
  std::string name_;
  std::uint16_t found_status_ = 0, status_ = 0, status_code_ = 0;
  std::uint16_t found_station_ = 0, station_ = 0;
  std::array<std::uint8_t, kMailboxManagers> found_managers_{};
  bool managers_changed_ = false, leaving_ = false;
  SlaveMailbox mailbox_of_slave_;
  std::optional<MailboxClient> mailbox_;
};

}  // namespace syncline
