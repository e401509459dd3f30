// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/widgets/widget_events.h"

class QAbstractItemView;
class QModelIndex;

namespace syncline::ui {

/// While it lives, the tool tip of every cell of a list, table or tree that ends in an ellipsis begins with its whole
/// text.
class WholeTexts final : public WidgetEvents {
  Q_OBJECT

 public:
  using WidgetEvents::WidgetEvents;
  /// The text of the cell does not fit into it.
  [[nodiscard]] static bool isCut(const QAbstractItemView& view, const QModelIndex& index);

 protected:
  bool take(QObject& watched, QEvent& event) override;
};

}  // namespace syncline::ui
