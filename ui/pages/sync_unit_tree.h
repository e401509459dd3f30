// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <vector>

class QToolButton;
class QTreeView;

namespace syncline::ui {

class Page;
class SyncUnitModel;
struct UnitMember;

/// Which slave is in which Sync Unit: dragged from one to another, or moved by the button below; one undo step each.
class SyncUnitTree final : public QWidget {
  Q_OBJECT

 public:
  explicit SyncUnitTree(Page& page);
  void refresh();

 private:
  [[nodiscard]] std::vector<UnitMember> selected() const;
  void move(const std::vector<UnitMember>& members, const QString& unit);
  void fillMenu();

  Page& page_;
  SyncUnitModel* model_;
  QTreeView* view_;
  QToolButton* button_;
};

}  // namespace syncline::ui
