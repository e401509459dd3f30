// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/explorer_panel.h"

#include <QHeaderView>
#include <QLayout>
#include <QMenu>
#include <QStackedWidget>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/editors/choice_edit.h"
#include "ui/panels/explorer_tree.h"
#include "ui/panels/node_delegate.h"
#include "ui/panels/run_state.h"
#include "ui/panels/topology_view.h"
#include "ui/session/workspace.h"
#include "ui/theme/theme.h"
#include "ui/widgets/named.h"
#include "ui/widgets/segments.h"

namespace syncline::ui {
namespace {

const QString kView = QStringLiteral("explorer/view"), kZoom = QStringLiteral("explorer/zoom");

}  // namespace

ExplorerPanel::ExplorerPanel(Workspace& workspace, QWidget* parent) : QWidget(parent), workspace_(workspace) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  networks_ = buildNetworks();
  layout->addWidget(networks_);
  views_ = buildViews();
  layout->addWidget(views_);
  auto& model = workspace.network();
  buildTree();
  topology_ = named(new TopologyView(model, workspace.cables()), "explorerTopology", tr("Topology of the network"));
  auto* own = topology_->selectionModel();
  topology_->setSelectionModel(tree_->selectionModel());
  delete own;
  topology_->setProject(workspace.document().project());
  stack_ = new QStackedWidget;
  stack_->setMinimumWidth(200);  // the views above it may need more
  stack_->addWidget(tree_);
  stack_->addWidget(topology_);
  layout->addWidget(stack_, 1);
  for (QAbstractItemView* view : {static_cast<QAbstractItemView*>(tree_), static_cast<QAbstractItemView*>(topology_)}) {
    view->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(view, &QWidget::customContextMenuRequested, this, [this, view](const QPoint& point) {
      const auto index = view->indexAt(point);
      if (index.data(NetworkModel::kOtherRole).toBool()) {
        takeNode(index);
      } else if (index.isValid()) {
        view->setCurrentIndex(index);
      }
      openMenu(view->viewport()->mapToGlobal(point));
    });
  }
  connect(&model, &QAbstractItemModel::modelAboutToBeReset, this, [this] {
    kept_slave_ = selected();
    kept_address_ = workspace_.network().indexOf(kept_slave_).data(NetworkModel::kAddressRole).toInt();
  });
  connect(&model, &QAbstractItemModel::modelReset, this, &ExplorerPanel::keepSelection);
  connect(tree_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex& current) {
    if (!current.isValid()) return;
    if (!current.data(NetworkModel::kOtherRole).toBool()) {
      own_ = current.data(NetworkModel::kSlaveRole).toInt();
      return Q_EMIT nodeSelected(own_);
    }
    // Not from here: the tree becomes another one with it.
    QMetaObject::invokeMethod(
        this, [this] { takeNode(tree_->currentIndex()); }, Qt::QueuedConnection);
  });
  // A click into the free room means nobody: the slave whose pages are shown stays marked.
  connect(tree_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
    auto& selection = *tree_->selectionModel();
    if (!selection.hasSelection() && selection.currentIndex().isValid())
      selection.select(selection.currentIndex(), QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  });
  // Also one that is selected already, and whose pages are not what is shown.
  for (auto* view : std::initializer_list<QAbstractItemView*>{tree_, topology_})
    connect(view, &QAbstractItemView::clicked, this, &ExplorerPanel::nodeClicked);
  connect(&workspace.document(), &ProjectDocument::projectChanged, this,
          [this] { topology_->setProject(workspace_.document().project()); });
  connect(&workspace, &Workspace::mayEditSlavesChanged, this,
          [this] { topology_->setEditable(workspace_.mayEditSlaves()); });
  topology_->setEditable(workspace.mayEditSlaves());
  const auto remembered = workspace.memory().value(kView).toInt();
  topology_->setZoom(workspace.memory().value(kZoom).isValid() ? workspace.memory().value(kZoom).toDouble() : 1);
  connect(topology_, &TopologyView::countersWanted, this, &ExplorerPanel::countersWanted);
  connect(topology_, &TopologyView::zoomChanged, this,
          [this](double zoom) { workspace_.memory().setValue(kZoom, zoom); });
  showNetworks();
  setView(static_cast<View>(std::clamp(remembered, 0, static_cast<int>(View::kTopology))));
  select(-1);
}

