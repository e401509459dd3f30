// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>
#include <QWidget>
#include <optional>
#include <vector>

#include "trace/histogram.h"
#include "trace/sample_store.h"
#include "trace/statistics.h"
#include "ui/plots/legend_bar.h"
#include "ui/plots/time_view.h"
#include "ui/plots/trace_plot.h"

class QHBoxLayout;
class QLabel;

namespace syncline {
struct RunLimits;
class RunRecord;
}  // namespace syncline

namespace syncline::ui {

class CursorSet;

/// A plot with its heading, legend and read-out. Subclasses say which series it shows.
class TracePanel : public QWidget {
  Q_OBJECT

 public:
  TracePanel(const QString& title, const TracePlot::Options& options, TimeView* view, CursorSet* cursors,
             QWidget* parent = nullptr);

  /// The source must outlive the panel or be replaced.
  void setSource(const RunRecord* source);
  /// Another recording over what is shown, later by `shift` ns than it was; null: none. It must outlive the panel or be
  /// replaced. The names tell whose curve is whose.
  struct Overlay {
    const RunRecord* record = nullptr;
    Nanoseconds shift = 0;
    QString own, other;
  };
  void setOverlay(const Overlay& overlay);
  [[nodiscard]] const Overlay& overlay() const { return overlay_; }
  /// The slave that is drawn whatever its values are; -1 = none.
  void setPickedSlave(int position);
  [[nodiscard]] int pickedSlave() const { return picked_; }
  /// How many slaves are drawn, the worst of them, 1 to kMostSlaves; 0: it is no panel of slaves.
  static constexpr int kMostSlaves = 6;
  [[nodiscard]] virtual int slavesShown() const { return 0; }
  virtual void setSlavesShown(int /*count*/) {}
  /// Limits nothing: by what is shown. In the unit of the axis.
  virtual void setScale(ValueScale scale);
  virtual void setLimits(TracePlot::Side side, const std::optional<AxisLimits>& limits);
  /// An own stretch of time, which begins as that of the others; or theirs again.
  virtual void setOwnTime(bool own);
  /// Once a tick: what there is of an own stretch of time is what the others have.
  void followTime();
  /// Chooses what to draw and writes the numbers; a few times a second.
  void refreshText(bool choose);
  void applyTheme();
  /// What the project would hold the signal against whose limit is drawn, where it is not that; it can be dragged then.
  /// Nothing: there is no project whose it is.
  void showWantedLimits(const std::optional<RunLimits>& wanted);
  /// Whose limit is drawn; nothing: none is.
  [[nodiscard]] virtual std::optional<Signal> limitSignal() const { return std::nullopt; }
  /// Drawn where the signal is, of this slave where it is one of slaves; nothing: no level.
  void showTriggerLevel(Signal signal, std::size_t slave, std::optional<double> level);

  [[nodiscard]] TracePlot* plot() const { return plot_; }
  /// Beside the heading, at the right end.
  void addToHead(QWidget* widget);
  [[nodiscard]] LegendBar* legend() const { return legend_; }
  [[nodiscard]] QString readout() const;
  [[nodiscard]] QString title() const;
  /// One line a curve, columns by tabulators: name, unit, values at A and B, their difference, smallest, largest, mean,
  /// the magnitude that 99.9 % do not exceed and number of the samples between the cursors, or in the range shown where
  /// there are none. Numbers are numbers in the language's form, for a spreadsheet.
  [[nodiscard]] QStringList figures() const;
  [[nodiscard]] static QStringList figureHeads();

