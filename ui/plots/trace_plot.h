// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <qwt_plot.h>
#include <QObject>

#include <QString>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "ui/plots/limit_band_item.h"
#include "ui/plots/series_item.h"
#include "ui/plots/trigger_level_item.h"
#include "ui/plots/value_axis.h"

class QWheelEvent;
class QwtPlotGrid;

namespace syncline::ui {

class BandItem;
class CursorItem;
class CursorSet;
class EventMarksItem;
class GapItem;
class LimitWordsItem;
class TimeView;

class UnitScaleDraw;

/// One plot of several series over a time view, on a value axis at the left and one at the right where something needs
/// it, and of states as bands above them. Never replots by itself: refresh() reduces and
/// redraws once, when something changed and the canvas can be seen.
class TracePlot final : public QwtPlot {
  Q_OBJECT

 public:
  using Quantity = ValueAxis::Quantity;
  using Options = ValueAxis::Options;
  enum Side : unsigned char { kLeft, kRight };

  TracePlot(const Options& options, TimeView* view, CursorSet* cursors, QWidget* parent = nullptr);
  ~TracePlot() override;

  /// The plot owns its items; the order is the drawing order.
  SeriesItem* addItem(const QString& title, SeriesItem::Shape shape);
  /// A state; drawn while it is visible, in the order in which they were added.
  BandItem* addBand(const QString& title);
  void setSide(SeriesItem& item, Side side);
  /// Room for the axis at the right, used or not: the canvases of a column stay aligned.
  void setRightReserved(bool reserved);
  void setLimit(double limit, const QString& label, Side side = kLeft);
  [[nodiscard]] double limit() const { return band_->limit(); }
  /// It can be dragged: limitDragged() tells where to; it stays where it is.
  void setLimitMovable(bool movable) { limit_movable_ = movable; }
  [[nodiscard]] bool limitMovable() const { return limit_movable_ && band_->limit() > 0; }
  /// What is wanted instead of it; 0: nothing else.
  void setWantedLimit(double limit, const QString& label);
  [[nodiscard]] double wantedLimit() const { return band_->wanted(); }
  /// Another stretch of time than that of the other plots, or theirs again. It must outlive the plot or be replaced.
  void setTimeView(TimeView* view, bool own);
  [[nodiscard]] TimeView* timeView() const { return view_; }
  [[nodiscard]] bool hasOwnTime() const { return own_time_; }
  /// In axis units; nothing: none of this plot. It can be dragged.
  void setTriggerLevel(std::optional<double> level, Side side = kLeft);
  [[nodiscard]] std::optional<double> triggerLevel() const { return level_->level(); }
  void applyTheme();
  /// What hatches the outages, and what marks the events.
  [[nodiscard]] GapItem& gaps() { return *gaps_; }
  [[nodiscard]] EventMarksItem& marks() { return *marks_; }

  void markDirty() { dirty_ = true; }
  /// Redraws when dirty and on screen; true when it did.
  bool refresh();
  /// Redraws whatever can be seen of it, for pictures.
  void redraw();
  void fitValues();
  [[nodiscard]] ValueAxis& axis(Side side) { return *axes_[side]; }
  [[nodiscard]] const ValueAxis& axis(Side side) const { return *axes_[side]; }

  /// Canvas paints since construction.
  [[nodiscard]] std::uint64_t paintCount() const { return paints_; }
  [[nodiscard]] const std::vector<SeriesItem*>& items() const { return items_; }
  [[nodiscard]] const std::vector<BandItem*>& bands() const { return state_bands_; }
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
  void limitDragged(double magnitude);
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
  void updateValueAxes();
  /// Of the height, for the bands.
  double layBands();
  [[nodiscard]] Side sideAt(const QPointF& place) const;
  bool mouseEvent(QEvent* event);
  void wheel(const QWheelEvent& event);
  void drag(const QPointF& place);
  void grab(const QPointF& place, bool overlay);
  [[nodiscard]] bool onLevel(double y) const;
  [[nodiscard]] bool onLimit(double y) const;
  void release(double x);

  TimeView* view_;
  CursorSet* cursors_;
  QwtPlotGrid* lines_;
  LimitBandItem* band_;
  LimitWordsItem* limit_words_;
  CursorItem* cursor_item_;
  GapItem* gaps_;
  EventMarksItem* marks_;
  TriggerLevelItem* level_;
  UnitScaleDraw* time_draw_;
  std::array<std::unique_ptr<ValueAxis>, 2> axes_;
  Side limit_side_ = kLeft;
  bool own_time_ = false, limit_movable_ = false, right_reserved_ = false;
  std::optional<double> dragged_limit_;
  std::vector<SeriesItem*> items_;
  std::vector<BandItem*> state_bands_;
  ColumnGrid grid_;
  bool dirty_ = true;
  std::uint64_t paints_ = 0;
  enum class Drag { kNone, kPan, kCursorA, kCursorB, kLevel, kLimit, kOverlay } drag_ = Drag::kNone;
  double drag_x_ = 0, grab_x_ = 0;
  std::optional<double> pointer_x_;
};

}  // namespace syncline::ui
