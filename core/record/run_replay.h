// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "record/overview_marks.h"
#include "record/recording_reader.h"

namespace syncline {

struct ReplayedRun;

/// A recorded run as it was at a moment of it: verdicts, figures and faults, events and samples are what somebody saw
/// who looked at the running machine then. The run's record itself is what shows them (RunRecord::show_at()), so that
/// nothing is kept twice; the overview is made of the recording's samples between the mark before the moment and the
/// moment. A moment costs the same wherever it lies: some milliseconds.
///
/// What a recording does not hold, no moment of it has: limits are those in force last; of arming only the last one is
/// known, before it the run is taken to have armed itself; findings are those of its end. Lives in one thread.
class RunReplay {
 public:
  /// `run` was read with the reader, and must outlive this; its marks are taken. As RecordingReader::blocks().
  [[nodiscard]] static Result<RunReplay> open(RecordingReader reader, ReplayedRun& run);
  RunReplay(RunReplay&&) noexcept = default;
  RunReplay& operator=(RunReplay&&) = delete;
  /// The run's record is to be shown whole before: leave().
  ~RunReplay() = default;

  /// Shows it at this moment (host clock), or at the next one that the recording has. kFileNotReadable where the
  /// recording is gone, or damaged since it was opened; all of it is shown then.
  [[nodiscard]] Status show(Nanoseconds moment);
  /// Shows all of it.
  void leave();
  /// Closes the file, for whoever wants to write notes into it; it is opened again when it is read next.
  void release() { reader_.reset(); }

  /// Of the first and the last cycle that the run's record keeps.
  [[nodiscard]] Nanoseconds begin() const { return begin_; }
  [[nodiscard]] Nanoseconds end() const { return end_; }
  /// All that are known as values, in the order of their coming.
  [[nodiscard]] const std::vector<Event>& events() const { return events_; }

 private:
  RunReplay(RecordingReader reader, ReplayedRun& run, std::vector<RecordingReader::Block> blocks);
  [[nodiscard]] Status make_overview(Nanoseconds moment);
  [[nodiscard]] Status read_current();
  /// Of the current block up to the moment; true: all of it.
  bool take(Nanoseconds until);
  void begin_anew(std::size_t block);

  std::string path_;
  std::optional<RecordingReader> reader_;  // none: released
  RunRecord* record_;
  OverviewRecorder fresh_;  // of the run before its first cycle
  OverviewMarks marks_;
  std::vector<RecordingReader::Block> blocks_;
  std::vector<Finding> damage_;  // that was there when it was opened
  std::vector<Event> events_;
  Nanoseconds begin_ = 0, end_ = 0;

  OverviewRecorder overview_;  // of what was taken
  Nanoseconds taken_until_ = INT64_MIN;
  std::size_t block_ = 0;             // the one that is being taken
  std::vector<CycleSample> samples_;  // of it; empty: not read yet
  std::size_t taken_samples_ = 0;     // of them
  std::size_t taken_events_ = 0;
};

}  // namespace syncline
