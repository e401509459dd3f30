// SPDX-License-Identifier: Apache-2.0
#include "record/replay_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "reasons/because.h"
#include "record/blocks_ahead.h"
#include "record/trigger_document.h"
#include "record/typed_values.h"

namespace syncline {
namespace {

bool goes_down(const Event& event) {
  const auto* const changed = event.as<events::StateChanged>();
  return changed != nullptr && changed->to < changed->from;
}

/// Without the states through which the bus was taken down: those that were told last before it was offline.
std::span<const Event> of_run(std::span<const Event> events) {
  const auto offline = std::ranges::find_if(events, [](const Event& event) { return event.is<events::Offline>(); });
  if (offline == events.end()) return events;
  auto count = static_cast<std::size_t>(offline - events.begin());
  while (count > 0 && goes_down(events[count - 1])) --count;
  return events.first(count);
}

/// The AL status of a slave: what snapshots have shown, and between them what events tell, which come first where both
/// have the same time.
RecordingReader::Points with_told(const RecordingReader::Points& shown, std::span<const Event> events, int slave) {
  RecordingReader::Points merged;
  std::optional<float> known;
  const auto put = [&](Nanoseconds time, float value) {
    const auto now = std::isnan(value) ? std::nullopt : std::optional(value);
    if (std::exchange(known, now) == now && !merged.times.empty()) return;
    merged.times.push_back(time);
    merged.values.push_back(value);
  };
  std::vector<std::pair<Nanoseconds, float>> told;
  for (const auto& event : events) {
    const auto status = event.slave == slave ? told_al_status(event) : std::nullopt;
    if (status) told.emplace_back(event.time, static_cast<float>(*status));
  }
  std::ranges::stable_sort(told, {}, &std::pair<Nanoseconds, float>::first);
  auto next = told.begin();
  for (std::size_t i = 0; i < std::min(shown.times.size(), shown.values.size()); ++i) {
    for (; next != told.end() && next->first <= shown.times[i]; ++next) put(next->first, next->second);
    put(shown.times[i], shown.values[i]);
  }
  for (; next != told.end(); ++next) put(next->first, next->second);
  return merged;
}

/// Counts and states, which no sample tells.
void restore_held(const RecordingReader::AllPoints& all, std::span<const Event> events, RunRecord& record) {
  for (const auto& signal : signals()) {
    const bool of_slaves = signal.scope == SignalInfo::Scope::kSlave;
    if (signal.form != SignalInfo::Form::kHeld || (!of_slaves && signal.of_bus == nullptr)) continue;
    const auto count = of_slaves ? static_cast<int>(record.config().slaves.size()) : 1;
    for (int slave = 0; slave < count; ++slave) {
      const auto points = all.find(series_number(signal.id, of_slaves ? slave : -1));
      if (points != all.end() && signal.id == Signal::kAlState) {
        const auto merged = with_told(points->second, events, slave);
        record.restore(signal.id, static_cast<std::size_t>(slave), merged.times, merged.values);
      } else if (points != all.end()) {
        record.restore(signal.id, static_cast<std::size_t>(slave), points->second.times, points->second.values);
      } else if (of_slaves) {
        record.restore(signal.id, static_cast<std::size_t>(slave), {}, {});
      }
    }
  }
}

std::vector<Finding> findings_of(const RecordingInfo& info, bool& only_words) {
  std::vector<Finding> findings;
  for (const auto& recorded : info.findings) {
    if (auto finding = decode_finding(recorded.details)) {
      findings.push_back(std::move(*finding));
    } else {
      only_words = true;
    }
  }
  return findings;
}

std::unique_ptr<RunRecord> made_for(NetworkConfig config, const RecordingInfo& info, std::size_t capacity) {
  if (capacity == 0)
    capacity = static_cast<std::size_t>(std::min<std::uint64_t>(info.cycles, ReplayOptions::kMostCycles));
  return std::make_unique<RunRecord>(std::move(config), std::max<std::size_t>(capacity, 1), info.about.limits,
                                     info.about.speed_counter_start);
}

}  // namespace

std::vector<Event> events_of(const RecordingInfo& info, bool& only_words) {
  std::vector<Event> events;
  const auto slaves = static_cast<int>(info.about.slaves.size());
  for (const auto& recorded : info.events) {
    auto what = decode_event(recorded.details);
    if (what && recorded.slave < slaves) {
      events.push_back({recorded.time, recorded.slave, std::move(*what)});
    } else {
      only_words = true;
    }
  }
  return events;
}

Result<ReplayedRun> replay_run(RecordingReader& reader, NetworkConfig config, const ReplayOptions& options) {
  auto info = reader.info();
  if (!info) return tl::unexpected(info.error());
  return replay_run(reader, std::move(*info), std::move(config), options);
}

Result<ReplayedRun> replay_run(RecordingReader& reader, RecordingInfo info, NetworkConfig config,
                               const ReplayOptions& options) {
  if (info.about.slaves.size() != config.slaves.size()) {
    return fail(
        ErrorCode::kBadValue, "configuration",
        because("it has {count} slaves, the recording has {other}", config.slaves.size(), info.about.slaves.size()));
  }
  ReplayedRun run{made_for(std::move(config), info, options.cycle_capacity), std::move(info)};
  auto& record = *run.record;
  record.set_link(run.info.about.link);
  // Where cycles are missing a sample says so: one for each of them at most.
  record.reserve(run.info.cycles + std::min(run.info.missing_cycles, run.info.cycles / 16));
  for (const auto& list : run.info.about.watched.lists()) {
    std::vector<WatchedVariable> variables;
    for (const auto number : list.places) variables.push_back(run.info.about.watched.variables()[number]);
    (void)record.watch(variables);
  }
  if (run.info.about.armed) record.arm_from(*run.info.about.armed);
  const auto events = events_of(run.info, run.only_words);
  std::size_t next = 0;
  std::uint64_t done = 0;
  std::size_t blocks = 0;
  run.marks = OverviewMarks(run.info.blocks);
  RecordingReader::AllPoints held;
  const auto known = reader.damage().size();
  BlocksAhead ahead(reader, held);
  for (std::vector<CycleSample> samples; ahead.next(samples);) {
    if (samples.empty() && options.gap) options.gap(blocks);
    add_in_order(record, std::span<const CycleSample>(samples), events, next);
    run.marks.pass(++blocks, next, record.overview_recorder());
    done += samples.size();
    if (options.progress && !options.progress(done, run.info.cycles)) return fail(ErrorCode::kCancelled);
  }
  for (; next < events.size(); ++next) record.add(events[next]);
  if (auto status = ahead.finish(); !status) return tl::unexpected(status.error());
  if (done == 0 && run.info.cycles > 0) return no_cycle_left(reader.path());
  for (auto& told : recorded(std::span(reader.damage()).subspan(known))) run.info.findings.push_back(std::move(told));
  restore_held(held, of_run(events), record);
  record.restore(findings_of(run.info, run.only_words));
  record.set_notes(run.info.notes);
  for (auto& kept : kept_triggers(run.info.about)) record.keep(std::move(kept));
  return run;
}

}  // namespace syncline
