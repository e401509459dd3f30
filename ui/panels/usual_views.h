// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace syncline {
struct MonitorView;
class RunRecord;
}  // namespace syncline

namespace syncline::ui {

struct SignalSource;

/// Signals that are alike, states and those of one unit, in a plot each.
[[nodiscard]] MonitorView viewOf(const RunRecord& record, const std::vector<SignalSource>& sources);

/// Views to begin with, made for the run at hand: its master synchronisation, the states of all its slaves, its frames,
/// and the counters of one slave, by position (-1: the first one).
[[nodiscard]] std::vector<MonitorView> usualViews(const RunRecord& record, int slave);

}  // namespace syncline::ui
