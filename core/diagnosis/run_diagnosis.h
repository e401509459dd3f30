// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

/// What a run's figures mean: pure rules on a RunReport, the same for the command line, the window and the report.
namespace syncline {

struct Finding;
struct RunReport;

/// Most severe first, then by slave. A healthy run has none above a note.
[[nodiscard]] std::vector<Finding> diagnose(const RunReport& report);

}  // namespace syncline
