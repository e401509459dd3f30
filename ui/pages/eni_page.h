// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "ui/editors/page.h"
#include "ui/text/message.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QMenu;
class QTableView;
class QToolButton;

namespace syncline {
struct Snapshot;
}  // namespace syncline

namespace syncline::ui {

class EniFindingModel;
class EniModel;
class EniPreview;
class EniTextView;
struct EniView;
class ValueLabel;

/// The ENI that the project would export, and which of its lines each change of the project adds, removes or alters. Of
/// the master; for a slave it stands at the slave's lines.
class EniPage final : public Page {
  Q_OBJECT

 public:
  explicit EniPage(Workspace& workspace);
  [[nodiscard]] EniModel& model() { return *model_; }
  /// Marks the lines that depend on a setting ("slave.3.alias"), and goes to the first when they are known.
  void showDependents(const QString& key);

  [[nodiscard]] bool appliesTo(int slave) const override;
  void refresh() override;
  void showLive(const Snapshot& snapshot) override;

 Q_SIGNALS:
  void compareWanted();
  void exportWanted();
  /// The menu of what the checker says of a line.
  void findingMenuOpens(QMenu& menu, const syncline::ui::Message& about);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* buildChoices();
  QWidget* buildSearch();
  QWidget* buildTrial();
  QTableView* buildFindings();
  void openFindingMenu(const QPoint& at);
  void buildShortcuts();
  QToolButton* stepButton(const char* name, const QString& what, Qt::ArrowType arrow, const QKeySequence& keys);
  void showView();
  void showProgress();
  void showSummary();
  void showTrial();
  void goToFirst();
  void showFindings();
  void fillSections();
  void goToNode();
  void goToLine(std::size_t line);
  void stepChange(bool forward);
  void stepFound(bool forward);

  EniPreview& preview_;
  EniModel* model_;
  EniFindingModel* findings_;
  QComboBox *dialect_, *since_, *section_;
  QCheckBox *only_changes_, *report_;
  QToolButton *change_up_, *change_down_, *found_up_, *found_down_;
  QLineEdit* words_;
  EniTextView* text_;
  QTableView* found_;
  ValueLabel *summary_, *checked_, *trial_;
  QLabel* trouble_;
  QWidget* trial_bar_;
  int gone_to_ = -1;                     // node
  bool came_back_ = false;               // shown again, and not gone anywhere yet
  std::shared_ptr<const EniView> left_;  // what stood here when it was left
  bool since_chosen_ = false, first_wanted_ = false;
};

}  // namespace syncline::ui
