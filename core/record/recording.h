// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "findings/finding.h"
#include "record/run_limits.h"
#include "trace/sync0_slaves.h"
#include "trace/watch_lists.h"

/// What stands in a recording besides samples: given by who records, read back as it was.
namespace syncline {

class RunRecord;
struct NetworkConfig;

struct RecordedDocument {
  std::string kind;  // "project", "configuration"; one of each
  std::string name;  // of the file it came from
  std::string body;
  bool operator==(const RecordedDocument&) const = default;
};

struct RecordingSlave {
  std::string name;
  std::uint32_t vendor_id = 0, product_code = 0, revision_no = 0;
  bool operator==(const RecordingSlave&) const = default;
};

/// About the run as a whole.
struct RecordingAbout {
  static constexpr Nanoseconds kNotArmed = INT64_MAX;

  std::string program;  // "synclinectl 0.1.0"
  std::string link;     // LINK text
  std::vector<RecordedDocument> documents;
  std::vector<RecordingSlave> slaves;
  RunLimits limits;  // those in force last
  /// Host clock: since when the run's figures were taken last; kNotArmed: not yet; nothing: not known.
  std::optional<Nanoseconds> armed;
  std::uint16_t speed_counter_start = 0x1000;  // register 0x0930
  std::vector<Sync0Slave> sync0{};             // by position; out of the configuration, and not in the file
  WatchLists watched{};                        // of the whole recording
};
/// Slaves and limits of a configuration; the rest is left to the caller.
[[nodiscard]] RecordingAbout about_run(const NetworkConfig& config);
/// The same of a run that goes on: what it is held against now, and since when.
[[nodiscard]] RecordingAbout about_run(const RunRecord& run);

struct RecordedEvent {
  Nanoseconds time = 0;  // host clock
  int slave = -1;        // -1: the master or the bus
  std::string kind;      // as docs/json.md lists them
  std::string text;
  std::string details{};  // what happened as encode_event() writes it; "": only the words are known
  bool operator==(const RecordedEvent&) const = default;
};

struct RecordedFinding {
  std::string code, level;
  int slave = -1;
  std::string text;
  std::string details{};  // as encode_finding() writes it; "": only the words are known
  bool operator==(const RecordedFinding&) const = default;
};
/// Whether it is about the file that a run was read from, not about the run.
[[nodiscard]] bool is_about_file(const Finding& finding);
[[nodiscard]] std::vector<RecordedFinding> recorded(std::span<const Finding> findings);

}  // namespace syncline
