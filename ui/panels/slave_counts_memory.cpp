// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/slave_counts_memory.h"

#include <algorithm>

#include "ui/panels/live_strip.h"
#include "ui/plots/trace_panel.h"
#include "ui/session/window_memory.h"

namespace syncline::ui {
namespace {

const QString kWorstRemembered = QStringLiteral("plots/worst/");

}  // namespace

void rememberSlaveCounts(LiveStrip& strip, WindowMemory& memory) {
  for (auto* panel : strip.findChildren<TracePanel*>()) {
    const int count = memory.value(kWorstRemembered + panel->objectName()).toInt();
    if (panel->slavesShown() > 0 && count > 0) panel->setSlavesShown(std::min(count, TracePanel::kMostSlaves));
  }
  QObject::connect(&strip, &LiveStrip::slavesShownChosen, &memory,
                   [&memory](const QString& panel, int count) { memory.setValue(kWorstRemembered + panel, count); });
}

}  // namespace syncline::ui
