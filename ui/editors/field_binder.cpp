// SPDX-License-Identifier: Apache-2.0
#include "ui/editors/field_binder.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QRadioButton>
#include <algorithm>
#include <utility>

#include "ui/editors/choice_edit.h"
#include "ui/editors/number_edit.h"
#include "ui/editors/page.h"
#include "ui/editors/preset_edit.h"
#include "ui/editors/text_edit.h"
#include "ui/session/workspace.h"
#include "ui/text/event_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/setting_text.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

using settings::Setting;
using settings::Value;

std::int64_t numberOf(const Value& value) {
  const auto* number = std::get_if<std::int64_t>(&value);
  return number != nullptr ? *number : 0;
}

const settings::Number& numberType(const char* key) { return std::get<settings::Number>(settings::row(key).type); }

/// Options in this project, or those of the type.
std::vector<settings::Option> optionsOf(const Setting& setting, const Project& project, const settings::Place& place) {
  if (setting.options) return setting.options(project, place);
  std::vector<settings::Option> options;
  if (!setting.unset.empty()) options.push_back({Value{}, setting.unset, {}});
  if (std::holds_alternative<settings::Switch>(setting.type)) {
    options.push_back({true, "on", {}});
    options.push_back({false, "off", {}});
    return options;
  }
  const auto& own = std::get<settings::Choice>(setting.type).options;
  options.insert(options.end(), own.begin(), own.end());
  return options;
}

}  // namespace

void FieldBinder::bindAt(QWidget& field, const char* key, std::function<std::optional<settings::Place>()> place,
                         std::function<void()> show) {
  bind(field, key, std::move(show));
  bound_.back().place = std::move(place);
}

FieldBinder::FieldBinder(Page& page) : QObject(&page), page_(page), where_([this] { return place(); }) {}

settings::Place FieldBinder::place() const { return {.slave = static_cast<std::size_t>(std::max(page_.node(), 0))}; }

Value FieldBinder::value(const char* key) const { return settings::row(key).read(page_.project(), place()); }

Value FieldBinder::read(const char* key, const Where& where) const {
  return settings::row(key).read(page_.project(), at(where));
}

QString FieldBinder::set(const char* key, const Value& value) {
  return take(
      key, [this] { return place(); }, value);
}

QString FieldBinder::take(const char* key, const Where& where, const Value& value) {
  const auto place = where();
  if (!place) return {};  // the slave lost it meanwhile
  const auto& setting = settings::row(key);
  return page_.set(tr("Change: %1").arg(settingLabel(setting)), {{&setting, *place, value}});
}

QString FieldBinder::takeText(const char* key, const Where& where, const QString& text) {
  const auto& setting = settings::row(key);
  const auto plain = text.toStdString();
  if (!setting.unset.empty() && (plain.empty() || plain == setting.unset)) return take(key, where, Value{});
  if (std::holds_alternative<settings::Text>(setting.type)) return take(key, where, plain);
  const auto trimmed = text.trimmed().toStdString();
  const auto value =
      setting.parse ? setting.parse(page_.project(), at(where), trimmed) : settings::parse_value(setting.type, trimmed);
  return value ? take(key, where, *value) : reasonText(value.error().detail);
}

void FieldBinder::bind(QWidget& field, const char* key, std::function<void()> show) {
  const auto& setting = settings::row(key);
  if (field.toolTip().isEmpty()) field.setToolTip(settingTip(setting));
  field.setWhatsThis(settingHelp(setting));
  field.installEventFilter(this);
  if (auto* line = field.findChild<QLineEdit*>()) line->installEventFilter(this);  // has a menu of its own
  bound_.push_back({.setting = &setting, .widget = &field, .show = std::move(show), .place = where_});
}

TextEdit* FieldBinder::textField(const char* object_name, const char* key, Where place) {
  const auto& setting = settings::row(key);
  const auto where = place ? std::move(place) : where_;
  auto* field = named(new TextEdit([this, key, where](const QString& text) { return takeText(key, where, text); }),
                      object_name, settingLabel(setting));
  field->setPlaceholderText(settingWord(setting.unset));
  bind(*field, key, [this, field, key, where] {
    const auto shown = read(key, where);
    if (std::holds_alternative<settings::Unset>(shown)) return field->showValue({});
    const auto* plain = std::get_if<std::string>(&shown);
    field->showValue(QString::fromStdString(
        plain != nullptr ? *plain : settings::text_of(settings::row(key), page_.project(), at(where))));
  });
  bound_.back().place = where;
  return field;
}

TextEdit* FieldBinder::text(Card& card, const char* object_name, const char* key) {
  auto* field = textField(object_name, key);
  addRow(card, field->accessibleName(), *field);
  return field;
}

NumberEdit* FieldBinder::numberField(const char* object_name, const char* key) {
  auto* field =
      named(new NumberEdit(numberType(key),
                           [this, key, where = where_](std::int64_t value) { return take(key, where, value); }),
            object_name, settingLabel(settings::row(key)));
  if (const auto& unset = settings::row(key).unset; !unset.empty()) {
    field->setClear(settingWord(unset), [this, key, where = where_] { return take(key, where, Value{}); });
  }
  bind(*field, key, [this, field, key, where = where_] {
    const auto& setting = settings::row(key);
    const auto effective = settings::effective_value(setting, page_.project(), at(where));
    const auto value = numberOf(effective);
    const auto range = settings::working_range(setting, page_.project(), at(where));
    if (std::holds_alternative<settings::Unset>(read(key, where))) {
      field->showUnset(std::holds_alternative<settings::Unset>(effective) ? std::nullopt : std::optional(value), range);
      if (std::holds_alternative<settings::Unset>(effective)) return;
    } else {
      field->showValue(value, range);
    }
    if (!field->pending() && field->isEnabled() && !range.contains(value)) {
      markField(*field, reasonText(settings::outside(numberType(key), value, range)));
    }
  });
  return field;
}

