// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "record/overview_marks.h"
#include "record/recording_reader.h"
#include "record/run_record.h"

namespace syncline {

/// A recorded run as it was drawn while it ran: the same samples in the same store, gaps and ages included, the same
/// events and findings. Its figures and faults are those from the later of two moments on: when the run was armed last,
/// and where the recording begins.
struct ReplayedRun {
  std::unique_ptr<RunRecord> record;
  RecordingInfo info;  // events, findings and notes in their words
  /// Of events and findings only the words are known: an older program, or a newer one, has recorded them.
  bool only_words = false;
  /// For who shows a moment of it, see RunReplay.
  OverviewMarks marks{};
};

struct ReplayOptions {
  /// The latest so many cycles are drawn; 0: all up to kMostCycles.
  std::size_t cycle_capacity = 0;
  /// After each block, with the cycles read of all; false: no more, kCancelled.
  std::function<bool(std::uint64_t done, std::uint64_t all)> progress{};
  /// Before progress(): this block, by its place in RecordingReader::blocks(), is damaged and has no samples.
  std::function<void(std::size_t block)> gap{};

  static constexpr std::size_t kMostCycles = 1U << 24;  // some 1.2 GB
};

/// The events that are there as values, in the order of their coming; `only_words`: of some only the words are known.
[[nodiscard]] std::vector<Event> events_of(const RecordingInfo& info, bool& only_words);

/// Samples, and events from `next` on, in the order of their times, as a run gives them: each event when the samples up
/// to its time are in, those later than the last sample not yet. An event that came late comes late here, too.
template <class Record>
void add_in_order(Record& record, std::span<const CycleSample> samples, const std::vector<Event>& events,
                  std::size_t& next) {
  if (samples.empty()) return;
  const auto last = samples.back().send_time;
  for (; next < events.size() && events[next].time <= last; ++next) {
    const auto later = std::ranges::find_if(
        samples, [time = events[next].time](const CycleSample& sample) { return sample.send_time > time; });
    const auto count = static_cast<std::size_t>(later - samples.begin());
    if (count > 0) record.add(samples.first(count));
    samples = samples.subspan(count);
    record.add(events[next]);
  }
  if (!samples.empty()) record.add(samples);
}

/// `config`: the recording's own, read from its document "configuration" by who knows ENI files. kBadValue when it is
/// another machine's, kFileNotReadable where the recording is damaged, kCancelled.
[[nodiscard]] Result<ReplayedRun> replay_run(RecordingReader& reader, NetworkConfig config,
                                             const ReplayOptions& options = {});
/// The same where the reader's info() is known already.
[[nodiscard]] Result<ReplayedRun> replay_run(RecordingReader& reader, RecordingInfo info, NetworkConfig config,
                                             const ReplayOptions& options = {});

}  // namespace syncline
