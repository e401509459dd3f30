// SPDX-License-Identifier: Apache-2.0
// What is found wrong with a setting stands below its field, wherever that stands.
#include <QBoxLayout>
#include <QLabel>
#include <algorithm>
#include <set>

#include "ui/editors/field_binder.h"
#include "ui/theme/theme.h"
#include "ui/widgets/card.h"

namespace syncline::ui {
namespace {

/// The layout in `layout` that holds the widget itself; null: none does.
QLayout* layoutOf(QLayout* layout, QWidget* widget) {
  if (layout == nullptr || layout->indexOf(widget) >= 0) return layout;
  for (int i = 0; i < layout->count(); ++i) {
    auto* inner = layout->itemAt(i)->layout();
    if (auto* found = inner == nullptr ? nullptr : layoutOf(inner, widget)) return found;
  }
  return nullptr;
}

/// Below the row of a card that the field is in, or below the field in the column that it stands in.
void putBelow(QWidget* field, QLabel* note) {
  for (auto* at = field; at->parentWidget() != nullptr; at = at->parentWidget()) {
    auto* layout = layoutOf(at->parentWidget()->layout(), at);
    if (auto* form = qobject_cast<QFormLayout*>(layout)) {
      int row = 0;
      QFormLayout::ItemRole role{};
      form->getWidgetPosition(at, &row, &role);
      return form->insertRow(row + 1, note);
    }
    auto* box = qobject_cast<QBoxLayout*>(layout);
    if (box != nullptr && box->direction() == QBoxLayout::TopToBottom)
      return box->insertWidget(box->indexOf(at) + 1, note);
  }
}

void setShown(QLabel* note, bool shown) {
  auto* form = qobject_cast<QFormLayout*>(layoutOf(note->parentWidget()->layout(), note));
  form != nullptr ? form->setRowVisible(note, shown) : note->setVisible(shown);
}

}  // namespace

void FieldBinder::showNotes(std::vector<Note> notes) {
  notes_ = std::move(notes);
  placeNotes();
}

/// Of a record with several fields below the first one that is shown.
void FieldBinder::placeNotes() {
  std::set<std::string> said;
  for (auto& bound : bound_) {
    const auto* note = noteOf(bound);
    if (note == nullptr || !said.insert(note->key).second) {
      if (bound.note != nullptr) setShown(bound.note, false);
      continue;
    }
    if (bound.note == nullptr) bound.note = makeNote(bound);
    auto palette = bound.widget->palette();
    palette.setColor(QPalette::WindowText,
                     theme::toneColor(palette, note->error ? theme::Tone::kBad : theme::Tone::kWarning));
    bound.note->setPalette(palette);
    bound.note->setText(QStringLiteral("\u25B2 ") + note->text);
    bound.note->setAccessibleName(tr("Finding: %1").arg(bound.widget->accessibleName()));
    setShown(bound.note, true);
  }
}

/// The worst: what an export refuses is not hidden by what it only warns of. Null: nothing is wrong with it, or it is
/// not shown.
const FieldBinder::Note* FieldBinder::noteOf(const Bound& bound) const {
  if (notes_.empty() || bound.widget->isHidden()) return nullptr;
  if (bound.row != nullptr && !bound.card->form()->isRowVisible(bound.row)) return nullptr;
  const auto place = bound.place();
  if (!place) return nullptr;
  const auto key = settings::key_of(*bound.setting, *place);
  const Note* worst = nullptr;
  for (const auto& note : notes_) {
    if (note.key == key && (worst == nullptr || (note.error && !worst->error))) worst = &note;
  }
  return worst;
}

QLabel* FieldBinder::makeNote(const Bound& bound) {
  auto* note = new QLabel;
  note->setObjectName(bound.widget->objectName() + QStringLiteral("Note"));
  note->setWordWrap(true);
  note->setTextFormat(Qt::PlainText);
  note->setTextInteractionFlags(Qt::TextSelectableByMouse);
  putBelow(bound.widget, note);
  return note;
}

}  // namespace syncline::ui
