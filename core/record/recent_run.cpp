// SPDX-License-Identifier: Apache-2.0
#include "record/recent_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

#include "reasons/because.h"
#include "record/recorded_event.h"
#include "record/recording_writer.h"
#include "record/run_record.h"
#include "sqlite/database_files.h"

namespace syncline {
namespace {

constexpr std::uint64_t kBytesOfCycle = 100;       // in a file, and some
constexpr std::uint64_t kBytesOfVariable = 10;     // the same, of each that is watched
constexpr std::uint64_t kLeaveFree = 64ULL << 20;  // of the disk
constexpr std::size_t kHeldCapacity = 1;           // of cycles, of which there are none

Status has_room(const std::string& path, std::size_t cycles, std::size_t variables) {
  std::error_code error;
  const auto folder = std::filesystem::absolute(path, error).parent_path();
  const auto space = std::filesystem::space(folder, error);
  const auto needed = cycles * (kBytesOfCycle + variables * kBytesOfVariable);
  if (error || space.available >= needed + kLeaveFree) return {};
  return fail(Error{.code = ErrorCode::kFileNotWritable,
                    .detail = because("it needs about {need} MiB, and the disk has {left} MiB left",
                                      (needed + kLeaveFree) >> 20, space.available >> 20),
                    .file = path});
}

Status write_all(RecordingWriter& writer, const RecentRun& run) {
  std::vector<RecordedEvent> events;
  for (const auto& event : run.events) {
    if (auto words = recorded_event(event)) events.push_back(std::move(*words));
  }
  auto event = events.begin();
  for (const auto& chunk : run.samples) {
    const auto samples = chunk->samples();
    const auto begin = std::ranges::lower_bound(samples, run.from, {}, &CycleSample::send_time);
    RecordingBatch batch;
    const auto end = std::ranges::upper_bound(begin, samples.end(), run.to, {}, &CycleSample::send_time);
    batch.samples.assign(begin, end);
    if (batch.samples.empty()) continue;
    const auto until = batch.samples.back().send_time;
    for (; event != events.end() && event->time <= until; ++event) batch.events.push_back(*event);
    if (auto status = writer.write(batch); !status) return status;
  }
  RecordingBatch rest;
  for (; event != events.end(); ++event) rest.events.push_back(*event);
  rest.notes = run.notes;
  if (!rest.empty()) {
    if (auto status = writer.write(rest); !status) return status;
  }
  return writer.finish("the last stretch out of memory", run.findings);
}

}  // namespace

std::unique_ptr<SampleStore> held_copy(const RunRecord& record, Nanoseconds until) {
  const auto& from = record.samples();
  auto copy = std::make_unique<SampleStore>(SampleStore::Layout{.slaves = from.slave_count(),
                                                                .cycle_time = record.limits().cycle_time,
                                                                .cycle_capacity = kHeldCapacity,
                                                                .speed_counter_start = 0});
  std::vector<Nanoseconds> times;
  std::vector<float> values;
  for (const auto& signal : signals()) {
    if (signal.form != SignalInfo::Form::kHeld) continue;
    const auto count = signal.scope == SignalInfo::Scope::kSlave ? from.slave_count() : 1;
    for (std::size_t slave = 0; slave < count; ++slave) {
      times.clear();
      values.clear();
      from.series(signal.id, slave).for_each(INT64_MIN, until + 1, [&](Nanoseconds time, float value) {
        times.push_back(time);
        values.push_back(value);
      });
      if (!times.empty()) copy->restore(signal.id, slave, times, values, std::min(from.heard(signal.id, slave), until));
    }
  }
  return copy;
}

RecentRun take_recent(const RunRecord& record, const RecentSamples& recent, RecordingAbout about, Nanoseconds from,
                      Nanoseconds to) {
  RecentRun run;
  run.about = std::move(about);
  run.from = std::max(from, recent.begin());
  run.to = to;
  run.samples = recent.since(run.from);
  run.held = held_copy(record, to);
  const auto within = [&run](const auto& moment) { return moment.time >= run.from && moment.time <= run.to; };
  std::ranges::copy_if(record.events(), std::back_inserter(run.events), within);
  run.findings = recorded(record.findings(run.from));
  std::ranges::copy_if(record.notes(), std::back_inserter(run.notes), within);
  return run;
}

Status save_recent(const std::string& path, const RecentRun& run) {
  std::size_t cycles = 0;
  for (const auto& chunk : run.samples) cycles += chunk->size();
  if (auto status = has_room(path, cycles, run.about.watched.variables().size()); !status) return status;
  auto writer = RecordingWriter::create(path, run.about);
  if (!writer) return tl::unexpected(writer.error());
  writer->take_held_from(*run.held);
  auto status = write_all(*writer, run);
  if (status) return {};
  // Half of it is none: what was there is still in memory.
  remove_database(path);
  return status;
}

}  // namespace syncline
