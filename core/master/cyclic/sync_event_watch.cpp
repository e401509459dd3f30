// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/sync_event_watch.h"

#include <algorithm>
#include <utility>

#include "channels/cycle_sample.h"
#include "channels/snapshot.h"
#include "config/command_data.h"
#include "config/frame_time.h"
#include "config/network_config.h"
#include "config/slave_config.h"
#include "dc/sync0_arrival.h"
#include "families/device_family.h"
#include "families/families.h"
#include "master/clocks/sync_watch.h"
#include "master/cyclic/cyclic_frame_set.h"
#include "master/exchange/slave_states.h"
#include "protocol/al_state.h"
#include "protocol/al_status_code.h"
#include "protocol/assign_activate.h"

namespace syncline {
namespace {

/// So long a slave that fell may be thought to be in OP: until the next sweep over all AL states.
constexpr Nanoseconds kStillInOp = 600 * kMillisecond;
/// What a slave counts while it finds into OP is no fault of the running bus; what makes it fall again is.
constexpr Nanoseconds kSettling = 100 * kMillisecond;

/// How much of the hold made the outputs late: nothing where they would not have come at their place anyway, because
/// nobody keeps the frames there.
Nanoseconds counting_hold(const dc::Sync0Grid& grid, Nanoseconds came, Nanoseconds held, Nanoseconds nominal_margin,
                          Nanoseconds cycle_time) {
  // A SYNC0 that comes every n-th cycle has n places in its period.
  const auto step = std::min(grid.period, cycle_time);
  const auto otherwise = dc::sync0_arrival(grid, came - held).margin % step;
  return held > 0 && otherwise < nominal_margin % step / 2 ? 0 : held;
}

bool in_op(const SlaveStatus& slave) {
  return slave.present && al_state_of(slave.al_status) == AlState::kOp && (slave.al_status & kAlErrorFlag) == 0;
}

}  // namespace

SyncEventWatch::SyncEventWatch(const NetworkConfig& config, Snapshot& snapshot, const SlaveStates& states,
                               const SyncWatch& sync)
    : config_(config), snapshot_(snapshot), states_(states), sync_(sync), place_(config.slaves.size(), kNone) {
  const auto& slaves = config.slaves;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    const auto& dc = slaves[i].dc;
    if (!dc || !slaves[i].send || !AssignActivate{dc->assign_activate}.sync0()) continue;
    const auto period = dc->cycle_time0 > 0 ? dc->cycle_time0 : config.cycle_time();
    place_[i] = slaves_.size();
    // Until it is read, the limit is what its start-up commands write, or what its family is delivered with.
    const auto limit = families::error_limit(slaves[i]).value_or(0);
    slaves_.push_back({.position = i,
                       .period = period,
                       .shift = dc->shift_time,
                       .wire = outputs_wire_time(config, i),
                       .task = outputs_task(config, i).value_or(0),
                       .account = {},
                       .before = {},
                       .limit = limit,
                       .told = {},
                       .in_op_since = {},
                       .at_limit_since = {}});
  }
}

SyncEventWatch::Slave* SyncEventWatch::find(std::size_t position) {
  if (position >= place_.size() || place_[position] == kNone) return nullptr;
  settle_all();
  auto& slave = slaves_[place_[position]];
  settle(slave);
  return &slave;
}

/// Where its SYNC0 comes, as it was read back when it was started.
dc::Sync0Grid SyncEventWatch::grid_of(const Slave& slave) const {
  const auto off = snapshot_.slaves[slave.position].evidence.sync0.off_ns;
  return {sync_.base() + slave.shift + off, slave.period};
}

void SyncEventWatch::end_settling(Slave& slave, Nanoseconds time) const {
  if (!slave.before || time - *slave.in_op_since < kSettling) return;
  // At its limit it may have fallen already, and nobody has seen that yet.
  if (slave.account->at_limit() && time - *slave.in_op_since < kSettling + kStillInOp) return;
  slave.account = slave.before;
  slave.account->entered_op(grid_of(slave));
  slave.before.reset();
}

/// Whoever is in OP still when it comes back tells itself what it missed meanwhile.
bool SyncEventWatch::follow_presence(Slave& slave) const {
  const auto& status = snapshot_.slaves[slave.position];
  if (!status.present) {
    slave.away = slave.in_op_since.has_value();
    return !slave.away;
  }
  if (!std::exchange(slave.away, false)) return true;
  slave.account->came_back();
  if (in_op(status)) slave.account->confirm_op();
  return true;
}

