// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>
#include <string>

#include "findings/finding.h"

class QComboBox;

namespace syncline {
class RunRecord;
}  // namespace syncline

namespace syncline::ui {

class BathtubPlot;
class CyclePlot;
class TimeView;

class ChoiceEdit;
class ValueLabel;

/// Where in the SYNC0 period of a slave its outputs come, over the range that the plots show; margins and setpoint
/// slips as numbers.
class CycleView final : public QWidget {
  Q_OBJECT

 public:
  explicit CycleView(const TimeView* view, QWidget* parent = nullptr);
  /// Null: nothing. It must outlive the view or be replaced.
  void setRecord(const RunRecord* record);
  /// Draws what is new; once a tick while it is seen.
  void refresh();
  /// Shows a slave of the run, where its arrivals are known.
  void select(int slave);
  /// By position; -1: of nobody anything is known.
  [[nodiscard]] int slave() const;
  [[nodiscard]] CyclePlot* plot() const { return plot_; }
  [[nodiscard]] BathtubPlot* bathtub() const { return bathtub_; }
  /// How often outputs came when; or how probable it is that they come later or earlier than that.
  enum class Figure { kArrivals, kBathtub };
  void setFigure(Figure figure);
  [[nodiscard]] Figure figure() const;
  /// What the numbers beside the slave say.
  [[nodiscard]] QString words() const;
  /// Of the arrivals the bins: their range since SYNC0 in ns and the count; of the bathtub the room kept to both SYNC0
  /// by its probability. C locale.
  [[nodiscard]] std::string csv() const;

 private:
  void showArrivals(std::size_t position);
  void showBathtub(std::size_t position);
  [[nodiscard]] QString figuresText() const;
  [[nodiscard]] QString bathtubText() const;
  [[nodiscard]] std::string bathtubCsv() const;

  const TimeView* view_;
  const RunRecord* record_ = nullptr;
  ChoiceEdit* slaves_;
  ValueLabel* figures_;
  QComboBox* figure_;
  CyclePlot* plot_;
  BathtubPlot* bathtub_;
  unsigned ticks_ = 0;
  /// What the figures are of.
  struct Shown {
    std::size_t slave = 0;
    Figure figure = Figure::kArrivals;
    Nanoseconds begin = 0, end = 0, last = 0;
    bool operator==(const Shown&) const = default;
  };
  std::optional<Shown> shown_;
};

}  // namespace syncline::ui
