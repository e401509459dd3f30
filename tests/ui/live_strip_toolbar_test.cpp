// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/live_strip_toolbar.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QMenu>
#include <QToolButton>
#include <utility>
#include <vector>

#include "support/ui_test_support.h"
#include "ui/plots/cursor_item.h"
#include "ui/plots/time_view.h"

namespace syncline::ui {
namespace {

using View = LiveStripToolbar::View;

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
  std::vector<std::pair<View, bool>> toggled;
  QObject::connect(&bar, &LiveStripToolbar::viewToggled, &bar,
                   [&](View which, bool on) { toggled.emplace_back(which, on); });
  Q_EMIT all.menu()->aboutToShow();
  ASSERT_EQ(all.menu()->actions().size(), 5);
  EXPECT_EQ(all.menu()->actions().last()->text(), cycle.text());
  all.menu()->actions().last()->trigger();
  ASSERT_EQ(toggled.size(), 1U);
  EXPECT_EQ(toggled.front(), std::pair(View::kCycle, true));
  bar.setWanted(View::kCycle);
  EXPECT_TRUE(all.isChecked());
  EXPECT_EQ(all.text(), cycle.text()) << "which one is shown";
  bar.setWanted(View::kNone);
  EXPECT_FALSE(all.isChecked());
  bar.resize(1600, bar.height());
  QApplication::processEvents();
  EXPECT_TRUE(cycle.isVisible());
  EXPECT_FALSE(all.isVisible());
}

}  // namespace
}  // namespace syncline::ui
