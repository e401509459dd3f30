// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "support/types.h"
#include "trace/named_signal.h"

namespace syncline {
class RunRecord;
}  // namespace syncline

namespace syncline::reports {

/// What the plots of a run show by themselves: the largest deviation, the DCM error, and the missed SM2 events of the
/// slave that has missed most, where it has missed any; those that have a value.
[[nodiscard]] std::vector<NamedSignal> usual_plots(const RunRecord& run);
/// "DCM error", "#3 Servo: SM2 events missed".
[[nodiscard]] std::string plot_title(const RunRecord& run, const NamedSignal& signal);

struct PlotsOf {
  const RunRecord& run;
  Nanoseconds begin = 0, end = 0;    // host clock
  std::vector<NamedSignal> signals;  // from top to bottom; no states, which have no curve
  std::string name;                  // of the recording
  double width = 1200, height = 0;   // pixels; height 0: 180 for each plot
};
/// Plots below each other on one time axis, which counts from the run's beginning, as a file of SVG: light, with
/// limits, faults, outages, date (UTC) and cycle. What has no value in the range says so. English, as all files are.
[[nodiscard]] std::string plots_svg(const PlotsOf& plots);

}  // namespace syncline::reports
