// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <vector>

#include "ui/plots/unit_scale_draw.h"

namespace syncline::ui {

class TimeView;

/// How the stretch that is shown is counted, as the view wants it. Only differences of times are floating-point.
struct TimeAxis {
  double begin = 0, end = 0;  // s
  double divisor = 1;         // labels show seconds / divisor
  QString quantity, unit;
  /// Where the labels stand, where they are no numbers of that unit; none: wherever there is room.
  std::vector<UnitScaleDraw::Tick> ticks{};
  bool labelled = false;  // by `ticks`, also where there are none
};
/// With at most so many ticks, where these are chosen here.
[[nodiscard]] TimeAxis timeAxisOf(const TimeView& view, int most);

}  // namespace syncline::ui
