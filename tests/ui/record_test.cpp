// SPDX-License-Identifier: Apache-2.0
// Lists of records: tasks, Sync Units, start-up commands, PDO entries.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>
#include <QUndoStack>
#include <memory>

#include "settings/settings_table.h"
#include "support/project_window.h"
#include "support/ui_test_support.h"
#include "ui/editors/object_picker.h"
#include "ui/editors/page.h"
#include "ui/editors/record_part.h"
#include "ui/editors/text_edit.h"
#include "ui/main_window.h"
#include "ui/models/pdo_model.h"
#include "ui/models/record_model.h"
#include "ui/pages/device_editor.h"
#include "ui/session/workspace.h"

namespace syncline::ui {
namespace {

TEST(RecordModel, KeepsRowsThatStay) {
  RecordModel model({QStringLiteral("a"), QStringLiteral("b")});
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Warning);
  const auto lines = [](std::initializer_list<const char*> words) {
    RecordModel::Lines all;
    for (const auto* word : words) all.push_back({QLatin1String(word), QStringLiteral("-")});
    return all;
  };
  model.setLines(lines({"1", "2", "3"}));
  const QPersistentModelIndex third = model.index(2, 0);
  model.setLines(lines({"1", "x", "2", "3"}));
  EXPECT_EQ(third.row(), 3);
  EXPECT_EQ(third.data().toString(), QStringLiteral("3"));
  model.setLines(lines({"3"}));
  EXPECT_EQ(model.rowCount(), 1);
  model.setLines({});
  EXPECT_EQ(model.rowCount(), 0);
}

/// Whatever is added, removed or changed: the edits make the one list of the other, and names stay unique on the way.
TEST(RecordEdits, MakeOneListOfAnother) {
  EXPECT_TRUE(rc::check([] {
    const auto list = [](const std::vector<int>& names) {
      Records records;
      for (const int name : names) {
        auto record = "T" + std::to_string(name) + " x2";
        if (std::ranges::find(records, record) == records.end()) records.push_back(std::move(record));
      }
      return records;
    };
    const auto before = list(*rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 9)));
    auto after = before;
    const int what = *rc::gen::inRange(0, 3);
    const auto place = before.empty() ? 0 : *rc::gen::inRange<std::ptrdiff_t>(0, static_cast<int>(before.size()));
    if (what == 0 || before.empty()) {
      after.push_back("New x3");
    } else if (what == 1) {
      after.erase(after.begin() + place);
    } else {
      after[static_cast<std::size_t>(place)] = "Changed x4";
    }
    Project project;
    for (const auto& edit : itemEdits("master.task.K", 0, {}, before))
      RC_ASSERT(settings::set_value(*edit.setting, project, edit.place, edit.value).has_value());
    for (const auto& edit : itemEdits("master.task.K", 0, before, after))
      RC_ASSERT(settings::set_value(*edit.setting, project, edit.place, edit.value).has_value());
    Records is;
    for (const auto& place_of : settings::row("master.task.K").items(project, 0))
      is.push_back(settings::text_of(settings::row("master.task.K"), project, place_of));
    RC_ASSERT(is == after);
  }));
}

/// A drive whose start-up list and PDOs can be edited.
Project machineWithLists() {
  auto machine = test::smallProject();
  auto& device = machine.slaves[1].device;
  device.mailbox.emplace().coe.emplace().pdo_config = true;
  ObjectDescription object;
  object.index = 0x6060;
  object.name = "Modes of operation";
  ObjectEntry entry;
  entry.name = object.name;
  entry.data_type = "SINT";
  entry.bit_length = 8;
  entry.writable = entry.rx_mappable = true;
  entry.default_data = {8};
  object.entries = {entry};
  device.dictionary = {object};
  return machine;
}

class Lists : public test::ProjectWindow {
 protected:
  Lists() : ProjectWindow(machineWithLists()) {}

  int steps() { return workspace_.document().undoStack().index(); }
  void press(const char* name) {
    auto& button = field<QToolButton>(name);
    ASSERT_TRUE(button.isEnabled()) << name;
    button.setFocus();
    QTest::keyClick(&button, Qt::Key_Space);
  }
};

TEST_F(Lists, StartupCommandsAreMadeByKeyboard) {
  show(1, "slaveStartupPage");
  EXPECT_FALSE(field("coeObject").isEnabled()) << "there is none";
  const int before = steps();
  press("startupAdd");
  ASSERT_EQ(project().slaves[1].startup.size(), 1U);
  EXPECT_FALSE(project().slaves[1].startup[0].enabled) << "nothing is sent before the user says what";
  test::type(field("coeObject"), QStringLiteral("6060:00"));
  EXPECT_EQ(field<QComboBox>("coeType").currentText(), QStringLiteral("As described (SINT)"));
  test::type(field("coeValue"), QStringLiteral("-3"));
  test::type(field("coeComment"), QStringLiteral("velocity"));
  auto& enabled = field<QCheckBox>("coeEnabled");
  enabled.setFocus();
  QTest::keyClick(&enabled, Qt::Key_Space);
  press("coeTransitionsSO");
  EXPECT_EQ(settings::text_of(settings::row("slave.N.startup.K"), project(), {.slave = 1}),
            "PS,SO 0x6060:00=fd # velocity");
  EXPECT_EQ(steps(), before + 6);
  press("startupAdd");
  EXPECT_EQ(field<QTableView>("startupTable").currentIndex().row(), 1);
  press("startupUp");
  EXPECT_EQ(project().slaves[1].startup[1].index, 0x6060);
  EXPECT_EQ(field<QTableView>("startupTable").currentIndex().row(), 0);
  press("startupRemove");
  ASSERT_EQ(project().slaves[1].startup.size(), 1U);
  EXPECT_EQ(project().slaves[1].startup[0].index, 0x6060);
  EXPECT_EQ(steps(), before + 9);
}

