// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/json.h"
#include "trace/run_report.h"

namespace syncline::cli {

/// How long before `now` that was, in ms; null for 0, never.
[[nodiscard]] Json age_json(Nanoseconds time, Nanoseconds now);
/// What the figures of a run mean: `code`, `severity`, `slave`, `from_ms`, `to_ms`, `evidence`, `text`. docs/json.md.
[[nodiscard]] Json findings_json(const RunReport& report);
/// What was read of a slave besides its clock: ports, watchdogs, 0x1C32 and 0x1C33, each with its age.
[[nodiscard]] Json evidence_json(const RunReport::Slave& slave, Nanoseconds now);
/// One line a finding, most severe first; what many slaves have alike is one line.
[[nodiscard]] std::string findings_text(const RunReport& report);

}  // namespace syncline::cli
