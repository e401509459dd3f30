// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "channels/cycle_sample.h"
#include "channels/snapshot.h"
#include "record/recording.h"
#include "record/recording_rows.h"
#include "record/run_note.h"
#include "sqlite/sqlite_database.h"
#include "trace/sample_store.h"

namespace syncline {

/// What one commit holds.
struct RecordingBatch {
  struct Taken {
    std::size_t after = 0;  // so many of the samples came before it
    Snapshot snapshot;
  };
  std::vector<CycleSample> samples;
  std::vector<Taken> snapshots;
  std::vector<RecordedEvent> events;
  std::vector<RunNote> notes;
  std::optional<std::vector<RecordedFinding>> findings{};  // what the run means by now, in place of what it meant
  std::optional<RunStanding> standing{};                   // in place of what was before
  std::vector<RecordedDocument> documents{};               // each in place of that of its kind
  std::vector<std::vector<WatchedVariable>> lists{};       // of watched variables that samples may be of from now on
  [[nodiscard]] bool empty() const {
    return samples.empty() && snapshots.empty() && events.empty() && notes.empty() && !findings && !standing &&
           documents.empty() && lists.empty();
  }
};

/// Writes a recording, in the calling thread. Everything is whole up to the last commit, whatever kills the program.
class RecordingWriter {
 public:
  /// kFileNotWritable, also when there is a file of this name; nothing is left of what could not be begun.
  [[nodiscard]] static Result<RecordingWriter> create(const std::string& path, const RecordingAbout& about);

  /// One commit: a block for each stretch of samples, and what came with it.
  [[nodiscard]] Status write(const RecordingBatch& batch);
  /// Counts and states of slaves, and totals, are those of a run that was watched; it outlives the next write(). From
  /// then on snapshots are not looked at.
  void take_held_from(const SampleStore& watched) { watched_ = &watched; }
  /// The last commit: why it ended, and what the run means. The file is then one file, to be read anywhere.
  [[nodiscard]] Status finish(const std::string& why, std::span<const RecordedFinding> findings);

  [[nodiscard]] const std::string& path() const { return database_.path(); }
  /// From the first sample to the last.
  [[nodiscard]] Nanoseconds duration() const { return any_ ? last_ - first_ : 0; }
  [[nodiscard]] std::uint64_t bytes() const;

 private:
  RecordingWriter(SqlDatabase database, const RecordingAbout& about);
  Status begin(const RecordingAbout& about);
  Status put_signals();
  Status put_meta(std::string_view key, std::string_view value);
  Status put_told(const RecordingBatch& batch);
  Status put_limits(const RunLimits& values);
  Status put_armed(Nanoseconds time);
  Status put_documents(std::span<const RecordedDocument> documents);
  Status put_findings(std::span<const RecordedFinding> findings);
  /// Those behind the first `variables` and `lists`.
  Status put_watched(std::size_t variables, std::size_t lists);
  Status add_lists(std::span<const std::vector<WatchedVariable>> lists);
  void store(const RecordingBatch& batch);
  /// `held_from`: with what slaves and counts have shown, of a recording that begins there; nothing: without.
  Status put_block(std::span<const CycleSample> samples, std::optional<Nanoseconds> held_from);
  /// How many have values.
  Result<std::int64_t> put_columns(std::span<const CycleSample> samples);
  Result<std::int64_t> put_variables(std::span<const CycleSample> samples);
  Status put_sums(std::span<const CycleSample> samples);
  /// What slaves and counts have shown since the block before; how many rows that is.
  Result<std::int64_t> put_held(std::int64_t block, Nanoseconds begin);
  Status put_series(std::int64_t series, Signal signal, int slave);
  Status put_summary(std::int64_t block, std::int64_t series, const std::vector<float>& values);

  SqlDatabase database_;
  SampleStore store_;  // the same that draws: gaps and ages are decided once
  const SampleStore* watched_ = nullptr;
  WatchLists lists_;                             // of watched variables
  std::map<std::int64_t, Nanoseconds> written_;  // by series, time of the newest sample
  std::set<std::int64_t> known_series_;
  RowTally tally_ = RowTally::of_all();
  std::int64_t blocks_ = 0, events_ = 0, notes_ = 0;
  std::int64_t sums_ = 0;  // rows of the block that is written
  Nanoseconds first_ = 0, last_ = 0;
  bool any_ = false;
};

}  // namespace syncline
