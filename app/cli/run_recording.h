// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>

#include "app/cli/context.h"
#include "record/recording_session.h"

namespace syncline {
class WatchLists;
struct NetworkConfig;
struct RunReport;
}  // namespace syncline

namespace CLI {
class App;
}  // namespace CLI

namespace syncline::cli {

struct RecordOptions {
  std::string file;     // "": none
  std::string longest;  // "10min"; "": the whole run
  std::uint32_t most_mib = 0, keep_free_mib = 256;
};
void add_record_options(CLI::App& command, RecordOptions& options);

/// The recording of a run, with what was run: the file as the user gave it, and its configuration as ENI. Does nothing
/// without a file name.
class RunRecording {
 public:
  [[nodiscard]] static Result<std::unique_ptr<RunRecording>> start(Context& context, const RecordOptions& options,
                                                                   const std::string& file, const std::string& link,
                                                                   const NetworkConfig& config,
                                                                   const WatchLists& watched, bool virtual_time);
  void add(std::span<const CycleSample> samples);
  void add(const Snapshot& snapshot);
  void add(const Event& event);
  /// With the findings; what failed is told now, at the latest.
  void finish(RunReport report);

 private:
  explicit RunRecording(Context& context) : context_(context) {}
  /// What the recorder's thread has said, in the thread that prints.
  void tell();

  Context& context_;
  std::string file_;
  std::mutex mutex_;
  std::optional<RecordingStop> stop_;
  std::unique_ptr<RecordingSession> session_;  // last: its thread uses what stands above
};

}  // namespace syncline::cli
