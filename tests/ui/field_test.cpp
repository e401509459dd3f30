// SPDX-License-Identifier: Apache-2.0
// Editing settings in the window: what is typed reaches the project as one undo step, and nothing else does.
#include <gtest/gtest.h>

#include <QAction>
#include <QButtonGroup>
#include <QCheckBox>
#include <QContextMenuEvent>
#include <QMenu>
#include <QRadioButton>
#include <QRegularExpression>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTimer>
#include <QToolButton>
#include <QWheelEvent>
#include <algorithm>
#include <map>
#include <set>

#include "eni/project/project_file.h"
#include "settings/default_value.h"
#include "support/editable_project.h"
#include "support/project_window.h"
#include "support/speak.h"
#include "support/ui_test_support.h"
#include "tests/support/eni_effect.h"
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

constexpr int kGateway = 3, kPins = 4;

using test::editableProject;
using test::projectOfFamilies;

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

TEST_F(Fields, PdosOfModulesAreShownAndNamed) {
  auto machine = editableProject();
  auto& device = machine.slaves[0].device;  // a coupler without PDOs of its own
  device.slots = machine.slaves[1].device.slots;
  device.modules = machine.slaves[1].device.modules;
  device.modules.front().tx_pdos = machine.slaves[1].device.tx_pdos;
  workspace_.document().replace(QStringLiteral("load"), machine);
  show(0, "slaveDataPage");
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

/// Both ends of the parts of records, by the fields' names.
const std::map<std::string, std::pair<const char*, const char*>> kPartEnds{
    {"taskName", {"x", "A task with a long name"}},
    {"taskMultiple", {"1", "1000"}},
    {"unitName", {"x", "A unit with a long name"}},
    {"coeObject", {"0x0001:00", "0xffff:ff"}},
    {"coeValue", {"0", "255"}},
    {"coeTimeout", {"1", "4294967295"}},
    {"coeComment", {"x", "A longer comment # with a mark"}},
    {"soeDrive", {"0", "7"}},
    {"soeIdn", {"S-0-0000", "P-7-4095"}},
    {"soeValue", {"00", "ffffffff"}},
    {"soeTimeout", {"1", "4294967295"}},
    {"soeComment", {"x", "A longer comment"}},
    {"mappingObject", {"0x0000:00", "0xffff:ff"}},
    {"mappingBits", {"1", "255"}},
};

/// Every key that a page edits, through its field and by keyboard.
class EveryKey : public Fields {
 protected:
  using Act = std::function<void()>;

  EveryKey() {
    workspace_.document().replace(QStringLiteral("load"), machine_);
    workspace_.setExpert(true);
  }

  static settings::Value read(const FieldBinder::Bound& bound, const Project& project) {
    return bound.setting->read(project, bound.place().value_or(settings::Place{}));
  }

  /// Both ends of what a text may be.
  static QStringList textEnds(const settings::Setting& setting) {
    if (std::holds_alternative<settings::MacAddress>(setting.type)) {
      return {QStringLiteral("00:00:00:00:00:00"), QStringLiteral("ff:ff:ff:ff:ff:ff")};
    }
    const auto* text = std::get_if<settings::Text>(&setting.type);
    if (text == nullptr) return {QStringLiteral("0:A"), QStringLiteral("2:D")};  // where a slave is plugged in
    if (text->fits == nullptr) return {QString(u'x'), QString(static_cast<int>(text->most_bytes), u'x')};
    const auto parts = QString::fromUtf8(text->example.data(), static_cast<int>(text->example.size())).count(u'.') + 1;
    return {QStringList(parts, QStringLiteral("0")).join(u'.'), QStringList(parts, QStringLiteral("255")).join(u'.')};
  }

  /// What the step changed in the ENI, where both can be exported.
  void noteEni(const std::string& key, const Project& before, const Project& after) {
    auto& effect = eni_[key];
    for (const auto dialect : {EniDialect::kEcEngineer, EniDialect::kTwinCat}) {
      const auto left = test::eni_text(before, dialect), right = test::eni_text(after, dialect);
      if (left.empty() || right.empty()) continue;
      ++effect.tried;
      if (left == right) continue;
      ++effect.changed;
      effect.paths.merge(test::other_paths(test::elements_of(left), test::elements_of(right)));
    }
  }

  /// The steps of a key changed what its column *ENI* names, where they changed anything in the ENI of this machine; a
  /// key without one changed nothing.
  static void expectEni(const settings::Setting& setting, const test::EniEffect& effect) {
    const auto named = test::named_in(setting.words.eni);
    EXPECT_TRUE(effect.changed == 0 || std::ranges::any_of(named, [&](const auto& name) { return effect.holds(name); }))
        << setting.key << " changes " << effect.some_path();
  }

  std::map<std::string, test::EniEffect> eni_;

  /// `act` is one undo step that gives `wanted`; undo and redo are exact.
  void expectOneStep(const FieldBinder::Bound& bound, const Act& act, const std::optional<settings::Value>& wanted) {
    const auto& key = bound.setting->key;
    const Project before = project();
    const int base = steps().index();
    act();
    ASSERT_EQ(steps().index(), base + 1) << key;
    const Project after = project();
    EXPECT_FALSE(after == before) << key;
    noteEni(key, before, after);
    if (wanted) {
      EXPECT_EQ(read(bound, project()), *wanted) << key;
    }
    steps().undo();
    EXPECT_EQ(project(), before) << key;
    steps().redo();
    EXPECT_EQ(project(), after) << key;
    expectReset(bound);
    EXPECT_EQ(project(), after) << key;
    steps().undo();
  }

  /// The field's menu takes the default in one undo step, and does not offer it where it is there.
  void expectReset(const FieldBinder::Bound& bound) {
    const auto place = bound.place();
    if (!place) return;  // the edit took the field away
    const auto& key = bound.setting->key;
    const auto usual = settings::default_value(*bound.setting, project(), *place);
    const auto point = bound.widget->mapToGlobal(QPoint(3, 3));
    QContextMenuEvent wanted(QContextMenuEvent::Mouse, QPoint(3, 3), point);
    QApplication::sendEvent(bound.widget, &wanted);
    auto* menu = bound.widget->findChild<QMenu*>(QStringLiteral("fieldMenu"));
    ASSERT_NE(menu, nullptr) << key;
    auto* reset = menu->findChild<QAction*>(QStringLiteral("fieldReset"));
    ASSERT_NE(reset, nullptr) << key;
    const bool differs = usual && *usual != read(bound, project());
    EXPECT_EQ(reset->isEnabled(), differs) << key;
    if (differs) {
      const int base = steps().index();
      reset->trigger();
      ASSERT_EQ(steps().index(), base + 1) << key;
      EXPECT_EQ(bound.setting->read(project(), *place), *usual) << key;
      steps().undo();
    }
    delete menu;
  }

  void expectValue(const FieldBinder::Bound& bound, const settings::Value& value, const Act& act) {
    if (read(bound, project()) == value) return;
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

  const Project machine_ = projectOfFamilies();

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
      if (const auto part = kPartEnds.find(text->objectName().toStdString()); part != kPartEnds.end()) {
        for (const auto* end : {part->second.first, part->second.second}) {
          if (text->text() == QLatin1String(end)) continue;
          expectOneStep(
              bound, [&] { test::type(*text, QLatin1String(end)); }, std::nullopt);
        }
        return;
      }
      for (const auto& end : textEnds(*bound.setting)) {
        const auto& setting = *bound.setting;
        const auto place = bound.place().value_or(settings::Place{});
        const auto value = setting.parse ? setting.parse(project(), place, end.toStdString())
                                         : settings::parse_value(setting.type, end.toStdString());
        ASSERT_TRUE(value.has_value()) << setting.key;
        expectValue(bound, *value, [&] { test::type(*text, end); });
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
    } else if (const auto transitions = widget->findChildren<QToolButton*>(); !transitions.isEmpty()) {
      for (auto* button : {transitions.front(), transitions.back()}) {
        expectOneStep(
            bound,
            [&] {
              button->setFocus();
              QTest::keyClick(button, Qt::Key_Space);
            },
            std::nullopt);
      }
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
  for (const int node : {-1, 1, kGateway, kPins}) {
    window_.selectNode(node);
    for (auto* page : window_.editor().pages()) {
      if (!page->appliesTo(node)) continue;
      window_.editor().tabs()->setCurrentWidget(page);
      for (const auto& bound : page->fields().bound()) {
        const bool driven = node > 1 && keys.contains(bound.setting->key);
        if (driven || !bound.place() || !bound.widget->isVisible()) continue;
        drive(bound);
        ASSERT_EQ(project(), machine_) << bound.setting->key;
        keys.insert(bound.setting->key);
      }
    }
  }
  for (const auto& setting : settings::table()) {
    EXPECT_TRUE(keys.contains(setting.key)) << setting.key;
    expectEni(setting, eni_[setting.key]);
  }
  const auto changed = [](const auto& of_key) { return of_key.second.changed > 0; };
  EXPECT_GT(std::ranges::count_if(eni_, changed), 25) << "keys whose steps another ENI came of";
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
