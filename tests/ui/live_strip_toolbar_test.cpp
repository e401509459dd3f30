// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/live_strip_toolbar.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QMenu>
#include <QSignalSpy>
#include <QToolButton>

#include "support/ui_test_support.h"

namespace syncline::ui {
namespace {

/// Where there is no room for all views, one button has them in its menu.
TEST(LiveStripToolbar, KeepsEveryViewInReachHoweverNarrowItIs) {
  TimeView view;
  CursorSet cursors;
  QWidget window;  // one that stands alone would not become narrower than its layout
  LiveStripToolbar bar(&view, &cursors, &window);
  window.resize(1700, 100);
  auto& all = *test::find<QToolButton>(bar, "viewsButton");
  auto& cycle = *test::find<QToolButton>(bar, "cycleButton");
  bar.resize(1600, bar.sizeHint().height());
  window.show();
  QApplication::processEvents();
  EXPECT_TRUE(cycle.isVisible());
  EXPECT_FALSE(all.isVisible());
  const int least = bar.minimumSizeHint().width();
  bar.resize(least, bar.height());
  QApplication::processEvents();
  EXPECT_FALSE(cycle.isVisible());
  EXPECT_TRUE(all.isVisible());
  EXPECT_EQ(bar.minimumSizeHint().width(), least) << "whichever way it is";
  QSignalSpy toggled(&bar, &LiveStripToolbar::cycleToggled);
  Q_EMIT all.menu()->aboutToShow();
  ASSERT_EQ(all.menu()->actions().size(), 4);
  EXPECT_EQ(all.menu()->actions().last()->text(), cycle.text());
  all.menu()->actions().last()->trigger();
  ASSERT_EQ(toggled.count(), 1);
  EXPECT_TRUE(toggled.takeFirst().front().toBool());
  bar.setWanted(false, false, false, true);
  EXPECT_TRUE(all.isChecked());
  EXPECT_EQ(all.text(), cycle.text()) << "which one is shown";
  bar.setWanted(false, false, false, false);
  EXPECT_FALSE(all.isChecked());
  bar.resize(1600, bar.height());
  QApplication::processEvents();
  EXPECT_TRUE(cycle.isVisible());
  EXPECT_FALSE(all.isVisible());
}

}  // namespace
}  // namespace syncline::ui
