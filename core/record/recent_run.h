// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "channels/event.h"
#include "record/recent_samples.h"
#include "record/recording.h"
#include "record/run_note.h"
#include "trace/sample_store.h"

/// The last stretch of a run, every cycle of it, in memory: what was not recorded can be kept afterwards.
namespace syncline {

/// What save_recent() writes: taken where the run lives, written in any thread.
struct RecentRun {
  RecordingAbout about;
  Nanoseconds from = 0, to = INT64_MAX;  // host clock, both belong to it
  std::vector<RecentSamples::Chunk> samples;
  std::unique_ptr<SampleStore> held;  // see held_copy()
  std::vector<Event> events;          // from then on, until then; put into words where they are written
  std::vector<RecordedFinding> findings;
  std::vector<RunNote> notes{};  // those of the stretch
};

/// Counts and states of a run until a moment, and nothing else of it.
[[nodiscard]] std::unique_ptr<SampleStore> held_copy(const RunRecord& record, Nanoseconds until = INT64_MAX - 1);

/// What of a run is between two moments (host clock, both belong to it) and remembered, with its findings.
[[nodiscard]] RecentRun take_recent(const RunRecord& record, const RecentSamples& recent, RecordingAbout about,
                                    Nanoseconds from, Nanoseconds to);

/// A recording of it, in the calling thread. kFileNotWritable, also when there is a file of this name or the disk has
/// no room for it; then there is none.
[[nodiscard]] Status save_recent(const std::string& path, const RecentRun& run);

}  // namespace syncline
