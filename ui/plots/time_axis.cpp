// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/time_axis.h"

#include "ui/plots/trace_plot.h"

namespace syncline::ui {

TimeAxis timeAxisOf(const TimeView& view) {
  const auto span = static_cast<double>(view.span()) / 1e9;
  if (view.mode() == TimeView::Mode::kLive) {
    const bool small = span <= 1;
    return {-span, 0, small ? 1e-3 : 1, TracePlot::tr("Time before now"),
            small ? QStringLiteral("ms") : QStringLiteral("s")};
  }
  const double end = static_cast<double>(view.end() - view.origin()) / 1e9;
  return {end - span, end, 1, TracePlot::tr("Time since start"), QStringLiteral("s")};
}

}  // namespace syncline::ui