 protected:
  /// The source is new, or gone: tell the items their series.
  virtual void attach() = 0;
  /// Another overlay, or none; nothing to do by default.
  virtual void attachOverlay() {}
  /// Picks slaves anew; nothing to do by default.
  virtual void choose() {}
  virtual void colorItems() = 0;
  /// Legend entries with values at `time`.
  [[nodiscard]] virtual std::vector<LegendBar::Entry> entries(Nanoseconds time) const = 0;
  /// The line beside the heading when no cursors are set.
  [[nodiscard]] virtual QString summary(Nanoseconds time) const = 0;
  /// What the figures between the cursors are of.
  [[nodiscard]] virtual const SeriesItem* primary() const = 0;
  /// The same of the overlay; null: none.
  [[nodiscard]] virtual const SeriesItem* primaryOfOverlay() const { return nullptr; }
  [[nodiscard]] virtual QString valueText(double value) const = 0;
  /// Half of an interval, without a sign; empty where the values are none that an estimate is made of.
  [[nodiscard]] virtual QString spreadText(double /*half*/) const { return {}; }
  /// What else there is to say between the cursors; in the time of the run.
  [[nodiscard]] virtual QString remark(Nanoseconds /*begin*/, Nanoseconds /*end*/) const { return {}; }
  /// The same where curves of the panel have several units.
  [[nodiscard]] virtual QString itemText(const SeriesItem& item, double value) const;
  /// In which the samples are; empty: counts, and what has none.
  [[nodiscard]] virtual QString unitText(const SeriesItem& /*item*/) const { return {}; }
  /// What is made only when somebody looks is brought up to date.
  virtual void renew() {}

  void setTitle(const QString& title);
  [[nodiscard]] bool hasSource() const { return source_ != nullptr; }
  [[nodiscard]] const RunRecord& source() const { return *source_; }
  [[nodiscard]] const SampleStore& store() const;
  /// The item draws the signal, of the bus or of one slave.
  void draw(SeriesItem& item, Signal signal, std::size_t slave = 0) const;
  [[nodiscard]] const TimeView& view() const { return *view_; }
  [[nodiscard]] LegendBar::Entry entry(const SeriesItem& item, Nanoseconds time) const;
  /// An item that draws the overlay, above the others and in its colour; nothing is drawn yet.
  [[nodiscard]] SeriesItem* addOverlayItem(SeriesItem::Shape shape);
  /// The item draws that signal of the overlay, and is titled by `name` and the file's; nothing where there is none, or
  /// it does not tell it.
  void drawOverlay(SeriesItem& item, const QString& name, Signal signal, std::size_t slave = 0) const;
  /// Of an item of the overlay, with its file's name.
  [[nodiscard]] LegendBar::Entry overlayEntry(const SeriesItem& item, const QString& name, Nanoseconds time) const;
  /// Adds the file's name to an entry, while there is an overlay to tell it from.
  void nameOwn(LegendBar::Entry& entry) const;
  /// As entry() for a slave's item, with its number as the short name.
  [[nodiscard]] LegendBar::Entry slaveEntry(const SeriesItem& item, int position, Nanoseconds time) const;
  [[nodiscard]] QString slaveName(int position) const;

 private:
  struct Measured {
    const MinMaxSeries* series = nullptr;
    Nanoseconds begin = 0, delta = 0;
    std::size_t samples = 0;
    const MinMaxSeries* overlay = nullptr;
    Nanoseconds shift = 0;
    bool operator==(const Measured&) const = default;
  };
  [[nodiscard]] QString betweenCursors();
  [[nodiscard]] QString limitWords() const;
  /// How often it is read, how old, by which clocks, and how far off it may be; at the time of its value.
  [[nodiscard]] QString aboutEntry(const LegendBar::Entry& entry) const;
  [[nodiscard]] QString measure(const SeriesItem& item, Nanoseconds begin) const;
  struct OfStretch {
    Statistics statistics;
    Histogram magnitudes;  // of what is measured in whole ns; else empty
  };
  /// The samples of [begin, end) in the time of the run.
  [[nodiscard]] OfStretch stretch(const SeriesItem& item, Nanoseconds begin, Nanoseconds end) const;
  /// " ± 3 ns" of a mean; empty without.
  [[nodiscard]] QString spread(const Statistics& statistics) const;

  TimeView* shared_;
  TimeView own_;
  TimeView* view_;
  CursorSet* cursors_;
  QHBoxLayout* head_;
  QLabel *heading_, *readout_;
  LegendBar* legend_;
  TracePlot* plot_;
  const RunRecord* source_ = nullptr;
  int picked_ = -1;
  Overlay overlay_;
  std::vector<SeriesItem*> overlay_items_;
  Measured measured_;
  QString measured_text_;
};

}  // namespace syncline::ui
