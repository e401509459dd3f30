// SPDX-License-Identifier: Apache-2.0
#include "ui/editors/record_form.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QShortcut>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "settings/settings_table.h"
#include "ui/editors/choice_edit.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/page.h"
#include "ui/editors/text_edit.h"
#include "ui/text/finding_text.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

constexpr int kSetColumns = 5;
constexpr const char* kWord = "word";
const QString kOn = QStringLiteral("on");

}  // namespace

RecordForm::RecordForm(Page& page, RecordList list, std::vector<RecordPart> parts, std::function<int()> row)
    : QObject(&page), page_(page), list_(std::move(list)), parts_(std::move(parts)), row_(std::move(row)) {}

void RecordForm::addFields(Card& card) {
  for (const auto& part : parts_) addField(card, part);
}

void RecordForm::addField(Card& card, const RecordPart& part) {
  switch (part.kind) {
    case RecordPart::Kind::kText:
      return card.addRow(part.label, makeText(part), part.tip);
    case RecordPart::Kind::kChoice:
      return card.addRow(part.label, makeChoice(part), part.tip);
    case RecordPart::Kind::kSet:
      return card.addRow(part.label, makeSet(part), part.tip);
    case RecordPart::Kind::kToggle:
      return card.addWide(makeToggle(part), part.tip);
    case RecordPart::Kind::kShown:
      return;
  }
}

QString RecordForm::current(const RecordPart& part) const {
  const auto records = list_.read();
  const int row = row_();
  return row >= 0 && std::cmp_less(row, records.size()) ? part.text(records, static_cast<std::size_t>(row)) : QString();
}

void RecordForm::bind(QWidget& field, const RecordPart& part, std::function<void(const QString& text)> show) {
  field.setToolTip(part.tip);
  fields_.append(&field);
  page_.fields().bindAt(
      field, list_.key, [this] { return list_.place(row_()); },
      [this, &part, show = std::move(show)] { show(current(part)); });
}

QWidget* RecordForm::makeText(const RecordPart& part) {
  auto* field = named(new TextEdit([this, &part](const QString& typed) { return take(part, typed); }), part.object_name,
                      part.label);
  bind(*field, part, [field](const QString& text) { field->showValue(text); });
  return field;
}

QWidget* RecordForm::makeChoice(const RecordPart& part) {
  auto* box = named(new ChoiceEdit, part.object_name, part.label);
  connect(box, &QComboBox::activated, this, [this, &part, box] { take(part, box->currentData().toString()); });
  bind(*box, part, [box, &part](const QString& text) {
    box->clear();
    for (const auto& [word, shown] : part.options()) box->addItem(shown, word);
    if (box->findData(text) < 0) box->addItem(text, text);  // one that is not offered
    box->setCurrentIndex(box->findData(text));
  });
  return box;
}

QWidget* RecordForm::makeToggle(const RecordPart& part) {
  auto* box = named(new QCheckBox(part.label), part.object_name, part.label);
  connect(box, &QCheckBox::clicked, this, [this, &part](bool on) { take(part, on ? kOn : QString()); });
  bind(*box, part, [box](const QString& text) { box->setChecked(text == kOn); });
  return box;
}

