// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace syncline {
struct MonitorView;
struct RecordingAbout;
}  // namespace syncline

namespace syncline::ui {

/// Views of the monitor of the project that was run; none where the recording has no project that can be read.
[[nodiscard]] std::vector<MonitorView> recordedViews(const RecordingAbout& about);

}  // namespace syncline::ui
