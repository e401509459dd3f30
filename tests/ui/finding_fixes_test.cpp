// SPDX-License-Identifier: Apache-2.0
// The menu of a finding: go to its field, or a value with which it is gone.
#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QTableView>

#include "support/project_window.h"
#include "ui/dialogs/finding_fixes.h"
#include "ui/models/eni_finding_model.h"
#include "ui/models/message_model.h"
#include "ui/session/eni_preview.h"

namespace syncline::ui {
namespace {

class FixesOfFindings : public test::ProjectWindow {
 protected:
  FixesOfFindings() : ProjectWindow(twice()) {}
  static Project twice() {
    auto project = test::smallProject();
    project.slaves[2].station_address = project.slaves[1].station_address;
    return project;
  }
  /// The row of the finding that names this key; -1: none.
  int rowOf(const QString& key) {
    static_cast<void>(workspace_.configuration().current());
    QApplication::processEvents();
    auto& model = workspace_.messages();
    for (int row = 0; row < model.rowCount(); ++row) {
      if (model.message(row).key == key) return row;
    }
    return -1;
  }
  QMenu* open(int row) {
    auto& table = field<QTableView>("messageTable");
    const auto at = table.visualRect(table.model()->index(row, MessageModel::kText)).center();
    Q_EMIT table.customContextMenuRequested(at);
    return window_.findChild<QMenu*>(QStringLiteral("messageMenu"));
  }
};

TEST_F(FixesOfFindings, AreTriedBeforeTheyAreOfferedAndAreOneStep) {
  const auto key = QStringLiteral("slave.2.station_address");
  const int row = rowOf(key);
  ASSERT_GE(row, 0);
  auto* menu = open(row);
  ASSERT_NE(menu, nullptr);
  auto* fix = menu->findChild<QAction*>(QStringLiteral("messageFix"));
  ASSERT_NE(fix, nullptr);
  EXPECT_TRUE(fix->text().contains(QStringLiteral("Station address"))) << qPrintable(fix->text());
  const int steps = workspace_.document().undoStack().count();
  fix->trigger();
  EXPECT_EQ(workspace_.document().undoStack().count(), steps + 1);
  EXPECT_NE(project().slaves[2].station_address, project().slaves[1].station_address);
  EXPECT_EQ(rowOf(key), -1) << "it is gone";
  workspace_.document().undoStack().undo();
  EXPECT_GE(rowOf(key), 0);
}

TEST_F(FixesOfFindings, LeadToTheMasterOrToASlave) {
  FindingFixes fixes(
      workspace_, [] { return true; }, nullptr);
  const auto way = [&fixes](int slave) {
    QMenu menu;
    Message message;
    message.slave = slave;
    fixes.fill(menu, message);
    return menu.actions().front()->text();
  };
  EXPECT_EQ(way(-1), QStringLiteral("Show the Master"));
  EXPECT_EQ(way(1), QStringLiteral("Show Its Slave"));
}

/// No compilation has it: a run that nobody watched leads to the switch, and switches it on.
TEST_F(FixesOfFindings, OfARunAreOneStepToo) {
  FindingFixes fixes(
      workspace_, [] { return true; }, nullptr);
  QString key;
  QObject::connect(&fixes, &FindingFixes::placeWanted, &fixes, [&key](int, const QString& place) { key = place; });
  QMenu menu;
  fixes.fillFor(menu, {.code = "not-monitored", .severity = Severity::kNote});
  menu.findChild<QAction*>(QStringLiteral("messageGo"))->trigger();
  EXPECT_EQ(key, QStringLiteral("master.dc.sync_window"));
  auto* fix = menu.findChild<QAction*>(QStringLiteral("messageFix"));
  ASSERT_NE(fix, nullptr);
  const int steps = workspace_.document().undoStack().count();
  ASSERT_FALSE(project().master.dc.sync_window.enabled);
  fix->trigger();
  EXPECT_TRUE(project().master.dc.sync_window.enabled);
  EXPECT_EQ(workspace_.document().undoStack().count(), steps + 1);
}

/// What a run advises of a number is set in one step; where it advises none the way to the setting is all.
TEST_F(FixesOfFindings, OfARunSetTheNumberThatItAdvises) {
  FindingFixes fixes(
      workspace_, [] { return true; }, nullptr);
  Finding tight{.code = "sync0-too-tight", .severity = Severity::kWarning};
  tight.figures = {{"more", Figure::Unit::kNanoseconds, 20'000}};
  QMenu menu;
  fixes.fillFor(menu, tight);
  auto* fix = menu.findChild<QAction*>(QStringLiteral("messageFix"));
  ASSERT_NE(fix, nullptr);
  fix->trigger();
  EXPECT_TRUE(project().master.dc.dcm.set_value.has_value());
  QMenu other;
  fixes.fillFor(other, {.code = "drift-too-high", .severity = Severity::kError});
  ASSERT_EQ(other.actions().size(), 1);
  EXPECT_EQ(other.actions().front()->text(), QStringLiteral("Go to the Setting"));
}

/// The panel of findings has what the messages have of the project: live, with the way to the field and the fixes.
TEST_F(FixesOfFindings, StandInTheirPanelToo) {
  const auto key = QStringLiteral("slave.2.station_address");
  ASSERT_GE(rowOf(key), 0);
  auto& model = workspace_.findings();
  const auto row = [&] {
    for (int at = 0; at < model.rowCount(); ++at) {
      if (QString::fromStdString(model.finding(at).place.key) == key) return at;
    }
    return -1;
  };
  ASSERT_GE(row(), 0);
  auto& table = field<QTableView>("findingsTable");
  window_.findChild<QDockWidget*>(QStringLiteral("findingsDock"))->raise();
  QApplication::processEvents();
  EXPECT_TRUE(table.isVisible());
  EXPECT_FALSE(field<QLabel>("noFindings").isVisible());
  window_.selectNode(-1);
  Q_EMIT table.activated(model.index(row(), 2));
  EXPECT_TRUE(field("slaveAddress").hasFocus());
  const auto at = table.visualRect(model.index(row(), 2)).center();
  Q_EMIT table.customContextMenuRequested(at);
  auto* menu = window_.findChild<QMenu*>(QStringLiteral("findingMenu"));
  ASSERT_NE(menu, nullptr);
  auto* fix = menu->findChild<QAction*>(QStringLiteral("messageFix"));
  ASSERT_NE(fix, nullptr);
  const int steps = workspace_.document().undoStack().count();
  fix->trigger();
  EXPECT_EQ(workspace_.document().undoStack().count(), steps + 1);
  EXPECT_EQ(rowOf(key), -1);
  EXPECT_EQ(row(), -1) << "it is gone";
}

/// What the checker says of the ENI stands among them, with a way to mend it, too.
TEST_F(FixesOfFindings, OfTheEniAreOneStepToo) {
  auto& document = workspace_.document();
  ASSERT_TRUE(document.edit(QStringLiteral("same name"), [](Project& target) -> Status {
    target.slaves[2].station_address = 1003;
    target.slaves[2].name = target.slaves[1].name;
    return {};
  }));
  const auto key = QStringLiteral("slave.2.name");
  int row = -1;
  ASSERT_TRUE(test::waitFor([&] { return (row = rowOf(key)) >= 0; }));
  auto* fix = open(row)->findChild<QAction*>(QStringLiteral("messageFix"));
  ASSERT_NE(fix, nullptr);
  EXPECT_TRUE(fix->text().contains(QStringLiteral("(2)"))) << qPrintable(fix->text());
  const int steps = document.undoStack().count();
  fix->trigger();
  EXPECT_EQ(document.undoStack().count(), steps + 1);
  EXPECT_NE(project().slaves[2].name, project().slaves[1].name);
  auto& eni = workspace_.eni();
  const auto checked = [&] { return eni.isCurrent() && eni.check() != nullptr; };
  ASSERT_TRUE(test::waitFor(checked));
  EXPECT_EQ(rowOf(key), -1) << "it is gone";
  document.undoStack().undo();
  EXPECT_TRUE(test::waitFor([&] { return rowOf(key) >= 0; })) << "it is back";
}

TEST_F(FixesOfFindings, OfTheEniStandInTheMenuOfItsPage) {
  show(-1, "eniPage");
  auto& eni = workspace_.eni();
  ASSERT_TRUE(test::waitFor([&] { return eni.isCurrent() && eni.check() != nullptr; }));
  auto& table = field<QTableView>("eniFindings");
  auto& findings = static_cast<EniFindingModel&>(*table.model());
  int row = 0;
  while (row < findings.rowCount() && findings.finding(row).code != "ENI-REF-03") ++row;
  ASSERT_LT(row, findings.rowCount());
  Q_EMIT table.customContextMenuRequested(table.visualRect(findings.index(row, 0)).center());
  auto* menu = window_.findChild<QMenu*>(QStringLiteral("eniFindingMenu"));
  ASSERT_NE(menu, nullptr);
  auto* fix = menu->findChild<QAction*>(QStringLiteral("messageFix"));
  ASSERT_NE(fix, nullptr);
  fix->trigger();
  EXPECT_NE(project().slaves[2].station_address, project().slaves[1].station_address);
  workspace_.document().undoStack().undo();
  EXPECT_EQ(project().slaves[2].station_address, project().slaves[1].station_address);
}

TEST_F(FixesOfFindings, TheMenuGoesToTheSetting) {
  const int row = rowOf(QStringLiteral("slave.2.station_address"));
  ASSERT_GE(row, 0);
  auto* menu = open(row);
  ASSERT_NE(menu, nullptr);
  menu->findChild<QAction*>(QStringLiteral("messageGo"))->trigger();
  EXPECT_EQ(window_.editor().tabs()->currentWidget()->objectName(), QStringLiteral("slaveGeneralPage"));
}

}  // namespace
}  // namespace syncline::ui
