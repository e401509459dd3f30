// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <qwt_plot_item.h>

#include <QColor>
#include <QString>
#include <functional>
#include <vector>

#include "ui/plots/series_item.h"

namespace syncline::ui {

/// Draws a state over time as a band with its names: one lane of several over each other, from the top of the plot on.
/// What fits into a column without being one state alone is hatched: there it changed. Where nothing is known is
/// nothing. The cost depends on the columns only.
class BandItem final : public QwtPlotItem {
 public:
  struct State {
    QString name;
    QColor fill, text;
    bool operator==(const State&) const = default;
  };
  using States = std::function<State(int value)>;

  explicit BandItem(const QString& title);

  /// The series must outlive the item or be replaced; null draws nothing.
  void setSeries(const MinMaxSeries* series, const HeldSeries* held, States states);
  [[nodiscard]] const MinMaxSeries* series() const { return series_; }
  /// Which lane, and of how many; logical pixels of its height.
  void setLane(int lane, double height);
  void setColors(const QColor& label, const QColor& background) {
    label_ = label;
    background_ = background;
  }
  /// Colours may have changed.
  void forgetColors() { known_.clear(); }
  /// The state at a time; empty where none is known.
  [[nodiscard]] QString stateAt(Nanoseconds time) const;

  /// Once a redraw, before draw().
  void prepare(const ColumnGrid& grid);
  /// In columns of the grid.
  struct Stretch {
    int begin = 0, end = 0;
    int value = 0;
    bool changes = false;  // several states in each of these columns
    bool operator==(const Stretch&) const = default;
  };
  [[nodiscard]] const std::vector<Stretch>& stretches() const { return stretches_; }
  void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const override;

 private:
  [[nodiscard]] const State& state(int value) const;

  const MinMaxSeries* series_ = nullptr;
  const HeldSeries* held_ = nullptr;
  States states_;
  int lane_ = 0;
  double height_ = 14;
  QColor label_, background_;
  ColumnGrid grid_;
  std::vector<SeriesColumn> columns_;
  std::vector<Stretch> stretches_;
  mutable std::vector<std::pair<int, State>> known_;
};

}  // namespace syncline::ui