NumberEdit* FieldBinder::number(Card& card, const char* object_name, const char* key, const QString& label) {
  auto* field = numberField(object_name, key);
  addRow(card, label.isEmpty() ? field->accessibleName() : label, *field);
  return field;
}

PresetEdit* FieldBinder::presetField(const char* object_name, const char* key, std::span<const std::int64_t> usual) {
  auto* field =
      named(new PresetEdit(numberType(key), usual, [this, key](std::int64_t value) { return set(key, value); }),
            object_name, settingLabel(settings::row(key)));
  bind(*field, key, [this, field, key] { field->showValue(numberOf(value(key))); });
  return field;
}

QCheckBox* FieldBinder::toggle(Card& card, const char* object_name, const char* key) {
  const auto label = settingLabel(settings::row(key));
  auto* box = named(new QCheckBox(label), object_name, label);
  connect(box, &QCheckBox::clicked, this, [this, key, where = where_](bool on) { take(key, where, on); });
  bind(*box, key, [this, box, key, where = where_] {
    const auto shown = read(key, where);
    box->setChecked(std::get<bool>(shown));
  });
  addWide(card, *box);
  return box;
}

QCheckBox* FieldBinder::automatic(Card& card, const char* object_name, const char* key, const QString& label,
                                  const QString& tip) {
  auto* box = named(new QCheckBox(label), object_name, label);
  box->setToolTip(tip);
  connect(box, &QCheckBox::clicked, this, [this, key](bool automatic) {
    set(key, automatic ? Value{} : settings::effective_value(settings::row(key), page_.project(), place()));
  });
  bind(*box, key, [this, box, key] { box->setChecked(std::holds_alternative<settings::Unset>(value(key))); });
  card.addWide(box, tip);
  return box;
}

ChoiceEdit* FieldBinder::choice(Card& card, const char* object_name, const char* key, Options own) {
  const auto label = settingLabel(settings::row(key));
  auto* box = named(new ChoiceEdit, object_name, label);
  const auto current = [this, key, where = where_, own = std::move(own)] {
    return own ? own(page_.project(), at(where)) : optionsOf(settings::row(key), page_.project(), at(where));
  };
  connect(box, &QComboBox::activated, this, [this, key, where = where_, current](int index) {
    const auto options = current();
    if (std::cmp_less(index, options.size())) take(key, where, options[static_cast<std::size_t>(index)].value);
  });
  bind(*box, key, [this, box, key, where = where_, current] {
    const auto options = current();
    const auto shown = read(key, where);
    box->clear();
    for (const auto& option : options) box->addItem(optionText(option), QString::fromStdString(option.word));
    const auto chosen = std::ranges::find(options, shown, &settings::Option::value);
    if (chosen == options.end()) {  // one that the list does not offer
      box->addItem(QString::fromStdString(settings::text_of(settings::row(key), page_.project(), at(where))));
    }
    box->setCurrentIndex(static_cast<int>(chosen - options.begin()));
  });
  addRow(card, label, *box);
  return box;
}

QButtonGroup* FieldBinder::buttons(Card& card, const char* key,
                                   const QList<std::pair<std::int64_t, const char*>>& object_names, int columns) {
  const auto& setting = settings::row(key);
  auto* group = new QButtonGroup(this);
  auto* area = new QWidget;
  area->setObjectName(fieldName(key));
  area->setAccessibleName(settingLabel(setting));
  auto* layout = new QGridLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setColumnStretch(columns, 1);
  for (const auto& [id, object_name] : object_names) {
    const auto& options = std::get<settings::Choice>(setting.type).options;
    const auto option = std::ranges::find(options, Value{id}, &settings::Option::value);
    if (option == options.end()) continue;
    auto* button = named(new QRadioButton(optionText(*option)), object_name, optionText(*option));
    const auto count = static_cast<int>(group->buttons().size());
    group->addButton(button, static_cast<int>(id));
    layout->addWidget(button, count / columns, count % columns);
  }
  connect(group, &QButtonGroup::idClicked, this, [this, key](int id) { set(key, std::int64_t{id}); });
  bind(*area, key, [this, group, key] {
    if (auto* button = group->button(static_cast<int>(numberOf(value(key))))) button->setChecked(true);
  });
  card.addWide(area);
  return group;
}

void FieldBinder::refresh() {
  for (const auto& items : items_) fillItems(items);
  showRows();
}

bool FieldBinder::commit() {
  bool taken = true;
  for (const auto& bound : bound_) {
    if (auto* field = dynamic_cast<Field*>(bound.widget)) taken = field->commit() && taken;
  }
  return taken;
}

void FieldBinder::revert() {
  for (const auto& bound : bound_) {
    auto* field = dynamic_cast<Field*>(bound.widget);
    if (field != nullptr && field->pending()) field->revert();
  }
}

std::vector<FieldBinder::Note> notesOf(const std::vector<Finding>& findings, const Project& project) {
  std::vector<FieldBinder::Note> notes;
  for (const auto& finding : findings) {
    if (finding.place.key.empty() || finding.severity == Severity::kNote) continue;
    notes.push_back({finding.place.key, messageOf(finding, project).text, finding.severity == Severity::kError});
  }
  return notes;
}

}  // namespace syncline::ui
