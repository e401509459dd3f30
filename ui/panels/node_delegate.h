// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStyledItemDelegate>

namespace syncline::ui {

/// The letter of a node's state on its colour.
void drawStateBadge(QPainter& painter, const QRect& box, const QPalette& palette, const QModelIndex& index);

/// Row of the project explorer: state badge, position, name, address, marks REF and DC.
class NodeDelegate final : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace syncline::ui
