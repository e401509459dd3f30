// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <qwt_plot.h>

#include <QString>
#include <cstdint>
#include <optional>
#include <vector>

#include "ui/plots/cursor_item.h"
#include "ui/plots/event_marks_item.h"
#include "ui/plots/gap_item.h"
#include "ui/plots/limit_band_item.h"
#include "ui/plots/series_item.h"
#include "ui/plots/slow_range.h"
#include "ui/plots/time_view.h"
#include "ui/plots/trigger_level_item.h"

class QWheelEvent;
class QwtPlotGrid;

namespace syncline::ui {

class UnitScaleDraw;

/// One plot of several series over the shared time view. Never replots by itself: refresh() reduces and
/// redraws once, when something changed and the canvas can be seen.
class TracePlot final : public QwtPlot {
  Q_OBJECT

 public:
  enum class Quantity { kTime, kCount };
  struct Options {
    QString quantity;                 // of the value axis, without the unit
    Quantity kind = Quantity::kTime;  // times are nanoseconds, shown as ns, us, ms or s
    double minimum_span = 1;          // of the value axis
    bool with_zero = false;
  };

  TracePlot(const Options& options, TimeView* view, CursorSet* cursors, QWidget* parent = nullptr);
  ~TracePlot() override;

  /// The plot owns its items; the order is the drawing order.
  SeriesItem* addItem(const QString& title, SeriesItem::Shape shape);
  void setLimit(double limit, const QString& label);
  /// In axis units; nothing: none of this plot. It can be dragged.
  void setTriggerLevel(std::optional<double> level);
  [[nodiscard]] std::optional<double> triggerLevel() const { return level_->level(); }
  void applyTheme();
  /// What hatches the outages, and what marks the events.
  [[nodiscard]] GapItem& gaps() { return *gaps_; }
  [[nodiscard]] EventMarksItem& marks() { return *marks_; }

  void markDirty() { dirty_ = true; }
  /// Redraws when dirty and on screen; true when it did.
  bool refresh();
  void fitValues();
  void fixValues(double low, double high);
  [[nodiscard]] const SlowRange& valueRange() const { return range_; }

  /// Canvas paints since construction.
  [[nodiscard]] std::uint64_t paintCount() const { return paints_; }
  [[nodiscard]] const std::vector<SeriesItem*>& items() const { return items_; }
  [[nodiscard]] const ColumnGrid& grid() const { return grid_; }
  [[nodiscard]] QSize sizeHint() const override { return {360, 150}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {160, 80}; }
  /// Time under a canvas x coordinate.
  [[nodiscard]] Nanoseconds timeAt(double x) const;

 Q_SIGNALS:
  void menuRequested(const QPoint& global, syncline::Nanoseconds time);
  void triggerLevelDragged(double level);
  /// Dragged with Ctrl: what lies over the plot is to be later by so many ns.
  void overlayDragged(syncline::Nanoseconds by);
  /// The mark of an event was clicked.
  void eventClicked(syncline::Nanoseconds time);

 protected:
  void drawCanvas(QPainter* painter) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  [[nodiscard]] bool onScreen() const;
  void prepare();
  void updateTimeAxis();
  void updateValueAxis();
  bool mouseEvent(QEvent* event);
  void wheel(const QWheelEvent& event);
  void drag(const QPointF& place);
  void grab(const QPointF& place, bool overlay);
  [[nodiscard]] bool onLevel(double y) const;
  void release(double x);

  Options options_;
  TimeView* view_;
  CursorSet* cursors_;
  QwtPlotGrid* lines_;
  LimitBandItem* band_;
  CursorItem* cursor_item_;
  GapItem* gaps_;
  EventMarksItem* marks_;
  TriggerLevelItem* level_;
  UnitScaleDraw *time_draw_, *value_draw_;
  std::vector<SeriesItem*> items_;
  SlowRange range_;
  ColumnGrid grid_;
  bool dirty_ = true;
  std::uint64_t paints_ = 0;
  enum class Drag { kNone, kPan, kCursorA, kCursorB, kLevel, kOverlay } drag_ = Drag::kNone;
  double drag_x_ = 0, grab_x_ = 0;
  std::optional<double> pointer_x_;
};

}  // namespace syncline::ui
