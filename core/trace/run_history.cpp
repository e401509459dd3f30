// SPDX-License-Identifier: Apache-2.0
#include "trace/run_history.h"

#include <algorithm>
#include <cstdlib>

#include "dc/plans.h"
#include "protocol/dc_registers.h"

namespace syncline {
namespace {

constexpr std::size_t kMostLosses = 64;

bool in_op(const CycleSample& sample) { return sample.master_state == static_cast<std::uint8_t>(AlState::kOp); }

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

// ---- samples ------------------------------------------------------------------------------------

HistoryRecorder::HistoryRecorder(const NetworkConfig& config)
    : limit_ns_(sync_window_limit_ns(config.dc.sync_window.exponent)),
      cycle_(config.cycle_time()),
      exceeded_(config.slaves.size()) {
  history_.slaves.resize(config.slaves.size());
}

void HistoryRecorder::add(std::span<const CycleSample> samples) {
  for (const auto& sample : samples) add(sample);
}

void HistoryRecorder::add(const CycleSample& sample) {
  history_.end = sample.send_time;
  const auto before = std::exchange(last_send_, sample.send_time);
  history_.reached_op = history_.reached_op || in_op(sample);
  if ((sample.flags & CycleSample::kFrameLost) != 0) {
    history_.lost_frames.note(sample.send_time, std::max<std::uint16_t>(1, sample.frames_lost));
  }
  if ((sample.flags & CycleSample::kFrameLate) != 0) history_.late_frames.note(sample.send_time, 1, sample.late_by_ns);
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
  if (in_op(sample)) add_arrival(sample);
}

/// Acquisition does not count: a clock is off when it had been near.
void HistoryRecorder::add_deviation(const CycleSample& sample) {
  if (sample.slave_position < 0 || static_cast<std::size_t>(sample.slave_position) >= history_.slaves.size()) return;
  auto& slave = history_.slaves[static_cast<std::size_t>(sample.slave_position)];
  const std::int64_t size = std::abs(std::int64_t{sample.slave_deviation_ns});
  if (size <= limit_ns_) {
    slave.was_near = slave.was_near || history_.reached_op;
  } else if (slave.was_near) {
    slave.off.note(sample.send_time, 1, size);
  }
}

void HistoryRecorder::add_arrival(const CycleSample& sample) {
  if (!grid_known_ || (sample.flags & CycleSample::kReferenceValid) == 0) return;
  history_.frame_lateness.add(dc::wrap_to_half(sample.reference_time - (base_ - set_value_), cycle_));
}

// ---- events and snapshots -----------------------------------------------------------------------

void HistoryRecorder::add_loss(std::vector<RunHistory::SyncLoss>& losses, const Event& event) const {
  if (event.a == 0) {
    if (history_.reached_op && losses.size() < kMostLosses) {
      const bool of_master = event.kind == EventKind::kDcmSync;
      losses.push_back({event.time,
                        event.slave,
                        event.b,
                        of_master ? static_cast<dc::SyncObstacle>(event.c) : dc::SyncObstacle::kNone,
                        {}});
    }
  } else if (event.a == 1 && !losses.empty() && !losses.back().back) {
    losses.back().back = event.time;
  }
}

void HistoryRecorder::add_port_errors(const Event& event, RunHistory::Slave& slave) {
  const auto port = static_cast<std::size_t>(event.a & 3);
  if (event.b > 0) slave.port_errors[port].note(event.time, static_cast<std::uint64_t>(event.b));
  if (event.c > 0) slave.lost_links[port].note(event.time, static_cast<std::uint64_t>(event.c));
}

void HistoryRecorder::add_link(const Event& event) {
  if (event.a == 2) return;
  history_.link = event.text;
  if (event.a == 0) {
    history_.link_down = true;
    history_.link_outages.note(event.time, 1);
  } else if (std::exchange(history_.link_down, false)) {
    history_.link_outages.note(event.time, 0, event.b, history_.link_outages.last());
  }
}

void HistoryRecorder::add(const Event& event) {
  if (history_.begin == 0) history_.begin = event.time;
  if (event.kind == EventKind::kLink) return add_link(event);
  if (event.kind == EventKind::kDcSlaveSync) add_loss(history_.slave_losses, event);
  if (event.kind == EventKind::kDcmSync) add_loss(history_.master_losses, event);
  if (event.kind == EventKind::kCable) {
    if (event.b >= 0 && event.b < static_cast<std::int64_t>(history_.slaves.size()) && event.slave >= 0) {
      auto& cable = history_.slaves[static_cast<std::size_t>(event.b)].cable;
      cable = event.c == 0 ? std::optional(RunHistory::Cable{event.slave, static_cast<int>(event.a)}) : std::nullopt;
    }
    return;
  }
  if (event.slave < 0 || static_cast<std::size_t>(event.slave) >= history_.slaves.size()) return;
  auto& slave = history_.slaves[static_cast<std::size_t>(event.slave)];
  switch (event.kind) {
    case EventKind::kSlaveLost:
      slave.absent = true;
      slave.absences.note(event.time, 1);
      break;
    case EventKind::kSlaveFound:
      if (std::exchange(slave.absent, false)) slave.absences.note(event.time, 0, 0, slave.absences.last());
      break;
    case EventKind::kAlStatusError:
      slave.fall =
          RunHistory::Fall{event.time, static_cast<std::uint16_t>(event.a), static_cast<std::uint16_t>(event.b)};
      break;
    case EventKind::kEmergency:
      slave.emergency = static_cast<std::uint16_t>(event.a);
      break;
    case EventKind::kPortErrors:
      add_port_errors(event, slave);
      break;
    case EventKind::kFirmwareSlow:
      if (event.c == 0) break;  // the counter itself is in the snapshots
      if (event.a == 1) {
        slave.late_inputs.note(event.time, 1);
      } else if (!slave.late_inputs.empty()) {
        slave.late_inputs.note(event.time, 0, 0, slave.late_inputs.last());
      }
      break;
    case EventKind::kWatchdog:
      (event.a == 0 ? slave.process_data_watchdog : slave.pdi_watchdog)
          .note(event.time, static_cast<std::uint64_t>(event.b));
      break;
    default:
      break;
  }
}

void HistoryRecorder::add(const Snapshot& snapshot) {
  // What was missed at its deadline and has come since is late, not lost.
  if (snapshot.late_frames > late_frames_) history_.lost_frames.take_back(snapshot.late_frames - late_frames_);
  late_frames_ = snapshot.late_frames;
  if (snapshot.dc.enabled) {
    grid_known_ = true;
    base_ = snapshot.dc.sync_base;
    set_value_ = snapshot.dcm.set_value_ns;
  }
  for (std::size_t i = 0; i < std::min(exceeded_.size(), snapshot.slaves.size()); ++i) {
    const auto& evidence = snapshot.slaves[i].evidence;
    auto& silences = history_.slaves[i].mailbox_silences;
    silences = std::max(silences, evidence.mailbox_silences);
    const std::array<const EvidenceCount*, 2> now{&evidence.outputs.exceeded, &evidence.inputs.exceeded};
    const std::array<Spells*, 2> spells{&history_.slaves[i].outputs_exceeded, &history_.slaves[i].inputs_exceeded};
    for (std::size_t n = 0; n < now.size(); ++n) {
      const auto more = now[n]->total - exceeded_[i][n];
      exceeded_[i][n] = now[n]->total;
      if (more > 0) spells[n]->note(now[n]->time, more);
    }
  }
}

}  // namespace syncline
