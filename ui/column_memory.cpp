// SPDX-License-Identifier: Apache-2.0
#include "ui/column_memory.h"

#include <QEvent>
#include <QHeaderView>
#include <QTableView>
#include <QTreeView>
#include <QVariantMap>
#include <algorithm>

#include "ui/session/window_memory.h"

namespace syncline::ui {
namespace {

constexpr int kWidest = 4000;  // px: beyond it somebody else has written the memory

QString keyOf(const QString& table) { return QStringLiteral("columns/") + table; }

/// Others take the room that is left, or that their content needs.
bool isOfUser(const QHeaderView& header, int column) {
  return header.sectionResizeMode(column) == QHeaderView::Interactive &&
         !(header.stretchLastSection() && column == header.count() - 1);
}

}  // namespace

ColumnMemory::ColumnMemory(QWidget& window, WindowMemory& memory) : QObject(&window), memory_(memory) {
  for (auto* view : window.findChildren<QTableView*>()) {
    if (!view->objectName().isEmpty()) watch(*view->horizontalHeader(), view->objectName());
  }
  for (auto* view : window.findChildren<QTreeView*>()) {
    if (!view->objectName().isEmpty() && !view->isHeaderHidden()) watch(*view->header(), view->objectName());
  }
}

void ColumnMemory::watch(QHeaderView& header, const QString& table) {
  tables_.insert(&header, table);
  header.viewport()->installEventFilter(this);
  recall(header, table);
  // Some get their columns only when there is something to show.
  connect(&header, &QHeaderView::sectionCountChanged, this, [this, &header, table](int before, int now) {
    if (before != now) recall(header, table);
  });
  connect(&header, &QHeaderView::sectionResized, this, [this, &header, table](int column, int, int) {
    if (header.viewport() == pressed_ && isOfUser(header, column)) note(header, table, column);
  });
  connect(&header, &QObject::destroyed, this, [this, gone = &header] {
    tables_.remove(gone);
    usual_.remove(gone);
  });
}

/// While the button is down on a header it is the user who drags an edge, or clicks on it twice.
bool ColumnMemory::eventFilter(QObject* viewport, QEvent* event) {
  if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick) pressed_ = viewport;
  if (event->type() == QEvent::MouseButtonRelease) pressed_ = nullptr;
  return QObject::eventFilter(viewport, event);
}

void ColumnMemory::recall(QHeaderView& header, const QString& table) {
  QList<int> usual;
  for (int column = 0; column < header.count(); ++column) usual << header.sectionSize(column);
  usual_.insert(&header, usual);
  const auto widths = memory_.value(keyOf(table)).toMap();
  for (auto it = widths.begin(); it != widths.end(); ++it) {
    const int column = it.key().toInt(), width = it.value().toInt();
    if (column < 0 || column >= header.count() || !isOfUser(header, column)) continue;
    if (width >= header.minimumSectionSize() && width <= kWidest) header.resizeSection(column, width);
  }
}

void ColumnMemory::note(const QHeaderView& header, const QString& table, int column) {
  auto widths = memory_.value(keyOf(table)).toMap();
  widths.insert(QString::number(column), header.sectionSize(column));
  memory_.setValue(keyOf(table), widths);
}

void ColumnMemory::reset() {
  for (auto it = tables_.begin(); it != tables_.end(); ++it) {
    memory_.setValue(keyOf(it.value()), {});
    auto& header = *it.key();
    const auto usual = usual_.value(&header);
    for (int column = 0; column < std::min<int>(header.count(), static_cast<int>(usual.size())); ++column) {
      if (isOfUser(header, column)) header.resizeSection(column, usual[column]);
    }
  }
}

}  // namespace syncline::ui
