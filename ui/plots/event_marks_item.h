// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <qwt_plot_item.h>

#include <QColor>
#include <optional>
#include <span>
#include <vector>

#include "ui/plots/series_item.h"

namespace syncline::ui {

/// An event on the time axis, or a note of the user.
struct EventMark {
  Nanoseconds time = 0;  // host clock
  bool fault = true;     // else a return to order, or a note
  int slave = -1;        // position in frame order, -1: the master or the bus
  bool note = false;
  bool operator==(const EventMark&) const = default;
};

/// A triangle, its lower edge at `foot`: up for a fault, down for a return to order.
void drawEventMark(QPainter& painter, const QPointF& foot, bool fault, const QColor& color);

/// A little flag on a pole that stands at `foot`.
void drawNoteMark(QPainter& painter, const QPointF& foot, const QColor& color);

/// Marks events at the foot of a plot: a triangle that points up for a fault, one that points down for a return to
/// order. Those that fall into one place are one, and a fault among them counts. Notes are flags, whatever else is
/// there.
class EventMarksItem final : public QwtPlotItem {
 public:
  EventMarksItem();
  /// By time; they must outlive the item or be replaced.
  void setMarks(const std::vector<EventMark>* marks) { marks_ = marks; }
  void setColors(const QColor& fault, const QColor& good, const QColor& note);
  void prepare(const ColumnGrid& grid) { grid_ = grid; }
  [[nodiscard]] const QColor& color(bool fault) const { return fault ? fault_ : good_; }
  /// Those from `begin` on and before `end`.
  [[nodiscard]] std::span<const EventMark> within(Nanoseconds begin, Nanoseconds end) const;
  /// The one nearest to a time, no further from it than `reach`.
  [[nodiscard]] std::optional<EventMark> nearest(Nanoseconds time, Nanoseconds reach) const;
  void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const override;

 private:
  const std::vector<EventMark>* marks_ = nullptr;
  QColor fault_ = Qt::red, good_ = Qt::darkGreen, note_ = Qt::black;
  ColumnGrid grid_;
};

}  // namespace syncline::ui
