// SPDX-License-Identifier: Apache-2.0
#include "ui/models/grouped_model.h"

namespace syncline::ui {
namespace {

// Of an index: a group has this, its members the number of the group behind it.
constexpr quintptr kGroupItself = 0;

}  // namespace

QModelIndex GroupedModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) + 1 : kGroupItself);
}

QModelIndex GroupedModel::parent(const QModelIndex& child) const {
  if (!child.isValid() || child.internalId() == kGroupItself) return {};
  return createIndex(static_cast<int>(groupOf(child)), 0, kGroupItself);
}

int GroupedModel::rowCount(const QModelIndex& parent) const {
  if (!parent.isValid()) return groups();
  if (parent.internalId() != kGroupItself || parent.column() != 0) return 0;
  return members(groupOf(parent));
}

std::size_t GroupedModel::groupOf(const QModelIndex& index) {
  return index.internalId() == kGroupItself ? static_cast<std::size_t>(index.row())
                                            : static_cast<std::size_t>(index.internalId() - 1);
}

std::optional<std::size_t> GroupedModel::memberOf(const QModelIndex& index) {
  if (index.internalId() == kGroupItself) return std::nullopt;
  return static_cast<std::size_t>(index.row());
}

}  // namespace syncline::ui
