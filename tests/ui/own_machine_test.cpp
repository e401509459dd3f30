// SPDX-License-Identifier: Apache-2.0
// A machine that exists only as a project runs in the window, on a simulated bus of its own devices.
#include <gtest/gtest.h>

#include <QAction>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <optional>

#include "support/ui_test_support.h"
#include "tests/support/own_devices.h"
#include "ui/dialogs/link_chooser.h"
#include "ui/main_window.h"
#include "ui/session/workspace.h"

namespace syncline {
namespace {

class OwnMachine : public ::testing::Test {
 protected:
  OwnMachine() : workspace_(test::virtualEnvironment()), window_(workspace_) {
    workspace_.live().setAutoAdvance(false);
    window_.show();
  }
  ~OwnMachine() override {
    workspace_.live().shutDown();
    workspace_.document().undoStack().setClean();
  }

  static constexpr std::uint32_t kUnknownVendor = 0x0A11;
  void build(int drives, std::optional<std::uint32_t> vendor = {}) {
    Project project;
    project.slaves.push_back(default_slave(sample::own("SL-1100"), 0));
    for (int i = 1; i <= drives; ++i) {
      project.slaves.push_back(default_slave(sample::own("SL-SV7"), static_cast<std::uint16_t>(i)));
      project.slaves.back().previous = PreviousPort{static_cast<std::uint16_t>(i - 1), 1};
      if (vendor) project.slaves.back().device.identity.vendor_id = *vendor;
    }
    workspace_.document().replace(QStringLiteral("Build"), project);
  }
  QAction* action(const char* name) { return window_.findChild<QAction*>(QLatin1String(name)); }
  /// Takes what the chooser proposes.
  void accept(const char* opener) {
    action(opener)->trigger();
    auto* chooser = window_.findChild<ui::LinkChooser*>();
    ASSERT_NE(chooser, nullptr);
    proposed_ = test::find<QListWidget>(*chooser, "linkList")->currentItem()->text();
    test::find<QPushButton>(*chooser, "linkAccept")->click();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  void runUntilInSync() {
    auto& live = workspace_.live();
    for (int i = 0; i < 200 && live.snapshot().dcm.state != SyncState::kInSync; ++i) live.advance(100 * kMillisecond);
    live.advance(5 * kSecond);
  }

  ui::Workspace workspace_;
  ui::MainWindow window_;
  QString proposed_;
};

TEST_F(OwnMachine, GoesOnlineOnASimulatedBusOfItsOwn) {
  EXPECT_FALSE(action("actionChooseLink")->isEnabled()) << "there is no machine yet";
  build(2);
  accept("actionOnline");
  EXPECT_TRUE(proposed_.startsWith(QStringLiteral("This machine"))) << qPrintable(proposed_);
  runUntilInSync();
  const auto& snapshot = workspace_.live().snapshot();
  EXPECT_EQ(snapshot.state, AlState::kOp);
  EXPECT_EQ(snapshot.slaves.size(), 3U);
  EXPECT_EQ(snapshot.dcm.state, SyncState::kInSync);
  const auto& missed = workspace_.live().run().record()->overview().missed;
  EXPECT_TRUE(missed.known);
  EXPECT_EQ(missed.count, 0U);
  window_.selectNode(1);
  workspace_.live().advance(kSecond);
  EXPECT_EQ(test::find<QLabel>(window_, "slaveMissed")->text(), QStringLiteral("0 (object 0x1C32:0C)"))
      << "a drive of its family, that counts";
  EXPECT_FALSE(action("actionChooseLink")->isEnabled()) << "it runs";
  workspace_.live().shutDown();
  // As it is now, not as it was when the bus was chosen; and nobody is asked again.
  build(3);
  action("actionOnline")->trigger();
  runUntilInSync();
  EXPECT_EQ(workspace_.live().snapshot().slaves.size(), 4U);
  EXPECT_EQ(workspace_.live().snapshot().state, AlState::kOp);
}

TEST_F(OwnMachine, ADeviceOfNoKnownFamilyHoldsWhatItIsGiven) {
  build(1, kUnknownVendor);
  accept("actionOnline");
  runUntilInSync();
  EXPECT_EQ(workspace_.live().snapshot().dcm.state, SyncState::kInSync);
  // No counter of missed events: what the master computes of each cycle counts, and is none.
  const auto& missed = workspace_.live().run().record()->overview().missed;
  EXPECT_TRUE(missed.known);
  EXPECT_EQ(missed.count, 0U);
  window_.selectNode(1);
  workspace_.live().advance(kSecond);
  EXPECT_EQ(test::find<QLabel>(window_, "slaveMissed")->text(), QStringLiteral("0 (computed: it has no counter)"));
}

TEST_F(OwnMachine, AnotherBusCanBeChosenWithoutAScan) {
  build(1);
  workspace_.setLink(workspace_.environment().demo_link);
  accept("actionChooseLink");
  EXPECT_TRUE(proposed_.startsWith(QStringLiteral("Demonstration"))) << "the present one";
  EXPECT_EQ(workspace_.live().phase(), ui::LiveSession::Phase::kOffline) << "only chosen";
  workspace_.setLink(QStringLiteral("nic:gone"));
  accept("actionChooseLink");
  EXPECT_EQ(workspace_.link(), ui::kMachineItself);
}

}  // namespace
}  // namespace syncline
