// SPDX-License-Identifier: Apache-2.0
#include "ui/models/record_model.h"

#include <algorithm>
#include <utility>

namespace syncline::ui {

RecordModel::RecordModel(QStringList titles, QObject* parent)
    : QAbstractTableModel(parent), titles_(std::move(titles)) {}

void RecordModel::setLines(const Lines& lines) {
  const auto common = std::min(lines.size(), lines_.size());
  const auto same = std::mismatch(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(common), lines_.begin());
  const auto first = static_cast<int>(same.first - lines.begin());
  if (lines.size() < lines_.size()) {
    const auto gone = static_cast<int>(lines_.size() - lines.size());
    beginRemoveRows({}, first, first + gone - 1);
    lines_.erase(lines_.begin() + first, lines_.begin() + first + gone);
    endRemoveRows();
  } else if (lines.size() > lines_.size()) {
    const auto more = static_cast<int>(lines.size() - lines_.size());
    beginInsertRows({}, first, first + more - 1);
    lines_.insert(lines_.begin() + first, lines.begin() + first, lines.begin() + first + more);
    endInsertRows();
  }
  if (lines == lines_) return;
  lines_ = lines;
  Q_EMIT dataChanged(index(first, 0), index(rowCount() - 1, columnCount() - 1));
}

int RecordModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(lines_.size());
}

int RecordModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(titles_.size());
}

QVariant RecordModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto& line = lines_[static_cast<std::size_t>(index.row())];
  if (role == kWordsRole) return line.join(u' ');
  return role == Qt::DisplayRole || role == Qt::ToolTipRole ? QVariant(line[index.column()]) : QVariant();
}

QVariant RecordModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return titles_.value(section);
}

}  // namespace syncline::ui
