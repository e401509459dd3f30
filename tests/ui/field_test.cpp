// SPDX-License-Identifier: Apache-2.0
// Editing settings in the window: what is typed reaches the project as one undo step, and nothing else does.
#include <gtest/gtest.h>

#include <QAction>
#include <QButtonGroup>
#include <QCheckBox>
#include <QRadioButton>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTimer>
#include <QWheelEvent>
#include <set>

#include "eni/project/project_file.h"
#include "support/ui_test_support.h"
#include "ui/editors/choice_edit.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/number_edit.h"
#include "ui/editors/number_text.h"
#include "ui/editors/page.h"
#include "ui/editors/preset_edit.h"
#include "ui/editors/text_edit.h"
#include "ui/main_window.h"
#include "ui/pages/device_editor.h"
#include "ui/session/workspace.h"
#include "ui/text/setting_text.h"

namespace syncline::ui {
namespace {

/// A machine in which every field of every page can be edited.
Project editableProject() {
  auto project = test::smallProject();
  project.master.dc.sync_window.enabled = true;
  for (std::size_t i = 1; i < project.slaves.size(); ++i) {
    auto& slave = project.slaves[i];
    slave.device.mailbox.emplace().coe.emplace();
    auto& modes = slave.device.dc->op_modes;
    modes.front().assign_activate = 0x0700;
    modes.push_back(modes.front());
    modes.back().name = "DC 2";
    slave.device.tx_pdos = {slave.device.rx_pdos[2]};
    slave.device.tx_pdos.front().index = 0x1A00;
    slave.dc.sync0.user_cycle = slave.dc.sync1.user_cycle = kMillisecond;
  }
  return project;
}

class Fields : public ::testing::Test {
 protected:
  Fields() : workspace_(test::virtualEnvironment()), window_(workspace_) {
    workspace_.document().replace(QStringLiteral("load"), editableProject());
    workspace_.document().undoStack().setClean();
    window_.show();
    window_.activateWindow();
    static_cast<void>(QTest::qWaitForWindowActive(&window_));
  }
  ~Fields() override { workspace_.document().undoStack().setClean(); }

  const Project& project() { return workspace_.document().project(); }
  QUndoStack& steps() { return workspace_.document().undoStack(); }
  template <class Widget = QWidget>
  Widget& field(const char* name) {
    return *test::find<Widget>(window_, name);
  }
  void show(int node, const char* page) {
    window_.selectNode(node);
    auto* tabs = window_.editor().tabs();
    for (int i = 0; i < tabs->count(); ++i) {
      if (tabs->widget(i)->objectName() == QLatin1String(page)) tabs->setCurrentIndex(i);
    }
    ASSERT_EQ(tabs->currentWidget()->objectName(), QLatin1String(page));
  }

