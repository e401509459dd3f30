// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/slave_counts_memory.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>

#include "support/ui_test_support.h"
#include "ui/panels/live_strip.h"
#include "ui/plots/trace_panel.h"
#include "ui/session/window_memory.h"

namespace syncline::ui {
namespace {

TEST(SlaveCounts, AreThoseOfTheLastStart) {
  const QTemporaryDir folder;
  const auto file = folder.filePath(QStringLiteral("window.ini"));
  {
    WindowMemory memory(file);
    LiveStrip strip;
    rememberSlaveCounts(strip, memory);
    ASSERT_EQ(strip.panels()[0]->slavesShown(), 3);
    Q_EMIT strip.slavesShownChosen(strip.panels()[0]->objectName(), 5);
  }
  WindowMemory memory(file);
  LiveStrip strip;
  rememberSlaveCounts(strip, memory);
  EXPECT_EQ(strip.panels()[0]->slavesShown(), 5);
  EXPECT_EQ(strip.panels()[1]->slavesShown(), 4) << "each for itself";
  memory.setValue(QStringLiteral("plots/worst/sm2Panel"), 99);
  LiveStrip other;
  rememberSlaveCounts(other, memory);
  EXPECT_EQ(other.panels()[1]->slavesShown(), TracePanel::kMostSlaves);
}

}  // namespace
}  // namespace syncline::ui
