// SPDX-License-Identifier: Apache-2.0
// The way of a user through the window, on the simulated machine and the virtual clock.
#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QListWidget>
#include <QPushButton>
#include <QRadioButton>
#include <QTabWidget>
#include <QTemporaryDir>
#include <algorithm>

#include "eni/format/eni_file.h"
#include "support/ui_test_support.h"
#include "ui/dialogs/file_commands.h"
#include "ui/dialogs/link_chooser.h"
#include "ui/main_window.h"
#include "ui/pages/device_editor.h"
#include "ui/panels/live_strip.h"
#include "ui/session/workspace.h"
#include "ui/widgets/pill.h"

namespace syncline {
namespace {

class MachineFlow : public ::testing::Test {
 protected:
  MachineFlow() : workspace_(test::virtualEnvironment()), window_(workspace_) {
    workspace_.live().setAutoAdvance(false);
    window_.show();
  }
  ~MachineFlow() override {
    workspace_.live().shutDown();
    workspace_.document().undoStack().setClean();
  }

  const Project& project() { return workspace_.document().project(); }
  QAction* action(const char* name) { return window_.findChild<QAction*>(QLatin1String(name)); }

  /// Through the action, the chooser and the background scan.
  void scan() {
    action("actionScan")->trigger();
    auto* chooser = window_.findChild<ui::LinkChooser*>();
    ASSERT_NE(chooser, nullptr);
    test::find<QListWidget>(*chooser, "linkList")->setCurrentRow(0);
    test::find<QPushButton>(*chooser, "linkAccept")->click();
    ASSERT_TRUE(test::waitFor([this] { return !workspace_.scan().isRunning() && !project().slaves.empty(); }));
  }

  /// Positions of the slaves that can use distributed clocks.
  std::vector<int> dcSlaves() {
    std::vector<int> positions;
    for (std::size_t i = 0; i < project().slaves.size(); ++i) {
      if (!project().slaves[i].dc.op_mode.empty()) positions.push_back(static_cast<int>(i));
    }
    return positions;
  }

  void showTab(const char* page) {
    auto* tabs = window_.editor().tabs();
    for (int i = 0; i < tabs->count(); ++i) {
      if (tabs->widget(i)->objectName() == QLatin1String(page)) tabs->setCurrentIndex(i);
    }
    ASSERT_EQ(tabs->currentWidget()->objectName(), QLatin1String(page));
  }

  static void choose(QComboBox* box, const QVariant& data) {
    const int row = box->findData(data);
    ASSERT_GE(row, 0) << qPrintable(data.toString());
    box->setCurrentIndex(row);
    Q_EMIT box->activated(row);
  }

  /// What the message window says, for the report of a failed test.
  std::string messages() {
    std::string text;
    for (int row = 0; row < workspace_.messages().rowCount(); ++row) {
      for (const int column : {ui::MessageModel::kTime, ui::MessageModel::kSource, ui::MessageModel::kText}) {
        text += workspace_.messages().index(row, column).data(Qt::DisplayRole).toString().toStdString() + "  ";
      }
      text += '\n';
    }
    return text;
  }

  void configureMaster(int reference) {
    window_.selectNode(-1);
    showTab("masterDcPage");
    choose(test::find<QComboBox>(window_, "referenceClock"), QString::number(reference));
    test::find<QRadioButton>(window_, "dcmMasterShift")->click();
    auto* monitor = test::find<QCheckBox>(window_, "syncWindow");
    if (!monitor->isChecked()) monitor->click();
    test::type(*test::find<QWidget>(window_, "syncWindowExponent"), QStringLiteral("9"));
  }

