// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTreeView>

namespace syncline::ui {

/// The tree of the explorer. What is dropped below a row that is open goes before the first row of that branch: there
/// the line is drawn that says where it lands.
class ExplorerTree final : public QTreeView {
 public:
  using QTreeView::QTreeView;

 protected:
  void dropEvent(QDropEvent* event) override;
};

}  // namespace syncline::ui
