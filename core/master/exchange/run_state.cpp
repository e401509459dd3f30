// SPDX-License-Identifier: Apache-2.0
#include "master/exchange/run_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "channels/master_channels.h"
#include "protocol/al_state_rank.h"
#include "support/overloaded.h"

namespace syncline {

RunState::RunState(const NetworkConfig& config, MasterChannels& channels, SharedText adapter)
    : mailboxes(config.slaves.size()),
      config_(config),
      channels_(channels),
      adapter_(std::move(adapter)),
      losses_(config.slaves.size()) {
  for (const auto& slave : config.slaves) {
    groups_.push_back(slave.hot_connect ? SharedText(slave.hot_connect->group) : SharedText());
  }
  for (std::size_t slave = 0; slave < mailboxes.size(); ++slave) {
    auto& mailbox = mailboxes[slave];
    mailbox.port = mailbox_port(config.slaves[slave]);
    mailbox.port.full = [&mailbox] { return mailbox.full; };
    mailbox.on_emergency = [this, slave](const coe::Emergency& what, Nanoseconds now) { emergency(slave, what, now); };
  }
  snapshot.cycle_time = config.cycle_time();
  snapshot.slaves.resize(config.slaves.size());
}

/// Notifications of the clocks can be switched off.
bool RunState::told(const EventDetails& what) const {
  const auto& notifications = config_.dc.notifications;
  return std::visit(Overloaded{[&](const events::ReferenceClockChanged&) { return notifications.reference_clock; },
                               [&](const events::SlavesInSync&) { return notifications.slaves_in_sync; },
                               [&](const events::SlavesOutOfSync&) { return notifications.slaves_in_sync; },
                               [&](const events::SlavesNotMonitored&) { return notifications.slaves_in_sync; },
                               [&](const events::SlavesSyncUnknown&) { return notifications.slaves_in_sync; },
                               [&](const events::DcInitialised&) { return notifications.dc_status; },
                               [&](const events::MasterInSync&) { return notifications.dcm_in_sync; },
                               [&](const events::MasterOutOfSync&) { return notifications.dcm_in_sync; },
                               [](const auto&) { return true; }},
                    what);
}

void RunState::event(Nanoseconds time, int slave, EventDetails what) {
  if (told(what)) channels_.events.push({time, slave, std::move(what)});
}

void RunState::error(const Error& error, Nanoseconds time) { event(time, -1, events::Failure{error}); }

void RunState::emergency(std::size_t slave, const coe::Emergency& emergency, Nanoseconds time) {
  event(time, static_cast<int>(slave),
        events::Emergency{emergency.error_code, emergency.error_register, emergency.data,
                          config_.slaves[slave].identity});
}

bool RunState::hot_connect(std::size_t slave, events::HotConnect::What what, Nanoseconds time) {
  const auto head = config_.hot_connect_head(slave);
  if (!head) return false;
  event(time, static_cast<int>(slave), events::HotConnect{what, groups_[*head]});
  return true;
}

/// Mailboxes count anew from INIT and BOOT on; in BOOT they stand elsewhere.
void RunState::place_mailbox(std::size_t slave, AlState state) {
  auto& mailbox = mailboxes[slave];
  if (state == AlState::kInit || state == AlState::kBoot) mailbox.restart();
  const auto& config = config_.slaves[slave].mailbox;
  if (!config) return;
  const bool boot = state == AlState::kBoot;
  mailbox.port.send = boot ? config->bootstrap_send.value_or(config->send) : config->send;
  mailbox.port.receive = boot ? config->bootstrap_receive.value_or(config->receive) : config->receive;
}

void RunState::set_al_status(std::size_t slave, std::uint16_t status, std::uint16_t code, Nanoseconds time) {
  auto& known = snapshot.slaves[slave];
  const auto old = std::exchange(known.al_status, status);
  const auto old_code = std::exchange(known.al_status_code, code);
  known.al_status_time = time;
  const auto position = static_cast<int>(slave);
  const auto state = al_state_of(status);
  if (status != old) note_slave_change();
  if (state != al_state_of(old)) place_mailbox(slave, state);
  if (al_state_of(old) != al_state_of(status)) {
    event(time, position, events::StateChanged{al_state_of(old), al_state_of(status)});
  }
  const bool failed = (status & kAlErrorFlag) != 0;
  // From BOOT a slave goes by itself, with new firmware.
  const bool operated = al_state_of(old) == AlState::kSafeop || al_state_of(old) == AlState::kOp;
  if (watched_for_others_ && operated && !failed && al_state_rank(state) < al_state_rank(al_state_of(old)))
    event(time, position, events::LeftUnasked{al_state_of(old), state});
  const bool news = (old & kAlErrorFlag) == 0 || old_code != code || al_state_of(old) != al_state_of(status);
  if (failed && news) event(time, position, events::AlStatusError{status, code});
}

void RunState::set_present(std::size_t slave, bool present, Nanoseconds time) {
  auto& known = snapshot.slaves[slave];
  if (std::exchange(known.present, present) == present) return;
  note_slave_change();
  using What = events::HotConnect::What;
  const bool told = hot_connect(slave, present ? What::kConnected : What::kDisconnected, time);
  if (!told && present) event(time, static_cast<int>(slave), events::SlaveFound{});
  if (!told && !present) event(time, static_cast<int>(slave), events::SlaveLost{});
  known.absent_since = present ? 0 : time;
  known.moved = time;
  if (!present) {
    ++losses_[slave];
    // Whatever it was in, nobody knows what it is in now. What was counted stays: it is the evidence.
    known.al_status = known.al_status_code = 0;
    known.al_status_time = 0;
    known.deviation_valid = false;
    mailboxes[slave].restart();
  }
}

void RunState::note_link(bool up, Nanoseconds time) {
  snapshot.link_up = up;
  if (up != link_away_since_.has_value()) return;  // nothing new
  if (up) {
    event(time, -1, events::LinkUp{adapter_, time - *link_away_since_});
    link_away_since_.reset();
  } else {
    event(time, -1, events::LinkDown{adapter_});
    link_away_since_ = time;
    ++link_outages_;
  }
}

bool RunState::somebody_absent() const { return !std::ranges::all_of(snapshot.slaves, &SlaveStatus::present); }

bool RunState::somebody_present() const { return std::ranges::any_of(snapshot.slaves, &SlaveStatus::present); }

bool RunState::complete() const {
  for (std::size_t i = 0; i < snapshot.slaves.size(); ++i) {
    if (!snapshot.slaves[i].present && !config_.hot_connect_head(i)) return false;
  }
  return true;
}

AlState RunState::lowest_state() const {
  auto lowest = AlState::kNone;
  for (const auto& slave : snapshot.slaves) {
    const auto state = al_state_of(slave.al_status);
    if (slave.present && (lowest == AlState::kNone || al_state_rank(state) < al_state_rank(lowest))) lowest = state;
  }
  return lowest;
}

void RunState::update_master_state(Nanoseconds time) {
  const auto state = complete() ? lowest_state() : AlState::kNone;
  const auto old = std::exchange(snapshot.state, state);
  if (old != state) event(time, -1, events::StateChanged{old, state});
}

std::string RunState::slave_name(std::size_t slave) const {
  const auto& name = config_.slaves[slave].name;
  return name.empty() ? fmt::format("slave {}", slave) : fmt::format("slave {} ({})", slave, name);
}

}  // namespace syncline
