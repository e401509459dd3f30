// SPDX-License-Identifier: Apache-2.0
#include "trace/sync_overview.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "config/network_config.h"
#include "trace/counted_cycle.h"
#include "trace/signals.h"

namespace syncline {
namespace {

void follow(SyncLamp& lamp, SyncState state, Nanoseconds time, bool counts) {
  if (lamp.since != 0 && lamp.state == state) return;
  const bool lost = lamp.state == SyncState::kInSync &&
                    (state == SyncState::kOutOfSync || state == SyncState::kUnknown || state == SyncState::kBusy);
  if (lost && counts) {
    lamp.last_lost = time;
    ++lamp.times_lost;
  }
  lamp.state = state;
  lamp.since = time;
}

void note(OverviewFigure& figure, const CycleSample& sample, Signal signal, bool counts) {
  const auto number = info(signal).of_cycle(sample);
  if (!number) return;
  const auto value = std::get<std::int64_t>(*number);
  figure.now = {sample.send_time, value};
  if (!counts) return;
  const auto magnitude = std::abs(value);
  figure.statistics.add(static_cast<double>(value));
  figure.magnitudes.add(magnitude);
  if (!figure.largest || magnitude > std::abs(figure.largest->value)) figure.largest = figure.now;
}

void forget(SyncLamp& lamp) {
  lamp.last_lost.reset();
  lamp.times_lost = 0;
  lamp.last_away.reset();
  lamp.times_away = 0;
}

void forget(OverviewFigure& figure) {
  figure.statistics.clear();
  figure.magnitudes.clear();
  figure.largest.reset();
}

}  // namespace

std::optional<double> OverviewFigure::margin(std::int64_t limit) const {
  if (limit <= 0 || !largest) return std::nullopt;
  return 1 - static_cast<double>(std::abs(largest->value)) / static_cast<double>(limit);
}

bool is_ready(SyncState state) { return !is_watched(state) || state == SyncState::kInSync; }

OverviewRecorder::OverviewRecorder(std::size_t slaves) : counters_(slaves), may_be_away_(slaves) {
  overview_.missed.by_slave.resize(slaves);
  overview_.followed.resize(slaves);
}

OverviewRecorder::OverviewRecorder(const NetworkConfig& config) : OverviewRecorder(config.slaves.size()) {
  for (std::size_t slave = 0; slave < may_be_away_.size(); ++slave)
    may_be_away_[slave] = config.hot_connect_head(slave).has_value();
}

void OverviewRecorder::add(std::span<const CycleSample> samples) {
  for (const auto& sample : samples) add(sample);
}

void OverviewRecorder::add(const CycleSample& sample) {
  if (!any_) overview_.begin = sample.send_time;
  any_ = true;
  overview_.end = sample.send_time;
  overview_.state = static_cast<AlState>(sample.master_state);
  if (armed_from_ && sample.send_time >= *armed_from_) {
    const auto time = std::max(*armed_from_, overview_.begin);
    armed_from_.reset();
    if (overview_.armed != time) arm_at(time);
  } else if (!overview_.armed && is_to_be_armed(sample)) {
    arm_at(sample.send_time);
  }
  follow(overview_.slaves, sample.slaves_sync, sample.send_time, overview_.armed.has_value());
  follow(overview_.master, sample.master_sync, sample.send_time, overview_.armed.has_value());
  const bool counts = overview_.armed && counts_in_figures(sample);
  note(overview_.deviation, sample, Signal::kDeviation, counts);
  if (const auto& now = overview_.deviation.now; counts && now && now->time == sample.send_time) {
    ++overview_.deviation_count;
    const bool has_ored = (sample.flags & CycleSample::kDeviationValid) != 0;
    if (has_ored && sample.deviation_ored_ns == sample.deviation_ns) ++overview_.deviation_ored;
  }
  note(overview_.dcm_error, sample, Signal::kDcmError, counts);
  note(overview_.dcm_filtered, sample, Signal::kDcmErrorFiltered, counts);
  if (const auto& filtered = overview_.dcm_filtered.now; counts && filtered && filtered->time == sample.send_time)
    overview_.dcm_lasting.add(filtered->time, std::abs(filtered->value));
  const bool follows = sample.slave_position >= 0 && (sample.flags & CycleSample::kSlaveFollows) != 0;
  if (follows && static_cast<std::size_t>(sample.slave_position) < overview_.followed.size())
    overview_.followed[static_cast<std::size_t>(sample.slave_position)] = true;
  add_missed(sample);
}

void OverviewRecorder::add_missed(const CycleSample& sample) {
  if (sample.sm2_position < 0 || static_cast<std::size_t>(sample.sm2_position) >= counters_.size()) return;
  const auto slave = static_cast<std::size_t>(sample.sm2_position);
  auto& missed = overview_.missed;
  missed.known = true;
  const auto before = counters_[slave];
  const auto now = sample.slave_sm2_missed;
  counters_[slave] = now;
  if (!before || !overview_.armed || now == *before) return;
  const std::uint64_t more = now > *before ? now - *before : now;  // it was cleared: what it shows came since
  if (more == 0) return;
  missed.count += more;
  missed.by_slave[slave] += more;
  missed.last = sample.send_time;
  overview_.faults.add_missed(sample.send_time, sample.sm2_position, more);
}

/// Before it is armed all is bring-up.
void OverviewRecorder::add(const Event& event) {
  if (overview_.armed) overview_.faults.add(event);
  note_away(event);
}

/// By events alone: however they are drained among the samples, it comes out the same.
void OverviewRecorder::note_away(const Event& event) {
  auto& lamp = overview_.slaves;
  if (event.is<events::SlavesInSync>()) {
    const bool any = !away_.empty();
    event.slave < 0 ? away_.clear() : static_cast<void>(away_.erase(event.slave));
    if (any && away_.empty()) lamp.back_since = event.time;
    return;
  }
  const auto slave = static_cast<std::size_t>(event.slave);
  if (!event.is<events::SlaveLost>() || event.slave < 0 || slave >= may_be_away_.size()) return;
  if (!overview_.followed[slave] || may_be_away_[slave]) return;
  const bool first = away_.empty();
  away_.insert(event.slave);
  if (!first || !overview_.armed || event.time < *overview_.armed) return;
  lamp.last_away = event.time;
  ++lamp.times_away;
}

bool OverviewRecorder::is_to_be_armed(const CycleSample& sample) const {
  if (armed_from_ == std::numeric_limits<Nanoseconds>::max()) return false;
  return sample.send_time > disarmed_ && is_run_in_op(sample) && is_ready(sample.slaves_sync) &&
         is_ready(sample.master_sync);
}

void OverviewRecorder::arm() {
  if (any_) arm_at(overview_.end + 1);
}

void OverviewRecorder::disarm(Nanoseconds time) {
  overview_.armed.reset();
  disarmed_ = time;
  begin_anew(time);
}

void OverviewRecorder::arm_at(Nanoseconds time) {
  overview_.armed = time;
  begin_anew(time);
}

void OverviewRecorder::begin_anew(Nanoseconds time) {
  forget(overview_.slaves);
  forget(overview_.master);
  forget(overview_.deviation);
  overview_.deviation_count = overview_.deviation_ored = 0;
  forget(overview_.dcm_error);
  forget(overview_.dcm_filtered);
  overview_.dcm_lasting.clear();
  auto& missed = overview_.missed;
  missed.count = 0;
  missed.last.reset();
  std::ranges::fill(missed.by_slave, 0);
  overview_.faults.clear(time);
}

}  // namespace syncline
