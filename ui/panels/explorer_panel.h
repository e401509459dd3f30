// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QTreeView;

namespace syncline::ui {

class NetworkModel;

/// Project explorer: the tree of the network, one node selected.
class ExplorerPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit ExplorerPanel(NetworkModel& model, QWidget* parent = nullptr);
  void select(int slave);
  [[nodiscard]] QSize sizeHint() const override;

 Q_SIGNALS:
  void nodeSelected(int slave);

 private:
  NetworkModel& model_;
  QTreeView* tree_;
};

}  // namespace syncline::ui
