// SPDX-License-Identifier: Apache-2.0
// A scan beside a project: nothing is taken over before the user says what.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QTimer>

#include "support/ui_test_support.h"
#include "ui/dialogs/bus_commands.h"
#include "ui/dialogs/found_dialog.h"
#include "ui/main_window.h"
#include "ui/models/found_model.h"
#include "ui/models/message_model.h"
#include "ui/session/workspace.h"

namespace syncline::ui {
namespace {

/// One coupler more behind the first, another revision of the second slave, another device instead of the third.
Project otherBus() {
  auto bus = test::smallProject();
  bus.slaves[1].device.identity.revision_no = 0x00050000;
  bus.slaves[2].device.identity.product_code = 0x7777;
  bus.slaves[2].device.type = "Valve";
  bus.slaves.insert(bus.slaves.begin() + 1, bus.slaves[0]);
  for (std::uint16_t i = 1; i < 4; ++i) bus.slaves[i].previous = PreviousPort{static_cast<std::uint16_t>(i - 1), 1};
  return bus;
}

TEST(FoundModel, SaysWhatDiffersAndIsTicked) {
  const auto ours = test::smallProject(), found = otherBus();
  FoundModel model(ours, found);
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Warning);
  ASSERT_EQ(model.rowCount(), 4);
  EXPECT_EQ(model.count(FoundKind::kMatched), 1);
  EXPECT_EQ(model.count(FoundKind::kRevision), 1);
  EXPECT_EQ(model.count(FoundKind::kOtherDevice), 1);
  EXPECT_EQ(model.count(FoundKind::kExtra), 1);
  EXPECT_EQ(model.tickedCount(), 3);
  EXPECT_EQ(model.index(2, FoundModel::kDifference).data().toString(),
            QStringLiteral("Revision 0x00050000 instead of 0x00040000"));
  EXPECT_FALSE(model.setData(model.index(0, 0), Qt::Unchecked, Qt::CheckStateRole)) << "nothing to take over";
  EXPECT_TRUE(model.setData(model.index(1, 0), Qt::Unchecked, Qt::CheckStateRole));
  EXPECT_EQ(model.tickedCount(), 2);
}

class ScanBesideProject : public ::testing::Test {
 protected:
  ScanBesideProject() : workspace_(test::virtualEnvironment()), window_(workspace_) { window_.show(); }
  ~ScanBesideProject() override { workspace_.document().undoStack().setClean(); }

  FoundDialog* scan() {
    window_.bus().scanLink(workspace_.environment().demo_link);
    static_cast<void>(test::waitFor(
        [this] { return !workspace_.scan().isRunning() && window_.findChild<FoundDialog*>() != nullptr; }));
    return window_.findChild<FoundDialog*>();
  }

  Workspace workspace_;
  MainWindow window_;
};

TEST_F(ScanBesideProject, NothingIsReplacedUnasked) {
  const auto ours = test::smallProject();
  workspace_.document().replace(QStringLiteral("load"), ours);
  const int steps = workspace_.document().undoStack().index();
  auto* dialog = scan();
  ASSERT_NE(dialog, nullptr);
  EXPECT_EQ(workspace_.document().project(), ours);
  const auto name = QStringLiteral("Demonstration machine (simulated)");
  EXPECT_TRUE(test::find<QLabel>(*dialog, "foundSummary")->text().contains(name)) << "the bus as everywhere else";
  bool told = false;
  const auto& messages = workspace_.messages();
  for (int row = 0; row < messages.rowCount(); ++row)
    told =
        told || (messages.message(row).source == QStringLiteral("Scan") && messages.message(row).text.contains(name));
  EXPECT_TRUE(told);
  test::find<QPushButton>(*dialog, "foundKeep")->click();
  EXPECT_EQ(workspace_.document().project(), ours);
  EXPECT_EQ(workspace_.document().undoStack().index(), steps);
}

TEST_F(ScanBesideProject, WhatIsTickedIsOneUndoStep) {
  workspace_.document().replace(QStringLiteral("load"), test::smallProject());
  const int steps = workspace_.document().undoStack().index();
  auto* dialog = scan();
  ASSERT_NE(dialog, nullptr);
  test::find<QPushButton>(*dialog, "foundTake")->click();
  EXPECT_GT(workspace_.document().project().slaves.size(), 3U);
  EXPECT_EQ(workspace_.document().undoStack().index(), steps + 1);
  workspace_.document().undoStack().undo();
  EXPECT_EQ(workspace_.document().project(), test::smallProject());
}

/// The scan of the program, of a bus that somebody else runs.
TEST(ScanOfARunningMachine, OnlyLooksUntilSomebodySaysOtherwise) {
  auto environment = test::virtualEnvironment();
  std::vector<bool> looks;
  environment.scan_bus = [&looks](const QString&, bool look_only, const std::atomic<bool>&,
                                  const std::function<void(const Event&)>&) -> Result<BusScan> {
    looks.push_back(look_only);
    BusScan scan;
    scan.slaves.resize(2);
    scan.look_only = look_only;
    scan.running = 2;
    return scan;
  };
  environment.describe_slaves = [](Project&, const QString&, const std::atomic<bool>&) -> Result<std::vector<Error>> {
    ADD_FAILURE() << "nobody is led to PREOP";
    return std::vector<Error>{};
  };
  Workspace workspace(environment);
  MainWindow window(workspace);
  window.show();
  window.bus().scanLink(QStringLiteral("nic:none"));
  ASSERT_TRUE(test::waitFor([&] { return window.findChild<FoundDialog*>() != nullptr; }));
  EXPECT_EQ(looks, std::vector<bool>({true}));
  EXPECT_TRUE(workspace.document().project().slaves.empty()) << "not even into an empty project";
  auto* dialog = window.findChild<FoundDialog*>();
  EXPECT_TRUE(test::find<QLabel>(*dialog, "foundLooked")->text().contains(QStringLiteral("2 slave")));
  dialog->reject();
}

TEST(ScanOfAnIdleMachine, IsLookedAtAndThenScanned) {
  auto environment = test::virtualEnvironment();
  std::vector<bool> looks;
  const auto scan = environment.scan_bus;
  environment.scan_bus = [&looks, scan](const QString& link, bool look_only, const std::atomic<bool>& cancelled,
                                        const std::function<void(const Event&)>& tell) {
    looks.push_back(look_only);
    return scan(link, look_only, cancelled, tell);
  };
  ScanController controller(environment.scan_bus, environment.describe_slaves, environment.esi_folders);
  std::optional<ScanOutcome> outcome;
  QObject::connect(&controller, &ScanController::finished, &controller,
                   [&outcome](const QString&, const ScanOutcome& found) { outcome = found; });
  controller.start(environment.demo_link);
  ASSERT_TRUE(test::waitFor([&] { return !controller.isRunning(); }));
  EXPECT_EQ(looks, std::vector<bool>({true, false}));
  ASSERT_TRUE(outcome);
  EXPECT_FALSE(outcome->looked_only);
}

}  // namespace
}  // namespace syncline::ui
