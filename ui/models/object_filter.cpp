// SPDX-License-Identifier: Apache-2.0
#include "ui/models/object_filter.h"

#include <algorithm>
#include <utility>

#include "ui/models/object_model.h"

namespace syncline::ui {
namespace {

QString csvCell(const QString& text) {
  const bool plain = std::ranges::none_of(text, [](QChar c) { return c == u',' || c == u'"' || c < u' '; });
  return plain ? text : u'"' + QString(text).replace(u'"', QStringLiteral("\"\"")) + u'"';
}

void appendRows(QString& out, const QAbstractItemModel& model, const QModelIndex& parent) {
  const auto above = parent.isValid() ? parent.data().toString() : QString();
  for (int row = 0; row < model.rowCount(parent); ++row) {
    const auto first = model.index(row, 0, parent);
    for (int column = 0; column < model.columnCount(parent); ++column) {
      const auto text = first.siblingAtColumn(column).data().toString();
      out += (column == 0 ? csvCell(above + text) : u',' + csvCell(text));
    }
    out += u'\n';
    appendRows(out, model, first);
  }
}

}  // namespace

ObjectFilter::ObjectFilter(QObject* parent) : QSortFilterProxyModel(parent) { setRecursiveFilteringEnabled(true); }

void ObjectFilter::setWords(const QString& text) {
  words_ = text.split(u' ', Qt::SkipEmptyParts);
  invalidateFilter();
}

void ObjectFilter::setWatchedOnly(bool only) {
  if (only != std::exchange(watched_only_, only)) invalidateFilter();
}

/// An object brings its entries where it fits itself, and an entry its object (recursive filtering).
bool ObjectFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  const auto index = sourceModel()->index(row, 0, parent);
  if (watched_only_ && !index.data(ObjectModel::kWatchedRole).toBool()) return false;
  if (words_.isEmpty()) return true;
  auto line = index.data(ObjectModel::kWordsRole).toString();
  if (parent.isValid()) line += u' ' + parent.data(ObjectModel::kWordsRole).toString();
  return std::ranges::all_of(words_, [&](const QString& word) { return line.contains(word, Qt::CaseInsensitive); });
}

QString tableCsv(const QAbstractItemModel& model) {
  QString out;
  for (int column = 0; column < model.columnCount(); ++column) {
    if (column > 0) out += u',';
    out += csvCell(model.headerData(column, Qt::Horizontal).toString());
  }
  out += u'\n';
  appendRows(out, model, {});
  return out;
}

QString rowsText(const QModelIndexList& rows) {
  QStringList lines;
  for (const auto& row : rows) {
    QStringList cells;
    for (int column = 0; column < row.model()->columnCount(row.parent()); ++column)
      cells << row.siblingAtColumn(column).data().toString();
    if (row.parent().isValid()) cells.front().prepend(row.parent().data().toString());
    lines << cells.join(u'\t');
  }
  return lines.join(u'\n');
}

}  // namespace syncline::ui
