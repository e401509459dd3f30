// SPDX-License-Identifier: Apache-2.0
#include "ui/models/object_filter.h"

#include <utility>

#include "support/csv_field.h"
#include "ui/models/object_model.h"

namespace syncline::ui {
namespace {

QString csvCell(const QString& text) { return QString::fromStdString(csv_field(text.toStdString())); }

/// Entries bear their object's index.
QStringList exportCells(const QModelIndex& row) {
  QStringList cells;
  for (int column = 0; column < row.model()->columnCount(row.parent()); ++column)
    cells << row.siblingAtColumn(column).data(ObjectModel::kExportRole).toString();
  if (row.parent().isValid()) cells.front().prepend(row.parent().data().toString());
  return cells << row.data(ObjectModel::kDefaultRole).toString();
}

void appendRows(QString& out, const QAbstractItemModel& model, const QModelIndex& parent) {
  for (int row = 0; row < model.rowCount(parent); ++row) {
    const auto first = model.index(row, 0, parent);
    auto cells = exportCells(first);
    for (auto& cell : cells) cell = csvCell(cell);
    out += cells.join(u',') + u'\n';
    appendRows(out, model, first);
  }
}

}  // namespace

ObjectFilter::ObjectFilter(QObject* parent) : WordFilter(ObjectModel::kWordsRole, parent) {}

void ObjectFilter::setWatchedOnly(bool only) {
  if (only != std::exchange(watched_only_, only)) invalidateFilter();
}

bool ObjectFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  const auto index = sourceModel()->index(row, 0, parent);
  if (watched_only_ && !index.data(ObjectModel::kWatchedRole).toBool()) return false;
  return WordFilter::filterAcceptsRow(row, parent);
}

QString tableCsv(const QAbstractItemModel& model) {
  QStringList titles;
  for (int column = 0; column < model.columnCount(); ++column)
    titles << csvCell(model.headerData(column, Qt::Horizontal).toString());
  QString out = (titles << ObjectModel::tr("Default")).join(u',') + u'\n';
  appendRows(out, model, {});
  return out;
}

QString rowsText(const QModelIndexList& rows) {
  QStringList lines;
  for (const auto& row : rows) lines << exportCells(row).join(u'\t');
  return lines.join(u'\n');
}

}  // namespace syncline::ui
