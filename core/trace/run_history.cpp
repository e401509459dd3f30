// SPDX-License-Identifier: Apache-2.0
#include "trace/run_history.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <variant>

#include "channels/cycle_sample.h"
#include "channels/event.h"
#include "channels/slave_evidence.h"
#include "channels/snapshot.h"
#include "config/network_config.h"
#include "dc/clock_registers.h"
#include "dc/sync0_arrival.h"
#include "protocol/system_time_difference.h"

namespace syncline {
namespace {

constexpr std::size_t kMostLosses = 64;

bool in_op(const CycleSample& sample) { return sample.master_state == static_cast<std::uint8_t>(AlState::kOp); }

/// In SAFEOP too: a slave that fell takes the master's state down with it, and the frames are as late as before.
bool is_cyclic(const CycleSample& sample) {
  return in_op(sample) || sample.master_state == static_cast<std::uint8_t>(AlState::kSafeop);
}

}  // namespace

// ---- spells -------------------------------------------------------------------------------------

void Spells::note(Nanoseconds time, std::uint64_t count, std::int64_t size, Nanoseconds from) {
  if (from == 0) from = time;
  const bool same = !spells_.empty() && from - spells_.back().to <= kGap;
  if (!same && spells_.size() < kMost) spells_.push_back({from, time, 0, 0});
  auto& spell = spells_.back();
  spell.to = std::max(spell.to, time);
  spell.count += count;
  spell.largest = std::max(spell.largest, size);
  count_ += count;
  largest_ = std::max(largest_, size);
}

void Spells::take_back(std::uint64_t count) {
  for (auto spell = spells_.rbegin(); spell != spells_.rend() && count > 0; ++spell) {
    const auto part = std::min(spell->count, count);
    spell->count -= part;
    count_ -= part;
    count -= part;
  }
}

bool Spells::near(const Spell& spell, Nanoseconds margin) const {
  return std::ranges::any_of(
      spells_, [&](const Spell& mine) { return mine.from <= spell.to + margin && spell.from <= mine.to + margin; });
}

/// More than any schedule that is in sync is away from its place.
constexpr Nanoseconds kOffItsGrid = 20 * kMicrosecond;

// ---- samples ------------------------------------------------------------------------------------

HistoryRecorder::HistoryRecorder(const NetworkConfig& config)
    : limit_ns_(sync_window_limit_ns(config.dc.sync_window.exponent)),
      cycle_(config.cycle_time()),
      counts_(config.slaves.size()),
      missed_(config.slaves.size()) {
  history_.slaves.resize(config.slaves.size());
}

void HistoryRecorder::add(std::span<const CycleSample> samples) {
  for (const auto& sample : samples) add(sample);
}

void HistoryRecorder::add(const CycleSample& sample) {
  history_.end = sample.send_time;
  const auto before = std::exchange(last_send_, sample.send_time);
  if (!history_.reached_op && in_op(sample)) {
    history_.reached_op = true;
    history_.op_reached = sample.send_time;
  }
  history_.operated = history_.operated || history_.reached_op;
  if ((sample.flags & CycleSample::kFrameLost) != 0) {
    history_.lost_frames.note(sample.send_time, std::max<std::uint16_t>(1, sample.frames_lost));
  }
  if ((sample.flags & CycleSample::kFrameLate) != 0) history_.late_frames.note(sample.send_time, 1, sample.late_by_ns);
  if (history_.operated)
    history_.largest_stamp_doubt = std::max<Nanoseconds>(history_.largest_stamp_doubt, sample.stamp_doubt_ns);
  if (held_frames_.note(sample.send_time, sample.stamp_doubt_ns))
    history_.held_frames.note(sample.send_time, 1, sample.stamp_doubt_ns);
  if (sample.skipped_cycles > 0) {
    const auto standstill = before ? sample.send_time - *before : 0;
    history_.stalls.note(sample.send_time, sample.skipped_cycles, standstill, before.value_or(sample.send_time));
  }
  if ((sample.flags & CycleSample::kWkcError) != 0) {
    history_.wrong_counters.note(sample.send_time, 1);
    history_.counter_expected = sample.wkc_expected;
    history_.counter_received = sample.wkc_received;
  }
  add_deviation(sample);
  if (history_.reached_op && is_cyclic(sample)) add_arrival(sample);
  add_missed(sample);
}

void HistoryRecorder::add_missed(const CycleSample& sample) {
  if (sample.sm2_position < 0 || static_cast<std::size_t>(sample.sm2_position) >= missed_.size()) return;
  auto& told = missed_[static_cast<std::size_t>(sample.sm2_position)];
  const auto before = std::exchange(told, sample.slave_sm2_missed);
  if (told > before) {
    history_.slaves[static_cast<std::size_t>(sample.sm2_position)].missed.note(sample.send_time, told - before);
  }
}

/// Acquisition does not count: a clock is off when it had been near.
void HistoryRecorder::add_deviation(const CycleSample& sample) {
  if (sample.slave_position < 0 || static_cast<std::size_t>(sample.slave_position) >= history_.slaves.size()) return;
  auto& slave = history_.slaves[static_cast<std::size_t>(sample.slave_position)];
  const std::int64_t size = std::abs(std::int64_t{sample.slave_deviation_ns});
  if (size <= limit_ns_) {
    slave.was_near = slave.was_near || history_.operated;
  } else if (slave.was_near) {
    if (slave.off.empty()) slave.first_off_ns = sample.slave_deviation_ns;
    slave.off.note(sample.send_time, 1, size);
  }
}

void HistoryRecorder::add_arrival(const CycleSample& sample) {
  if (!grid_known_ || (sample.flags & CycleSample::kReferenceValid) == 0) return;
  const auto arrival = dc::sync0_arrival({base_ - set_value_, cycle_}, sample.reference_time);
  const auto late = dc::wrap_to_half(arrival.phase, cycle_);
  // Not by what the host was late: the grid itself is elsewhere, with a reference clock that has stepped.
  const bool off = std::abs(late - sample.wake_lateness_ns) > kOffItsGrid;
  if (off && sample.master_sync != SyncState::kInSync) return;
  history_.frame_lateness.add(late);
}

// ---- events and snapshots -----------------------------------------------------------------------

void HistoryRecorder::add_loss(std::vector<RunHistory::SyncLoss>& losses, const RunHistory::SyncLoss& loss) const {
  if (!history_.operated || losses.size() >= kMostLosses) return;
  // It is out of sync for another reason now.
  if (!losses.empty() && !losses.back().back) losses.back().back = loss.time;
  // The slaves are read in turn, and the controller has patience.
  constexpr Nanoseconds kBefore = 400 * kMillisecond;
  losses.push_back(loss);
  losses.back().held = held_frames_.sum(loss.time - kBefore, loss.time);
}

RunHistory::Slave* HistoryRecorder::slave_at(int position) {
  if (position < 0 || static_cast<std::size_t>(position) >= history_.slaves.size()) return nullptr;
  return &history_.slaves[static_cast<std::size_t>(position)];
}

/// What events say of the whole run.
struct HistoryRecorder::OfRun {
  HistoryRecorder& recorder;
  const Event& event;