/// As slaves in the explorer.
TEST_F(Lists, AreEditedByTheKeysOfAList) {
  show(1, "slaveStartupPage");
  auto& table = field<QTableView>("startupTable");
  const auto& commands = project().slaves[1].startup;
  const int before = steps();
  const auto press_key = [&table](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    table.setFocus();
    QTest::keyClick(&table, key, modifiers);
  };
  press_key(Qt::Key_Insert);
  press_key(Qt::Key_Insert);
  ASSERT_EQ(commands.size(), 2U);
  test::type(field("coeObject"), QStringLiteral("6060:00"));
  press_key(Qt::Key_Up, Qt::AltModifier);
  EXPECT_EQ(commands[0].index, 0x6060);
  press_key(Qt::Key_Up, Qt::AltModifier);
  EXPECT_EQ(commands[0].index, 0x6060) << "it is the first one";
  press_key(Qt::Key_Down, Qt::AltModifier);
  EXPECT_EQ(commands[1].index, 0x6060);
  press_key(Qt::Key_Delete);
  ASSERT_EQ(commands.size(), 1U);
  EXPECT_NE(commands[0].index, 0x6060);
  EXPECT_EQ(steps(), before + 6);
  // A field's own.
  auto& value = field<QLineEdit>("coeComment");
  value.setFocus();
  QTest::keyClick(&value, Qt::Key_Delete);
  EXPECT_EQ(commands.size(), 1U);
}

TEST_F(Lists, WhatIsNoValueStaysAndIsMarked) {
  show(1, "slaveStartupPage");
  press("startupAdd");
  const int before = steps();
  auto& value = field<TextEdit>("coeValue");
  test::type(value, QStringLiteral("soon"));
  EXPECT_EQ(value.text(), QStringLiteral("soon"));
  EXPECT_FALSE(value.accessibleDescription().isEmpty());
  EXPECT_EQ(steps(), before);
  press("coeTransitionsPS");
  EXPECT_EQ(project().slaves[1].startup[0].transitions.size(), 1U) << "a command without transition is none";
}

TEST_F(Lists, AnObjectIsChosenFromTheDictionary) {
  show(1, "slaveStartupPage");
  press("startupAdd");
  const int before = steps();
  field<QAbstractButton>("coeChoose").click();
  auto* picker = window_.findChild<ObjectPicker*>();
  ASSERT_NE(picker, nullptr);
  QTest::keyClicks(test::find<QWidget>(*picker, "objectWords"), QStringLiteral("modes sint"));
  test::find<QAbstractButton>(*picker, "objectChoose")->click();
  EXPECT_EQ(steps(), before + 1);
  const auto& command = project().slaves[1].startup[0];
  EXPECT_EQ(command.index, 0x6060);
  EXPECT_EQ(command.data, std::vector<std::uint8_t>({8}));
  EXPECT_EQ(command.comment, "Modes of operation");
}

TEST_F(Lists, UnitsFollowTheNameOfTheirTask) {
  workspace_.setExpert(true);
  show(-1, "masterTasksPage");
  press("tasksAdd");
  press("unitsAdd");
  ASSERT_EQ(project().master.tasks.size(), 1U);
  ASSERT_EQ(project().master.sync_units.size(), 1U);
  auto& task = field<QComboBox>("unitTask");
  task.setFocus();
  QTest::keyClick(&task, Qt::Key_End);
  EXPECT_EQ(project().master.sync_units[0].task, project().master.tasks[0].name);
  const int before = steps();
  test::type(field("taskName"), QStringLiteral("Slow"));
  EXPECT_EQ(project().master.sync_units[0].task, "Slow");
  EXPECT_EQ(steps(), before + 1);
  ASSERT_TRUE(
      workspace_.document().set(QStringLiteral("set"), {{&settings::row("slave.N.sync_unit.outputs"),
                                                         {.slave = 1},
                                                         settings::Value{project().master.sync_units[0].name}}}));
  show(-1, "masterTasksPage");
  test::type(field("unitName"), QStringLiteral("Infeed"));
  EXPECT_EQ(project().slaves[1].output_unit, "Infeed");
  press("tasksRemove");
  EXPECT_EQ(project().master.sync_units[0].task, "");
  press("unitsRemove");
  EXPECT_EQ(project().slaves[1].output_unit, "");
}

