// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

class QAbstractItemView;
class QModelIndex;

namespace syncline::ui {

/// While it lives, the tool tip of every cell of a list, table or tree that ends in an ellipsis begins with its whole
/// text.
class WholeTexts final : public QObject {
  Q_OBJECT

 public:
  /// Watches the application.
  explicit WholeTexts(QObject* parent);
  /// The text of the cell does not fit into it.
  [[nodiscard]] static bool isCut(const QAbstractItemView& view, const QModelIndex& index);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace syncline::ui