void SyncEventWatch::follow_state(Slave& slave, Nanoseconds time) {
  const bool op = in_op(snapshot_.slaves[slave.position]);
  if (!op && !slave.in_op_since) note_fall(slave);
  if (op == slave.in_op_since.has_value()) return;
  if (!op) {
    slave.in_op_since.reset();
    slave.before.reset();
    slave.account->left_op();
    note_fall(slave);
    publish(slave);
    return;
  }
  slave.in_op_since = time;
  slave.gave_up = slave.fallen = false;
  snapshot_.slaves[slave.position].sm2_missed.settling = true;
  if (!slave.account) slave.account.emplace(grid_of(slave));
  slave.account->set_limit(slave.limit);
  slave.before = slave.account;
  slave.account->entered_op(grid_of(slave));
}

/// It may fall before anybody has seen it in OP.
void SyncEventWatch::note_fall(Slave& slave) {
  const auto& status = snapshot_.slaves[slave.position];
  const bool fell = (status.al_status & kAlErrorFlag) != 0 && is_about_outputs(status.al_status_code);
  if (std::exchange(slave.fallen, fell) == fell || !fell) return;
  slave.gave_up = true;
  if (!slave.account) slave.account.emplace(grid_of(slave));
  slave.account->set_limit(slave.limit);
  explain_fall(slave);
}

/// Who gives up within a cycle or two has its counter read never, and perhaps what it takes only later.
void SyncEventWatch::explain_fall(Slave& slave) {
  if (!slave.gave_up || slave.limit == 0 || slave.need == 0) return;
  if (nominal_margin(slave) < slave.need) {
    slave.account->gave_up_late();
  } else if (!slave.account->gave_up_in_doubt()) {
    return;
  }
  slave.gave_up = false;
  publish(slave);
}

Nanoseconds SyncEventWatch::nominal_margin(const Slave& slave) const {
  const auto& status = snapshot_.slaves[slave.position];
  return dc::nominal_margin(snapshot_.dcm.set_value_ns, {slave.shift + status.evidence.sync0.off_ns, slave.period},
                            status.propagation_delay_ns, slave.wire);
}

Nanoseconds SyncEventWatch::room() {
  const auto changes = states_.slave_changes();
  const auto set_value = snapshot_.dcm.set_value_ns;
  if (!room_ || room_->changes != changes || room_->set_value != set_value) {
    room_ = {INT64_MAX, changes, set_value};
    for (const auto& slave : slaves_) room_->room = std::min(room_->room, room_of(slave));
  }
  return room_->room;
}

/// Frames come in each cycle, and SYNC0 perhaps in every n-th: the last one counts that is early enough. Who does not
/// say what it needs may need much of what it has, but hardly the last sixteenth of it.
Nanoseconds SyncEventWatch::room_of(const Slave& slave) const {
  constexpr Nanoseconds kLastPart = 16;
  const auto step = std::min(slave.period, config_.cycle_time());
  const auto thought = config_.slaves[slave.position].mailbox ? step / 2 : step / 4;
  const auto need = slave.need > 0 ? slave.need : thought;
  const auto margin = nominal_margin(slave) % step;
  const auto sooner = margin < need ? (need - margin + step - 1) / step * step : 0;
  const auto room = (margin + sooner < slave.period ? margin + sooner : margin) - need;
  return slave.need > 0 ? room : std::max(room, margin / kLastPart);
}

void SyncEventWatch::observe(CycleSample& sample, const Sent& frames) {
  if (!sync_.active()) return;
  const bool known = (sample.flags & CycleSample::kReferenceValid) != 0;
  const auto sent = sync_.reference_time_at(sample.send_time);
  const auto passed = known ? sample.reference_time : sent;
  // It may as well have been the way back that took longer: no longer than from the master to the reference clock.
  const auto held = std::clamp<Nanoseconds>(frames.held, 0, std::max<Nanoseconds>(passed - sent, 0));
  const Outputs outputs{sample.send_time, passed, frames.back, sample.skipped_cycles, held, frames.frames};
  if (!outputs.regular() || !pass_together(passed)) observe_each(outputs);
  if (sample.sm2_position < 0) tell(sample);
}

/// Closed form of looking at one slave after the other.
bool SyncEventWatch::pass_together(Nanoseconds passed) {
  if (!together_ || together_->changes != states_.slave_changes()) return false;
  if (passed < together_->begin || passed >= together_->end) return false;
  together_->begin += together_->period;
  together_->end += together_->period;
  ++together_->cycles;
  return true;
}

void SyncEventWatch::settle_all() {
  if (!together_) return;
  for (auto& slave : slaves_) {
    if (!slave.next) continue;
    *slave.next += together_->cycles * together_->period;
    slave.regular += together_->cycles;
  }
  together_.reset();
}