  void operator()(const events::LinkDown& link) const {
    history().link = link.adapter.str();
    history().link_down = true;
    history().link_outages.note(event.time, 1);
  }
  void operator()(const events::LinkUp& link) const {
    history().link = link.adapter.str();
    if (!std::exchange(history().link_down, false)) return;
    history().link_outages.note(event.time, 0, link.away, history().link_outages.last());
  }
  void operator()(const events::Online&) const { history().operated = true; }
  void operator()(const events::ReferenceClockChanged& change) const {
    if (change.what != events::ReferenceClockChanged::What::kLost) history().lead_changes.note(event.time, 1);
  }
  void operator()(const events::SlavesOutOfSync& out) const {
    // All at once and to the same side: not they have moved, but what they follow.
    const bool stepped = event.slave < 0 && out.over_limit > 0;
    recorder.add_loss(history().slave_losses, {event.time,
                                               event.slave,
                                               out.deviation_ns,
                                               stepped ? dc::SyncObstacle::kClockStep : dc::SyncObstacle::kNone,
                                               {}});
  }
  void operator()(const events::FramesWayChanged& change) const {
    if (history().way_changes.size() < kMostLosses)
      history().way_changes.push_back({event.time, event.slave, change.deviation_ns, std::nullopt});
  }
  void operator()(const events::SlaveLost&) const { take_for_a_changed_way(); }
  void operator()(const events::SlaveFound&) const { take_for_a_changed_way(); }
  void operator()(const events::DelaysMeasured&) const {
    for (auto& change : history().way_changes) {
      if (!change.renewed) change.renewed = event.time;
    }
  }
  void operator()(const events::SlavesInSync&) const { regain(history().slave_losses); }
  void operator()(const events::MasterOutOfSync& out) const {
    recorder.add_loss(history().master_losses, {event.time, event.slave, out.error, out.obstacle, {}});
  }
  void operator()(const events::MasterInSync&) const { regain(history().master_losses); }
  void operator()(const events::CableChanged& change) const {
    auto* far = recorder.slave_at(change.far_slave);
    if (far == nullptr || event.slave < 0) return;
    far->cable = change.healed ? std::nullopt : std::optional(RunHistory::Cable{event.slave, change.port});
  }
  template <class Other>
  void operator()(const Other&) const {}

