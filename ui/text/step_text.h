// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "support/types.h"

namespace syncline {
class RunRecord;
}  // namespace syncline

namespace syncline::ui {

/// How the error of the master synchronisation came back from a step at `begin`, up to `end` (host clock), and how its
/// controller would bring it back without noise; empty where no step is seen.
[[nodiscard]] QString stepText(const RunRecord& record, Nanoseconds begin, Nanoseconds end);

}  // namespace syncline::ui
