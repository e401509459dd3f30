// SPDX-License-Identifier: Apache-2.0
// A machine that does not start: what is said of it, and the ways on.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "settings/settings_table.h"
#include "support/running_window.h"
#include "ui/dialogs/found_dialog.h"
#include "ui/panels/explorer_panel.h"
#include "ui/panels/live_strip.h"

namespace syncline::ui {
namespace {

class RefusedStart : public test::RunningWindow {
 protected:
  /// The project has a revision of a drive that is not on the bus.
  void spoil() {
    load();
    ASSERT_TRUE(workspace_.document().edit(QStringLiteral("spoil"), [](Project& project) -> Status {
      project.slaves[kServo].device.identity.product_code += 1;
      return {};
    }));
  }
  void start() {
    ASSERT_TRUE(workspace_.goOnline());
    for (int i = 0; i < 200 && workspace_.live().phase() != LiveSession::Phase::kOffline; ++i) run(20 * kMillisecond);
    ASSERT_EQ(workspace_.live().phase(), LiveSession::Phase::kOffline);
  }
  QString said() { return field<QLabel>("startBarText").text(); }
};

TEST_F(RefusedStart, IsSaidBelowThePagesUntilItIsClosed) {
  spoil();
  EXPECT_FALSE(field("startBar").isVisible());
  start();
  ASSERT_TRUE(field("startBar").isVisible());
  EXPECT_TRUE(said().contains(QString::fromStdString(project().slaves[kServo].name))) << qPrintable(said());
  EXPECT_TRUE(said().contains(QStringLiteral("0x00007002")))
      << "as the project and the ESI write it: " << qPrintable(said());
  EXPECT_FALSE(said().contains(QStringLiteral("further")))
      << "one slave, however often it was asked: " << qPrintable(said());
  EXPECT_LE(window_.liveStrip().height(), 2 * window_.fontMetrics().height()) << "nothing to plot";
  window_.selectNode(kCoupler);
  field<QPushButton>("startBarSlave").click();
  EXPECT_EQ(window_.explorer().selected(), kServo);
  field<QToolButton>("startBarClose").click();
  EXPECT_FALSE(field("startBar").isVisible());
}

TEST_F(RefusedStart, LooksAtTheBusBesideTheProject) {
  spoil();
  start();
  field<QPushButton>("startBarScan").click();
  ASSERT_TRUE(test::waitFor([this] { return window_.findChild<FoundDialog*>() != nullptr; }));
  window_.findChild<FoundDialog*>()->reject();
  EXPECT_TRUE(field("startBar").isVisible());
  workspace_.document().replace(QStringLiteral("taken over"), test::smallProject());
  EXPECT_FALSE(field("startBar").isVisible()) << "other slaves, perhaps those of the bus";
}

TEST_F(RefusedStart, IsForgottenWithAStartThatSucceeds) {
  spoil();
  start();
  ASSERT_TRUE(field("startBar").isVisible());
  workspace_.document().undoStack().undo();
  ASSERT_TRUE(workspace_.goOnline());
  EXPECT_FALSE(field("startBar").isVisible());
  for (int i = 0; i < 100 && workspace_.live().snapshot().state != AlState::kOp; ++i) run(200 * kMillisecond);
  ASSERT_EQ(workspace_.live().snapshot().state, AlState::kOp);
  workspace_.live().shutDown();
  EXPECT_FALSE(field("startBar").isVisible()) << "whoever ends it ends it";
}

TEST_F(RefusedStart, IsNoneWhereTheUserEndsTheStart) {
  load();
  ASSERT_TRUE(workspace_.goOnline());
  ASSERT_EQ(workspace_.live().phase(), LiveSession::Phase::kStarting);
  workspace_.live().shutDown();
  EXPECT_FALSE(field("startBar").isVisible());
}

}  // namespace
}  // namespace syncline::ui
