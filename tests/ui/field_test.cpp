// SPDX-License-Identifier: Apache-2.0
// Editing settings in the window: what is typed reaches the project as one undo step, and nothing else does.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QRegularExpression>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTimer>
#include <QToolTip>
#include <QWheelEvent>
#include <set>

#include "eni/project/project_file.h"
#include "support/editable_project.h"
#include "support/project_window.h"
#include "support/speak.h"
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

using test::editableProject;

class Fields : public test::ProjectWindow {
 protected:
  Fields() : ProjectWindow(editableProject()) {}

  QUndoStack& steps() { return workspace_.document().undoStack(); }
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
  EXPECT_TRUE(
      set_value.accessibleDescription().contains(QStringLiteral("800 \u00B5s is outside 0.001..499.999 \u00B5s")))
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

/// Whoever types looks at the field, not for a tip of the pointer.
TEST_F(Fields, WhyATextIsNotTakenIsToldBesideTheField) {
  const auto told = [](QWidget& widget, Qt::Key leave) {
    QToolTip::hideText();
    widget.setFocus();
    QTest::keyClick(&widget, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&widget, QStringLiteral("99999999"));
    QTest::keyClick(&widget, leave);
    QApplication::processEvents();
    const auto why = widget.accessibleDescription();
    return !why.isEmpty() && QToolTip::isVisible() && QToolTip::text() == why;
  };
  for (const auto leave : {Qt::Key_Return, Qt::Key_Tab}) {
    show(-1, "masterGeneralPage");
    EXPECT_TRUE(told(field("masterCycle"), leave)) << leave;
    window_.editor().revertFields();
    show(1, "slaveGeneralPage");
    EXPECT_TRUE(told(field("slaveAlias"), leave)) << leave;
    window_.editor().revertFields();
    EXPECT_TRUE(told(field("slavePrevious"), leave)) << leave;
    window_.editor().revertFields();
  }
  EXPECT_EQ(project(), editableProject());
  QToolTip::hideText();
  show(-1, "masterDcPage");
  test::type(field<NumberEdit>("setValue"), QStringLiteral("800"));
  show(-1, "masterGeneralPage");
  test::type(field("masterCycle"), QStringLiteral("500"));
  QApplication::processEvents();
  EXPECT_FALSE(QToolTip::isVisible()) << "what others made wrong is marked where it stands, and no more";
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

/// By the names of slave and field, with the way to it; and once, however often it is offered.
TEST_F(Fields, ARefusedValueIsToldOnceByItsName) {
  show(-1, "masterGeneralPage");
  const auto told = [this] {
    QStringList lines;
    for (int row = 0; row < workspace_.messages().rowCount(); ++row) {
      const auto at = workspace_.messages().index(row, MessageModel::kText);
      if (at.siblingAtColumn(MessageModel::kSource).data().toString() == QStringLiteral("Project"))
        lines << at.data().toString();
    }
    return lines;
  };
  auto& cycle = field<PresetEdit>("masterCycle");
  test::type(cycle, QStringLiteral("7"));
  ASSERT_EQ(told().size(), 1);
  EXPECT_TRUE(told().front().contains(QStringLiteral("Cycle time"))) << qPrintable(told().front());
  EXPECT_FALSE(told().front().contains(QStringLiteral("master.cycle_time_us"))) << qPrintable(told().front());
  QTest::keyClick(&cycle, Qt::Key_Return);
  QTest::keyClick(&cycle, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(told().size(), 1) << "offered once more";
  EXPECT_EQ(cycle.currentText(), QStringLiteral("1000")) << "given up";
  test::type(cycle, QStringLiteral("7"));
  EXPECT_EQ(told().size(), 1);
  test::type(cycle, QStringLiteral("2000"));
  test::type(cycle, QStringLiteral("7"));
  EXPECT_EQ(told().size(), 2) << "another attempt";
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

TEST_F(Fields, PdosOfModulesAreShownAndNamed) {
  auto machine = editableProject();
  auto& device = machine.slaves[0].device;  // a coupler without PDOs of its own
  device.slots = machine.slaves[1].device.slots;
  device.modules = machine.slaves[1].device.modules;
  device.modules.front().tx_pdos = machine.slaves[1].device.tx_pdos;
  workspace_.document().replace(QStringLiteral("load"), machine);
  show(0, "slaveModulesPage");
  auto& module = field<ChoiceEdit>("slaveModule0");
  EXPECT_EQ(module.accessibleName(), QStringLiteral("0  Axes"));
  module.setFocus();
  QTest::keyClick(&module, Qt::Key_End);
  ASSERT_EQ(project().slaves[0].modules.size(), 1U);
  show(0, "processDataPage");
  ASSERT_TRUE(field("variableName").isEnabled());
  test::type(field("variableName"), QStringLiteral("Axis 1 position"));
  ASSERT_EQ(project().slaves[0].variable_names.size(), 1U);
  EXPECT_EQ(project().slaves[0].variable_names.front().name, "Axis 1 position");
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

/// In another language nothing of what is told of a field is English but names of formats, objects and keys.
TEST(SettingText, WhatIsToldOfAFieldIsInTheUsersLanguage) {
  std::set<std::string> known;
  for (const char* text : translatableSettings()) known.insert(text);
  static const QRegularExpression word(QStringLiteral("\\b[a-z]{3,}\\b"));
  for (const auto& code : test::translatedLanguages()) {
    const test::Speak speak(code);
    for (const auto& setting : settings::table()) {
      const auto help = settingHelp(setting);
      const bool words = std::holds_alternative<settings::Text>(setting.type) || !setting.range_words.empty() ||
                         std::holds_alternative<settings::MacAddress>(setting.type) ||
                         std::holds_alternative<settings::Indices>(setting.type) ||
                         std::holds_alternative<settings::Record>(setting.type);
      auto range = setting.range_words.empty() ? settings::range_text(setting.type) : setting.range_words;
      const auto comma = range.find(", ");
      const auto first = range.substr(0, comma);
      if (comma != std::string::npos && (first == setting.unset || first == "off" || first == "nothing"))
        range = range.substr(comma + 2);
      if (words) {
        EXPECT_TRUE(known.contains(range)) << setting.key << ": " << range;
        const auto english = QString::fromStdString(range).toHtmlEscaped();
        EXPECT_FALSE(english.contains(word) && help.contains(english)) << qPrintable(code) << ' ' << setting.key;
      }
      for (const auto& told : {setting.unset, setting.words.preset}) {
        if (told.empty() || told == "auto") continue;
        EXPECT_TRUE(known.contains(told)) << setting.key << ": " << told;
        EXPECT_FALSE(help.contains(QStringLiteral(": %1<").arg(QString::fromStdString(told).toHtmlEscaped())) &&
                     QString::fromStdString(told).contains(word))
            << qPrintable(code) << ' ' << setting.key << ": " << told;
      }
    }
  }
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
        const bool shown = !option.text.empty();  // else it is a word of the ETG, or a number
        EXPECT_TRUE(!shown || known.contains(option.text)) << bound.setting->key << ' ' << option.text;
      }
    }
  }
}

}  // namespace
}  // namespace syncline::ui
