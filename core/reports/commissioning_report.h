// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "record/recording.h"

namespace syncline {
struct ReplayedRun;
}  // namespace syncline

namespace syncline::reports {

struct Acceptance;

/// What the report knows beside the run. Texts are somebody's own and are escaped here.
struct CommissioningFacts {
  std::string machine;                        // name of the project or of the recording's file
  std::string date;                           // when the report was made
  std::string program;                        // by which
  std::string recording{};                    // name of its file; "": a run out of memory
  std::string recorded_by{}, link{};          // program and link of the run
  std::optional<std::string> ended{};         // why; nothing: cut short, or it goes on
  std::vector<RecordedDocument> documents{};  // what was run, told by name, size and SHA-256
  std::vector<RecordedFinding> told{};        // findings of which only the words are known
};

/// Those of a run but for date and program; the machine's name is that of its project's file. `path`: of the recording,
/// which gives the name where there is no project; "": out of memory.
[[nodiscard]] CommissioningFacts facts_of(const RecordingAbout& about, const std::string& path);
/// The same of a recording, with how it ended and what was found in words.
[[nodiscard]] CommissioningFacts facts_of(const ReplayedRun& run, const std::string& path);
/// What was found, for judge(), also where only the words are known.
[[nodiscard]] std::vector<Finding> severities_of(const ReplayedRun& run);

/// What an integrator hands over with a machine: whether its synchronisation was as required, by what that was judged,
/// and the evidence. One HTML file in English, as exports/html_page.h; the same bytes for the same run and facts.
[[nodiscard]] std::string commissioning_report(const RunRecord& run, const CommissioningFacts& facts,
                                               const Acceptance& acceptance);

/// SHA-256 (FIPS 180-4) in hexadecimal.
[[nodiscard]] std::string sha256_text(std::string_view bytes);

}  // namespace syncline::reports
