// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/explorer_tree.h"

#include <QDropEvent>

namespace syncline::ui {

void ExplorerTree::dropEvent(QDropEvent* event) {
  const auto above = indexAt(event->position().toPoint());
  if (dropIndicatorPosition() != BelowItem || !isExpanded(above) || !model()->hasChildren(above))
    return QTreeView::dropEvent(event);
  if (model()->dropMimeData(event->mimeData(), event->dropAction(), 0, 0, above)) event->acceptProposedAction();
  stopAutoScroll();
  setState(NoState);
  viewport()->update();
}

}  // namespace syncline::ui
