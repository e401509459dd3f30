// SPDX-License-Identifier: Apache-2.0
#include "master/exchange/slave_states.h"

#include <algorithm>
#include <utility>

#include "channels/snapshot.h"
#include "config/network_config.h"
#include "master/exchange/event_teller.h"
#include "master/exchange/slave_mailbox.h"
#include "protocol/al_state_rank.h"

namespace syncline {

SlaveStates::SlaveStates(const NetworkConfig& config, Snapshot& snapshot, EventTeller& teller,
                         std::span<SlaveMailbox> mailboxes)
    : config_(config), snapshot_(snapshot), teller_(teller), mailboxes_(mailboxes), losses_(config.slaves.size()) {}

/// Mailboxes count anew from INIT and BOOT on; in BOOT they stand elsewhere.
void SlaveStates::place_mailbox(std::size_t slave, AlState state) {
  auto& mailbox = mailboxes_[slave];
  if (state == AlState::kInit || state == AlState::kBoot) mailbox.restart();
  const auto& config = config_.slaves[slave].mailbox;
  if (!config) return;
  const bool boot = state == AlState::kBoot;
  mailbox.port.send = boot ? config->bootstrap_send.value_or(config->send) : config->send;
  mailbox.port.receive = boot ? config->bootstrap_receive.value_or(config->receive) : config->receive;
}

void SlaveStates::set_al_status(std::size_t slave, std::uint16_t status, std::uint16_t code, Nanoseconds time) {
  auto& known = snapshot_.slaves[slave];
  const auto old = std::exchange(known.al_status, status);
  const auto old_code = std::exchange(known.al_status_code, code);
  known.al_status_time = time;
  const auto position = static_cast<int>(slave);
  const auto state = al_state_of(status);
  if (status != old) note_slave_change();
  if (state != al_state_of(old)) place_mailbox(slave, state);
  if (al_state_of(old) != al_state_of(status)) {
    teller_.tell(time, position, events::StateChanged{al_state_of(old), al_state_of(status)});
  }
  const bool failed = (status & kAlErrorFlag) != 0;
  // From BOOT a slave goes by itself, with new firmware.
  const bool operated = has_process_data_communication(al_state_of(old));
  if (watched_for_others_ && operated && !failed && al_state_rank(state) < al_state_rank(al_state_of(old)))
    teller_.tell(time, position, events::LeftUnasked{al_state_of(old), state});
  const bool news = (old & kAlErrorFlag) == 0 || old_code != code || al_state_of(old) != al_state_of(status);
  if (failed && news) teller_.tell(time, position, events::AlStatusError{status, code});
}

void SlaveStates::tell_presence(std::size_t slave, bool present, Nanoseconds time) {
  using What = events::HotConnect::What;
  if (teller_.hot_connect(slave, present ? What::kConnected : What::kDisconnected, time)) return;
  const auto position = static_cast<int>(slave);
  if (present) {
    teller_.tell(time, position, events::SlaveFound{});
  } else {
    teller_.tell(time, position, events::SlaveLost{});
  }
}

void SlaveStates::set_present(std::size_t slave, bool present, Nanoseconds time) {
  auto& known = snapshot_.slaves[slave];
  if (std::exchange(known.present, present) == present) return;
  note_slave_change();
  tell_presence(slave, present, time);
  known.absent_since = present ? 0 : time;
  known.moved = time;
  if (!present) {
    ++losses_[slave];
    // Whatever it was in, nobody knows what it is in now. What was counted stays: it is the evidence.
    known.al_status = known.al_status_code = 0;
    known.al_status_time = 0;
    known.deviation_valid = false;
    mailboxes_[slave].restart();
  }
}

bool SlaveStates::somebody_absent() const { return !std::ranges::all_of(snapshot_.slaves, &SlaveStatus::present); }

bool SlaveStates::somebody_present() const { return std::ranges::any_of(snapshot_.slaves, &SlaveStatus::present); }

bool SlaveStates::complete() const {
  for (std::size_t i = 0; i < snapshot_.slaves.size(); ++i) {
    if (!snapshot_.slaves[i].present && !config_.hot_connect_head(i)) return false;
  }
  return true;
}

AlState SlaveStates::lowest_state() const {
  auto lowest = AlState::kNone;
  for (const auto& slave : snapshot_.slaves) {
    const auto state = al_state_of(slave.al_status);
    if (slave.present && (lowest == AlState::kNone || al_state_rank(state) < al_state_rank(lowest))) lowest = state;
  }
  return lowest;
}

void SlaveStates::update_master_state(Nanoseconds time) {
  const auto state = complete() ? lowest_state() : AlState::kNone;
  const auto old = std::exchange(snapshot_.state, state);
  if (old != state) teller_.tell(time, -1, events::StateChanged{old, state});
}

}  // namespace syncline
