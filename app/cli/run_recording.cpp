// SPDX-License-Identifier: Apache-2.0
#include "app/cli/run_recording.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>
#include <vector>

#include "app/cli/duration.h"
#include "app/cli/options.h"
#include "diagnosis/run_diagnosis.h"
#include "eni/format/eni_file.h"
#include "record/recording.h"
#include "support/whole_file.h"
#include "trace/run_report.h"

namespace syncline::cli {
namespace {

constexpr std::uint64_t kMiB = 1ULL << 20;

Result<RecordingAbout> about(const std::string& file, const std::string& link, const NetworkConfig& config) {
  auto text = read_whole_file(file);
  if (!text) return tl::unexpected(text.error());
  auto result = about_run(config);
  add_source(result, {.program = std::string("synclinectl ") + SYNCLINE_VERSION,
                      .link = link,
                      .project_name = std::filesystem::path(file).filename().string(),
                      .project_body = std::move(*text),
                      .eni = eni::write_eni(config)});
  return result;
}

}  // namespace

void add_record_options(CLI::App& command, RecordOptions& options) {
  auto* record = command.add_option("--record", options.file,
                                    "Record the run to this new file: every cycle, events, findings and what was run");
  command
      .add_option("--record-longest", options.longest, "End the recording after so long, e.g. 10min; the run goes on")
      ->needs(record);
  command.add_option("--record-most-mib", options.most_mib, "End the recording at this size; the run goes on")
      ->needs(record);
  command
      .add_option("--record-keep-free-mib", options.keep_free_mib,
                  "End the recording when the disk has less room than this left")
      ->needs(record)
      ->capture_default_str();
}

Result<std::unique_ptr<RunRecording>> RunRecording::start(Context& context, const RecordOptions& options,
                                                          const std::string& file, const std::string& link,
                                                          const NetworkConfig& config, const WatchLists& watched,
                                                          bool virtual_time) {
  std::unique_ptr<RunRecording> recording(new RunRecording(context));
  if (options.file.empty()) return recording;
  RecordingBounds bounds;
  if (!options.longest.empty()) {
    const auto longest = parse_duration(options.longest);
    if (!longest) return tl::unexpected(longest.error());
    bounds.longest = *longest;
  }
  bounds.most_bytes = options.most_mib * kMiB;
  bounds.keep_free_bytes = options.keep_free_mib * kMiB;
  auto what = about(file, link, config);
  if (!what) return tl::unexpected(what.error());
  what->watched = watched;
  const auto stopped = [where = recording.get()](const RecordingStop& stop) {
    const std::lock_guard lock(where->mutex_);
    where->stop_ = stop;
  };
  auto session =
      RecordingSession::start({.path = options.file, .virtual_time = virtual_time, .bounds = bounds}, *what, stopped);
  if (!session) return tl::unexpected(session.error());
  recording->session_ = std::move(*session);
  recording->file_ = options.file;
  return recording;
}

void RunRecording::add(std::span<const CycleSample> samples) {
  if (!session_) return;
  session_->add(samples);
  tell();
}

void RunRecording::add(const Snapshot& snapshot) {
  if (session_) session_->add(snapshot);
}

void RunRecording::add(const Event& event) {
  if (session_) session_->add(event);
}

void RunRecording::tell() {
  const std::lock_guard lock(mutex_);
  if (!stop_) return;
  if (stop_->error) {
    context_.fail_with(*stop_->error);
  } else {
    context_.console.err << fmt::format("{}: the recording has ended, {}; the run goes on\n", file_, stop_->why);
  }
  stop_.reset();
}

void RunRecording::finish(RunReport report) {
  if (!session_) return;
  report.told_from = session_->told_from();  // all times of a recording are told from there on
  const auto status = session_->finish("end of the run", recorded(diagnose(report)));
  const bool told = [this] {
    const std::lock_guard lock(mutex_);
    return !stop_;
  }();
  tell();
  if (!status && told && context_.exit_code == kDone) context_.fail_with(status.error());
}

}  // namespace syncline::cli
