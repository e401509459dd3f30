// SPDX-License-Identifier: Apache-2.0
#include "record/recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

#include "reasons/because.h"
#include "record/recording_schema.h"
#include "sqlite/database_files.h"
#include "support/attempt.h"

namespace syncline {
namespace {

constexpr double kMiB = 1024.0 * 1024.0;

Recorder::Stop failed(const Error& error) { return {error.detail.text(), error}; }

}  // namespace

Result<std::unique_ptr<Recorder>> Recorder::start(const std::string& path, const RecordingAbout& about,
                                                  const Options& options, std::function<void(const Stop&)> on_stopped) {
  auto writer = RecordingWriter::create(path, about);
  if (!writer) return tl::unexpected(writer.error());
  try {
    return std::unique_ptr<Recorder>(new Recorder(std::move(*writer), options, std::move(on_stopped)));
  } catch (const std::system_error&) {  // the system gives no thread
    remove_database(path);
    return fail(
        Error{.code = ErrorCode::kFileNotWritable, .detail = because("there is not enough memory"), .file = path});
  }
}

Recorder::Recorder(RecordingWriter writer, const Options& options, std::function<void(const Stop&)> on_stopped)
    : writer_(std::move(writer)),
      options_(options),
      on_stopped_(std::move(on_stopped)),
      no_memory_(failed({.code = ErrorCode::kFileNotWritable,
                         .detail = because("there is not enough memory"),
                         .file = writer_.path()})),
      thread_([this] { run(); }) {}

Recorder::~Recorder() {
  attempt([this] { return finish(); });
}

void Recorder::add(std::span<const CycleSample> samples) {
  std::unique_lock lock(mutex_);
  if (options_.wait_for_disk) room_.wait(lock, [&] { return stopped_ || finished_ || waiting_ < kMostWaiting; });
  if (stopped_ || finished_) return;
  if (waiting_ >= kMostWaiting) {
    lost_ += samples.size();
    return;
  }
  waiting_ += samples.size();
  for (const auto& sample : samples) {
    open_.samples.push_back(sample);
    if (is_due()) cut();
  }
}

void Recorder::add(const Snapshot& snapshot) {
  const std::lock_guard lock(mutex_);
  if (!stopped_ && !finished_ && snapshot.online) open_.snapshots.push_back({open_.samples.size(), snapshot});
}

void Recorder::add(RecordedEvent event) {
  const std::lock_guard lock(mutex_);
  if (!stopped_ && !finished_) open_.events.push_back(std::move(event));
}

void Recorder::add(RunNote note) {
  const std::lock_guard lock(mutex_);
  if (!stopped_ && !finished_) open_.notes.push_back(std::move(note));
}

void Recorder::tell(std::vector<RecordedFinding> findings) {
  const std::lock_guard lock(mutex_);
  if (!stopped_ && !finished_) open_.findings = std::move(findings);
}

void Recorder::tell(const RunStanding& standing) {
  const std::lock_guard lock(mutex_);
  if (!stopped_ && !finished_) open_.standing = standing;
}

void Recorder::tell(RecordedDocument document) {
  const std::lock_guard lock(mutex_);
  if (!stopped_ && !finished_) open_.documents.push_back(std::move(document));
}

void Recorder::tell(std::vector<WatchedVariable> list) {
  const std::lock_guard lock(mutex_);
  if (!stopped_ && !finished_) open_.lists.push_back(std::move(list));
}

std::uint64_t Recorder::lost_samples() const {
  const std::lock_guard lock(mutex_);
  return lost_;
}

bool Recorder::is_due() const {
  const auto& samples = open_.samples;
  return samples.back().send_time - samples.front().send_time >= options_.commit_every ||
         samples.size() >= static_cast<std::size_t>(kMostBlockCycles);
}

void Recorder::cut() {
  ready_.push_back(std::exchange(open_, {}));
  news_.notify_one();
}

/// Memory that there is not ends the recording, not the run: what is written is whole.
void Recorder::run() noexcept {
  try {
    write_all();
    return;
  } catch (const std::exception&) {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
    why_stopped_.swap(no_memory_.why);
    if (status_) status_ = tl::unexpected(std::move(*no_memory_.error));  // made before: there is none for it now
    open_ = {};
    ready_.clear();
  }
  room_.notify_all();
  try {
    if (on_stopped_) on_stopped_({why_stopped_, status_.error()});
  } catch (const std::exception&) {
    return;  // not even for a sentence; finish() tells it
  }
}

void Recorder::write_all() {
  std::unique_lock lock(mutex_);
  for (;;) {
    const bool came = news_.wait_for(lock, std::chrono::nanoseconds(options_.commit_every),
                                     [this] { return ending_ || !ready_.empty(); });
    // What has waited for so long is written also where the run stands still; on virtual time this would make files of
    // the same run differ by how busy the host is.
    if (!open_.empty() && (ending_ || (!came && options_.by_clock))) cut();
    if (ready_.empty() && ending_) return;
    while (!ready_.empty()) {
      const auto batch = std::move(ready_.front());
      ready_.pop_front();
      lock.unlock();
      write(batch);
      lock.lock();
      waiting_ -= std::min(waiting_, batch.samples.size());
      room_.notify_all();
    }
  }
}

void Recorder::write(const RecordingBatch& batch) {
  {
    const std::lock_guard lock(mutex_);
    if (stopped_) return;
  }
  if (const auto status = writer_.write(batch); !status) return stop(failed(status.error()));
  if (const auto reached = bound_reached()) stop(*reached);
}

std::optional<Recorder::Stop> Recorder::bound_reached() const {
  if (options_.longest > 0 && writer_.duration() >= options_.longest) {
    return Stop{fmt::format("it has its length of {} s", static_cast<double>(options_.longest) / 1e9), {}};
  }
  std::error_code error;
  if (!std::filesystem::exists(writer_.path(), error)) {
    return failed({.code = ErrorCode::kFileNotWritable,
                   .detail = because("the file is gone: it, or its folder, was deleted or moved while it was recorded"),
                   .file = writer_.path()});
  }
  const auto bytes = writer_.bytes();
  if (options_.most_bytes > 0 && bytes >= options_.most_bytes) {
    return Stop{fmt::format("it has its size of {:.1f} MiB", static_cast<double>(options_.most_bytes) / kMiB), {}};
  }
  const auto folder = std::filesystem::absolute(writer_.path(), error).parent_path();
  const auto space = std::filesystem::space(folder, error);
  if (error || space.available >= options_.keep_free_bytes) return std::nullopt;
  return failed({.code = ErrorCode::kFileNotWritable,
                 .detail = because("only {left} MiB are left on the disk; the recording is whole up to here",
                                   fmt::format("{:.0f}", static_cast<double>(space.available) / kMiB)),
                 .file = writer_.path()});
}

void Recorder::stop(const Stop& reason) {
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
    why_stopped_ = reason.why;
    if (status_ && reason.error) status_ = tl::unexpected(*reason.error);
    open_ = {};
    ready_.clear();
  }
  room_.notify_all();
  if (on_stopped_) on_stopped_(reason);
}

Status Recorder::finish(const std::string& why, std::span<const RecordedFinding> findings) {
  {
    const std::lock_guard lock(mutex_);
    if (finished_) return status_;
    finished_ = true;
    ending_ = true;
  }
  news_.notify_one();
  thread_.join();
  auto status = writer_.finish(stopped_ ? why_stopped_ : why, findings);
  if (status_ && !status) status_ = std::move(status);
  return status_;
}

}  // namespace syncline
