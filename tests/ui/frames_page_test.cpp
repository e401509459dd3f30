// SPDX-License-Identifier: Apache-2.0
// What the master sends: the cyclic frames with their cost, and the init commands.
#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QTableView>

#include "advice/image_report.h"
#include "exports/init_commands.h"
#include "support/running_window.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

class FramesOfTheMaster : public test::RunningWindow {
 protected:
  QString cell(const char* name, int row, int column) {
    return field<QTableView>(name).model()->index(row, column).data().toString();
  }
  int rows(const char* name) { return field<QTableView>(name).model()->rowCount(); }
};

TEST_F(FramesOfTheMaster, CostWhatTheReportSays) {
  load();
  show(-1, "framesPage");
  const auto& config = workspace_.configuration().current().value().config;
  const auto report = image_report(project(), config);
  ASSERT_EQ(rows("frameTable"), static_cast<int>(report.frames.size()));
  EXPECT_EQ(cell("frameTable", 0, 3), QString::number(report.frames[0].bytes));
  EXPECT_EQ(rows("datagramTable"), static_cast<int>(report.frames[0].datagrams)) << "of the first frame";
  EXPECT_GT(rows("slaveCostTable"), 1);
  EXPECT_LT(rows("slaveCostTable"), static_cast<int>(project().slaves.size())) << "a coupler costs nothing";
  const auto summary = field<QLabel>("framesSummary").text();
  EXPECT_TRUE(summary.contains(QStringLiteral("bandwidth"))) << qPrintable(summary);
  EXPECT_FALSE(summary.contains(QStringLiteral("longer than the cycle")));
  // A slower cycle has the same frames and another share.
  ASSERT_TRUE(workspace_.document().edit(QStringLiteral("cycle"), [](Project& project) -> Status {
    project.master.cycle_time = 2 * kMillisecond;
    return {};
  }));
  ASSERT_TRUE(workspace_.configuration().current());
  QApplication::processEvents();
  EXPECT_NE(field<QLabel>("framesSummary").text(), summary);
  EXPECT_EQ(cell("frameTable", 0, 1), cycleText(2 * kMillisecond));
}

/// What both pages say is the same.
TEST_F(FramesOfTheMaster, CostTheSameOnThePageOfTheMaster) {
  load();
  show(-1, "framesPage");
  const auto summary = field<QLabel>("framesSummary").text();
  const auto report = image_report(project(), workspace_.configuration().current().value().config);
  show(-1, "masterGeneralPage");
  for (const char* name : {"masterInputs", "masterOutputs"}) {
    const auto text = field<QLabel>(name).text();
    EXPECT_TRUE(summary.contains(text)) << name << ' ' << qPrintable(text) << ": " << qPrintable(summary);
  }
  std::uint32_t bytes = 0;
  for (const auto& frame : report.frames) bytes += frame.bytes;
  const auto frames = field<QLabel>("masterFrame").text();
  EXPECT_TRUE(frames.contains(bitsText(8 * bytes))) << qPrintable(frames);
  EXPECT_TRUE(frames.contains(timeText(report.wire_time))) << qPrintable(frames);
}

TEST_F(FramesOfTheMaster, BeginWithTheInitCommands) {
  load();
  workspace_.setExpert(true);
  show(-1, "initCommandsPage");
  const auto& config = workspace_.configuration().current().value().config;
  const auto all = exports::init_commands(config);
  ASSERT_EQ(rows("initCommandTable"), static_cast<int>(all.size()));
  EXPECT_FALSE(field<QTableView>("initCommandTable").isColumnHidden(0));
  field<QLineEdit>("initCommandSearch").setText(QStringLiteral("0x09A0"));
  const int cycles = rows("initCommandTable");
  EXPECT_GT(cycles, 0);
  EXPECT_LT(cycles, static_cast<int>(all.size()));
  field<QLineEdit>("initCommandSearch").clear();
  show(kServo, "initCommandsPage");
  EXPECT_TRUE(field<QTableView>("initCommandTable").isColumnHidden(0));
  EXPECT_EQ(rows("initCommandTable"),
            static_cast<int>(std::ranges::count(all, kServo, &exports::InitCommandRow::slave)));
  workspace_.setExpert(false);
  EXPECT_NE(window_.editor().tabs()->currentWidget()->objectName(), QStringLiteral("initCommandsPage"));
}

}  // namespace
}  // namespace syncline::ui
