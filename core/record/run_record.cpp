// SPDX-License-Identifier: Apache-2.0
#include "record/run_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "config/sync_grid.h"
#include "dc/clock_registers.h"
#include "diagnosis/run_diagnosis.h"
#include "trace/sync_overview.h"

namespace syncline {
namespace {

/// Ten minutes and something to scroll back to, within the memory that the samples may take.
constexpr Nanoseconds kHistory = 620 * kSecond;
constexpr std::size_t kLeastCycles = 1U << 16, kMostCycles = 1U << 21;

SampleStore::Layout layout_of(const NetworkConfig& config, std::size_t cycle_capacity, const RunLimits& limits,
                              std::uint16_t speed_counter_start) {
  SampleStore::Layout layout;
  layout.slaves = config.slaves.size();
  layout.cycle_time = std::max<Nanoseconds>(limits.cycle_time, 1);
  const auto suitable = std::clamp(static_cast<std::size_t>(kHistory / layout.cycle_time), kLeastCycles, kMostCycles);
  layout.cycle_capacity = cycle_capacity > 0 ? cycle_capacity : suitable;
  layout.clocks = static_cast<std::size_t>(
      std::ranges::count_if(config.slaves, [](const SlaveConfig& slave) { return slave.dc.has_value(); }));
  // Of a recording all readings and changes are kept, so that each of its moments has its own; there are no more than
  // cycles.
  layout.reading_capacity = layout.held_capacity = cycle_capacity;
  layout.speed_counter_start = speed_counter_start;
  layout.sync0 = sync0_slaves(config);
  layout.sync_grid = sync_grid(config).value_or(0);
  return layout;
}

}  // namespace

RunRecord::RunRecord(const NetworkConfig& config, std::size_t cycle_capacity)
    : RunRecord(NetworkConfig(config), cycle_capacity, limits_of(config), speed_counter_start_of(config)) {}

RunRecord::RunRecord(NetworkConfig config, std::size_t cycle_capacity, const RunLimits& limits,
                     std::uint16_t speed_counter_start)
    : config_(std::move(config)),
      limits_(limits),
      samples_(layout_of(config_, cycle_capacity, limits_, speed_counter_start)),
      recorder_(config_),
      overview_(std::make_unique<OverviewRecorder>(config_)) {}

RunRecord::~RunRecord() = default;

void RunRecord::arm() { overview_->arm(); }

void RunRecord::arm_from(Nanoseconds time) { overview_->arm_from(time); }

RunStanding RunRecord::standing() const { return {limits_, overview().armed}; }

const SyncOverview& RunRecord::overview() const {
  return shown_overview_ == nullptr ? overview_->overview() : *shown_overview_;
}

std::vector<Finding> RunRecord::findings() const { return findings(overview().begin); }

void RunRecord::add(std::span<const CycleSample> samples) {
  samples_.append(samples);
  recorder_.add(samples);
  overview_->add(samples);
  reference_times_.add(samples);
}

void RunRecord::add(const Snapshot& snapshot) {
  if (!snapshot.online) return;
  const bool configured = snapshot.dcm.times_configured != snapshot_.dcm.times_configured;
  snapshot_ = snapshot;
  samples_.append(snapshot_);
  recorder_.add(snapshot_);
  if (!configured) return;
  // What was measured before says nothing about the controller as it is now, and nothing was lost by the change.
  if (limits_.dcm_error_ns != 0) limits_.dcm_error_ns = snapshot_.dcm.in_sync_limit;
  overview_->disarm(snapshot_.time);
}

void RunRecord::add(RunNote note) {
  notes_.insert(std::ranges::upper_bound(notes_, note.time, {}, &RunNote::time), std::move(note));
  ++notes_changed_;
}

void RunRecord::set_notes(std::vector<RunNote> notes) {
  notes_ = std::move(notes);
  std::ranges::stable_sort(notes_, {}, &RunNote::time);
  ++notes_changed_;
}

void RunRecord::keep(KeptTrigger found) {
  const auto same = std::ranges::find_if(
      triggers_, [&found](const KeptTrigger& one) { return finds_the_same(one.trigger, found.trigger); });
  if (same != triggers_.end()) {
    *same = std::move(found);
    return;
  }
  if (triggers_.size() == kMostTriggers) triggers_.erase(triggers_.begin());
  triggers_.push_back(std::move(found));
}

void RunRecord::add(const Event& event) {
  samples_.append(event);
  recorder_.add(event);
  overview_->add(event);
  if (events_.size() == kMostEvents) {
    events_.pop_front();
    ++forgotten_events_;
  }
  events_.push_back(event);
}

void RunRecord::show_at(Nanoseconds time, const SyncOverview& overview) {
  samples_.show_until(time);
  // Behind the last cycle comes what was told when the run had ended.
  show_events(samples_.next_cycle_time(time) ? time : std::numeric_limits<Nanoseconds>::max());
  shown_overview_ = &overview;
  shown_at_ = time;
}

void RunRecord::show_whole() {
  samples_.show_until(std::numeric_limits<Nanoseconds>::max());
  show_events(std::numeric_limits<Nanoseconds>::max());
  shown_overview_ = nullptr;
  shown_at_.reset();
}

/// In the order of their coming: one that came late hides nothing that came before it.
void RunRecord::show_events(Nanoseconds until) {
  if (!shown_at_ || until < *shown_at_) {
    const auto first = std::ranges::find_if(events_, [until](const Event& event) { return event.time > until; });
    const auto count = static_cast<std::size_t>(first - events_.begin());
    for (; events_.size() > count; events_.pop_back()) hidden_events_.push_back(std::move(events_.back()));
  }
  for (; !hidden_events_.empty() && hidden_events_.back().time <= until; hidden_events_.pop_back())
    events_.push_back(std::move(hidden_events_.back()));
}

std::string RunRecord::slave_name(std::size_t position) const {
  return position < config_.slaves.size() ? config_.slaves[position].name : fmt::format("{}", position);
}

std::vector<Finding> RunRecord::findings(Nanoseconds told_from) const {
  if (restored_findings_) {
    const bool at_end = !shown_at_ || !samples_.next_cycle_time(*shown_at_);
    return at_end ? *restored_findings_ : std::vector<Finding>{};
  }
  auto run = report();
  run.told_from = told_from;
  return run.history.reached_op ? diagnose(run) : std::vector<Finding>{};
}

}  // namespace syncline
