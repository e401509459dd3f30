// SPDX-License-Identifier: Apache-2.0
// Two machines beside each other: the project, files, what runs, a bus.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTreeView>

#include "compile/compile.h"
#include "eni/format/eni_file.h"
#include "eni/project/project_file.h"
#include "settings/settings_table.h"
#include "support/project_window.h"
#include "support/running_window.h"
#include "tests/support/sample_devices.h"
#include "ui/dialogs/compare_dialog.h"
#include "ui/dialogs/comparison_model.h"
#include "ui/dialogs/file_commands.h"
#include "ui/session/comparison.h"

namespace syncline::ui {
namespace {

using Kind = ComparedSide::Kind;

/// The machine with another shift of its drive, another name of a terminal and another cycle.
Project otherMachine() {
  auto machine = sample::small_machine();
  machine.slaves[3].dc.sync0.shift = 50 * kMicrosecond;
  machine.slaves[1].name = "Renamed";
  machine.master.cycle_time = 2 * kMillisecond;
  return machine;
}

/// Rows of the tree as "where|what|left|right|class".
QStringList rowsOf(const QAbstractItemModel& model) {
  QStringList rows;
  for (int node = 0; node < model.rowCount(); ++node) {
    const auto parent = model.index(node, 0);
    for (int row = 0; row < model.rowCount(parent); ++row) {
      QStringList fields{parent.data().toString()};
      for (int column = 0; column < model.columnCount(); ++column)
        fields.append(model.index(row, column, parent).data().toString());
      rows.append(fields.join(u'|'));
    }
  }
  return rows;
}

bool anyOf(const QStringList& rows, const QString& part) {
  return std::ranges::any_of(rows, [&](const QString& row) { return row.contains(part); });
}

class Compare : public test::ProjectWindow {
 protected:
  Compare() : ProjectWindow(sample::small_machine()) {}

  CompareDialog& dialog() { return *window_.findChild<CompareDialog*>(); }
  QTreeView& tree() { return *dialog().findChild<QTreeView*>(); }
  QString fileWith(const Project& machine, const char* name = "other.syncline") {
    const auto path = folder_.filePath(QLatin1String(name));
    EXPECT_TRUE(eni::save_project(machine, path.toStdString()));
    return path;
  }
  void open() {
    test::find<QAction>(window_, "actionCompare")->trigger();
    ASSERT_NE(window_.findChild<CompareDialog*>(), nullptr);
    ASSERT_TRUE(dialog().isVisible());
  }
  void compare(const ComparedSide& left, const ComparedSide& right) {
    dialog().compare(left, right);
    ASSERT_TRUE(test::waitFor([this] { return !dialog().isComparing(); }));
  }
  QModelIndex rowWith(const QString& text) {
    const auto& model = *tree().model();
    const auto found = model.match(model.index(0, 0), Qt::DisplayRole, text, 1, Qt::MatchExactly | Qt::MatchRecursive);
    return found.isEmpty() ? QModelIndex() : found.front();
  }