TEST_F(Lists, AMappingIsEditedWhereTheDeviceLetsIt) {
  show(1, "processDataPage");
  EXPECT_TRUE(field("mappingObject").isVisible());
  press("mappingAdd");
  auto mapping = [&] {
    return settings::text_of(settings::row("slave.N.pdo.map.0xIIII"), project(), {.slave = 1, .item = 0x1600});
  };
  EXPECT_EQ(mapping(), "0x6040:00:16,0x0000:00:8,0x0000:00:8,0x607a:00:32");
  test::type(field("mappingObject"), QStringLiteral("0x6060:00"));
  EXPECT_EQ(mapping(), "0x6040:00:16,0x6060:00:8,0x0000:00:8,0x607a:00:32");
  EXPECT_EQ(project().slaves[1].changed_pdos.front().entries[1].name, "Modes of operation");
  press("mappingDown");
  EXPECT_EQ(mapping(), "0x6040:00:16,0x0000:00:8,0x6060:00:8,0x607a:00:32");
  press("mappingRemove");
  EXPECT_EQ(mapping(), "0x6040:00:16,0x0000:00:8,0x607a:00:32");
  EXPECT_TRUE(project().slaves[1].changed_pdos.empty()) << "as the device has it";
  show(2, "processDataPage");
  EXPECT_FALSE(field("mappingObject").isVisible());
  EXPECT_TRUE(field<QLabel>("mappingRefusal").isVisible());
  EXPECT_FALSE(field("mappingAdd").isEnabled());
}

TEST_F(Lists, AnEntryIsWrittenInItsFieldAsInItsList) {
  show(1, "processDataPage");
  auto& list = field<QTableView>("pdoEntries");
  for (const int row : {0, 2}) {
    const auto cell = list.model()->index(row, PdoEntryModel::kObject);
    list.setCurrentIndex(cell);
    EXPECT_EQ(field<QLineEdit>("mappingObject").text(), cell.data().toString());
  }
  EXPECT_EQ(field<QLineEdit>("mappingObject").text(), QStringLiteral("0x607A:00"));
}

/// The order by the mouse, within the list alone.
TEST_F(Lists, EntriesAreDraggedToTheirPlace) {
  show(1, "processDataPage");
  press("mappingAdd");
  const auto mapping = [&] {
    return settings::text_of(settings::row("slave.N.pdo.map.0xIIII"), project(), {.slave = 1, .item = 0x1600});
  };
  ASSERT_EQ(mapping(), "0x6040:00:16,0x0000:00:8,0x0000:00:8,0x607a:00:32");
  auto& view = field<QTableView>("pdoEntries");
  auto* model = view.model();
  const QAbstractItemModelTester tester(model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  EXPECT_TRUE(model->flags(model->index(3, 0)) & Qt::ItemIsDragEnabled);
  const int steps = workspace_.document().undoStack().index();
  const auto drag = [&](int from, int before) {
    const std::unique_ptr<QMimeData> data(model->mimeData({model->index(from, 0)}));
    EXPECT_TRUE(model->canDropMimeData(data.get(), Qt::MoveAction, before, 0, {}));
    EXPECT_FALSE(model->dropMimeData(data.get(), Qt::MoveAction, before, 0, {})) << "the view removes nothing";
  };
  drag(3, 1);
  EXPECT_EQ(mapping(), "0x6040:00:16,0x607a:00:32,0x0000:00:8,0x0000:00:8");
  EXPECT_EQ(view.currentIndex().row(), 1) << "it stays selected";
  EXPECT_EQ(workspace_.document().undoStack().index(), steps + 1);
  drag(0, -1);
  EXPECT_EQ(mapping(), "0x607a:00:32,0x0000:00:8,0x0000:00:8,0x6040:00:16") << "below all: to the end";
  drag(2, 3);
  EXPECT_EQ(workspace_.document().undoStack().index(), steps + 2) << "where it stood";
  workspace_.document().undoStack().undo();
  workspace_.document().undoStack().undo();
  EXPECT_EQ(mapping(), "0x6040:00:16,0x0000:00:8,0x0000:00:8,0x607a:00:32");
  show(2, "processDataPage");
  EXPECT_FALSE(model->flags(model->index(0, 0)) & Qt::ItemIsDragEnabled) << "its device takes no other mapping";
}

/// A device without distributed clocks in its ESI, which synchronises by its SyncManager.
TEST_F(Lists, ADeviceWithoutClockHasItsSynchronisation) {
  auto machine = project();
  machine.slaves[1].device.dc.reset();
  machine.slaves[1].dc = {};
  workspace_.document().replace(QStringLiteral("load"), machine);
  show(1, "slaveSyncPage");
  EXPECT_TRUE(field("syncErrorLimit").isVisible());
  EXPECT_TRUE(field("syncErrorLimit").isEnabled());
  window_.selectNode(0);
  auto* tabs = window_.editor().tabs();
  for (int i = 0; i < tabs->count(); ++i) EXPECT_NE(tabs->widget(i)->objectName(), QStringLiteral("slaveSyncPage"));
}

}  // namespace
}  // namespace syncline::ui
