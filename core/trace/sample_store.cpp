// SPDX-License-Identifier: Apache-2.0
#include "trace/sample_store.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "channels/event.h"
#include "channels/mailbox_silence.h"
#include "channels/snapshot.h"
#include "trace/bus_signals.h"
#include "trace/cycle_gap.h"

namespace syncline {
namespace {

using Form = SignalInfo::Form;
using Scope = SignalInfo::Scope;

constexpr float kGap = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t kLeastReadings = 8192;
/// So many cycles without an answer, and what was known of states and counts is old.
constexpr std::uint32_t kOutage = 10;
/// What is read in turn is old after so many cycles, or when its turn was missed.
constexpr Nanoseconds kOldCycles = 10;
/// How often values are looked over for their age.
constexpr Nanoseconds kLookEvery = 100 * kMillisecond;

/// Events that wait for their snapshot.
constexpr std::size_t kMostTold = 4096;

/// It begins anew when a slave is in OP again.
/// Counts that the slave alone keeps, in objects of its own.
bool is_told_by_mailbox(Signal signal) {
  return signal == Signal::kOutputsExceeded || signal == Signal::kInputsExceeded ||
         signal == Signal::kOutputsShiftTooShort || signal == Signal::kInputsShiftTooShort;
}

bool is_of_fuse(Signal signal) { return signal == Signal::kSm2Integrator || signal == Signal::kSm2CyclesToTrip; }

/// Cycles that are stored at once, so that what is made of them stays near the processor.
constexpr std::size_t kLongestRun = 1024;

}  // namespace

std::optional<std::uint16_t> told_al_status(const Event& event) {
  std::optional<std::uint16_t> status;
  if (const auto* changed = event.as<events::StateChanged>()) status = static_cast<std::uint16_t>(changed->to);
  if (const auto* failed = event.as<events::AlStatusError>()) status = failed->al_status;
  return event.slave < 0 || status == 0 ? std::nullopt : status;
}

SampleStore::SampleStore(const Layout& layout)
    : layout_(layout), places_(kSignalCount), slips_(layout.sync0, layout.cycle_time), has_clock_(layout.slaves) {
  const auto clocks = std::max<std::size_t>(layout.clocks > 0 ? layout.clocks : layout.slaves, 1);
  const auto readings = layout.reading_capacity > 0 ? layout.reading_capacity : layout.cycle_capacity / clocks;
  const auto per_slave = std::max(readings, kLeastReadings);
  for (const auto& signal : signals()) {
    auto& first = places_[static_cast<std::size_t>(signal.id)];
    const bool of_slaves = signal.scope == Scope::kSlave;
    const auto count = of_slaves ? layout.slaves : 1;
    switch (signal.form) {
      case Form::kCell:
      case Form::kDerived:
      case Form::kWatched:
        break;
      case Form::kCycles:
        first = of_cycles_.size();
        cycles_.push_back(&signal);
        of_cycles_.push_back(first == 0 ? MinMaxSeries(layout.cycle_capacity)
                                        : MinMaxSeries::beside(of_cycles_.front()));
        break;
      case Form::kReadings:
        first = of_readings_.size();
        if (!of_slaves) readings_.push_back(&signal);
        for (std::size_t i = 0; i < count; ++i) of_readings_.emplace_back(per_slave);
        break;
      case Form::kHeld:
        first = of_held_.size();
        (of_slaves ? held_by_slave_ : held_).push_back(&signal);
        for (std::size_t i = 0; i < count; ++i) of_held_.emplace_back(std::max(layout.held_capacity, kLeastReadings));
        break;
    }
  }
  arrivals_.emplace(axis(), layout.sync0, layout.cycle_time, layout.sync_grid);
}

Sync0Slave SampleStore::sync0(std::size_t slave) const {
  return slave < layout_.sync0.size() ? layout_.sync0[slave] : Sync0Slave{};
}

std::size_t SampleStore::place(Signal signal, std::size_t slave) const {
  return places_[static_cast<std::size_t>(signal)] + slave;
}

const MinMaxSeries& SampleStore::series(Signal signal) const { return series(signal, 0); }

const MinMaxSeries& SampleStore::series(Signal signal, std::size_t slave) const {
  switch (info(signal).form) {
    case Form::kReadings:
      return of_readings_.at(place(signal, slave));
    case Form::kHeld:
      return of_held_.at(place(signal, slave)).series();
    case Form::kDerived:
      return arrivals_->phase(slave, series(Signal::kPropagationDelay, slave));
    case Form::kWatched:
      return of_variables_.at(slave);
    default:
      return of_cycles_.at(place(signal, slave));
  }
}

const HeldSeries* SampleStore::held(Signal signal, std::size_t slave) const {
  return info(signal).form == Form::kHeld ? &of_held_.at(place(signal, slave)) : nullptr;
}

Nanoseconds SampleStore::heard(Signal signal) const { return heard(signal, 0); }

Nanoseconds SampleStore::heard(Signal signal, std::size_t slave) const {
  return info(signal).form == Form::kHeld ? of_held_.at(place(signal, slave)).heard()
                                          : series(signal, slave).last_time();
}

Nanoseconds SampleStore::longest_gap(Signal signal) const {
  if (info(signal).form != Form::kReadings) return longest_cycle_gap(layout_.cycle_time);
  if (info(signal).scope != Scope::kSlave) return kOldCycles * layout_.cycle_time;
  // One clock is read a cycle, in turn; with the frame of one its reading is lost, and comes a round later.
  return std::max(kOldCycles * layout_.cycle_time,
                  2 * clocks_ * layout_.cycle_time + longest_cycle_gap(layout_.cycle_time));
}

std::optional<MinMaxSeries::Reading> SampleStore::value(Signal signal, Nanoseconds time) const {
  return value(signal, 0, time);
}

std::optional<MinMaxSeries::Reading> SampleStore::value(Signal signal, std::size_t slave, Nanoseconds time) const {
  if (info(signal).form == Form::kHeld) return of_held_.at(place(signal, slave)).at(time);
  auto reading = series(signal, slave).at(time);
  if (reading && time - reading->time > longest_gap(signal)) reading.reset();
  return reading;
}

/// Counted back from the end of its stretch: there every cycle is one sample, and the beginning may be forgotten.
std::optional<std::uint64_t> SampleStore::cycle_at(Nanoseconds time) const {
  if (empty() || time < first_time()) return std::nullopt;
  const auto found = std::ranges::lower_bound(stretches_, time, {}, &StretchEnd::time);
  const auto& newest = shown_newest_ ? *shown_newest_ : newest_;
  const auto& end = found == stretches_.end() || found->time > newest.time ? newest : *found;
  return time >= end.time ? end.cycle : end.cycle - axis().count(time + 1, end.time + 1);
}

std::optional<Nanoseconds> SampleStore::cycle_time_at(Nanoseconds time) const {
  const auto reading = axis().at(time);
  return reading ? std::optional(reading->time) : std::nullopt;
}

void SampleStore::show_until(Nanoseconds time) {
  const auto show = [this](Nanoseconds until) {
    for (auto& series : of_cycles_) series.show_until(until);
    for (auto& series : of_readings_) series.show_until(until);
    for (auto& series : of_variables_) series.show_until(until);
    for (auto& held : of_held_) held.show_until(until);
    arrivals_->show_until(until);
  };
  show(INT64_MAX);
  shown_newest_.reset();
  if (empty() || time >= last_time()) return;
  // Its number is counted from the end of its stretch, which is about to be hidden.
  if (const auto cycle = cycle_at(time)) shown_newest_ = StretchEnd{cycle_time_at(time).value_or(time), *cycle};
  show(time);
}

std::size_t SampleStore::memory_bytes() const {
  std::size_t bytes = 0;
  for (const auto& series : of_cycles_) bytes += series.memory_bytes();
  for (const auto& series : of_readings_) bytes += series.memory_bytes();
  for (const auto& held : of_held_) bytes += held.series().memory_bytes();
  for (const auto& series : of_variables_) bytes += series.memory_bytes();
  bytes += arrivals_->memory_bytes();
  return bytes;
}

void SampleStore::append(std::span<const CycleSample> samples) {
  while (!samples.empty()) {
    std::size_t count = 1;
    const auto follows = [&] {
      return samples[count].cycle == samples[count - 1].cycle + 1 &&
             samples[count].send_time >= samples[count - 1].send_time;
    };
    while (count < std::min(samples.size(), kLongestRun) && follows()) ++count;
    append_run(samples.first(count));
    samples = samples.subspan(count);
  }
}

void SampleStore::reserve(std::size_t cycles) {
  for (auto& series : of_cycles_) series.reserve(cycles);
}

bool SampleStore::watch(std::span<const WatchedVariable> variables) {
  if (!watched_.add(variables)) return false;
  while (of_variables_.size() < watched_.variables().size())
    of_variables_.push_back(MinMaxSeries::beside(of_cycles_.front()));
  return true;
}

/// One gap sample keeps the lines from being joined across what is missing.
void SampleStore::leave_gap(Nanoseconds time) {
  for (auto& series : of_cycles_) series.append(time, kGap);
  for (auto& series : of_variables_) series.append(time, kGap);
  arrivals_->leave_gap(time);
  slips_.begin_anew();
  hear_slips(time);
  for (const auto* signal : held_) of_held_[place(signal->id, 0)].lose(time);
}

void SampleStore::append_run(std::span<const CycleSample> run) {
  if (any_ && run.front().cycle > next_cycle_) {
    missing_cycles_ += run.front().cycle - next_cycle_;
    stretches_.push_back(newest_);
    while (!stretches_.empty() && stretches_.front().time < first_time()) stretches_.pop_front();
    leave_gap(run.front().send_time - 1);
  }
  any_ = true;
  next_cycle_ = run.back().cycle + 1;
  newest_ = {run.back().send_time, run.back().cycle};
  stamped_by_ = run.back().stamped_by;

  run_values_.resize(run.size());
  run_times_.resize(run.size());
  std::ranges::transform(run, run_times_.begin(), &CycleSample::send_time);
  append_cycles(run);
  for (const auto* signal : readings_) {
    auto& series = of_readings_[place(signal->id, 0)];
    cycle_values(signal->id)(run, run_values_.data());
    for (std::size_t i = 0; i < run.size(); ++i) {
      if (!std::isnan(run_values_[i])) series.append(run_times_[i], run_values_[i]);
    }
  }
  for (const auto* signal : held_) {
    if (signal->of_cycle == nullptr) continue;
    cycle_values(signal->id)(run, run_values_.data());
    of_held_[place(signal->id, 0)].hear(run_times_, run_values_);
  }
  for (const auto& sample : run) append_slaves(sample);
}

void SampleStore::append_cycles(std::span<const CycleSample> run) {
  // What is earlier than the newest is not drawn.
  const auto newest = axis().empty() ? run_times_.front() : axis().last_time();
  const auto from = static_cast<std::size_t>(std::ranges::lower_bound(run_times_, newest) - run_times_.begin());
  if (from == run.size()) return;
  const auto times = std::span(run_times_).subspan(from);
  const auto values = std::span(run_values_).subspan(from);
  for (std::size_t i = 0; i < cycles_.size(); ++i) {
    cycle_values(cycles_[i]->id)(run.subspan(from), values.data());
    of_cycles_[i].append(times, values);
  }
  append_variables(run.subspan(from), times, values);
  arrivals_->append(run.subspan(from), times);
}

void SampleStore::append_variables(std::span<const CycleSample> run, std::span<const Nanoseconds> times,
                                   std::span<float> values) {
  for (std::size_t variable = 0; variable < of_variables_.size(); ++variable) {
    std::ranges::transform(run, values.begin(),
                           [&](const CycleSample& sample) { return watched_.drawn(sample, variable); });
    of_variables_[variable].append(times, values);
  }
}

void SampleStore::hear_slips(Nanoseconds time) {
  for (std::size_t slave = 0; slave < std::min(layout_.slaves, layout_.sync0.size()); ++slave) {
    auto& held = of_held_[place(Signal::kSetpointSlips, slave)];
    if (const auto count = slips_.count(slave)) {
      held.hear(time, static_cast<float>(count->total()));
    } else {
      held.lose(time);
    }
  }
}

void SampleStore::append_slaves(const CycleSample& sample) {
  const auto time = sample.send_time;
  if (sample.slave_position >= 0 && static_cast<std::size_t>(sample.slave_position) < layout_.slaves) {
    auto& known = has_clock_[static_cast<std::size_t>(sample.slave_position)];
    if (std::exchange(known, std::uint8_t{1}) == 0) ++clocks_;
  }
  // What a reference clock shows there is no deviation from itself.
  const bool follows = sample.slave_position >= 0 && (sample.flags & CycleSample::kSlaveFollows) != 0;
  if (follows && static_cast<std::size_t>(sample.slave_position) < layout_.slaves) {
    of_readings_[place(Signal::kSlaveDeviation, static_cast<std::size_t>(sample.slave_position))].append(
        time, static_cast<float>(sample.slave_deviation_ns));
  }
  if (sample.sm2_position >= 0 && static_cast<std::size_t>(sample.sm2_position) < layout_.slaves) {
    const auto slave = static_cast<std::size_t>(sample.sm2_position);
    of_held_[place(Signal::kSm2Missed, slave)].hear(time, static_cast<float>(sample.slave_sm2_missed));
    of_held_[place(Signal::kSm2Integrator, slave)].hear(time, static_cast<float>(sample.slave_sm2_integrator));
  }
  const bool lost = (sample.flags & CycleSample::kFrameLost) != 0;
  lost_in_a_row_ = lost ? lost_in_a_row_ + 1 : 0;
  const bool outage = lost_in_a_row_ == kOutage;
  if (outage) slips_.begin_anew();
  const bool slipped = slips_.observe(sample);
  const bool look = outage || time >= next_look_;
  if (slipped || look) hear_slips(time);
  if (!look) return;
  next_look_ = time + kLookEvery;
  for (const auto* signal : held_by_slave_) {
    for (std::size_t slave = 0; slave < layout_.slaves; ++slave) {
      auto& held = of_held_[place(signal->id, slave)];
      if (outage) {
        held.lose(time - (kOutage - 1) * layout_.cycle_time);
      } else {
        held.expire(time);
      }
    }
  }
}

void SampleStore::restore(Signal signal, std::size_t slave, std::span<const Nanoseconds> times,
                          std::span<const float> values, Nanoseconds until) {
  if (info(signal).form != Form::kHeld) return;
  if (signal == Signal::kPropagationDelay) arrivals_->forget_made();
  auto& held = of_held_.at(place(signal, slave));
  held.clear();
  for (std::size_t i = 0; i < std::min(times.size(), values.size()); ++i) {
    if (std::isnan(values[i])) {
      held.lose(times[i]);
    } else {
      (void)held.change(times[i], values[i]);
    }
  }
  if (!values.empty() && !std::isnan(values.back())) held.hear(until, values.back());
  held.forget_interval();
}

void SampleStore::append(const Event& event) {
  const auto status = told_al_status(event);
  if (!status || static_cast<std::size_t>(event.slave) >= layout_.slaves) return;
  if (al_told_.size() == kMostTold) al_told_.erase(al_told_.begin());
  al_told_.push_back({event.time, static_cast<std::size_t>(event.slave), *status});
}

/// Those up to a snapshot of the run: what is told while the bus is taken down has none behind it.
void SampleStore::take_told(Nanoseconds until) {
  const auto later =
      std::stable_partition(al_told_.begin(), al_told_.end(), [until](const Told& told) { return told.time <= until; });
  for (auto told = al_told_.begin(); told != later; ++told)
    (void)of_held_[place(Signal::kAlState, told->slave)].change(told->time, static_cast<float>(told->status));
  al_told_.erase(al_told_.begin(), later);
}

void SampleStore::append(const Snapshot& snapshot) {
  take_told(snapshot.time);
  for (const auto* signal : held_) {
    if (signal->of_bus == nullptr) continue;
    if (const auto value = signal->of_bus(snapshot))
      of_held_[place(signal->id, 0)].hear(snapshot.time, static_cast<float>(*value));
  }
  if (slips_.observe(snapshot)) hear_slips(snapshot.time);
  const auto count = std::min(layout_.slaves, snapshot.slaves.size());
  for (const auto* signal : held_by_slave_) {
    if (signal->of_slave == nullptr) continue;
    for (std::size_t slave = 0; slave < count; ++slave) {
      const auto& status = snapshot.slaves[slave];
      auto& held = of_held_[place(signal->id, slave)];
      if (!status.present || lost_in_a_row_ >= kOutage) {
        held.lose(status.present ? snapshot.time : status.absent_since);
      } else if (mailbox_silent(status.evidence) && is_told_by_mailbox(signal->id)) {
        held.lose(held.heard());  // however seldom it is read
      } else if (const auto reading = signal->of_slave(snapshot, status, layout_.speed_counter_start)) {
        held.hear(reading->time, static_cast<float>(reading->value));
      } else if (status.sm2_missed.settling && is_of_fuse(signal->id)) {
        held.lose(snapshot.time);
      }
    }
  }
}

}  // namespace syncline
