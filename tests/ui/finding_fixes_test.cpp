// SPDX-License-Identifier: Apache-2.0
// The menu of a finding: go to its field, or a value with which it is gone.
#include <gtest/gtest.h>

#include <QAction>
#include <QMenu>
#include <QTableView>

#include "support/project_window.h"
#include "ui/models/message_model.h"

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