  QTemporaryDir folder_;
};

TEST_F(Compare, ShowsProjectAndFileAsATree) {
  open();
  EXPECT_FALSE(dialog().findChild<QLabel*>(QStringLiteral("compareStatus"))->text().isEmpty()) << "what to choose";
  compare({}, {Kind::kFile, fileWith(otherMachine())});
  const auto rows = rowsOf(dialog().model());
  EXPECT_TRUE(anyOf(rows, QStringLiteral("Network|Cycle time|1000 µs|2000 µs|Setting")))
      << qPrintable(rows.join(u'\n'));
  EXPECT_TRUE(anyOf(rows, QStringLiteral("|Clocks"))) << "what it does to the machine";
  EXPECT_TRUE(anyOf(rows, QStringLiteral("Renamed")));
  EXPECT_EQ(dialog().model().differences(), rows.size());
  auto* matters = dialog().findChild<QCheckBox*>(QStringLiteral("compareOnlyMatters"));
  matters->setChecked(true);
  const auto fewer = rowsOf(*tree().model());
  EXPECT_LT(fewer.size(), rows.size());
  EXPECT_FALSE(anyOf(fewer, QStringLiteral("Renamed"))) << "a name";
  matters->setChecked(false);
  dialog().findChild<QLineEdit*>(QStringLiteral("compareWords"))->setText(QStringLiteral("cycle network"));
  EXPECT_TRUE(anyOf(rowsOf(*tree().model()), QStringLiteral("Cycle time")));
  EXPECT_FALSE(anyOf(rowsOf(*tree().model()), QStringLiteral("Renamed")));
  compare({Kind::kFile, fileWith(otherMachine())}, {Kind::kFile, fileWith(otherMachine(), "again.syncline")});
  EXPECT_EQ(dialog().model().differences(), 0);
}

TEST_F(Compare, CountsTheChangesOfTheProjectApart) {
  open();
  auto other = otherMachine();
  other.slaves[3].dc.sync0.user_cycle = kMillisecond;  // what it has by itself at the other cycle
  compare({}, {Kind::kFile, fileWith(other)});
  EXPECT_EQ(dialog().model().changes(), 2) << "cycle and shift; the name and the same value by another word are none";
  EXPECT_GT(dialog().model().differences(), 4) << "these, too, and what follows in the network";
  EXPECT_TRUE(dialog().findChild<QLabel*>(QStringLiteral("compareStatus"))->text().contains(u'2'));
}

TEST_F(Compare, AClickGoesToTheSetting) {
  open();
  compare({}, {Kind::kFile, fileWith(otherMachine())});
  const auto shift = rowWith(QStringLiteral("Shift of SYNC0"));
  ASSERT_TRUE(shift.isValid());
  Q_EMIT tree().clicked(shift);
  EXPECT_EQ(window_.editor().node(), 3);
  EXPECT_EQ(window_.editor().tabs()->currentWidget()->objectName(), QStringLiteral("slaveDcPage"));
  const auto renamed = rowWith(QStringLiteral("Slave 1 %1").arg(QString::fromStdString(project().slaves[1].name)));
  ASSERT_TRUE(renamed.isValid());
  Q_EMIT tree().clicked(renamed);
  EXPECT_EQ(window_.editor().node(), 1);
  Q_EMIT tree().clicked(tree().model()->index(0, 0));
  EXPECT_EQ(window_.editor().node(), -1) << "the network is the master's";
}

TEST_F(Compare, IsCopiedAndExported) {
  open();
  compare({}, {Kind::kFile, fileWith(otherMachine())});
  dialog().findChild<QPushButton*>(QStringLiteral("compareCopy"))->click();
  const auto copied = QGuiApplication::clipboard()->text();
  EXPECT_EQ(copied.count(u'\n'), dialog().model().differences() + 1);
  EXPECT_TRUE(copied.contains(QStringLiteral("Network\tCycle time\t1000 µs\t2000 µs\tSetting")));
  const auto path = folder_.filePath(QStringLiteral("d.csv"));
  ASSERT_TRUE(dialog().exportTo(path));
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_TRUE(QString::fromUtf8(file.readAll()).contains(QStringLiteral("Network,Cycle time,1000 µs,2000 µs,Setting")));
}

TEST_F(Compare, FollowsTheProjectWhileItIsEdited) {
  open();
  compare({}, {Kind::kFile, fileWith(sample::small_machine())});
  EXPECT_EQ(dialog().model().differences(), 0);
  EXPECT_FALSE(test::find<QPushButton>(dialog(), "compareCopy")->isEnabled());
  ASSERT_TRUE(workspace_.document().edit(QStringLiteral("name"), [](Project& project) {
    project.slaves[1].name = "Renamed";
    return Status{};
  }));
  ASSERT_TRUE(test::waitFor([this] { return dialog().model().differences() > 0; })) << "stale";
  EXPECT_TRUE(anyOf(rowsOf(dialog().model()), QStringLiteral("Renamed")));
  EXPECT_TRUE(test::find<QPushButton>(dialog(), "compareCopy")->isEnabled());
  dialog().compare({}, {});
  EXPECT_FALSE(test::find<QPushButton>(dialog(), "compareCopy")->isEnabled()) << "there is nothing";
}

TEST_F(Compare, TheLastOfSeveralIsTheOneThatIsShown) {
  const auto other = otherMachine(), same = sample::small_machine();
  Comparison comparison({});
  int finished = 0;
  QObject::connect(&comparison, &Comparison::finished, &comparison, [&finished] { ++finished; });
  comparison.start({}, {Kind::kRunning}, same, other);
  comparison.start({}, {Kind::kRunning}, same, same);
  ASSERT_TRUE(test::waitFor([&] { return !comparison.isRunning(); }));
  EXPECT_EQ(finished, 1);
  ASSERT_TRUE(comparison.result());
  EXPECT_TRUE(comparison.result()->settings.empty());
}

TEST_F(Compare, AnEniOfTheProjectIsTheSame) {
  const auto compiled = compile(project());
  ASSERT_TRUE(compiled);
  const auto path = folder_.filePath(QStringLiteral("m.xml"));
  ASSERT_TRUE(eni::save_eni(compiled->config, path.toStdString()));
  open();
  compare({}, {Kind::kFile, path});
  EXPECT_EQ(dialog().model().differences(), 0) << qPrintable(rowsOf(dialog().model()).join(u'\n'));
  compare({}, {Kind::kFile, folder_.filePath(QStringLiteral("none.xml"))});
  EXPECT_TRUE(dialog().findChild<QLabel*>(QStringLiteral("compareStatus"))->text().contains(QStringLiteral("none.xml")))
      << "why not";
}

TEST_F(Compare, ADroppedMachineCanBeCompared) {
  const auto path = fileWith(otherMachine());
  QTimer::singleShot(0, &window_, [] {
    for (auto* widget : QApplication::topLevelWidgets()) {
      if (widget->objectName() == QLatin1String("dropQuestion"))
        widget->findChild<QPushButton*>(QStringLiteral("dropCompare"))->click();
    }
  });
  window_.files().openDropped(path);
  ASSERT_NE(window_.findChild<CompareDialog*>(), nullptr);
  ASSERT_TRUE(test::waitFor([this] { return !dialog().isComparing(); }));
  EXPECT_GT(dialog().model().differences(), 0);
  EXPECT_EQ(project(), sample::small_machine()) << "nothing was opened";
}

TEST_F(Compare, ModelKeepsItsPromises) {
  ComparisonModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  const auto left = sample::small_machine(), right = otherMachine();
  Compared compared{
      compare_configs(compile(left)->config, compile(right)->config), compare_settings(left, right), {}, {}};
  model.setCompared(compared, QStringLiteral("l"), QStringLiteral("r"), true);
  EXPECT_GT(model.rowCount(), 1);
  EXPECT_EQ(model.headerData(ComparisonModel::kRight, Qt::Horizontal, Qt::DisplayRole).toString(), QStringLiteral("r"));
  model.setCompared({}, {}, {}, std::nullopt);
  EXPECT_EQ(model.rowCount(), 0);
}

class CompareRunning : public test::RunningWindow {};

TEST_F(CompareRunning, WhatRunsIsOnTheLeft) {
  goOnline();
  ASSERT_FALSE(HasFatalFailure());
  ASSERT_TRUE(workspace_.document().set(
      QStringLiteral("set"), {{&settings::row("master.cycle_time_us"), {}, settings::Value{2 * kMillisecond}}}));
  static_cast<void>(workspace_.configuration().current());
  test::find<QPushButton>(window_, "runBarShow")->click();
  auto* dialog = window_.findChild<CompareDialog*>();
  ASSERT_NE(dialog, nullptr);
  ASSERT_TRUE(test::waitFor([dialog] { return !dialog->isComparing(); }));
  EXPECT_TRUE(anyOf(rowsOf(dialog->model()), QStringLiteral("Network|Cycle time|1000 µs|2000 µs|Setting")))
      << qPrintable(rowsOf(dialog->model()).join(u'\n'));
}

TEST_F(CompareRunning, ABusIsOnlyLookedAt) {
  load();
  ASSERT_FALSE(HasFatalFailure());
  CompareDialog dialog(workspace_, &window_);
  dialog.compare({}, {Kind::kBus, workspace_.environment().demo_link});
  ASSERT_TRUE(test::waitFor([&dialog] { return !dialog.isComparing(); }));
  EXPECT_FALSE(test::find<QToolButton>(dialog, "compareSwap")->isEnabled()) << "a bus stands on the right only";
  ASSERT_TRUE(workspace_.document().edit(QStringLiteral("name"), [](Project& project) {
    project.slaves[1].name = "Renamed";
    return Status{};
  }));
  EXPECT_FALSE(dialog.isComparing()) << "no bus is looked at unasked";
  EXPECT_TRUE(test::find<QLabel>(dialog, "compareStatus")->text().contains(QStringLiteral("once more")));
  const auto rows = rowsOf(dialog.model());
  EXPECT_FALSE(anyOf(rows, QStringLiteral("|Slaves"))) << qPrintable(rows.join(u'\n'));
}

}  // namespace
}  // namespace syncline::ui
