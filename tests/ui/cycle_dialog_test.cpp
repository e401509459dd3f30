// SPDX-License-Identifier: Apache-2.0
// Which cycles the slaves accept: asked for on the page General, taken in one undo step.
#include "ui/dialogs/cycle_dialog.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QTimer>

#include "support/project_window.h"
#include "ui/editors/cycle_table.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

/// A Sigma-7 drive takes 125 us to 4 ms; the cycle is 5 ms.
Project tooSlow() {
  auto project = test::smallProject();
  for (auto& slave : project.slaves) {
    if (slave.device.dc) slave.device.type = "SGD7S";
  }
  project.master.cycle_time = 5 * kMillisecond;
  return project;
}

int rowOf(const CycleTable& table, qint64 cycle) {
  for (int row = 0; row < table.rowCount(); ++row) {
    if (table.item(row, 0)->data(Qt::UserRole).toLongLong() == cycle) return row;
  }
  return -1;
}

class CycleDialogTest : public test::ProjectWindow {
 protected:
  CycleDialogTest() : ProjectWindow(tooSlow()) {}
  /// Presses the button of the page and does `what` with the dialog.
  template <class What>
  void ask(const What& what) {
    show(-1, "masterGeneralPage");
    bool asked = false;
    QTimer::singleShot(0, &window_, [&] {
      auto* dialog = qobject_cast<CycleDialog*>(QApplication::activeModalWidget());
      ASSERT_NE(dialog, nullptr);
      asked = true;
      what(*dialog);
      dialog->reject();
    });
    field<QPushButton>("masterAccepted").click();
    EXPECT_TRUE(asked);
  }
};

TEST_F(CycleDialogTest, SaysWhoRefusesACycleAndWhy) {
  const int steps = workspace_.document().undoStack().count();
  ask([](CycleDialog& dialog) {
    auto& table = *test::find<CycleTable>(dialog, "cycleDialogTable");
    EXPECT_TRUE(test::find<QLabel>(dialog, "cycleDialogAccepted")->text().contains(cycleText(4 * kMillisecond)));
    const int own = rowOf(table, 5 * kMillisecond);
    ASSERT_GE(own, 0);
    EXPECT_EQ(table.currentRow(), own);
    EXPECT_TRUE(table.item(own, 0)->font().bold());
    EXPECT_FALSE(test::find<QPushButton>(dialog, "cycleDialogUse")->isEnabled()) << "it is the project's own";
    const auto why = table.item(own, 2)->text();
    EXPECT_TRUE(why.contains(QStringLiteral("is the longest cycle that"))) << qPrintable(why);
    for (std::size_t i = 1; i < 3; ++i)
      EXPECT_TRUE(why.contains(QString::fromStdString(tooSlow().slaves[i].name))) << qPrintable(why);
    EXPECT_EQ(why.count(QLatin1Char('\n')), 0) << "one reason, told once: " << qPrintable(why);
    EXPECT_TRUE(table.item(rowOf(table, kMillisecond), 2)->text().isEmpty());
  });
  EXPECT_EQ(workspace_.document().undoStack().count(), steps) << "closed without taking one";
}

TEST_F(CycleDialogTest, TakesTheMarkedCycleInOneUndoStep) {
  const int steps = workspace_.document().undoStack().count();
  ask([](CycleDialog& dialog) {
    auto& table = *test::find<CycleTable>(dialog, "cycleDialogTable");
    table.selectRow(rowOf(table, 2 * kMillisecond));
    auto& use = *test::find<QPushButton>(dialog, "cycleDialogUse");
    ASSERT_TRUE(use.isEnabled());
    use.click();
  });
  EXPECT_EQ(project().master.cycle_time, 2 * kMillisecond);
  EXPECT_EQ(workspace_.document().undoStack().count(), steps + 1);
  workspace_.document().undoStack().undo();
  EXPECT_EQ(project().master.cycle_time, 5 * kMillisecond);
}

}  // namespace
}  // namespace syncline::ui