void SyncEventWatch::observe_each(const Outputs& outputs) {
  settle_all();
  bool all_regular = true;
  Together together;
  together.changes = states_.slave_changes();
  for (auto& slave : slaves_) {
    slave.left_out += outputs.skipped;
    if (slave.task > 0) all_regular = false;  // not all of them in each cycle
    if (!outputs.frames.is_due(slave.task)) continue;
    const auto left_out = std::exchange(slave.left_out, 0);
    const auto came =
        dc::outputs_arrival(outputs.passed, snapshot_.slaves[slave.position].propagation_delay_ns, slave.wire);
    const auto delay = came - outputs.passed;
    const bool back = outputs.frames.brought_outputs(slave.position);
    if (back && left_out == 0 && slave.next && observe_regular(slave, came)) {
      if (together.period == 0) together.period = slave.period;
      all_regular = all_regular && slave.period == together.period;
      together.begin = std::max(together.begin, *slave.next - delay);
      together.end = std::min(together.end, *slave.next - delay + slave.period - slave.need);
      continue;
    }
    settle(slave);
    if (!follow_presence(slave)) continue;
    // The gap that made a slave fall may be told in the same cycle as its fall: first the gap, then the state.
    const auto held = counting_hold(grid_of(slave), came, outputs.held, nominal_margin(slave), config_.cycle_time());
    const dc::SyncEventAccount::Cycle cycle{came, back, left_out, slave.need, held};
    const bool was_in_op = slave.in_op_since.has_value();
    if (was_in_op) slave.account->observe(cycle);
    follow_state(slave, outputs.send_time);
    if (!slave.in_op_since) continue;
    all_regular = false;
    if (!was_in_op) slave.account->observe(cycle);
    end_settling(slave, outputs.send_time);
    confirm(slave, outputs.send_time);
    if (slave.before) continue;
    publish(slave);
    if (!slave.at_limit_since) slave.next = slave.account->regular_until();
  }
  if (all_regular) together_ = together;
}

bool SyncEventWatch::observe_regular(Slave& slave, Nanoseconds time) const {
  const auto since = time - *slave.next;
  if (since < 0 || since >= slave.period - slave.need || !in_op(snapshot_.slaves[slave.position])) return false;
  *slave.next += slave.period;
  ++slave.regular;
  return true;
}

void SyncEventWatch::settle(Slave& slave) {
  if (slave.regular > 0) slave.account->pass_regular(std::exchange(slave.regular, 0));
  slave.next.reset();
}

void SyncEventWatch::tell(CycleSample& sample) {
  if (!news_) return;
  for (auto& slave : slaves_) {
    const auto& status = snapshot_.slaves[slave.position].sm2_missed;
    if (!status.known || slave.told == status.missed) continue;
    slave.told = status.missed;
    sample.sm2_position = static_cast<std::int16_t>(slave.position);
    sample.slave_sm2_missed = status.missed;
    sample.slave_sm2_integrator = status.integrator;
    return;
  }
  news_ = false;
}

void SyncEventWatch::confirm(Slave& slave, Nanoseconds time) {
  if (!slave.account->at_limit()) {
    slave.at_limit_since.reset();
  } else if (!slave.at_limit_since) {
    slave.at_limit_since = time;
  }
  if (!slave.at_limit_since || time - *slave.at_limit_since > kStillInOp) slave.account->confirm_op();
}

void SyncEventWatch::came_late(std::uint32_t cycles) {
  if (cycles == 0) return;
  for (auto& slave : slaves_) {
    if (slave.before) slave.before->came_late(cycles);
    if (!slave.account) continue;
    slave.account->came_late(cycles);
    if (!slave.before) publish(slave);
  }
}

void SyncEventWatch::read(std::size_t position, std::uint32_t counter) {
  auto* slave = find(position);
  if (slave == nullptr || !slave->account) return;
  if (slave->before) return;
  slave->account->read(counter);
  publish(*slave);
}

void SyncEventWatch::set_limit(std::size_t position, std::uint32_t limit) {
  auto* slave = find(position);
  if (slave == nullptr) return;
  slave->limit = limit;
  if (slave->before) slave->before->set_limit(limit);
  if (slave->account) slave->account->set_limit(limit);
  explain_fall(*slave);
}

void SyncEventWatch::set_calc_and_copy(std::size_t position, Nanoseconds time) {
  // With more than its period no outputs would ever be in time, and all would stand in doubt.
  auto* slave = find(position);
  if (slave == nullptr) return;
  slave->need = std::clamp<Nanoseconds>(time, 0, slave->period - 1);
  room_.reset();
  explain_fall(*slave);
}

void SyncEventWatch::publish(const Slave& slave) {
  auto& status = snapshot_.slaves[slave.position].sm2_missed;
  const auto& account = *slave.account;
  news_ = news_ || !status.known || status.missed != account.missed();
  status.known = true;
  status.settling = false;
  status.missed = account.missed();
  status.computed = account.computed();
  status.at_least = account.at_least();
  status.by_cause = account.by_cause();
  status.integrator = account.integrator();
  status.integrator_highest = account.integrator_highest();
  status.limit = slave.limit;
}

}  // namespace syncline
