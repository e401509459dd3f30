// SPDX-License-Identifier: Apache-2.0
// Variables of the process image in the monitor: chosen on their page, drawn, studied, triggered on, exported.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "record/recording_reader.h"
#include "support/running_window.h"
#include "ui/models/variable_model.h"
#include "ui/panels/distribution_view.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/stability_view.h"
#include "ui/panels/variables_row.h"
#include "ui/plots/histogram_plot.h"
#include "ui/session/variable_watch.h"

namespace syncline::ui {
namespace {

using testing::HasSubstr;

class WatchedVariables : public test::RunningWindow {
 protected:
  LiveStrip& strip() { return field<LiveStrip>("liveStrip"); }
  QPushButton& button() { return field<QPushButton>("variableWatch"); }
  /// Chooses a variable of the servo on its page.
  QString choose(const QString& words, int slave = kServo) {
    show(slave, "variablesPage");
    field<QLineEdit>("variableSearch").setText(words);
    auto& table = field<QTableView>("variableTable");
    EXPECT_EQ(table.model()->rowCount(), 1) << qPrintable(words);
    table.setCurrentIndex(table.model()->index(0, 0));
    return table.model()->index(0, VariableModel::kName).data().toString();
  }
  QString cell(VariableModel::Column column) {
    return field<QTableView>("variableTable").model()->index(0, column).data().toString();
  }
  QString watch(const QString& words, int slave = kServo) {
    const auto name = choose(words, slave);
    EXPECT_TRUE(button().isEnabled());
    button().click();
    EXPECT_TRUE(button().isChecked());
    return name;
  }
  const RunRecord& record() { return *workspace_.live().record(); }
  std::size_t valuesOf(std::size_t variable) {
    std::size_t count = 0;
    record()
        .samples()
        .series(Signal::kVariable, variable)
        .for_each(INT64_MIN, INT64_MAX, [&](Nanoseconds, float value) {
          if (!std::isnan(value)) ++count;
        });
    return count;
  }
};

TEST_F(WatchedVariables, AreChosenOnTheirPageAndDrawnInEachCycle) {
  goOnline();
  EXPECT_FALSE(strip().variables()->isVisible()) << "nothing is watched";
  const auto name = watch(QStringLiteral("statusword"));
  EXPECT_EQ(cell(VariableModel::kMonitor), QStringLiteral("watched"));
  run(400 * kMillisecond);
  strip().refresh();
  EXPECT_TRUE(strip().variables()->isVisible());
  auto* panel = strip().variables()->panels()[0];
  EXPECT_TRUE(panel->isVisible());
  EXPECT_FALSE(strip().variables()->panels()[1]->isVisible());
  EXPECT_EQ(panel->title(), QStringLiteral("#3 Statusword"));
  EXPECT_TRUE(name.endsWith(QStringLiteral(".Statusword"))) << qPrintable(name);
  EXPECT_GE(valuesOf(0), 390U) << "one in each cycle of 1 ms";
  EXPECT_LE(valuesOf(0), 420U) << "none from before";
  const auto shown = cell(VariableModel::kValue).toUInt();
  EXPECT_GT(shown, 0U);
  EXPECT_EQ(record().samples().value(Signal::kVariable, 0, record().samples().last_time())->value,
            static_cast<float>(shown));
  EXPECT_THAT(panel->legend()->text().toStdString(), HasSubstr(std::to_string(shown)));
  EXPECT_THAT(panel->readout().toStdString(), HasSubstr("max"));
  // Out again.
  button().click();
  EXPECT_EQ(cell(VariableModel::kMonitor), QString());
  run(100 * kMillisecond);
  strip().refresh();
  EXPECT_FALSE(strip().variables()->isVisible());
}

TEST_F(WatchedVariables, OfTheSameNameShareAPlot) {
  goOnline();
  watch(QStringLiteral("statusword"));
  watch(QStringLiteral("statusword"), kOtherServo);
  watch(QStringLiteral("controlword"));
  run(200 * kMillisecond);
  strip().refresh();
  const auto& panels = strip().variables()->panels();
  EXPECT_EQ(panels[0]->variables(), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(panels[0]->title(), QStringLiteral("Statusword"));
  EXPECT_EQ(panels[1]->variables(), (std::vector<std::size_t>{2}));
  EXPECT_EQ(panels[1]->title(), QStringLiteral("#3 Controlword"));
  ASSERT_EQ(panels[0]->legend()->entries().size(), 2U);
  EXPECT_TRUE(panels[0]->legend()->entries()[1].name.startsWith(QStringLiteral("#4 Slave_1005")));
  const auto &mine = panels[0]->plot()->grid(), &above = strip().panels()[0]->plot()->grid();
  EXPECT_LE(std::abs(mine.origin - above.origin), std::max(mine.width, above.width)) << "one time axis";
}

TEST_F(WatchedVariables, AreWatchedFromTheFirstCycleOfTheNextRun) {
  goOnline();
  const auto name = watch(QStringLiteral("statusword"));
  run(100 * kMillisecond);
  workspace_.live().shutDown();
  goOnline();
  ASSERT_EQ(record().watched().variables().size(), 1U);
  EXPECT_EQ(record().watched().variables()[0].name, name.toStdString());
  EXPECT_GT(valuesOf(0), 300U) << "since SAFEOP";
}

TEST_F(WatchedVariables, AreSignalsOfDistributionStabilityAndCsv) {
  goOnline();
  const auto name = watch(QStringLiteral("statusword"));
  run(400 * kMillisecond);
  strip().showBody(LiveStrip::Body::kDistribution);
  auto* chooser = strip().distribution()->findChild<QToolButton*>(QStringLiteral("distributionSignals"));
  ASSERT_NE(chooser, nullptr);
  const auto offered = [&](QToolButton& of) -> QAction* {
    Q_EMIT of.menu()->aboutToShow();
    for (auto* part : of.menu()->findChildren<QMenu*>()) {
      for (auto* action : part->actions()) {
        if (action->text() == name) return action;
      }
    }
    return nullptr;
  };
  auto* action = offered(*chooser);
  ASSERT_NE(action, nullptr) << "it is in the menu by its name";
  action->trigger();
  strip().refresh();
  ASSERT_EQ(strip().distribution()->sources().size(), 2U);
  EXPECT_THAT(strip().csv(), HasSubstr(",\"" + name.toStdString() + "\"\n"));
  strip().showBody(LiveStrip::Body::kStability);
  auto* stability = strip().stability();
  auto* other = stability->findChild<QToolButton*>(QStringLiteral("stabilitySignals"));
  ASSERT_NE(other, nullptr);
  action = offered(*other);
  ASSERT_NE(action, nullptr);
  action->trigger();
  ASSERT_EQ(stability->sources().size(), 1U) << "times are not beside it";
  EXPECT_EQ(stability->sources()[0].signal, Signal::kVariable);
  ASSERT_TRUE(test::waitFor([&] {
    stability->refresh();
    return stability->complete();
  }));
  EXPECT_THAT(strip().csv(), HasSubstr("signal,tau_s,adev,mdev,tdev,mtie,windows\n"));
  strip().showBody(LiveStrip::Body::kPlots);
  const auto table = strip().csv();
  EXPECT_THAT(table.substr(0, table.find('\n')), HasSubstr(name.toStdString()));
}

TEST_F(WatchedVariables, TheChooserLeadsToThePage) {
  goOnline();
  strip().showBody(LiveStrip::Body::kDistribution);
  auto* chooser = strip().distribution()->findChild<QToolButton*>(QStringLiteral("distributionSignals"));
  Q_EMIT chooser->menu()->aboutToShow();
  QAction* more = nullptr;
  for (auto* part : chooser->menu()->findChildren<QMenu*>()) {
    for (auto* action : part->actions()) {
      if (action->text().startsWith(QStringLiteral("Watch others"))) more = action;
    }
  }
  ASSERT_NE(more, nullptr);
  more->trigger();
  EXPECT_EQ(window_.editor().tabs()->currentWidget()->objectName(), QStringLiteral("variablesPage"));
}

TEST_F(WatchedVariables, AreTriggeredOn) {
  goOnline();
  const auto name = watch(QStringLiteral("statusword"));
  run(200 * kMillisecond);
  const auto level = record().samples().value(Signal::kVariable, 0, record().samples().last_time())->value;
  auto& source = field<QComboBox>("triggerSource");
  source.setCurrentIndex(source.findData(static_cast<int>(Signal::kVariable)));
  Q_EMIT source.activated(source.currentIndex());
  auto& variable = field<QComboBox>("triggerVariable");
  EXPECT_FALSE(variable.isHidden());
  ASSERT_EQ(variable.findText(name), 0);
  variable.setCurrentIndex(0);
  Q_EMIT variable.activated(0);
  field<QDoubleSpinBox>("triggerLevel").setValue(static_cast<double>(level) + 1);
  workspace_.trigger().arm();
  EXPECT_EQ(workspace_.trigger().trigger().variable, name.toStdString());
  strip().refresh();
  EXPECT_EQ(strip().variables()->panels()[0]->plot()->triggerLevel(), static_cast<double>(level) + 1);
  EXPECT_FALSE(strip().panels()[0]->plot()->triggerLevel());
  // The drive follows its controlword: another statusword.
  const auto servo = record().watched().variables()[0].slave;
  const auto controlword = record().config().slaves[static_cast<std::size_t>(servo)].send->bit_start;
  field<QDoubleSpinBox>("triggerLevel").setValue(static_cast<double>(level) - 0.5);
  const auto& before = workspace_.trigger().episodes();
  EXPECT_TRUE(before.empty());
  for (const std::uint64_t control : {6U, 0U, 6U, 0U, 6U}) {
    workspace_.live().forceOutput(controlword, 16, control);
    run(200 * kMillisecond);
    workspace_.trigger().look();
  }
  EXPECT_FALSE(workspace_.trigger().episodes().empty());
  EXPECT_EQ(workspace_.trigger().episodes()[0].slave, servo);
}

TEST_F(WatchedVariables, StandInRecordingsUnderTheirNames) {
  const QTemporaryDir folder;
  const auto path = folder.filePath(QStringLiteral("run.slrec"));
  goOnline();
  const auto status = watch(QStringLiteral("statusword"));
  ASSERT_TRUE(workspace_.disk().start(path));
  run(300 * kMillisecond);
  const auto control = watch(QStringLiteral("controlword"));
  run(300 * kMillisecond);
  workspace_.disk().finish();
  auto reader = RecordingReader::open(path.toStdString());
  ASSERT_TRUE(reader) << reader.error().detail.text();
  const auto info = reader->info();
  ASSERT_TRUE(info) << info.error().detail.text();
  const auto& watched = info->about.watched;
  ASSERT_EQ(watched.variables().size(), 2U);
  EXPECT_EQ(watched.variables()[0].name, status.toStdString());
  EXPECT_EQ(watched.variables()[1].name, control.toStdString());
  std::size_t first = 0, second = 0;
  ASSERT_TRUE(reader->samples([&](std::span<const CycleSample> samples) {
    for (const auto& sample : samples) {
      if (watched.bits(sample, 0)) ++first;
      if (watched.bits(sample, 1)) ++second;
    }
    return true;
  }));
  EXPECT_GE(first, 590U);
  EXPECT_GE(second, 290U);
  EXPECT_LT(second, 320U) << "from the cycle on in which it was watched";
  EXPECT_TRUE(reader->verify());
}

TEST_F(WatchedVariables, AreSixteenAtMost) {
  load();
  show(-1, "variablesPage");
  auto& table = field<QTableView>("variableTable");
  ASSERT_GT(table.model()->rowCount(), 17);
  int row = 0;
  for (; workspace_.variables().hasRoom(); ++row) {
    table.setCurrentIndex(table.model()->index(row, 0));
    if (button().isEnabled()) button().click();
  }
  table.setCurrentIndex(table.model()->index(row, 0));
  EXPECT_FALSE(button().isEnabled());
  EXPECT_THAT(button().toolTip().toStdString(), HasSubstr("16 variables are watched already"));
  EXPECT_FALSE(field<QAction>("actionWatchVariable").isEnabled());
  table.setCurrentIndex(table.model()->index(0, 0));
  EXPECT_TRUE(button().isEnabled()) << "it can be taken away";
  button().click();
  EXPECT_TRUE(workspace_.variables().hasRoom());
}

TEST(VariableMemory, KeepsTheListOfAProjectsFile) {
  const QTemporaryDir folder;
  WindowMemory memory(folder.filePath(QStringLiteral("memory.ini")));
  const auto file = folder.filePath(QStringLiteral("m.syncline")),
             other = folder.filePath(QStringLiteral("o.syncline"));
  const VariableName position{"Servo.Inputs.Position", false}, same{"Servo.Inputs.Position", true};
  ProjectDocument document;
  VariableWatch watch(document, memory);
  QSignalSpy changes(&watch, &VariableWatch::changed);
  watch.add(position);
  watch.add(position);
  watch.add(same);
  EXPECT_EQ(changes.count(), 2);
  ASSERT_TRUE(document.save(file));
  document.reset();
  EXPECT_TRUE(watch.names().empty()) << "another machine";
  ASSERT_TRUE(document.load(file));
  EXPECT_EQ(watch.names(), (std::vector{position, same}));
  ASSERT_TRUE(document.save(other));
  watch.remove(position);
  ASSERT_TRUE(document.load(file));
  EXPECT_EQ(watch.names().size(), 2U) << "that of the file before";
  ASSERT_TRUE(document.load(other));
  EXPECT_EQ(watch.names(), std::vector{same});
}

}  // namespace
}  // namespace syncline::ui
