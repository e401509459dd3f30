// SPDX-License-Identifier: Apache-2.0
#include "record/recent_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <type_traits>
#include <utility>

#include "reasons/because.h"
#include "record/recorded_event.h"
#include "record/recording_writer.h"

namespace syncline {
namespace {

constexpr std::size_t kChunkCycles = 4096;
/// What watched variables add to a sample stands at its end.
constexpr std::size_t kUnwatched = offsetof(CycleSample, watched_known);
static_assert(std::is_trivially_copyable_v<CycleSample> && std::is_standard_layout_v<CycleSample>);
static_assert(offsetof(CycleSample, watch_list) > kUnwatched && offsetof(CycleSample, watched) > kUnwatched);
constexpr std::uint64_t kBytesOfCycle = 100;       // in a file, and some
constexpr std::uint64_t kBytesOfVariable = 10;     // the same, of each that is watched
constexpr std::uint64_t kLeaveFree = 64ULL << 20;  // of the disk
constexpr std::size_t kHeldCapacity = 1;           // of cycles, of which there are none

bool watches(const CycleSample& sample) { return sample.watch_list != 0; }

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

SampleChunk::SampleChunk(std::span<const CycleSample> samples)
    : stride_(std::ranges::any_of(samples, watches) ? sizeof(CycleSample) : kUnwatched),
      bytes_(samples.size() * stride_),
      first_(samples.front().send_time),
      last_(samples.back().send_time) {
  for (std::size_t i = 0; i < samples.size(); ++i) std::memcpy(&bytes_[i * stride_], &samples[i], stride_);
}

std::vector<CycleSample> SampleChunk::samples() const {
  std::vector<CycleSample> samples(size());
  for (std::size_t i = 0; i < samples.size(); ++i) std::memcpy(&samples[i], &bytes_[i * stride_], stride_);
  return samples;
}

void RecentSamples::add(std::span<const CycleSample> samples) {
  while (!samples.empty()) {
    if (open_.capacity() < kChunkCycles) open_.reserve(kChunkCycles);
    const auto count = std::min(samples.size(), kChunkCycles - open_.size());
    open_.insert(open_.end(), samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(count));
    samples = samples.subspan(count);
    if (open_.size() < kChunkCycles) return;
    chunks_.push_back(std::make_shared<const SampleChunk>(open_));
    bytes_ += chunks_.back()->bytes();
    open_.clear();
    forget_beyond();
  }
}

void RecentSamples::forget_beyond() {
  for (; bytes_ > budget_ && chunks_.size() > 1; chunks_.pop_front()) bytes_ -= chunks_.front()->bytes();
}

void RecentSamples::set_budget(std::size_t budget) {
  budget_ = budget;
  forget_beyond();
}

void RecentSamples::clear() {
  chunks_.clear();
  bytes_ = 0;
  open_.clear();
}

Nanoseconds RecentSamples::begin() const {
  if (!chunks_.empty()) return chunks_.front()->first_time();
  return open_.empty() ? 0 : open_.front().send_time;
}

Nanoseconds RecentSamples::span() const {
  if (empty()) return 0;
  return (open_.empty() ? chunks_.back()->last_time() : open_.back().send_time) - begin();
}

Nanoseconds RecentSamples::reach(Nanoseconds cycle_time) const {
  const auto of_chunk = chunks_.empty() ? kChunkCycles * kUnwatched : chunks_.back()->bytes();
  return static_cast<Nanoseconds>(std::max<std::size_t>(budget_ / of_chunk, 1) * kChunkCycles) * cycle_time;
}

std::vector<RecentSamples::Chunk> RecentSamples::since(Nanoseconds from) const {
  std::vector<Chunk> result;
  for (const auto& chunk : chunks_) {
    if (chunk->last_time() >= from) result.push_back(chunk);
  }
  if (!open_.empty()) result.push_back(std::make_shared<const SampleChunk>(open_));
  return result;
}

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
  for (const char* const beside : {"", "-wal", "-shm"}) {
    std::error_code error;
    std::filesystem::remove(path + beside, error);
  }
  return status;
}

}  // namespace syncline
