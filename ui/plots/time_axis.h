// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "ui/plots/time_view.h"

namespace syncline::ui {

/// How the stretch that is shown is counted: backwards from now while it follows, else from the beginning of the run.
struct TimeAxis {
  double begin = 0, end = 0;  // s
  double divisor = 1;         // labels show seconds / divisor
  QString quantity, unit;
};
[[nodiscard]] TimeAxis timeAxisOf(const TimeView& view);

}  // namespace syncline::ui