 private:
  /// The or-ed deviation shows sooner than a sweep who has gone or come, and with it the way of those behind.
  void take_for_a_changed_way() const {
    constexpr Nanoseconds kSwept = 500 * kMillisecond;
    constexpr std::int64_t kLongestWay = 10 * kMicrosecond;
    auto& losses = history().slave_losses;
    if (losses.empty() || losses.back().back || losses.back().obstacle == dc::SyncObstacle::kClockStep) return;
    const auto& loss = losses.back();
    if (event.time - loss.time > kSwept || (loss.slave >= 0 && loss.slave <= event.slave)) return;
    if (std::abs(loss.size) > kLongestWay) return;
    operator()(events::FramesWayChanged{std::abs(loss.size), 0});
    losses.pop_back();
  }
  [[nodiscard]] RunHistory& history() const { return recorder.history_; }
  void regain(std::vector<RunHistory::SyncLoss>& losses) const {
    if (!losses.empty() && !losses.back().back) losses.back().back = event.time;
  }
};

/// What events say of the slave that they are about.
struct HistoryRecorder::OfSlave {
  RunHistory::Slave& slave;
  Nanoseconds time;
  bool reached_op;

  void operator()(const events::SlaveLost&) const {
    slave.absent = true;
    slave.absences.note(time, 1);
  }
  void operator()(const events::SlaveFound&) const {
    if (std::exchange(slave.absent, false)) slave.absences.note(time, 0, 0, slave.absences.last());
  }
  void operator()(const events::HotConnect& group) const {
    if (group.what == events::HotConnect::What::kConnected) return operator()(events::SlaveFound{});
    operator()(events::SlaveLost{});
  }
  void operator()(const events::StateChanged& change) const {
    if (change.from == AlState::kOp || change.from == AlState::kNone) slave.left_op = time;
    const bool found = change.from == AlState::kNone && !slave.absences.empty();
    if (found && change.to == AlState::kInit) slave.restarts.note(time, 1);
  }
  /// One who refuses to be led up again has not fallen once more.
  void operator()(const events::AlStatusError& error) const {
    slave.fall = RunHistory::Fall{time, error.al_status, error.al_status_code};
    if (reached_op && slave.left_op == time && slave.falls.size() < RunHistory::kMostFalls)
      slave.falls.push_back(*slave.fall);
  }
  void operator()(const events::RecoveryStep& step) const {
    const bool begun = step.stage == events::RecoveryStep::Stage::kBegun;
    slave.recoveries.note(time, begun ? 1 : 0, 0, begun || slave.recoveries.empty() ? time : slave.recoveries.last());
  }
  void operator()(const events::LeftUnasked& left) const {
    if (!slave.unasked) slave.unasked = RunHistory::Unasked{time, left.from, left.to};
  }
  void operator()(const events::DelayFinding& found) const {
    // What is not above the slave before it is told of the one whose way made it so; a little below zero is noise.
    constexpr Nanoseconds kNoise = 100;
    const bool negative = found.warning == dc::DelayWarning::kNegativeHop && found.value < -kNoise;
    const bool wrong = negative || found.warning == dc::DelayWarning::kImplausibleHop;
    if (wrong) slave.delay = RunHistory::DelayTrouble{time, found.value};
  }
  void operator()(const events::Emergency& emergency) const { slave.emergency = emergency.error_code; }
  void operator()(const events::PortErrors& errors) const {
    const auto port = errors.port & 3U;
    if (errors.damaged_frames > 0) {
      constexpr Nanoseconds kLongSince = kSecond;  // slaves are read in turn
      slave.port_errors[port].note(time, errors.damaged_frames);
      slave.damage[port].note(time, errors.damaged_frames, 0, errors.since != 0 ? errors.since : time - kLongSince);
    }
    if (errors.lost_links > 0) slave.lost_links[port].note(time, errors.lost_links);
  }
  // Of LongCycles the counter itself is in the snapshots.
  void operator()(const events::StaleProcessData& stale) const {
    auto& late = stale.outputs ? slave.late_outputs : slave.late_inputs;
    if (stale.begun) {
      late.note(time, 1);
    } else if (!late.empty()) {
      late.note(time, 0, 0, late.last());
    }
  }
  void operator()(const events::WatchdogExpired& expired) const {
    const bool pdi = expired.which == events::WatchdogExpired::Which::kPdi;
    (pdi ? slave.pdi_watchdog : slave.process_data_watchdog).note(time, expired.count);
  }
  template <class Other>
  void operator()(const Other&) const {}
};

void HistoryRecorder::add(const Event& event) {
  if (history_.begin == 0) history_.begin = event.time;
  std::visit(OfRun{*this, event}, event.what);
  if (auto* slave = slave_at(event.slave)) std::visit(OfSlave{*slave, event.time, history_.reached_op}, event.what);
}

void HistoryRecorder::add(const Snapshot& snapshot) {
  auto& losses = history_.master_losses;
  const bool away = !losses.empty() && !losses.back().back && dc::is_of_external_clock(losses.back().obstacle);
  if (away && std::abs(snapshot.dcm.external_error_ns.value_or(0)) > std::abs(losses.back().size))
    losses.back().size = *snapshot.dcm.external_error_ns;
  // Also of a bus that was never operated, and where samples were lost.
  history_.end = std::max(history_.end, snapshot.time);
  // What was missed at its deadline and has come since is late, not lost.
  if (snapshot.late_frames > late_frames_) history_.lost_frames.take_back(snapshot.late_frames - late_frames_);
  late_frames_ = snapshot.late_frames;
  if (snapshot.dc.enabled) {
    grid_known_ = true;
    base_ = snapshot.dc.sync_base;
    set_value_ = snapshot.dcm.set_value_ns;
  }
  for (std::size_t i = 0; i < std::min(counts_.size(), snapshot.slaves.size()); ++i) {
    const auto& evidence = snapshot.slaves[i].evidence;
    auto& slave = history_.slaves[i];
    if (evidence.pdi_silent) slave.pdi_silent.note(snapshot.time, 0);
    if (evidence.mailbox_silences > slave.mailbox_silences) {
      if (slave.mailbox_silences == 0) slave.silent_from = snapshot.time;
      slave.silent_to = snapshot.time;
      slave.mailbox_silences = evidence.mailbox_silences;
    }
    const auto note = [&](std::size_t n, const EvidenceCount& count, Spells& spells) {
      const auto before = std::exchange(counts_[i][n], count.total);
      if (count.total > before) spells.note(count.time, count.total - before);
    };
    note(0, evidence.outputs.exceeded, slave.outputs_exceeded);
    note(1, evidence.inputs.exceeded, slave.inputs_exceeded);
    note(2, evidence.outputs.shift_too_short, slave.shift_too_short);
    note(3, evidence.processing_unit_errors, slave.unprocessed);
  }
}

}  // namespace syncline
