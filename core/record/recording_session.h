// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "channels/cycle_sample.h"
#include "record/recording_bounds.h"
#include "record/run_limits.h"

namespace syncline {

class Recorder;
class RunRecord;
struct Event;
struct RecordedDocument;
struct RecordedFinding;
struct RecordingAbout;
struct RunNote;
struct Snapshot;
struct WatchedVariable;

/// What a recording says of where its run comes from.
struct RecordingSource {
  std::string program;                     // "synclinectl 0.1.0"
  std::string link;                        // LINK text
  std::string project_name, project_body;  // the file that was run: its name without folders, and its text
  std::string eni;                         // the configuration that was run, as an ENI
};
void add_source(RecordingAbout& about, RecordingSource source);
/// The document of a recording that holds what was run: also what was applied to it since.
[[nodiscard]] RecordedDocument project_document(std::string name, std::string body);

/// A run that goes to disk while it goes on, once for both programs: which of what is drained goes into the file, in
/// which form and how often. For the thread that drains; finish() for any, once that has handed it over.
class RecordingSession {
 public:
  struct Request {
    std::string path;
    bool virtual_time = false;
    RecordingBounds bounds{};  // but `by_clock`, which follows from the clock
  };
  /// `begun`: host clock of the newest sample by now, from which on findings count where no other comes; 0: none. See
  /// Recorder::start() for `on_stopped` and for the errors.
  [[nodiscard]] static Result<std::unique_ptr<RecordingSession>> start(
      Request request, const RecordingAbout& about, std::function<void(const RecordingStop&)> on_stopped,
      Nanoseconds begun = 0);
  ~RecordingSession();
  RecordingSession(const RecordingSession&) = delete;
  RecordingSession& operator=(const RecordingSession&) = delete;

  void add(std::span<const CycleSample> samples);
  void add(const Snapshot& snapshot);
  /// In its English words; what only programs care about is left out.
  void add(const Event& event);
  void add(const RunNote& note);
  void tell(RecordedDocument document);
  void tell(std::vector<WatchedVariable> list);

  // Of a run that is kept whole; `run` is always the one that is recorded.
  /// What it means already; its standing is among what the recording began with.
  void begin(const RunRecord& run);
  /// Its standing where that is another one, and, once a second of its time, what its triggers have found.
  void follow(const RunRecord& run);
  /// The triggers of the run have found something that the file has not been told.
  void note_triggers() { triggers_new_ = true; }
  /// What it means by now.
  void tell_findings(const RunRecord& run);
  /// All that was not told yet; finish() may follow in another thread, with the findings that this returns.
  [[nodiscard]] std::vector<RecordedFinding> close(const RunRecord& run);

  /// Host clock: findings count their moments from here on. That of the first sample in the file.
  [[nodiscard]] Nanoseconds told_from() const { return first_ != 0 ? first_ : begun_; }
  /// Of the run, in the file, by `run`'s samples.
  [[nodiscard]] Nanoseconds duration(const RunRecord& run) const;
  [[nodiscard]] std::uint64_t lost_samples() const;
  /// The rest is on the disk. The first error of all.
  Status finish(const std::string& why, std::span<const RecordedFinding> findings);

 private:
  explicit RecordingSession(Nanoseconds begun);
  void tell_standing(const RunRecord& run);
  void tell_triggers(const RunRecord& run, bool at_end);

  Nanoseconds begun_, first_ = 0;    // first_: of the samples in the file; 0: none yet
  std::optional<RunStanding> told_;  // to the recorder
  bool triggers_new_ = false;
  Nanoseconds triggers_told_ = 0;
  std::unique_ptr<Recorder> recorder_;
};

}  // namespace syncline
