// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/explorer_panel.h"

#include <QHeaderView>
#include <QTreeView>
#include <QVBoxLayout>

#include "ui/models/network_model.h"
#include "ui/panels/node_delegate.h"
#include "ui/widgets/named.h"

namespace syncline::ui {

ExplorerPanel::ExplorerPanel(NetworkModel& model, QWidget* parent) : QWidget(parent), model_(model) {
  setMinimumWidth(200);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  tree_ = named(new QTreeView, "explorerTree", tr("Project explorer"));
  tree_->setModel(&model);
  tree_->setItemDelegate(new NodeDelegate(tree_));
  tree_->setHeaderHidden(true);
  tree_->setUniformRowHeights(true);
  tree_->setRootIsDecorated(false);
  tree_->setItemsExpandable(true);
  tree_->setIndentation(16);
  tree_->setFrameShape(QFrame::NoFrame);
  tree_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  layout->addWidget(tree_);
  tree_->expandAll();
  connect(&model, &QAbstractItemModel::modelReset, this, [this] {
    tree_->expandAll();
    select(-1);
  });
  connect(tree_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex& current) {
    if (current.isValid()) Q_EMIT nodeSelected(current.data(NetworkModel::kSlaveRole).toInt());
  });
  select(-1);
}

QSize ExplorerPanel::sizeHint() const { return {250, 400}; }

void ExplorerPanel::select(int slave) {
  const auto index = model_.indexOf(slave);
  if (!index.isValid()) return;
  tree_->setCurrentIndex(index);
  tree_->scrollTo(index);
}

}  // namespace syncline::ui
