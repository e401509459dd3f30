// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>

#include "record/recording_bounds.h"
#include "record/recording_writer.h"

namespace syncline {

/// Records a run to disk in a thread of its own: whoever drains the channels hands over what came, and the disk may
/// take its time. A commit a second; what a kill takes is at most what came since the last one.
class Recorder {
 public:
  using Options = RecordingBounds;
  using Stop = RecordingStop;
  /// `on_stopped` is called once, in the recorder's thread. kFileNotWritable as RecordingWriter::create().
  [[nodiscard]] static Result<std::unique_ptr<Recorder>> start(const std::string& path, const RecordingAbout& about,
                                                               const Options& options,
                                                               std::function<void(const Stop&)> on_stopped);
  /// As finish() without words.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// For one thread, that which drains. After the recording has stopped they do nothing.
  void add(std::span<const CycleSample> samples);
  void add(const Snapshot& snapshot);
  void add(RecordedEvent event);
  void add(RunNote note);
  /// What the run means by now; a recording that is cut short keeps the last that were told.
  void tell(std::vector<RecordedFinding> findings);
  /// What it is held against by now, and since when.
  void tell(const RunStanding& standing);
  /// What is run by now, in place of the document of its kind.
  void tell(RecordedDocument document);
  /// The samples of the next list of watched variables may come from now on, as RunRecord::watch() is told.
  void tell(std::vector<WatchedVariable> list);
  /// The rest is on the disk, with why the recording ended and what the run means. The first error of all.
  Status finish(const std::string& why = "end of the run", std::span<const RecordedFinding> findings = {});

  /// Samples that the disk was too slow for; they are missing in the file as cycles that never came.
  [[nodiscard]] std::uint64_t lost_samples() const;

 private:
  static constexpr std::size_t kMostWaiting = 1U << 19;  // samples between the two threads, 150 MB

  Recorder(RecordingWriter writer, const Options& options, std::function<void(const Stop&)> on_stopped);
  void run() noexcept;
  void write_all();
  /// With the lock: what is open has its length. Cut by the run's time, so that the same run gives the same file.
  [[nodiscard]] bool is_due() const;
  void cut();
  void write(const RecordingBatch& batch);
  /// Why no more is to be written.
  [[nodiscard]] std::optional<Stop> bound_reached() const;
  void stop(const Stop& reason);

  RecordingWriter writer_;
  Options options_;
  std::function<void(const Stop&)> on_stopped_;
  Stop no_memory_;
  mutable std::mutex mutex_;
  std::condition_variable news_, room_;
  RecordingBatch open_;
  std::deque<RecordingBatch> ready_;
  std::size_t waiting_ = 0;  // samples in both
  std::uint64_t lost_ = 0;
  bool ending_ = false, finished_ = false, stopped_ = false;
  std::string why_stopped_;
  Status status_;
  std::thread thread_;  // last: it uses everything above
};

}  // namespace syncline
