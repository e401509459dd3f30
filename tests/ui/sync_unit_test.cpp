// SPDX-License-Identifier: Apache-2.0
// Slaves are dragged from one Sync Unit to another.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QToolButton>
#include <QTreeView>
#include <memory>

#include "support/project_window.h"
#include "ui/models/sync_unit_model.h"

namespace syncline::ui {
namespace {

/// Two units, in one of which are the inputs of the first drive.
Project machineWithUnits() {
  auto project = test::smallProject();
  project.master.sync_units = {{"Heating", ""}, {"Press", ""}};
  for (auto& slave : project.slaves) {
    if (slave.assigned_rx_pdos.empty()) continue;
    slave.input_unit = "Heating";
    break;
  }
  return project;
}

/// All of the first drive in a task of every fourth bus cycle.
Project machineWithASlowDrive() {
  auto project = machineWithUnits();
  project.master.tasks = {{"Slow", 4}};
  project.master.sync_units[0].task = "Slow";
  for (auto& slave : project.slaves) {
    if (slave.input_unit == "Heating") slave.output_unit = "Heating";
    if (!slave.device.dc) continue;
    slave.device.sync_managers.resize(4);
    constexpr SyncManagerType kTypes[] = {SyncManagerType::kMailboxOut, SyncManagerType::kMailboxIn,
                                          SyncManagerType::kOutputs, SyncManagerType::kInputs};
    for (std::size_t i = 0; i < 4; ++i) slave.device.sync_managers[i].type = kTypes[i];
  }
  return project;
}

class SlowDrive : public test::ProjectWindow {
 protected:
  SlowDrive() : ProjectWindow(machineWithASlowDrive()) {}
};

/// What the page says of the cycle is what is written to 0x09A0.
TEST_F(SlowDrive, HasTheCycleOfItsTask) {
  const auto& compiled = workspace_.configuration().current();
  ASSERT_TRUE(compiled);
  ASSERT_EQ(workspace_.configuration().config()->slaves[1].dc->cycle_time0, 4 * kMillisecond);
  show(1, "slaveDcPage");
  EXPECT_EQ(field<QLabel>("syncBusCycle").text(), QStringLiteral("4\u00A0ms"));
  EXPECT_EQ(field<QComboBox>("sync0Factor").currentText(), QStringLiteral("As operation mode (4\u00A0ms)"));
  show(2, "slaveDcPage");
  EXPECT_EQ(field<QLabel>("syncBusCycle").text(), QStringLiteral("1\u00A0ms")) << "the other drive is not in it";
}

QStringList linesOf(const QAbstractItemModel& model) {
  QStringList lines;
  for (int unit = 0; unit < model.rowCount(); ++unit) {
    const auto parent = model.index(unit, 0);
    for (int row = 0; row < model.rowCount(parent); ++row) {
      lines << QStringLiteral("%1: %2 %3")
                   .arg(parent.data().toString(), model.index(row, 0, parent).data().toString(),
                        model.index(row, 1, parent).data().toString());
    }
  }
  return lines;
}

TEST(SyncUnitModel, HasEachSlaveWhereItsDataAreExchanged) {
  SyncUnitModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  auto project = machineWithUnits();
  model.setProject(project);
  EXPECT_EQ(model.rowCount(), 3) << "the unnamed one comes first";
  const auto address = [&](const QModelIndex& index) { return model.member(index)->address; };
  const auto heating = model.index(1, 0);
  ASSERT_EQ(model.rowCount(heating), 1);
  const auto drive = model.index(0, 0, heating);
  EXPECT_TRUE(model.member(drive)->inputs);
  EXPECT_FALSE(model.member(drive)->outputs);
  EXPECT_EQ(model.find(address(drive)).size(), 2) << "its outputs are elsewhere";
  EXPECT_EQ(model.member(heating), nullptr);
  EXPECT_EQ(model.unit(drive), QStringLiteral("Heating"));
  const auto before = linesOf(model);
  project.master.sync_units.pop_back();
  model.setProject(project);
  EXPECT_EQ(model.rowCount(), 2);
  EXPECT_EQ(linesOf(model), before);
}

TEST(SyncUnitModel, AsksForWhatIsDropped) {
  SyncUnitModel model;
  model.setProject(machineWithUnits());
  std::vector<UnitMember> wanted;
  QString where;
  QObject::connect(&model, &SyncUnitModel::moveWanted, &model,
                   [&](const std::vector<UnitMember>& members, const QString& unit) {
                     wanted = members;
                     where = unit;
                   });
  const auto heating = model.index(1, 0), press = model.index(2, 0);
  const auto drive = model.index(0, 0, heating);
  EXPECT_EQ(model.mimeData({heating}), nullptr) << "a unit is not moved";
  const std::unique_ptr<QMimeData> data(model.mimeData({drive, drive.siblingAtColumn(1)}));
  ASSERT_NE(data, nullptr);
  EXPECT_FALSE(model.canDropMimeData(data.get(), Qt::MoveAction, -1, -1, {})) << "beside the units is no place";
  EXPECT_TRUE(model.dropMimeData(data.get(), Qt::MoveAction, -1, -1, press));
  ASSERT_EQ(wanted.size(), 1U);
  EXPECT_EQ(wanted.front(), *model.member(drive)) << "its inputs alone";
  EXPECT_EQ(where, QStringLiteral("Press"));
  EXPECT_TRUE(model.dropMimeData(data.get(), Qt::MoveAction, 0, 0, model.index(0, 0, model.index(0, 0))))
      << "on a slave: to its unit";
  EXPECT_TRUE(where.isEmpty());
  auto gone = machineWithUnits();
  gone.slaves.clear();
  model.setProject(gone);
  EXPECT_FALSE(model.dropMimeData(data.get(), Qt::MoveAction, -1, -1, model.index(2, 0))) << "nobody is left";
}

class SyncUnitsInTheWindow : public test::ProjectWindow {
 protected:
  SyncUnitsInTheWindow() : ProjectWindow(machineWithUnits()) {
    workspace_.setExpert(true);
    has(-1, "masterTasksPage");
  }
  QTreeView& tree() { return field<QTreeView>("unitMembers"); }
  QToolButton& button() { return field<QToolButton>("unitMove"); }
};

TEST_F(SyncUnitsInTheWindow, SelectedSlavesAreMovedInOneStep) {
  ASSERT_TRUE(tree().isVisible());
  EXPECT_FALSE(button().isEnabled()) << "nothing is selected";
  const auto before = project();
  const auto& model = *tree().model();
  const auto none = model.index(0, 0);
  ASSERT_GE(model.rowCount(none), 2);
  auto& selection = *tree().selectionModel();
  for (int row = 0; row < 2; ++row)
    selection.select(model.index(row, 0, none), QItemSelectionModel::Select | QItemSelectionModel::Rows);
  ASSERT_TRUE(button().isEnabled());
  Q_EMIT button().menu()->aboutToShow();
  ASSERT_EQ(button().menu()->actions().size(), 3);
  button().menu()->actions().at(2)->trigger();
  EXPECT_EQ(workspace_.document().undoStack().count(), 2) << "loading, and this";
  EXPECT_EQ(model.rowCount(model.index(2, 0)), 2);
  EXPECT_EQ(selection.selectedRows().size(), 3) << "the selection goes with them, all rows of a slave";
  EXPECT_NE(project(), before);
  workspace_.document().undoStack().undo();
  EXPECT_EQ(project(), before);
  EXPECT_EQ(model.rowCount(model.index(2, 0)), 0);
}

TEST_F(SyncUnitsInTheWindow, AreNotThereWithoutUnits) {
  ASSERT_TRUE(workspace_.document().edit(QStringLiteral("none"), [](Project& project) -> Status {
    project.master.sync_units.clear();
    for (auto& slave : project.slaves) slave.input_unit.clear();
    return {};
  }));
  EXPECT_FALSE(tree().isVisible());
}

}  // namespace
}  // namespace syncline::ui
