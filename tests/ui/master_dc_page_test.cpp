// SPDX-License-Identifier: Apache-2.0
// What the page of the master's clocks shows of a running bus.
#include <gtest/gtest.h>

#include <QLabel>

#include "channels/snapshot.h"
#include "support/project_window.h"
#include "support/ui_test_support.h"
#include "ui/pages/master_dc_page.h"
#include "ui/text/units.h"
#include "ui/widgets/pill.h"

namespace syncline::ui {
namespace {

class MasterDcPageTest : public test::ProjectWindow {
 protected:
  MasterDcPageTest() : ProjectWindow(test::smallProject()) {
    show(-1, "masterDcPage");
    snapshot_.online = true;
    snapshot_.dc.enabled = true;
  }
  void tell() { window_.findChild<MasterDcPage*>()->showLive(snapshot_); }
  QString text(const char* name) { return field<QLabel>(name).text(); }

  Snapshot snapshot_;
};

TEST_F(MasterDcPageTest, ShowsTheExternalClockWhereThereIsOne) {
  tell();
  EXPECT_FALSE(field("dcmExternal").isVisible());
  snapshot_.dcm.mode = DcmMode::kDcx;
  tell();
  EXPECT_TRUE(field("dcmExternal").isVisible());
  EXPECT_EQ(text("dcmExternal"), QStringLiteral("\u2013")) << "nobody has told it yet";
  snapshot_.dcm.external_error_ns = -125'000;
  snapshot_.dcm.state = SyncState::kOutOfSync;
  snapshot_.dcm.obstacle = dc::SyncObstacle::kToExternalClock;
  tell();
  EXPECT_EQ(text("dcmExternal"), signedTimeText(-125'000));
  EXPECT_EQ(field<Pill>("dcmState").text(), QStringLiteral("Out of sync: on the way to the external clock"));
  snapshot_.dcm.mode = DcmMode::kBusShift;
  tell();
  EXPECT_FALSE(field("dcmExternal").isVisible());
}

}  // namespace
}  // namespace syncline::ui
