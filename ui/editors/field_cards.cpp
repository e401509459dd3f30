// SPDX-License-Identifier: Apache-2.0
// Cards made of lists of keys, and which of their fields are shown.
#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <algorithm>
#include <set>

#include "settings/settings_table.h"
#include "ui/editors/choice_edit.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/number_edit.h"
#include "ui/editors/page.h"
#include "ui/editors/text_edit.h"
#include "ui/text/setting_text.h"
#include "ui/widgets/card.h"

namespace syncline::ui {
namespace {

using settings::Setting;

/// What a new project and a new slave have. Expert settings do not depend on the device.
bool isDefault(const Setting& setting, const Project& project, const settings::Place& place) {
  static const Project fresh = [] {
    Project made;
    made.slaves.emplace_back();
    return made;
  }();
  auto same = place;
  same.slave = 0;
  return setting.read(project, place) == setting.read(fresh, same);
}

bool holdsFocus(const QWidget& field) { return field.hasFocus() || field.isAncestorOf(QApplication::focusWidget()); }

}  // namespace

QString fieldName(const char* key) {
  QString name;
  bool upper = false;
  for (const auto& part : QString::fromLatin1(key).split(u'.')) {
    if (part == u"N" || part == u"K" || part == u"0xIIII") continue;
    for (const auto c : part) {
      if (c != u'_') name += upper ? c.toUpper() : c;
      upper = c == u'_';
    }
    upper = true;
  }
  return name;
}

QWidget* FieldBinder::makeField(Card& card, const QString& object_name, const char* key, const Options& options) {
  const auto latin = object_name.toLatin1();
  const auto& setting = settings::row(key);
  const bool on_off = std::holds_alternative<settings::Switch>(setting.type);
  if (options || std::holds_alternative<settings::Choice>(setting.type) || (on_off && !setting.unset.empty())) {
    return choice(card, latin.constData(), key, options);
  }
  if (on_off) return toggle(card, latin.constData(), key);
  if (std::holds_alternative<settings::Number>(setting.type)) return number(card, latin.constData(), key);
  return text(card, latin.constData(), key);
}

void FieldBinder::addRow(Card& card, const QString& label, QWidget& field) {
  auto& bound = bound_.back();
  bound.marked = bound.setting->words.expert && !expert_card_;
  card.addRow(bound.marked ? expertText(label) : label, &field, field.toolTip());
  bound.card = &card;
  bound.row = &field;
}

void FieldBinder::addWide(Card& card, QWidget& field) {
  auto& bound = bound_.back();
  auto* box = qobject_cast<QCheckBox*>(&field);
  bound.marked = box != nullptr && bound.setting->words.expert && !expert_card_;
  if (bound.marked) box->setText(expertText(box->text()));
  card.addWide(&field, field.toolTip());
  bound.card = &card;
  bound.row = &field;
}

/// True when nothing else stands in the card; then its title says whether all of it is for experts.
bool FieldBinder::ownCard(Card& card, bool experts) {
  if (card.form()->rowCount() != 0) return false;
  own_cards_.push_back(&card);
  if (experts && !expert_page_) card.setTitle(tr("%1 (Expert)").arg(card.title()));
  return true;
}

void FieldBinder::keys(Card& card, std::initializer_list<const char*> keys, const Applies& applies) {
  addKeys(card, keys, {}, applies);
}

void FieldBinder::chosen(Card& card, std::initializer_list<const char*> keys, const Options& options,
                         const Applies& applies) {
  addKeys(card, keys, options, applies);
}

void FieldBinder::addKeys(Card& card, std::initializer_list<const char*> keys, const Options& options,
                          const Applies& applies) {
  const bool experts = std::ranges::all_of(keys, [](const char* key) { return settings::row(key).words.expert; });
  const bool own = ownCard(card, experts);
  expert_card_ = experts && (own || expert_page_);
  for (const auto* key : keys) {
    makeField(card, fieldName(key), key, options);
    bound_.back().applies = applies;
  }
  expert_card_ = false;
}

void FieldBinder::items(Card& card, const char* key, Label label, Options options) {
  const bool own = ownCard(card, settings::row(key).words.expert);
  items_.push_back(std::make_shared<Items>(Items{&card, key, std::move(label), std::move(options), {}, own}));
}

/// Makes the rows that are missing; those that are too many stay and are hidden.
void FieldBinder::fillItems(const std::shared_ptr<Items>& items) {
  const auto slave = place().slave;
  const auto& project = page_.project();
  items->places =
      slave < project.slaves.size() ? settings::row(items->key).items(project, slave) : std::vector<settings::Place>{};
  const auto usual = where_;
  expert_card_ = items->own_card;
  for (; items->made < items->places.size(); ++items->made) {
    where_ = [items, number = items->made]() -> std::optional<settings::Place> {
      return number < items->places.size() ? std::optional(items->places[number]) : std::nullopt;
    };
    makeField(*items->card, fieldName(items->key) + QString::number(items->made), items->key, items->options);
    bound_.back().label = items->label;
  }
  expert_card_ = false;
  where_ = usual;
}

bool FieldBinder::shows(const Bound& bound, const settings::Place& place) const {
  const auto& project = page_.project();
  if (bound.setting->of_slave() && place.slave >= project.slaves.size()) return false;
  const auto& setting = *bound.setting;
  if (bound.applies && !bound.applies(project.slaves[place.slave])) return false;
  const bool of_use = !setting.applies || setting.applies(project.slaves[place.slave]);
  if (of_use && (!setting.words.expert || page_.expert())) return true;
  return !isDefault(setting, project, place);  // nothing works in secret
}

bool FieldBinder::wanted(int node) const {
  const auto slave = static_cast<std::size_t>(std::max(node, 0));
  const auto& project = page_.project();
  for (const auto& items : items_) {
    const auto& setting = settings::row(items->key);
    if (slave >= project.slaves.size()) continue;
    const auto places = setting.items(project, slave);
    if (std::ranges::any_of(places, [&](const settings::Place& place) {
          return !setting.words.expert || page_.expert() || !isDefault(setting, project, place);
        })) {
      return true;
    }
  }
  return std::ranges::any_of(bound_, [&](const Bound& bound) {
    if (bound.setting->items) return false;
    return shows(bound, {.slave = slave}) || (node == page_.node() && holdsFocus(*bound.widget));
  });
}

std::vector<const Setting*> FieldBinder::settings() const {
  std::vector<const Setting*> all;
  const auto add = [&all](const Setting* setting) {
    if (std::ranges::find(all, setting) == all.end()) all.push_back(setting);
  };
  for (const auto& bound : bound_) add(bound.setting);
  for (const auto& items : items_) add(&settings::row(items->key));
  return all;
}

QWidget* FieldBinder::fieldOf(const Setting& setting, const settings::Place& place) const {
  for (const auto& bound : bound_) {
    if (bound.setting != &setting || bound.widget->isHidden()) continue;
    if (bound.row != nullptr && (!bound.card->form()->isRowVisible(bound.row) || bound.card->isHidden())) continue;
    const auto at = bound.place();
    if (!at) continue;
    // Parts of a record are told apart by what is selected; whose setting has no items by the slave alone.
    if (setting.items ? *at == place : at->slave == place.slave || !setting.of_slave()) return bound.widget;
  }
  return nullptr;
}

void FieldBinder::showRows() {
  std::set<Card*> used;
  for (const auto& bound : bound_) {
    const auto place = bound.place();
    // A value on its way through its default does not take the field away under the cursor.
    const bool shown = place && (shows(bound, *place) || holdsFocus(*bound.widget));
    if (bound.row != nullptr) bound.card->form()->setRowVisible(bound.row, shown);
    if (!shown) continue;
    used.insert(bound.card);
    if (bound.label) {
      const auto label = bound.label(page_.project(), *place);
      bound.widget->setAccessibleName(label);
      if (auto* caption = qobject_cast<QLabel*>(bound.card->form()->labelForField(bound.row))) {
        caption->setText(bound.marked ? expertText(label) : label);
      }
    }
    if (bound.show) bound.show();
  }
  for (auto* card : own_cards_) card->setVisible(used.contains(card));
  placeNotes();  // of a list, those of the record that is selected now
}

}  // namespace syncline::ui
