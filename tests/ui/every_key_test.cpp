// SPDX-License-Identifier: Apache-2.0
// Every key goes through its field at both ends of its range: one undo step each, exact in the project and in the bytes
// of the ENI, and the elements of the ENI that change are those that tests/golden says, no more and no less.
#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QContextMenuEvent>
#include <QMenu>
#include <QRadioButton>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>
#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "config/project.h"
#include "settings/default_value.h"
#include "settings/setting.h"
#include "settings/settings_table.h"
#include "support/editable_project.h"
#include "support/project_window.h"
#include "support/ui_test_support.h"
#include "support/whole_file.h"
#include "tests/support/cases.h"
#include "tests/support/eni_effect.h"
#include "tests/support/source_dir.h"
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

namespace syncline::ui {
namespace {

constexpr int kTheGateway = 3, kThePins = 4;
constexpr EniDialect kDialects[] = {EniDialect::kEcEngineer, EniDialect::kTwinCat};

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
    {"aoeMessageData", {"00", "ffffffffffffffff"}},
    {"aoeMessageTimeout", {"1", "4294967295"}},
    {"aoeMessageComment", {"x", "A longer comment"}},
    {"eoeMessageData", {"02", "0800000001000000"}},
    {"eoeMessageTimeout", {"1", "4294967295"}},
    {"eoeMessageComment", {"x", "A longer comment"}},
    {"foeMessageData", {"02", "0100ffffffff6669"}},
    {"foeMessageTimeout", {"1", "4294967295"}},
    {"foeMessageComment", {"x", "A longer comment"}},
    {"voeMessageData", {"00", "ffffffffffffffff"}},
    {"voeMessageTimeout", {"1", "4294967295"}},
    {"voeMessageComment", {"x", "A longer comment"}},
    {"registerAddress", {"0x0000", "0xfffe"}},
    {"registerData", {"1", "1486"}},
    {"registerExpected", {"0000", "ffff"}},
    {"registerMask", {"0000", "00ff"}},
    {"registerWithin", {"0", "4294967295"}},
    {"registerComment", {"x", "A longer comment"}},
    {"masterRegisterAddress", {"0x0000", "0xfffe"}},
    {"masterRegisterData", {"1", "1486"}},
    {"masterRegisterExpected", {"0000", "ffff"}},
    {"masterRegisterMask", {"0000", "00ff"}},
    {"masterRegisterWithin", {"0", "4294967295"}},
    {"masterRegisterComment", {"x", "A longer comment"}},
};

/// What a machine must have for a key to matter that has nothing to say in the first one. Slave 1 is the one edited.
using Prepare = void (*)(Project&);

void giveInputs(Project& project) {
  for (auto& slave : project.slaves) {
    if (!slave.device.tx_pdos.empty()) slave.assigned_tx_pdos = {slave.device.tx_pdos.front().index};
  }
}
void giveBits(Project& project) {
  // A digital terminal.
  auto& device = project.slaves[2].device;
  device.mailbox.reset();
  for (auto* pdos : {&device.rx_pdos, &device.tx_pdos}) {
    for (auto& pdo : *pdos) pdo.entries = {{0x7000, 1, 1, "Output", "BOOL"}};
  }
}
void giveUnits(Project& project) {
  giveInputs(project);
  project.slaves[1].output_unit = project.slaves[1].input_unit = "Infeed";
  project.master.sync_units[0].task = "Slow";
}
void giveModules(Project& project) {
  auto& module = project.slaves[1].device.modules.front();
  module.rx_pdos = {project.slaves[1].device.rx_pdos.front()};
  module.rx_pdos.front().index = 0x1680;
}
void byTheFactor(Project& project) {
  auto& dc = project.slaves[1].dc;
  dc.sync0.user_cycle = dc.sync1.user_cycle = std::nullopt;
  dc.sync0.cycle_factor = 2;
  dc.sync1.cycle_factor = 4;
}

const std::map<std::string, Prepare> kWhatMatters{
    {"master.overlap_process_data", giveInputs},
    {"master.dc.first_slave_is_reference_clock", [](Project& p) { p.master.dc.reference_clock = 2; }},
    {"master.dc.all_slaves", [](Project& p) { p.slaves[2].dc.op_mode.clear(); }},
    {"master.image.bit_packing", giveBits},
    {"master.task.K", giveUnits},
    {"master.sync_unit.K", giveUnits},
    {"slave.N.check.serial", [](Project& p) { p.slaves[1].device.identity.serial_no = 77; }},
    {"slave.N.dc.sync0.factor", byTheFactor},
    {"slave.N.dc.sync1.factor", byTheFactor},
    {"slave.N.check.revision_rule", [](Project& p) { p.slaves[1].check.revision = true; }},
    {"slave.N.mailbox.poll_time_ms", [](Project& p) { p.slaves[1].mailbox.state_bit = false; }},
    {"slave.N.sync_unit.inputs", giveUnits},
    {"slave.N.sync.type",
     [](Project& p) {
       p.slaves[1].device.identity = {0x1234, 1, 1, 0};
     }},  // any may be chosen
    {"slave.N.module.K", giveModules},
    {"slave.N.variable.0xIIII.K", giveInputs},
};

/// Every key that a page edits, through its field and by keyboard.
class EveryKey : public test::ProjectWindow {
 protected:
  using Act = std::function<void()>;