  ui::Workspace workspace_;
  ui::MainWindow window_;
};

TEST_F(MachineFlow, ScansConfiguresExportsRunsAndGetsInSync) {
  scan();
  ASSERT_FALSE(HasFatalFailure());
  ASSERT_GE(project().slaves.size(), 4U);
  const auto dc = dcSlaves();
  ASSERT_GE(dc.size(), 2U);
  const int reference = dc.front();
  const int drive = dc.back();

  // A reference clock behind another clock cannot lead that one: the window says so at once.
  configureMaster(dc[1]);
  workspace_.configuration().current();
  EXPECT_GE(workspace_.messages().count(ui::Severity::kWarning), 1) << messages();
  configureMaster(reference);
  workspace_.configuration().current();
  EXPECT_EQ(workspace_.messages().count(ui::Severity::kWarning), 0) << messages();
  const auto marks = workspace_.network().indexOf(reference).data(ui::NetworkModel::kMarksRole).toStringList();
  EXPECT_TRUE(marks.contains(QStringLiteral("REF")));
  EXPECT_EQ(project().master.dc.reference_clock, static_cast<std::uint16_t>(reference));
  EXPECT_EQ(project().master.dc.dcm.mode, DcmMode::kMasterShift);
  EXPECT_TRUE(project().master.dc.sync_window.enabled);
  EXPECT_EQ(project().master.dc.sync_window.exponent, 9);

  window_.selectNode(drive);
  showTab("slaveDcPage");
  choose(test::find<QComboBox>(window_, "sync0Factor"), QStringLiteral("2"));
  const auto& chosen = project().slaves[static_cast<std::size_t>(drive)].dc.sync0;
  EXPECT_EQ(chosen.cycle_factor, 2);

  // Undo and redo of the last edit, through the actions.
  action("actionUndo")->trigger();
  EXPECT_NE(chosen.cycle_factor, 2);
  action("actionRedo")->trigger();
  EXPECT_EQ(chosen.cycle_factor, 2);

  QTemporaryDir folder;
  const auto path = folder.filePath(QStringLiteral("machine.eni.xml"));
  ASSERT_TRUE(window_.files().exportTo(path));
  const auto exported = eni::read_eni(path.toStdString());
  ASSERT_TRUE(exported.has_value()) << exported.error().subject;
  ASSERT_EQ(exported->slaves.size(), project().slaves.size());
  EXPECT_EQ(exported->reference_clock(), static_cast<std::uint16_t>(reference));
  ASSERT_TRUE(exported->slaves[static_cast<std::size_t>(drive)].dc.has_value());
  EXPECT_EQ(exported->slaves[static_cast<std::size_t>(drive)].dc->cycle_time0, 2 * project().master.cycle_time);
  const auto& commands = exported->cyclic.front().frames.front().commands;
  EXPECT_TRUE(std::ranges::any_of(commands, [](const CyclicCmd& command) {
    return command.command == Command::kBrd && command.ado == 0x092C;
  })) << "sync window monitoring must be in the cyclic frame";
  EXPECT_FALSE(std::ranges::any_of(commands, [](const CyclicCmd& command) {
    return (command.command == Command::kFpwr || command.command == Command::kApwr) && command.ado == 0x0910;
  })) << "master shift needs no write to the reference clock";

  // A cycle of 2 ms is more than this drive's application may like; run with the mode's own.
  action("actionUndo")->trigger();
  action("actionOnline")->trigger();
  for (int i = 0; i < 200 && workspace_.live().snapshot().dcm.state != SyncState::kInSync; ++i) {
    workspace_.live().advance(100 * kMillisecond);
  }
  workspace_.live().advance(kSecond);
  const auto& snapshot = workspace_.live().snapshot();
  ASSERT_TRUE(snapshot.online);
  EXPECT_EQ(snapshot.state, AlState::kOp) << messages();
  EXPECT_EQ(snapshot.dc.state, SyncState::kInSync);
  EXPECT_EQ(snapshot.dcm.state, SyncState::kInSync);
  EXPECT_EQ(test::find<ui::Pill>(window_, "statusDc")->tone(), ui::theme::Tone::kGood);
  EXPECT_EQ(test::find<ui::Pill>(window_, "statusDcm")->tone(), ui::theme::Tone::kGood);
  EXPECT_EQ(snapshot.dc.reference_clock, reference);
  ASSERT_NE(window_.liveStrip().store(), nullptr);
  EXPECT_GT(window_.liveStrip().store()->series(Signal::kDeviation).size(), 1000U) << "the plots must fill";

  action("actionOffline")->trigger();
  EXPECT_TRUE(test::waitFor([this] { return workspace_.live().phase() == ui::LiveSession::Phase::kOffline; }));
}

TEST_F(MachineFlow, EveryEditCanBeUndoneToTheScannedProject) {
  scan();
  ASSERT_FALSE(HasFatalFailure());
  const Project scanned = project();
  configureMaster(dcSlaves()[1]);
  EXPECT_FALSE(project() == scanned);
  while (workspace_.document().undoStack().index() > 1) action("actionUndo")->trigger();
  EXPECT_EQ(project(), scanned);
  action("actionUndo")->trigger();
  EXPECT_TRUE(project().slaves.empty());
}

TEST_F(MachineFlow, SavesAndLoadsTheProject) {
  scan();
  ASSERT_FALSE(HasFatalFailure());
  QTemporaryDir folder;
  const auto path = folder.filePath(QStringLiteral("machine.syncline"));
  ASSERT_TRUE(workspace_.document().save(path).has_value());
  EXPECT_FALSE(workspace_.document().isModified());
  const Project saved = project();
  workspace_.document().reset();
  ASSERT_TRUE(window_.files().openFile(path));
  EXPECT_EQ(project(), saved);
}

TEST_F(MachineFlow, EveryControlHasAnAccessibleName) {
  scan();
  ASSERT_FALSE(HasFatalFailure());
  for (int slave = -1; slave < static_cast<int>(project().slaves.size()); ++slave) {
    window_.selectNode(slave);
    for (const auto* widget : window_.findChildren<QWidget*>()) {
      if (!widget->isVisibleTo(&window_) || (widget->focusPolicy() & Qt::TabFocus) == 0) continue;
      // Parts of a control (its line edit, its scroll area) speak with the control's name.
      if (widget->focusProxy() != nullptr || widget->objectName().startsWith(QLatin1String("qt_"))) continue;
      EXPECT_FALSE(widget->accessibleName().isEmpty() && !widget->parentWidget()->inherits("QComboBox") &&
                   !widget->inherits("QTabBar") && !widget->inherits("QMenuBar"))
          << widget->metaObject()->className() << ' ' << qPrintable(widget->objectName());
    }
  }
}

/// As the program runs it: the machine in a thread of its own, the window only looks.
TEST_F(MachineFlow, RunsInTheBackgroundAndEndsInTheMiddleOfABringUp) {
  scan();
  ASSERT_FALSE(HasFatalFailure());
  workspace_.live().setAutoAdvance(true);
  action("actionOnline")->trigger();
  EXPECT_TRUE(test::waitFor([this] { return workspace_.live().snapshot().state == AlState::kOp; })) << messages();
  action("actionOffline")->trigger();
  EXPECT_TRUE(test::waitFor([this] { return workspace_.live().phase() == ui::LiveSession::Phase::kOffline; }));
  action("actionOnline")->trigger();
  EXPECT_EQ(workspace_.live().phase(), ui::LiveSession::Phase::kStarting);
  workspace_.live().shutDown();
  EXPECT_EQ(workspace_.live().phase(), ui::LiveSession::Phase::kOffline);
}

TEST_F(MachineFlow, ABusThatIsNotThereIsToldAndNothingIsLost) {
  scan();
  ASSERT_FALSE(HasFatalFailure());
  const Project before = project();
  workspace_.scan().start(QStringLiteral("sim:/no/such/file.toml?virtual"));
  ASSERT_TRUE(test::waitFor([this] { return !workspace_.scan().isRunning(); }));
  EXPECT_EQ(project(), before);
  EXPECT_GE(workspace_.messages().count(ui::Severity::kError), 1);
}

}  // namespace
}  // namespace syncline
