// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <QTimer>

#include "ui/session/comparison.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QToolButton;
class QTreeView;

namespace syncline::ui {

class ComparisonFilter;
class ComparisonModel;
class Workspace;

/// Two machines beside each other: the project, files, what runs, a bus. A click goes to the setting or the slave of
/// the project.
class CompareDialog final : public QDialog {
  Q_OBJECT

 public:
  CompareDialog(Workspace& workspace, QWidget* parent);

  /// What the project is usually compared with: what runs, else its file, else nothing.
  [[nodiscard]] static ComparedSide usualSide(Workspace& workspace);
  void compare(const ComparedSide& left, const ComparedSide& right);
  [[nodiscard]] bool isComparing() const { return comparison_.isRunning(); }
  [[nodiscard]] ComparisonModel& model() { return *model_; }
  /// What is shown, a line a difference; `separator` between the columns.
  [[nodiscard]] QString text(QChar separator, bool quoted) const;
  /// As CSV; false: the error was shown.
  bool exportTo(const QString& path);

 Q_SIGNALS:
  /// A slave of the project (-1: its network) and the key of a setting, or none.
  void placeWanted(int slave, const QString& key);

 private:
  QWidget* buildSides();
  QWidget* buildFilter();
  void buildTree();
  QWidget* buildButtons();
  QComboBox* sideBox(const char* name, const QString& what);
  void fill(QComboBox& box);
  void choose(QComboBox& box);
  void select(QComboBox& box, const ComparedSide& side);
  [[nodiscard]] ComparedSide side(const QComboBox& box) const;
  [[nodiscard]] QString sideName(const ComparedSide& side) const;
  void restart();
  void onChange(ComparedSide::Kind kind);
  [[nodiscard]] bool withBus() const;
  void showResult();
  void goTo(const QModelIndex& index);
  void exportCsv();

  Workspace& workspace_;
  Comparison comparison_;
  ComparisonModel* model_;
  ComparisonFilter* filter_;
  QTimer edited_;  // runs until nobody edits any more
  QComboBox *left_, *right_;
  QToolButton* swap_;
  ComparedSide chosen_[2];  // of the two boxes, to go back to
  QLineEdit* words_;
  QCheckBox* only_matters_;
  QTreeView* tree_;
  QLabel* status_;
  QPushButton *copy_, *export_;
};

}  // namespace syncline::ui
