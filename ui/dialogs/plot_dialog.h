// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <QString>
#include <vector>

#include "config/monitor_view.h"

class QButtonGroup;
class QCheckBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;
class QTreeView;

namespace syncline {
class RunRecord;
}  // namespace syncline

namespace syncline::ui {

class LimitFields;
class SignalTree;
class WordFilter;

/// All there is to choose of a plot of the free view: which signals of the run, on which axis, as total or rate; title,
/// scale, limits, time axis. Of the run as it was when it opened; needs it no more afterwards.
class PlotDialog final : public QDialog {
  Q_OBJECT

 public:
  /// `left`, `right`: what the axes show now, proposed as fixed limits.
  PlotDialog(const RunRecord& record, ViewPlot plot, const AxisLimits& left, const AxisLimits& right,
             QWidget* parent = nullptr);
  ~PlotDialog() override;

  /// What was chosen.
  [[nodiscard]] ViewPlot plot() const;

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  QWidget* buildOffer(const RunRecord& record);
  QWidget* buildChosen();
  QWidget* buildSettings(const AxisLimits& left, const AxisLimits& right);
  void search(const QString& words);
  void add();
  void takeOut();
  void fillChosen();
  void readTable(int row, int column);
  void showState();
  [[nodiscard]] bool isRight(const ViewSignal& signal) const;

  ViewPlot plot_;
  std::vector<QString> names_;  // of the signals of plot_
  SignalTree* tree_;
  WordFilter* filter_;
  QLineEdit *words_, *title_;
  QTreeView* offer_;
  QTableWidget* chosen_;
  QPushButton *add_, *out_;
  QButtonGroup* scale_;
  LimitFields *left_, *right_;
  QCheckBox* own_time_;
  QLabel *about_, *wrong_;
  QDialogButtonBox* buttons_;
  bool filling_ = false;
};

}  // namespace syncline::ui
