// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractItemModel>
#include <cstddef>
#include <optional>

namespace syncline::ui {

/// A tree of two levels: groups, and below each its members. What a model holds it says by counts, and asks by numbers.
class GroupedModel : public QAbstractItemModel {
  Q_OBJECT

 public:
  using QAbstractItemModel::QAbstractItemModel;
  [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const final;
  [[nodiscard]] QModelIndex parent(const QModelIndex& child) const final;
  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const final;

 protected:
  [[nodiscard]] virtual int groups() const = 0;
  [[nodiscard]] virtual int members(std::size_t group) const = 0;

  /// Of a valid index, a group's own or a member's.
  [[nodiscard]] static std::size_t groupOf(const QModelIndex& index);
  /// Nothing: the index is a group's.
  [[nodiscard]] static std::optional<std::size_t> memberOf(const QModelIndex& index);
};

}  // namespace syncline::ui
