// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "config/monitor_view.h"
#include "record/run_record.h"
#include "trace/rate_series.h"
#include "ui/plots/signal_source.h"
#include "ui/plots/trace_panel.h"

class QMenu;
class QToolButton;

namespace syncline::ui {

class BandItem;
struct CsvColumn;
class CursorSet;

/// A plot of the free view: any signals of the run, as the view says. Changes nothing by itself: it asks for another
/// plot in its place.
class FreePlot final : public TracePanel {
  Q_OBJECT

 public:
  FreePlot(TimeView* view, CursorSet* cursors, QWidget* parent = nullptr);
  ~FreePlot() override;

  /// `number` from 0, of `count`: its place in the view.
  void setPlot(const ViewPlot& plot, int number, int count);
  [[nodiscard]] const ViewPlot& settings() const { return shown_; }
  /// Of signals that are made only when somebody looks (arrival phases) so many are drawn at most, from the next plot
  /// or run on: the store keeps few at once.
  void setMostDerived(int most) { most_derived_ = most; }
  /// So many has it of them, drawn or not.
  [[nodiscard]] static int derivedOf(const ViewPlot& plot);
  /// Variables may be watched now that were not.
  void follow();
  /// Redraws when something changed and it can be seen.
  void refresh();
  /// Without what only the window needs.
  void setButtons(bool on);
  /// A column for each signal that is there.
  [[nodiscard]] std::vector<CsvColumn> columns();
  /// What series are made of is asked for again, so that nobody else's wishes have taken them away.
  void renew() override;

  [[nodiscard]] std::optional<Signal> limitSignal() const override { return limit_signal_; }
  void setScale(ValueScale scale) override;
  void setLimits(TracePlot::Side side, const std::optional<AxisLimits>& limits) override;
  void setOwnTime(bool own) override;

 Q_SIGNALS:
  void edited(const syncline::ViewPlot& plot);
  /// The dialog with all there is to choose.
  void settingsWanted();
  void moveWanted(int by);
  void removeWanted();

 protected:
  void attach() override;
  void colorItems() override;
  [[nodiscard]] std::vector<LegendBar::Entry> entries(Nanoseconds time) const override;
  [[nodiscard]] QString summary(Nanoseconds time) const override;
  [[nodiscard]] const SeriesItem* primary() const override;
  [[nodiscard]] QString valueText(double value) const override;
  [[nodiscard]] QString itemText(const SeriesItem& item, double value) const override;
  [[nodiscard]] QString unitText(const SeriesItem& item) const override;

 private:
  struct Curve {
    std::size_t signal = 0;  // of shown_.signals
    std::optional<SignalSource> source;
    SeriesItem* item = nullptr;
    BandItem* band = nullptr;
    std::unique_ptr<RateSeries> rate;
  };
  [[nodiscard]] const ViewSignal& signalOf(const Curve& curve) const { return shown_.signals[curve.signal]; }
  [[nodiscard]] const Curve* curveOf(const SeriesItem& item) const;
  [[nodiscard]] QString autoTitle() const;
  [[nodiscard]] QString curveName(const ViewSignal& signal) const;
  [[nodiscard]] bool atLeast(const Curve& curve, Nanoseconds time) const;
  void attachCurve(Curve& curve);
  void drawCurve(Curve& curve);
  void layAxes();
  void showLimit();
  void fillMenu(QMenu& menu);
  void change(const ViewPlot& plot);

  ViewPlot shown_;
  int number_ = 0, count_ = 1, most_derived_ = 0, drawn_derived_ = 0;
  std::vector<SeriesItem*> items_;  // made so far, used or not
  std::vector<BandItem*> bands_;
  std::vector<Curve> curves_;
  std::optional<Signal> limit_signal_;
  RunLimits limits_;       // that were drawn
  std::size_t lists_ = 0;  // of watched variables, that were looked at
  QToolButton *choose_, *menu_;
};

}  // namespace syncline::ui
