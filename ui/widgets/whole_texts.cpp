// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/whole_texts.h"

#include <QAbstractItemView>
#include <QHeaderView>
#include <QHelpEvent>
#include <QToolTip>

namespace syncline::ui {

bool WholeTexts::isCut(const QAbstractItemView& view, const QModelIndex& index) {
  return !index.data().toString().isEmpty() && view.sizeHintForIndex(index).width() > view.visualRect(index).width();
}

bool WholeTexts::take(QObject& watched, QEvent& event) {
  if (event.type() != QEvent::ToolTip) return false;
  const auto* view = qobject_cast<const QAbstractItemView*>(watched.parent());
  if (view == nullptr || view->viewport() != &watched || qobject_cast<const QHeaderView*>(view) != nullptr)
    return false;
  const auto* help = static_cast<const QHelpEvent*>(&event);
  const auto index = view->indexAt(help->pos());
  if (!index.isValid() || !isCut(*view, index)) return false;
  const auto text = index.data().toString();
  const auto more = index.data(Qt::ToolTipRole).toString();
  if (more.contains(text)) return false;  // the view shows it
  QToolTip::showText(help->globalPos(), more.isEmpty() ? text : text + QLatin1Char('\n') + more, view->viewport(),
                     view->visualRect(index));
  return true;
}

}  // namespace syncline::ui