  Workspace workspace_;
  MainWindow window_;
};

TEST_F(Fields, AShorterCycleLeavesTheSetValueToTheMaster) {
  show(-1, "masterGeneralPage");
  const int before = steps().index();
  test::type(field("masterCycle"), QStringLiteral("500"));
  EXPECT_EQ(project().master.cycle_time, 500 * kMicrosecond);
  EXPECT_EQ(project().master.dc.dcm.set_value, std::nullopt) << "nobody set it";
  EXPECT_EQ(steps().index(), before + 1);
  show(-1, "masterDcPage");
  EXPECT_TRUE(field<QCheckBox>("setValueAuto").isChecked());
  EXPECT_EQ(field<NumberEdit>("setValue").value(), 500 * kMicrosecond * 2 / 3);
  EXPECT_EQ(field<NumberEdit>("setValue").range().high, 500 * kMicrosecond - 1);
  steps().undo();
  EXPECT_EQ(project(), editableProject());
  EXPECT_TRUE(steps().isClean());
}

TEST_F(Fields, ASetValueThatNoLongerFitsIsKeptAndMarked) {
  show(-1, "masterDcPage");
  auto& set_value = field<NumberEdit>("setValue");
  test::type(set_value, QStringLiteral("800"));
  ASSERT_EQ(project().master.dc.dcm.set_value, 800 * kMicrosecond);
  show(-1, "masterGeneralPage");
  test::type(field("masterCycle"), QStringLiteral("500"));
  EXPECT_EQ(project().master.dc.dcm.set_value, 800 * kMicrosecond);
  EXPECT_EQ(set_value.value(), 800 * kMicrosecond);
  EXPECT_TRUE(set_value.accessibleDescription().contains(QStringLiteral("800 us is outside 0.001..499.999 us")))
      << qPrintable(set_value.accessibleDescription());
}

TEST_F(Fields, AnEmptiedFieldIsLeftToWhoeverDecidesOtherwise) {
  show(1, "slaveDcPage");
  auto& shift = field<NumberEdit>("sync0Shift");
  test::type(shift, QStringLiteral("-12.5"));
  ASSERT_EQ(project().slaves[1].dc.sync0.shift, -12'500);
  QTest::keyClick(&shift, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClick(&shift, Qt::Key_Delete);
  QTest::keyClick(&shift, Qt::Key_Return);
  EXPECT_EQ(project().slaves[1].dc.sync0.shift, std::nullopt);
  show(1, "slaveGeneralPage");
  auto& alias = field<NumberEdit>("slaveAlias");
  alias.setFocus();
  QTest::keyClick(&alias, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClick(&alias, Qt::Key_Delete);
  QTest::keyClick(&alias, Qt::Key_Return);
  EXPECT_FALSE(alias.accessibleDescription().isEmpty()) << "an alias always has a value";
  EXPECT_EQ(project().slaves[1].alias, 0);
}

TEST_F(Fields, WhatIsTypedIsNotCompleted) {
  show(-1, "masterGeneralPage");
  test::type(field("masterCycle"), QStringLiteral("200"));
  EXPECT_EQ(project().master.cycle_time, 200 * kMicrosecond);
}

TEST_F(Fields, TheWheelOverAFieldWithoutFocusEditsNothing) {
  for (const int node : {-1, 1}) {
    window_.selectNode(node);
    for (auto* page : window_.editor().pages()) {
      if (!page->appliesTo(node)) continue;
      window_.editor().tabs()->setCurrentWidget(page);
      window_.editor().tabs()->setFocus();
      for (const auto& bound : page->fields().bound()) {
        if (qobject_cast<QTableView*>(bound.widget) != nullptr) continue;
        const QPointF middle(bound.widget->rect().center());
        QWheelEvent wheel(middle, bound.widget->mapToGlobal(middle), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(bound.widget, &wheel);
        EXPECT_EQ(project(), editableProject()) << bound.setting->key;
      }
    }
  }
}

TEST_F(Fields, SavingTakesWhatIsBeingTyped) {
  QTemporaryDir folder;
  const auto path = folder.filePath(QStringLiteral("machine.syncline"));
  ASSERT_TRUE(workspace_.document().save(path).has_value());
  show(-1, "masterGeneralPage");
  test::type(field("masterName"), QStringLiteral("Press 7"), false);
  QTest::keyClick(&field("masterName"), Qt::Key_S, Qt::ControlModifier);
  const auto saved = eni::load_machine(path.toStdString());
  ASSERT_TRUE(saved.has_value());
  EXPECT_EQ(saved->networks.front().master.name, "Press 7");
  EXPECT_FALSE(workspace_.document().isModified());
}

TEST_F(Fields, WhatCannotBeAValueStopsSavingAndStays) {
  QTemporaryDir folder;
  ASSERT_TRUE(workspace_.document().save(folder.filePath(QStringLiteral("machine.syncline"))).has_value());
  show(-1, "masterGeneralPage");
  auto& cycle = field<PresetEdit>("masterCycle");
  for (const auto* text : {"7", "soon"}) {
    test::type(cycle, QLatin1String(text), false);
    QTest::keyClick(&cycle, Qt::Key_S, Qt::ControlModifier);
    for (int row = 0; row < workspace_.messages().rowCount(); ++row) {
      const auto message = workspace_.messages().index(row, MessageModel::kText).data().toString();
      EXPECT_FALSE(message.startsWith(QStringLiteral("Saved"))) << qPrintable(message);
    }
    EXPECT_EQ(cycle.currentText(), QLatin1String(text));
    EXPECT_FALSE(cycle.accessibleDescription().isEmpty());
    EXPECT_EQ(project(), editableProject());
  }
  QTest::keyClick(&cycle, Qt::Key_Escape);
  EXPECT_EQ(cycle.currentText(), QStringLiteral("1000"));
  EXPECT_TRUE(cycle.accessibleDescription().isEmpty());
}

TEST_F(Fields, UndoAndExportWorkFromAFocusedField) {
  show(-1, "masterGeneralPage");
  auto& name = field<TextEdit>("masterName");
  test::type(name, QStringLiteral("Press"));
  ASSERT_EQ(project().master.name, "Press");
  QTest::keyClick(&name, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(project(), editableProject());
  EXPECT_EQ(name.text(), QStringLiteral("Master"));
  QTest::keyClick(&name, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(project().master.name, "Press");

  for (const char* of : {"masterName", "masterCycle", "recoveryErrorTries"}) {
    bool asked = false;
    QTimer close;
    QObject::connect(&close, &QTimer::timeout, [&asked] {
      if (auto* dialog = QApplication::activeModalWidget()) {
        asked = true;
        dialog->close();
      }
    });
    close.start(10);
    window_.activateWindow();
    static_cast<void>(QTest::qWaitForWindowActive(&window_));
    field(of).setFocus();
    QTest::keyClick(&field(of), Qt::Key_E, Qt::ControlModifier);
    EXPECT_TRUE(asked) << of;
  }
}

TEST_F(Fields, UndoTakesBackWhatIsBeingTyped) {
  show(-1, "masterGeneralPage");
  test::type(field("masterName"), QStringLiteral("Press"));
  auto& cycle = field<PresetEdit>("masterCycle");
  test::type(cycle, QStringLiteral("500"), false);
  QTest::keyClick(&cycle, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(project().master.cycle_time, kMillisecond);
  EXPECT_EQ(project().master.name, "Press") << "the step before stays";
  test::type(cycle, QStringLiteral("x"), false);
  QTest::keyClick(&cycle, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(cycle.currentText(), QStringLiteral("1000"));
  EXPECT_EQ(project().master.name, "Press");
}

TEST_F(Fields, WhatWasTypedBelongsToTheSlaveThatWasShown) {
  show(1, "slaveGeneralPage");
  test::type(field("slaveAlias"), QStringLiteral("7"), false);
  window_.selectNode(2);
  EXPECT_EQ(project().slaves[1].alias, 7);
  EXPECT_EQ(project().slaves[2].alias, 0);
}

TEST_F(Fields, WhatIsTypedGoesWithItsMachine) {
  show(1, "slaveGeneralPage");
  test::type(field("slaveAlias"), QStringLiteral("7"), false);
  auto other = editableProject();
  other.slaves.pop_back();
  workspace_.document().replace(QStringLiteral("scan"), other);
  window_.selectNode(-1);
  EXPECT_EQ(project(), other);
}

TEST_F(Fields, AMenuOverAFieldDoesNotEndTheTyping) {
  for (const auto& [node, page, name] :
       {std::tuple{-1, "masterGeneralPage", "masterName"}, std::tuple{-1, "masterGeneralPage", "masterCycle"},
        std::tuple{1, "slaveGeneralPage", "slaveAlias"}}) {
    show(node, page);
    test::type(field(name), QStringLiteral("5"), false);
    QFocusEvent menu(QEvent::FocusOut, Qt::PopupFocusReason);
    QApplication::sendEvent(&field(name), &menu);
    EXPECT_EQ(project(), editableProject()) << name;
    EXPECT_TRUE(fieldOf(&field(name))->pending()) << name;
    QTest::keyClick(&field(name), Qt::Key_Escape);
  }
}

TEST_F(Fields, EachSaysWhatItMeansAndWhereItGoes) {
  for (auto* page : window_.editor().pages()) {
    for (const auto& bound : page->fields().bound()) {
      EXPECT_FALSE(bound.widget->toolTip().isEmpty() && bound.widget->layout() == nullptr) << bound.setting->key;
      EXPECT_TRUE(bound.widget->whatsThis().contains(QString::fromStdString(bound.setting->key))) << bound.setting->key;
      EXPECT_TRUE(bound.widget->whatsThis().contains(settingLabel(*bound.setting).toHtmlEscaped()))
          << bound.setting->key;
    }
  }
}

TEST(NumberFields, ReadWhatUsersWrite) {
  const auto us = settings::microseconds(0, kSecond);
  EXPECT_EQ(parseNumber(us, QStringLiteral("62.5")), 62'500);
  EXPECT_EQ(parseNumber(us, QStringLiteral(" 62.5 \u00B5s ")), 62'500);
  EXPECT_EQ(parseNumber(us, QStringLiteral("-0.001us")), -1);
  EXPECT_EQ(parseNumber(us, QStringLiteral("0.0001")), std::nullopt);
  EXPECT_EQ(parseNumber(us, QString()), std::nullopt);
  EXPECT_EQ(numberText(us, 1'000'001), QStringLiteral("1000.001"));
  QLocale::setDefault(QLocale(QLocale::German));
  EXPECT_EQ(numberText(us, 62'500), QStringLiteral("62,5"));
  EXPECT_EQ(parseNumber(us, QStringLiteral("62,5")), 62'500);
  EXPECT_EQ(parseNumber(us, QStringLiteral("62.5")), 62'500);
  QLocale::setDefault(QLocale::c());
  EXPECT_EQ(parseNumber(settings::integer(0, 9, "ms"), QStringLiteral("7 ms")), 7);
}

/// Every key that a page edits, through its field and by keyboard.
class EveryKey : public Fields {
 protected:
  using Act = std::function<void()>;

  /// `act` is one undo step that gives `wanted`; undo and redo are exact.
  void expectOneStep(const FieldBinder::Bound& bound, const Act& act, const std::optional<settings::Value>& wanted) {
    const auto& key = bound.setting->key;
    const Project before = project();
    const int base = steps().index();
    act();
    ASSERT_EQ(steps().index(), base + 1) << key;
    const Project after = project();
    EXPECT_FALSE(after == before) << key;
    if (wanted) {
      EXPECT_EQ(bound.setting->read(project(), {.slave = 1}), *wanted) << key;
    }
    steps().undo();
    EXPECT_EQ(project(), before) << key;
    steps().redo();
    EXPECT_EQ(project(), after) << key;
    steps().undo();
  }

  void expectValue(const FieldBinder::Bound& bound, const settings::Value& value, const Act& act) {
    if (bound.setting->read(project(), {.slave = 1}) == value) return;
    expectOneStep(bound, act, value);
  }

  void driveChoice(const FieldBinder::Bound& bound, ChoiceEdit& box) {
    for (const auto end : {Qt::Key_End, Qt::Key_Home}) {
      const int row = end == Qt::Key_Home ? 0 : box.count() - 1;
      if (box.currentIndex() == row) continue;
      expectOneStep(
          bound,
          [&] {
            box.setFocus();
            QTest::keyClick(&box, end);
          },
          std::nullopt);
    }
  }

  void drive(const FieldBinder::Bound& bound) {
    auto* widget = bound.widget;
    ASSERT_TRUE(widget->isEnabled()) << bound.setting->key;
    if (auto* number = qobject_cast<NumberEdit*>(widget)) {
      const auto& type = std::get<settings::Number>(bound.setting->type);
      for (const auto end : {number->range().low, number->range().high}) {
        expectValue(bound, end, [&] { test::type(*number, numberText(type, end)); });
      }
    } else if (auto* preset = qobject_cast<PresetEdit*>(widget)) {
      const auto& type = std::get<settings::Number>(bound.setting->type);
      for (const auto end : {type.range.low, type.range.high}) {
        expectValue(bound, end, [&] { test::type(*preset, numberText(type, end)); });
      }
    } else if (auto* text = qobject_cast<TextEdit*>(widget)) {
      for (const auto& end : {QString(u'x'), QString(255, u'x')}) {
        expectValue(bound, end.toStdString(), [&] { test::type(*text, end); });
      }
    } else if (auto* choice = qobject_cast<ChoiceEdit*>(widget)) {
      driveChoice(bound, *choice);
    } else if (qobject_cast<QCheckBox*>(widget) != nullptr) {
      expectOneStep(
          bound,
          [&] {
            widget->setFocus();
            QTest::keyClick(widget, Qt::Key_Space);
          },
          std::nullopt);
    } else if (auto* table = qobject_cast<QTableView*>(widget)) {
      expectOneStep(
          bound,
          [&] {
            table->setFocus();
            table->setCurrentIndex(table->model()->index(0, 0));
            QTest::keyClick(table, Qt::Key_Space);
          },
          std::nullopt);
    } else {
      const auto buttons = widget->findChildren<QRadioButton*>();
      ASSERT_FALSE(buttons.isEmpty()) << bound.setting->key;
      for (auto* button : buttons) {
        if (button->isChecked()) continue;
        expectOneStep(
            bound,
            [&] {
              button->setFocus();
              QTest::keyClick(button, Qt::Key_Space);
            },
            std::nullopt);
      }
    }
  }
};

TEST_F(EveryKey, GoesThroughItsFieldAtBothEndsOfItsRange) {
  std::set<std::string> keys;
  for (const int node : {-1, 1}) {
    window_.selectNode(node);
    for (auto* page : window_.editor().pages()) {
      if (!page->appliesTo(node)) continue;
      window_.editor().tabs()->setCurrentWidget(page);
      for (const auto& bound : page->fields().bound()) {
        drive(bound);
        EXPECT_EQ(project(), editableProject()) << bound.setting->key;
        keys.insert(bound.setting->key);
      }
    }
  }
  EXPECT_GE(keys.size(), 35U);
  RecordProperty("keys", static_cast<int>(keys.size()));
}

/// Only the keyboard and the mouse reach the project: showing other nodes and other projects makes no step.
TEST_F(Fields, ShowingMakesNoStep) {
  const int before = steps().index();
  for (const int node : {-1, 0, 1, 2, -1}) {
    window_.selectNode(node);
    for (auto* page : window_.editor().pages()) {
      if (page->appliesTo(node)) window_.editor().tabs()->setCurrentWidget(page);
    }
  }
  EXPECT_EQ(steps().index(), before);
  EXPECT_EQ(project(), editableProject());
}

TEST(SettingText, WordsOfFieldsAreKnownToTheTranslations) {
  std::set<std::string> known;
  for (const char* text : translatableSettings()) known.insert(text);
  Workspace workspace(test::virtualEnvironment());
  MainWindow window(workspace);
  for (auto* page : window.editor().pages()) {
    for (const auto& bound : page->fields().bound()) {
      EXPECT_TRUE(known.contains(bound.setting->words.label)) << bound.setting->words.label;
      EXPECT_TRUE(known.contains(bound.setting->words.help)) << bound.setting->words.help;
      const auto* choice = std::get_if<settings::Choice>(&bound.setting->type);
      for (const auto& option : choice != nullptr ? choice->options : std::vector<settings::Option>{}) {
        EXPECT_TRUE(known.contains(option.text)) << bound.setting->key << ' ' << option.text;
      }
    }
  }
}

}  // namespace
}  // namespace syncline::ui
