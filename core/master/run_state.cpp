// SPDX-License-Identifier: Apache-2.0
#include "master/run_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "config/families/families.h"
#include "link/link.h"

namespace syncline {
namespace {

/// BOOT stands beside the ladder INIT, PREOP, SAFEOP, OP, below PREOP.
int rank(AlState state) {
  switch (state) {
    case AlState::kNone: return 0;
    case AlState::kInit: return 1;
    case AlState::kBoot: return 2;
    case AlState::kPreop: return 3;
    case AlState::kSafeop: return 4;
    case AlState::kOp: return 5;
  }
  return 0;
}

}  // namespace

RunState::RunState(const NetworkConfig& config, MasterChannels& channels)
    : mailbox_counters(config.slaves.size()), mailbox_full(config.slaves.size()), config_(config), channels_(channels) {
  snapshot.cycle_time = config.cycle_time();
  snapshot.slaves.resize(config.slaves.size());
}

/// Notifications of the clocks can be switched off.
bool RunState::told(EventKind kind) const {
  const auto& notifications = config_.dc.notifications;
  switch (kind) {
    case EventKind::kReferenceClock: return notifications.reference_clock;
    case EventKind::kDcSlaveSync: return notifications.slaves_in_sync;
    case EventKind::kDcInitialised: return notifications.dc_status;
    case EventKind::kDcmSync: return notifications.dcm_in_sync;
    default: return true;
  }
}

void RunState::event(EventKind kind, Nanoseconds time, int slave, std::int64_t a, std::int64_t b, std::int64_t c) {
  if (!told(kind)) return;
  Event event;
  event.kind = kind;
  event.time = time;
  event.slave = slave;
  event.a = a;
  event.b = b;
  event.c = c;
  channels_.events.push(std::move(event));
}

void RunState::error(const Error& error, Nanoseconds time) {
  Event event;
  event.kind = EventKind::kError;
  event.time = time;
  event.error = error;
  channels_.events.push(std::move(event));
}

void RunState::emergency(std::size_t slave, const coe::Emergency& emergency, Nanoseconds time) {
  std::int64_t data = 0;
  for (std::size_t i = emergency.data.size(); i-- > 0;) data = data << 8 | emergency.data[i];
  Event event;
  event.kind = EventKind::kEmergency;
  event.time = time;
  event.slave = static_cast<int>(slave);
  event.a = emergency.error_code;
  event.b = emergency.error_register;
  event.c = data;
  const auto* alarm = families::find_alarm(config_.slaves[slave].identity, emergency.error_code, static_cast<std::uint64_t>(data));
  if (alarm != nullptr) event.text = alarm->name;  // short enough to need no memory
  channels_.events.push(std::move(event));
}

bool RunState::hot_connect(std::size_t slave, int what, Nanoseconds time) {
  const auto head = config_.hot_connect_head(slave);
  if (!head) return false;
  Event event;
  event.kind = EventKind::kHotConnect;
  event.time = time;
  event.slave = static_cast<int>(slave);
  event.a = what;
  event.text = config_.slaves[*head].hot_connect->group;
  channels_.events.push(std::move(event));
  return true;
}

MailboxPort RunState::port_of(std::size_t slave) const {
  auto port = mailbox_port(config_.slaves[slave]);
  port.full = [this, slave] { return mailbox_full[slave]; };
  return port;
}

void RunState::set_al_status(std::size_t slave, std::uint16_t status, std::uint16_t code, Nanoseconds time) {
  auto& known = snapshot.slaves[slave];
  const auto old = std::exchange(known.al_status, status);
  const auto old_code = std::exchange(known.al_status_code, code);
  const auto position = static_cast<int>(slave);
  if (al_state_of(old) != al_state_of(status)) {
    event(EventKind::kStateChanged, time, position, old & 0x0F, status & 0x0F);
  }
  const bool failed = (status & kAlErrorFlag) != 0;
  const bool news = (old & kAlErrorFlag) == 0 || old_code != code || al_state_of(old) != al_state_of(status);
  if (failed && news) event(EventKind::kAlStatusError, time, position, status, code);
}

void RunState::set_present(std::size_t slave, bool present, Nanoseconds time) {
  auto& known = snapshot.slaves[slave];
  if (std::exchange(known.present, present) == present) return;
  const bool told = hot_connect(slave, present ? 1 : 0, time);
  if (!told) event(present ? EventKind::kSlaveFound : EventKind::kSlaveLost, time, static_cast<int>(slave));
  known.absent_since = present ? 0 : time;
  if (!present) {
    // Whatever it was in, nobody knows what it is in now. What was counted stays: it is the evidence.
    known.al_status = known.al_status_code = 0;
    known.deviation_valid = false;
  }
}

void RunState::note_link(bool up, Nanoseconds time, const Link& link) {
  snapshot.link_up = up;
  if (up != link_away_since_.has_value()) return;  // nothing new
  Event event;
  event.kind = EventKind::kLink;
  event.time = time;
  event.a = up ? 1 : 0;
  event.b = up ? time - *link_away_since_ : 0;
  event.text = link.describe().name;
  channels_.events.push(std::move(event));
  if (up) {
    link_away_since_.reset();
  } else {
    link_away_since_ = time;
    ++link_outages_;
  }
}

bool RunState::somebody_absent() const {
  return !std::ranges::all_of(snapshot.slaves, &SlaveStatus::present);
}

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
    if (slave.present && (lowest == AlState::kNone || rank(state) < rank(lowest))) lowest = state;
  }
  return lowest;
}

void RunState::update_master_state(Nanoseconds time) {
  const auto state = complete() ? lowest_state() : AlState::kNone;
  const auto old = std::exchange(snapshot.state, state);
  if (old != state) {
    event(EventKind::kStateChanged, time, -1, static_cast<std::int64_t>(old), static_cast<std::int64_t>(state));
  }
}

std::string RunState::slave_name(std::size_t slave) const {
  const auto& name = config_.slaves[slave].name;
  return name.empty() ? fmt::format("slave {}", slave) : fmt::format("slave {} ({})", slave, name);
}

}  // namespace syncline
