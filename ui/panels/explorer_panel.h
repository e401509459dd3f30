// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <set>

class QAction;
class QStackedWidget;
class QTreeView;

class QMenu;

namespace syncline::ui {

class ChoiceEdit;
class Segments;
class TopologyView;
class Workspace;

/// Project explorer: the networks of the machine as a tree by wiring (classic), as lists by position (flat), or the one
/// in work drawn (topology); one node selected in all three. Whoever selects a node of another network takes it in
/// work. Slaves are moved by dragging.
class ExplorerPanel final : public QWidget {
  Q_OBJECT

 public:
  enum class View { kClassic, kFlat, kTopology };

  explicit ExplorerPanel(Workspace& workspace, QWidget* parent = nullptr);
  void select(int slave);
  [[nodiscard]] int selected() const;
  [[nodiscard]] View view() const { return view_; }
  void setView(View view);
  [[nodiscard]] const QList<QAction*>& viewActions() const;
  [[nodiscard]] TopologyView& topology() { return *topology_; }
  /// For the context menu, and for the keys that they have while the explorer has the focus.
  void setCommands(const QList<QAction*>& commands);
  [[nodiscard]] QSize sizeHint() const override;

 Q_SIGNALS:
  void nodeSelected(int slave);
  /// Also the one that is selected already.
  void nodeClicked();
  /// What a port of the slave counted is to be seen.
  void countersWanted(int slave);
  /// Another network of the machine is to come in work.
  void networkWanted(int network);
  /// The context menu of a slave is about to be shown: what else can be done with it is added here.
  void menuOpens(QMenu& menu, int slave);

 private:
  void openMenu(const QPoint& at);
  void addCounters(QMenu& menu);
  void buildTree();
  [[nodiscard]] Segments* buildViews();
  [[nodiscard]] ChoiceEdit* buildNetworks();
  void showNetworks();
  void showStates(int network);
  void keepSelection();
  void takeNode(const QModelIndex& index);
  void unfold();

  Workspace& workspace_;
  QTreeView* tree_;
  TopologyView* topology_;
  QStackedWidget* stack_;
  Segments* views_;
  ChoiceEdit* networks_;
  View view_ = View::kClassic;
  int kept_slave_ = -1, kept_address_ = 0;  // over a reset of the model
  int own_ = -1;                            // selected last of the network in work
  std::set<int> folded_;                    // networks whose slaves the user does not want to see
};

}  // namespace syncline::ui