/// A node of another network, which comes in work if it may; else the one in work keeps the selection.
void ExplorerPanel::takeNode(const QModelIndex& index) {
  if (!index.data(NetworkModel::kOtherRole).toBool()) return;
  const int network = index.data(NetworkModel::kNetworkRole).toInt(),
            slave = index.data(NetworkModel::kSlaveRole).toInt();
  Q_EMIT networkWanted(network);
  select(workspace_.document().network() == network ? slave : own_);
}

void ExplorerPanel::openMenu(const QPoint& at) {
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("slaveMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addActions(actions());
  addCounters(*menu);
  if (selected() >= 0) Q_EMIT menuOpens(*menu, selected());
  menu->popup(at);
}

/// For whoever does not click the number at the cable.
void ExplorerPanel::addCounters(QMenu& menu) {
  const auto badge = workspace_.cables().badge(selected());
  if (badge.damage == CableDamage::kNone) return;
  menu.addSeparator();
  auto* action = menu.addAction(tr("Error Counters at Its Cable (%1)").arg(badgeText(badge)));
  action->setObjectName(QStringLiteral("cableCounters"));
  connect(action, &QAction::triggered, this, [this, slave = badge.slave] { Q_EMIT countersWanted(slave); });
}

void ExplorerPanel::buildTree() {
  tree_ = named(new ExplorerTree, "explorerTree", tr("Project explorer"));
  tree_->setModel(&workspace_.network());
  tree_->setItemDelegate(new NodeDelegate(tree_));
  tree_->setHeaderHidden(true);
  tree_->setUniformRowHeights(true);
  tree_->setRootIsDecorated(false);
  tree_->setItemsExpandable(true);
  tree_->setIndentation(16);
  tree_->setFrameShape(QFrame::NoFrame);
  tree_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  tree_->setDragDropMode(QAbstractItemView::DragDrop);
  tree_->setDefaultDropAction(Qt::MoveAction);
  tree_->setDropIndicatorShown(true);
  const auto network = [](const QModelIndex& index) {
    return index.parent().isValid() ? -1 : index.data(NetworkModel::kNetworkRole).toInt();
  };
  connect(tree_, &QTreeView::collapsed, this, [this, network](const QModelIndex& index) {
    if (network(index) >= 0) folded_.insert(network(index));
  });
  connect(tree_, &QTreeView::expanded, this,
          [this, network](const QModelIndex& index) { folded_.erase(network(index)); });
  unfold();
}

const QList<QAction*>& ExplorerPanel::viewActions() const { return views_->choices(); }

Segments* ExplorerPanel::buildViews() {
  const auto key = [](Qt::Key digit) { return QKeySequence(Qt::CTRL | Qt::ALT | digit); };
  auto* views =
      new Segments({{"viewClassic", tr("Classic"), tr("Tree by wiring: terminals below their coupler"), key(Qt::Key_1)},
                    {"viewFlat", tr("Flat"), tr("All slaves in bus order"), key(Qt::Key_2)},
                    {"viewTopology", tr("Topology"), tr("Ports and cables; drag a slave to another port to rewire it"),
                     key(Qt::Key_3)}});
  views->layout()->setContentsMargins(4, 3, 4, 3);
  connect(views, &Segments::chosen, this, [this](int view) { setView(static_cast<View>(view)); });
  return views;
}

/// All but the networks that were folded; the one in work is open.
void ExplorerPanel::unfold() {
  auto folded = folded_;
  folded.erase(workspace_.network().network());
  tree_->expandAll();
  for (const int network : folded) tree_->collapse(workspace_.network().indexOf(network, -1));
  folded_ = folded;
}

/// Which of the machine's networks is in work, where only that one is drawn; nothing to choose where there is one.
ChoiceEdit* ExplorerPanel::buildNetworks() {
  auto* networks = named(new ChoiceEdit, "networkChoice", tr("Network of the machine"));
  networks->setToolTip(tr("Which network of the machine is in work (Ctrl+F6: the next one)"));
  connect(networks, &QComboBox::activated, this, [this](int network) {
    Q_EMIT networkWanted(network);
    showNetworks();  // also where it was refused
  });
  connect(&workspace_.document(), &ProjectDocument::networksChanged, this, &ExplorerPanel::showNetworks);
  connect(&workspace_.recording(), &OpenedRecording::changed, this, &ExplorerPanel::showNetworks);
  connect(&workspace_.runs(), &NetworkRuns::phaseChanged, this, &ExplorerPanel::showStates);
  connect(&workspace_.runs(), &NetworkRuns::snapshotChanged, this, &ExplorerPanel::showStates);
  return networks;
}

/// The states alone: a list that is open stays as it is otherwise.
void ExplorerPanel::showStates(int network) {
  if (network < 0 || network >= networks_->count()) return;
  const auto text = networkText(networks_->itemData(network).toString(), workspace_.runs().of(network).run);
  if (text != networks_->itemText(network)) networks_->setItemText(network, text);
}

void ExplorerPanel::showNetworks() {
  const auto names = workspace_.document().networks();
  networks_->clear();
  for (int i = 0; i < names.size(); ++i)
    networks_->addItem(networkText(names[i], workspace_.runs().of(i).run), names[i]);
  networks_->setCurrentIndex(workspace_.document().network());
  networks_->setEnabled(!workspace_.recording().isOpen());
  networks_->setVisible(names.size() > 1 && view_ == View::kTopology);
  tree_->setRootIsDecorated(names.size() > 1);
}

void ExplorerPanel::setView(View view) {
  view_ = view;
  views_->setCurrent(static_cast<int>(view));
  const auto slave = selected();
  workspace_.network().setShape(view == View::kFlat ? NetworkModel::Shape::kFlat : NetworkModel::Shape::kClassic);
  QWidget* wanted = topology_;
  if (view != View::kTopology) wanted = tree_;
  const bool focused = stack_->currentWidget()->hasFocus();
  stack_->setCurrentWidget(wanted);
  networks_->setVisible(networks_->count() > 1 && view == View::kTopology);
  stack_->setFocusProxy(wanted);
  if (focused) wanted->setFocus();
  select(slave);
  workspace_.memory().setValue(kView, static_cast<int>(view));
}

void ExplorerPanel::setCommands(const QList<QAction*>& commands) {
  addActions(commands);
  setFocusProxy(stack_);
}

QSize ExplorerPanel::sizeHint() const { return {250, 400}; }

int ExplorerPanel::selected() const {
  const auto index = tree_->currentIndex();
  // One of another network is selected for a moment only, until that comes in work.
  const bool own = index.isValid() && !index.data(NetworkModel::kOtherRole).toBool();
  return own ? index.data(NetworkModel::kSlaveRole).toInt() : -1;
}

void ExplorerPanel::select(int slave) {
  const auto index = workspace_.network().indexOf(slave);
  if (!index.isValid()) return;
  tree_->setCurrentIndex(index);
  tree_->scrollTo(index);
  topology_->scrollTo(index);
}

/// The slave that was selected, wherever it stands now.
void ExplorerPanel::keepSelection() {
  unfold();
  auto& network = workspace_.network();
  int slave = -1;
  for (int i = 0; kept_slave_ >= 0 && i < network.slaveCount(); ++i) {
    if (network.indexOf(i).data(NetworkModel::kAddressRole).toInt() == kept_address_) slave = i;
  }
  if (kept_slave_ >= 0 && slave < 0) slave = std::min(kept_slave_, network.slaveCount() - 1);
  topology_->setProject(workspace_.document().project());
  select(slave);
}

}  // namespace syncline::ui
