// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/result.h"
#include "trace/signals.h"

namespace syncline {
struct Project;
struct RunLimits;
}  // namespace syncline

namespace syncline::ui {

class ProjectDocument;

/// What a run of the project would be held against.
[[nodiscard]] RunLimits limitsOf(const Project& project);
/// The limit of a signal in the project, as one undo step: of deviations the sync window, to the nearest 2^n - 1 ns; of
/// the DCM error its in-sync limit. `magnitude` in ns. kBadValue where the signal has none, or it is out of range.
Status setLimit(ProjectDocument& document, Signal signal, double magnitude);

}  // namespace syncline::ui