QWidget* RecordForm::makeSet(const RecordPart& part) {
  auto* area = named(new QWidget, part.object_name, part.label);
  auto* layout = new QGridLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(3);
  QList<QToolButton*> buttons;
  for (const auto& [word, text] : part.options()) {
    auto* button = new QToolButton;
    button->setObjectName(QLatin1String(part.object_name) + word);
    button->setText(word);
    button->setProperty(kWord, word);
    button->setAccessibleName(text);
    button->setToolTip(text);
    button->setCheckable(true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    const auto count = static_cast<int>(buttons.size());
    layout->addWidget(button, count / kSetColumns, count % kSetColumns);
    connect(button, &QToolButton::clicked, this, [this, &part, word = word](bool on) {
      auto words = current(part).split(u',', Qt::SkipEmptyParts);
      words.removeAll(word);
      if (on) words << word;
      take(part, words.join(u','));
    });
    buttons.append(button);
  }
  bind(*area, part, [buttons](const QString& text) {
    const auto words = text.split(u',');
    for (auto* button : buttons) {
      const auto word = button->property(kWord).toString();
      button->setChecked(words.contains(word));
      button->setText(button->isChecked() ? QStringLiteral("\u2713 ") + word : word);  // no theme hides that
    }
  });
  return area;
}

QString RecordForm::take(const RecordPart& part, const QString& typed) {
  const auto records = list_.read();
  const int row = row_();
  if (row < 0 || std::cmp_greater_equal(row, records.size())) return {};  // it went meanwhile
  auto record = part.put(records[static_cast<std::size_t>(row)], typed);
  if (!record) {
    page_.refresh();
    return reasonText(record.error().detail);
  }
  return replace(*record);
}

QString RecordForm::replace(const std::string& record) {
  const auto before = list_.read();
  const int row = row_();
  if (row < 0 || std::cmp_greater_equal(row, before.size())) return {};
  auto after = before;
  after[static_cast<std::size_t>(row)] = record;
  return write(before, after);
}

QString RecordForm::write(const Records& before, const Records& after) {
  if (before == after) return {};
  return page_.set(tr("Change: %1").arg(list_.item), list_.edits(before, after));
}

QWidget* RecordForm::makeButtons(const QString& prefix) {
  auto* area = new QWidget;
  auto* layout = new QHBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  const auto add = [&](const char* name, const QString& text, const QString& tip, auto act) {
    auto* button = new QToolButton;
    button->setObjectName(prefix + QLatin1String(name));
    button->setText(text);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    button->setFocusPolicy(Qt::StrongFocus);
    connect(button, &QToolButton::clicked, this, act);
    layout->addWidget(button);
    return button;
  };
  add_ = add("Add", tr("Add"), tr("Add: %1").arg(list_.item), [this] { insert(list_.fresh(list_.read())); });
  remove_ = add("Remove", tr("Remove"), tr("Remove: %1").arg(list_.item), [this] { remove(); });
  if (list_.ordered) {
    up_ = add("Up", QString(QChar(0x25B2)), tr("Move up: %1").arg(list_.item), [this] { move(-1); });
    down_ = add("Down", QString(QChar(0x25BC)), tr("Move down: %1").arg(list_.item), [this] { move(1); });
  }
  return area;
}

void RecordForm::takeKeysOf(QWidget& list) {
  const std::pair<QAbstractButton*, QKeySequence> keys[] = {{add_, QKeySequence(Qt::Key_Insert)},
                                                            {remove_, QKeySequence(Qt::Key_Delete)},
                                                            {up_, QKeySequence(Qt::ALT | Qt::Key_Up)},
                                                            {down_, QKeySequence(Qt::ALT | Qt::Key_Down)}};
  for (const auto& [button, key] : keys) {
    if (button == nullptr) continue;
    auto* shortcut = new QShortcut(key, &list);
    shortcut->setContext(Qt::WidgetShortcut);
    connect(shortcut, &QShortcut::activated, button, &QAbstractButton::click);
    button->setToolTip(QStringLiteral("%1 (%2)").arg(button->toolTip(), key.toString(QKeySequence::NativeText)));
  }
  add_tip_ = add_->toolTip();
}

void RecordForm::insert(const std::string& record) {
  const auto before = list_.read();
  auto after = before;
  const auto count = static_cast<int>(before.size());
  const int row = list_.ordered && row_() >= 0 ? std::min(row_() + 1, count) : count;
  after.insert(after.begin() + row, record);
  if (write(before, after).isEmpty()) Q_EMIT rowWanted(row);
}

void RecordForm::remove() {
  const auto before = list_.read();
  const int row = row_();
  if (row < 0 || std::cmp_greater_equal(row, before.size())) return;
  auto after = before;
  after.erase(after.begin() + row);
  if (write(before, after).isEmpty()) Q_EMIT rowWanted(std::min(row, static_cast<int>(after.size()) - 1));
}

void RecordForm::move(int by) { moveTo(row_(), row_() + by); }

void RecordForm::moveTo(int from, int to) {
  const auto before = list_.read();
  if (from < 0 || to < 0 || std::cmp_greater_equal(std::max(from, to), before.size())) return;
  auto after = before;
  const auto moved = after.begin() + from;
  to < from ? std::rotate(after.begin() + to, moved, moved + 1) : std::rotate(moved, moved + 1, after.begin() + to + 1);
  if (write(before, after).isEmpty()) Q_EMIT rowWanted(to);
}

void RecordForm::refresh() {
  const auto count = static_cast<int>(list_.read().size());
  const int row = row_();
  const bool any = row >= 0 && row < count, free = editable();
  const auto why = list_.refusal ? list_.refusal() : QString();
  for (auto* field : std::as_const(fields_)) {
    field->setEnabled(any && free);
    auto* text = dynamic_cast<TextEdit*>(field);
    if (!any && text != nullptr) text->showValue({});
  }
  if (add_ == nullptr) return;
  add_->setEnabled(free);
  add_->setToolTip(free ? add_tip_ : why);
  remove_->setEnabled(any && free);
  if (up_ == nullptr) return;
  up_->setEnabled(any && free && row > 0);
  down_->setEnabled(any && free && row + 1 < count);
}

}  // namespace syncline::ui
