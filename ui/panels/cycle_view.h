// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>
#include <string>

#include "record/run_record.h"
#include "ui/plots/cycle_plot.h"
#include "ui/plots/time_view.h"

namespace syncline::ui {

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
  /// The bins: their range since SYNC0 in ns and the count of arrivals; C locale.
  [[nodiscard]] std::string csv() const;

 private:
  [[nodiscard]] QString figuresText() const;

  const TimeView* view_;
  const RunRecord* record_ = nullptr;
  ChoiceEdit* slaves_;
  ValueLabel* figures_;
  CyclePlot* plot_;
  unsigned ticks_ = 0;
  /// What the figures are of.
  struct Shown {
    std::size_t slave = 0;
    Nanoseconds begin = 0, end = 0, last = 0;
    bool operator==(const Shown&) const = default;
  };
  std::optional<Shown> shown_;
};

}  // namespace syncline::ui
