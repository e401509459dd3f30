// SPDX-License-Identifier: Apache-2.0
#include "ui/models/difference_model.h"

#include <utility>

namespace syncline::ui {

DifferenceModel::DifferenceModel(std::vector<Line> lines, const QString& left, const QString& right, QObject* parent)
    : QAbstractTableModel(parent), lines_(std::move(lines)), titles_{tr("Where"), tr("What"), left, right} {}

int DifferenceModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(lines_.size());
}

int DifferenceModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant DifferenceModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto& line = lines_[static_cast<std::size_t>(index.row())];
  if (role == kKeyRole) return line.key;
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
  switch (index.column()) {
    case kWhere:
      return line.where;
    case kWhat:
      return role == Qt::ToolTipRole && !line.key.isEmpty() ? QStringLiteral("%1 (%2)").arg(line.what, line.key)
                                                            : line.what;
    case kLeft:
      return line.left;
    case kRight:
      return line.right;
    default:
      return {};
  }
}

QVariant DifferenceModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return titles_.value(section);
}

}  // namespace syncline::ui