  QUndoStack& steps() { return workspace_.document().undoStack(); }

  EveryKey() : ProjectWindow(test::editableProject()) {
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

  /// Of both dialects; no text where the project cannot be compiled.
  struct Exports {
    std::string texts[std::size(kDialects)];
    test::EniElements elements[std::size(kDialects)];
  };
  static Exports exported(const Project& project) {
    Exports all;
    for (std::size_t i = 0; i < std::size(kDialects); ++i) {
      all.texts[i] = test::eni_text(project, kDialects[i]);
      all.elements[i] = test::elements_of(all.texts[i]);
    }
    return all;
  }

  /// Those of the project as it is before a step: made once for the many steps that begin with the same one.
  const Exports& exportsBefore() {
    if (!begun_ || begun_->first != project()) begun_.emplace(project(), exported(project()));
    return begun_->second;
  }
  std::optional<std::pair<Project, Exports>> begun_;

  /// What a step changed in the ENI, where both can be exported.
  void noteEni(const std::string& key, const Exports& before, const Exports& after) {
    auto& effect = eni_[key];
    for (std::size_t i = 0; i < std::size(kDialects); ++i) {
      if (before.texts[i].empty() || after.texts[i].empty()) continue;
      ++effect.tried;
      if (before.texts[i] == after.texts[i]) continue;
      ++effect.changed;
      effect.paths.merge(test::other_paths(before.elements[i], after.elements[i]));
    }
  }

  /// The steps of a key changed what its column *ENI* names; where the column says why there is nothing, nothing.
  static void expectEni(const settings::Setting& setting, const test::EniEffect& effect) {
    const auto named = test::named_in(setting.words.eni);
    EXPECT_GT(effect.tried, 0) << setting.key << " was in no machine that can be exported";
    EXPECT_TRUE((named.empty() && effect.changed == 0) ||
                std::ranges::any_of(named, [&](const auto& name) { return effect.holds(name); }))
        << setting.key << " changes " << effect.some_path();
  }

  /// Every element of the ENI that the steps of each key changed, and of those that its column does not name which
  /// follow: "key: named | following". Steps of one value are told from steps of none.
  [[nodiscard]] std::string effects() const {
    std::string text;
    for (const auto& setting : settings::table()) {
      const auto& effect = eni_.at(setting.key);
      const auto names = test::named_in(setting.words.eni);
      std::string named, following;
      for (const auto& path : effect.paths) {
        const auto shorter = path.substr(path.find("/Config/") + std::string_view("/Config/").size());
        const bool meant = std::ranges::any_of(names, [&](const auto& name) { return test::is_meant(path, name); });
        (meant ? named : following) += " " + shorter;
      }
      if (names.empty()) named = " " + settings::eni_text(setting.words);
      text += setting.key + ":" + named + (following.empty() ? "" : " |" + following) + "\n";
    }
    return text;
  }

  std::map<std::string, test::EniEffect> eni_;

  /// `act` is one undo step that gives `wanted`; undo and redo are exact.
  void expectOneStep(const FieldBinder::Bound& bound, const Act& act, const std::optional<settings::Value>& wanted) {
    const auto& key = bound.setting->key;
    const Project before = project();
    const auto& exported_before = exportsBefore();
    const int base = steps().index();
    act();
    ASSERT_EQ(steps().index(), base + 1) << key;
    const Project after = project();
    EXPECT_FALSE(after == before) << key;
    noteEni(key, exported_before, exported(after));
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

  /// All steps of a field are taken back, in the bytes of the ENI, too.
  void expectTakenBack(const std::string& key, const Project& machine) {
    ASSERT_EQ(project(), machine) << key;
    for (std::size_t i = 0; i < std::size(kDialects); ++i)
      EXPECT_EQ(test::eni_text(project(), kDialects[i]), exportsBefore().texts[i]) << key << ": undo gives another ENI";
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

  /// With mailboxes that the ENI has, so that what goes through them is in it.
  static Project machineWithMailboxes() {
    auto project = test::projectOfFamilies();
    project.master.dc.input_shift = 100 * kMicrosecond;
    project.slaves[1].dc.input_reference = true;
    const auto manager = [](SyncManagerType type, std::uint16_t start, std::uint8_t control) {
      SyncManagerDescription made;
      made.type = type;
      made.start_address = start;
      made.control_byte = control;
      made.enable = true;
      made.default_size = 128;
      return made;
    };
    for (auto& slave : project.slaves) {
      if (!slave.device.mailbox) continue;
      slave.device.sync_managers = {
          manager(SyncManagerType::kMailboxOut, 0x1000, 0x26), manager(SyncManagerType::kMailboxIn, 0x1800, 0x22),
          manager(SyncManagerType::kOutputs, 0x2000, 0x64), manager(SyncManagerType::kInputs, 0x2400, 0x20)};
      slave.device.fmmus = {FmmuUse::kOutputs, FmmuUse::kInputs, FmmuUse::kMailboxState};
      for (auto& pdo : slave.device.tx_pdos) pdo.sync_manager = 3;
    }
    return project;
  }

  const Project machine_ = machineWithMailboxes();

  /// One key alone, in a machine in which it matters.
  void driveWhereItMatters(const std::string& key, Prepare prepare) {
    auto machine = machine_;
    prepare(machine);
    ASSERT_FALSE(test::eni_text(machine, kDialects[0]).empty()) << key;
    workspace_.document().replace(QStringLiteral("load"), machine);
    window_.selectNode(key.starts_with("master.") ? -1 : 1);
    int driven = 0;
    for (auto* page : window_.editor().pages()) {
      for (const auto& bound : page->fields().bound()) {
        if (bound.setting->key != key || !page->appliesTo(window_.editor().node())) continue;
        window_.editor().tabs()->setCurrentWidget(page);
        if (!bound.place() || !bound.widget->isVisible()) continue;
        drive(bound);
        ASSERT_NO_FATAL_FAILURE(expectTakenBack(key, machine));
        ++driven;
      }
    }
    EXPECT_GT(driven, 0) << key;
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
  int seen = 0;
  for (const int node : {-1, 1, kTheGateway, kThePins}) {
    window_.selectNode(node);
    for (auto* page : window_.editor().pages()) {
      if (!page->appliesTo(node)) continue;
      window_.editor().tabs()->setCurrentWidget(page);
      for (const auto& bound : page->fields().bound()) {
        const bool driven = node > 1 && keys.contains(bound.setting->key);
        if (driven || !bound.place() || !bound.widget->isVisible()) continue;
        if (seen++ % test::kEvery != 0) continue;
        drive(bound);
        ASSERT_NO_FATAL_FAILURE(expectTakenBack(bound.setting->key, machine_));
        keys.insert(bound.setting->key);
      }
    }
  }
  for (const auto& [key, prepare] : kWhatMatters) {
    EXPECT_EQ(eni_[key].changed, 0) << key << " matters in the usual machine, too";
    ASSERT_NO_FATAL_FAILURE(driveWhereItMatters(key, prepare));
  }
  RecordProperty("keys", static_cast<int>(keys.size()));
  if constexpr (test::kEvery > 1) return;
  for (const auto& setting : settings::table()) {
    EXPECT_TRUE(keys.contains(setting.key)) << setting.key;
    expectEni(setting, eni_[setting.key]);
  }
  const auto file = test::source_dir() + "/tests/golden/eni_of_each_key.txt";
  if (std::getenv("SYNCLINE_WRITE_GOLDEN") != nullptr) {
    ASSERT_TRUE(write_whole_file(file, effects()).has_value());
  }
  EXPECT_EQ(effects(), read_whole_file(file).value_or(std::string()))
      << "a key changes other elements of the ENI than before; SYNCLINE_WRITE_GOLDEN=1 test_ui writes the file";
}

}  // namespace
}  // namespace syncline::ui
