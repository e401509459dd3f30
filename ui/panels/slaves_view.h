// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "trace/slave_figures.h"
#include "ui/plots/heat_map_plot.h"

class QSortFilterProxyModel;
class QTableView;

namespace syncline {
class RunRecord;
}  // namespace syncline

namespace syncline::ui {

class CursorSet;
class SlaveFiguresModel;
class TimeView;

class HeatLegend;
class ValueLabel;

/// All slaves at a glance: a heat map of their deviations over the range that the plots show, and beside it a table of
/// their figures over the same range, the worst first. A row that is chosen in one is marked in the other.
class SlavesView final : public QWidget {
  Q_OBJECT

 public:
  SlavesView(TimeView* view, CursorSet* cursors, QWidget* parent = nullptr);
  /// Null: nothing. It must outlive the view or be replaced.
  void setRecord(const RunRecord* record);
  /// Draws what is new, and goes on with the figures; once a tick while it is seen.
  void refresh();
  /// The figures are of the range that is shown.
  [[nodiscard]] bool complete() const;
  /// Of the record's events, by time; they must outlive the view or be replaced.
  void setMarks(const std::vector<EventMark>* marks) { plot_->setMarks(marks); }
  [[nodiscard]] HeatMapPlot* plot() const { return plot_; }
  /// Marks a slave in map and table; -1: none.
  void select(int slave);
  /// The cells shown: a line a column of time, a column a slave, empty without a reading; C locale.
  [[nodiscard]] std::string csv() const;

 Q_SIGNALS:
  /// A moment of a slave is to be shown in the plots.
  void momentChosen(int slave, syncline::Nanoseconds time);
  void eventClicked(syncline::Nanoseconds time);
  void menuRequested(const QPoint& global, syncline::Nanoseconds time);

 private:
  void updateRows();
  void widenNames();
  void updateFigures();
  void showFigures();
  void showReading();
  [[nodiscard]] QString worstText() const;
  [[nodiscard]] int selectedInTable() const;
  [[nodiscard]] QVector<float> courseOf(std::size_t slave) const;
  [[nodiscard]] QString eventsText(const HeatMapPlot::MarkSpot& spot) const;
  [[nodiscard]] QString readingText(const HeatMapPlot::Spot& spot) const;

  TimeView* view_;
  const RunRecord* record_ = nullptr;
  std::vector<ClockRole> roles_;
  SlaveFigureRound round_;
  Nanoseconds begin_ = 0, end_ = 0;  // of the round
  unsigned ticks_ = 0;
  HeatMapPlot* plot_;
  HeatLegend* legend_;
  ValueLabel* reading_;
  SlaveFiguresModel* model_;
  QSortFilterProxyModel* sorted_;
  QTableView* table_;
};

}  // namespace syncline::ui
