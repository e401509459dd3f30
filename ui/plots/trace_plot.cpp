// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/trace_plot.h"

#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_scale_widget.h>

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/plots/plot_colors.h"
#include "ui/plots/small_font.h"
#include "ui/plots/time_axis.h"
#include "ui/plots/unit_scale_draw.h"
#include "ui/theme/theme.h"

namespace syncline::ui {
namespace {

constexpr double kGrabDistance = 5;  // logical pixels about a cursor line
constexpr double kZoomPerNotch = 0.8;
constexpr int kValueLabelExtent = 38;  // keeps the canvas where it is when labels get longer
constexpr int kBorder = 7;
constexpr double kLimitWithin = 6;  // a limit this many times the data is still shown to scale

struct Unit {
  double divisor;
  QString name;
};

Unit timeUnit(double magnitude_ns) {
  if (magnitude_ns < 2e4) return {1, QStringLiteral("ns")};
  if (magnitude_ns < 2e7) return {1e3, QStringLiteral("\u00B5s")};
  if (magnitude_ns < 2e10) return {1e6, QStringLiteral("ms")};
  return {1e9, QStringLiteral("s")};
}

QwtText titleText(const QString& quantity, const QString& unit, const QPalette& palette, const QFont& font) {
  QwtText title(unit.isEmpty() ? quantity : quantity + QStringLiteral(" / ") + unit);
  title.setFont(font);
  title.setColor(theme::mutedText(palette));
  return title;
}

}  // namespace

TracePlot::TracePlot(const Options& options, TimeView* view, CursorSet* cursors, QWidget* parent)
    : QwtPlot(parent),
      options_(options),
      view_(view),
      cursors_(cursors),
      lines_(new QwtPlotGrid),
      band_(new LimitBandItem),
      cursor_item_(new CursorItem(cursors)),
      gaps_(new GapItem),
      marks_(new EventMarksItem),
      level_(new TriggerLevelItem),
      time_draw_(new UnitScaleDraw),
      value_draw_(new UnitScaleDraw),
      range_(options.minimum_span, options.with_zero) {
  setAutoReplot(false);
  setFocusPolicy(Qt::StrongFocus);
  auto* surface = new QwtPlotCanvas(this);
  // Every redraw is a whole one: a backing store would only be copied.
  surface->setPaintAttribute(QwtPlotCanvas::BackingStore, false);
  surface->setFrameStyle(QFrame::NoFrame);
  surface->setFocusPolicy(Qt::NoFocus);
  surface->setMouseTracking(true);
  surface->setCursor(Qt::CrossCursor);
  surface->installEventFilter(this);
  setCanvas(surface);
  plotLayout()->setAlignCanvasToScales(true);
  plotLayout()->setSpacing(2);
  setAxisScaleDraw(QwtPlot::xBottom, time_draw_);
  setAxisScaleDraw(QwtPlot::yLeft, value_draw_);
  for (const auto axis : {QwtPlot::xBottom, QwtPlot::yLeft}) {
    axisScaleDraw(axis)->enableComponent(QwtAbstractScaleDraw::Backbone, false);
    axisScaleDraw(axis)->setTickLength(QwtScaleDiv::MinorTick, 0);
    axisScaleDraw(axis)->setTickLength(QwtScaleDiv::MediumTick, 0);
    axisScaleDraw(axis)->setTickLength(QwtScaleDiv::MajorTick, 3);
    axisWidget(axis)->setMargin(0);
    axisWidget(axis)->setSpacing(1);
  }
  value_draw_->setMinimumExtent(kValueLabelExtent);
  // Room for half a label at each end, used or not: the canvases of a row stay aligned.
  axisWidget(QwtPlot::yLeft)->setMinBorderDist(kBorder, kBorder);
  axisWidget(QwtPlot::xBottom)->setMinBorderDist(kBorder, 2 * kBorder);
  for (QwtPlotItem* item :
       {static_cast<QwtPlotItem*>(lines_), static_cast<QwtPlotItem*>(band_), static_cast<QwtPlotItem*>(cursor_item_),
        static_cast<QwtPlotItem*>(gaps_), static_cast<QwtPlotItem*>(marks_), static_cast<QwtPlotItem*>(level_)}) {
    item->attach(this);
  }
  connect(view_, &TimeView::changed, this, &TracePlot::markDirty);
  connect(cursors_, &CursorSet::changed, this, &TracePlot::markDirty);
  connect(cursors_, &CursorSet::pointerMoved, this, &TracePlot::markDirty);
  applyTheme();
}

TracePlot::~TracePlot() = default;

SeriesItem* TracePlot::addItem(const QString& title, SeriesItem::Shape shape) {
  auto* item = new SeriesItem(title);
  item->setShape(shape);
  item->setZ(20 + static_cast<double>(items_.size()));
  item->attach(this);
  items_.push_back(item);
  return item;
}

void TracePlot::setLimit(double limit, const QString& label) {
  band_->setLimit(limit, label);
  markDirty();
}

void TracePlot::setTriggerLevel(std::optional<double> level) {
  if (level == level_->level()) return;
  level_->setLevel(level);
  markDirty();
}

void TracePlot::applyTheme() {
  const auto small = smallFont(font());
  setCanvasBackground(palette().color(QPalette::Base));
  lines_->setPen(plot_colors::grid(palette()), 0);
  band_->setColors(plot_colors::limitFill(palette()), plot_colors::limitLine(palette()),
                   palette().color(QPalette::Base));
  cursor_item_->setColors(plot_colors::cursor(palette()), palette().color(QPalette::Base));
  level_->setColors(theme::toneColor(palette(), theme::Tone::kAccent), palette().color(QPalette::Base));
  gaps_->setColor(plot_colors::grid(palette()));
  marks_->setColors(theme::toneColor(palette(), theme::Tone::kBad), theme::toneColor(palette(), theme::Tone::kGood),
                    palette().color(QPalette::WindowText));
  auto axis_palette = palette();
  axis_palette.setColor(QPalette::WindowText, plot_colors::envelope(palette()));
  axis_palette.setColor(QPalette::Text, theme::mutedText(palette()));
  for (const auto axis : {QwtPlot::xBottom, QwtPlot::yLeft}) {
    axisWidget(axis)->setPalette(axis_palette);
    setAxisFont(axis, small);
  }
  canvas()->setFont(small);
  updateTimeAxis();
  updateValueAxis();
  markDirty();
}

bool TracePlot::onScreen() const {
  return isVisible() && !window()->isMinimized() && !canvas()->visibleRegion().isEmpty();
}

bool TracePlot::refresh() {
  if (!dirty_ || !onScreen()) return false;
  dirty_ = false;
  prepare();
  updateTimeAxis();
  updateValueAxis();
  replot();
  return true;
}

void TracePlot::prepare() {
  const double ratio = canvas()->devicePixelRatioF();
  const int columns = static_cast<int>(std::lround(canvas()->contentsRect().width() * ratio));
  grid_ = ColumnGrid::of(view_->begin(), view_->end(), columns);
  double low = 1;
  double high = 0;
  for (auto* item : items_) {
    if (!item->isVisible()) continue;
    item->setHoldUntil(view_->last());
    item->prepare(grid_);
    const auto extent = item->extent();
    if (!extent) continue;
    const bool first = low > high;
    low = first ? static_cast<double>(extent->min) : std::min(low, static_cast<double>(extent->min));
    high = first ? static_cast<double>(extent->max) : std::max(high, static_cast<double>(extent->max));
  }
  // The pointer stays where it is on the screen while the data pass below it.
  if (pointer_x_) cursors_->setPointer(timeAt(*pointer_x_));
  cursor_item_->prepare(grid_);
  gaps_->prepare(grid_);
  marks_->prepare(grid_);
  if (const double limit = band_->limit(); limit > 0 && low <= high) {
    if (limit <= kLimitWithin * std::max(std::abs(low), std::abs(high))) {
      low = std::min(low, -limit);
      high = std::max(high, limit);
    }
  }
  range_.update(low, high);
}

void TracePlot::updateTimeAxis() {
  const auto axis = timeAxisOf(*view_);
  time_draw_->setDivisor(axis.divisor);
  setAxisMaxMajor(QwtPlot::xBottom, std::clamp(canvas()->width() / 52, 2, 8));
  setAxisScale(QwtPlot::xBottom, axis.begin, axis.end);
  const auto title = titleText(axis.quantity, axis.unit, palette(), canvas()->font());
  if (axisTitle(QwtPlot::xBottom) != title) setAxisTitle(QwtPlot::xBottom, title);
}

void TracePlot::updateValueAxis() {
  Unit unit{1, {}};
  if (options_.kind == Quantity::kTime) unit = timeUnit(std::max(std::abs(range_.low()), std::abs(range_.high())));
  value_draw_->setDivisor(unit.divisor);
  setAxisScale(QwtPlot::yLeft, range_.low(), range_.high(), range_.step());
  const auto title = titleText(options_.quantity, unit.name, palette(), canvas()->font());
  if (axisTitle(QwtPlot::yLeft) != title) setAxisTitle(QwtPlot::yLeft, title);
}

void TracePlot::fitValues() {
  range_.fit();
  markDirty();
}

void TracePlot::fixValues(double low, double high) {
  range_.fix(low, high);
  markDirty();
}

Nanoseconds TracePlot::timeAt(double x) const {
  const auto width = static_cast<double>(std::max(canvas()->contentsRect().width(), 1));
  const double column = (x - canvas()->contentsRect().left()) / width * grid_.columns;
  return grid_.origin + static_cast<Nanoseconds>(std::llround(column * static_cast<double>(grid_.width)));
}

void TracePlot::drawCanvas(QPainter* painter) {
  ++paints_;
  QwtPlot::drawCanvas(painter);
  if (!hasFocus()) return;
  painter->setPen(QPen(palette().color(QPalette::Highlight), 0));
  painter->drawRect(QRectF(canvas()->contentsRect()).adjusted(0, 0, -1, -1));
}

void TracePlot::focusInEvent(QFocusEvent* event) {
  QwtPlot::focusInEvent(event);
  canvas()->update();
}

void TracePlot::focusOutEvent(QFocusEvent* event) {
  QwtPlot::focusOutEvent(event);
  canvas()->update();
}

void TracePlot::resizeEvent(QResizeEvent* event) {
  QwtPlot::resizeEvent(event);
  markDirty();
}

bool TracePlot::eventFilter(QObject* watched, QEvent* event) {
  if (watched == canvas() && mouseEvent(event)) return true;
  if (watched == canvas() && event->type() == QEvent::Resize) markDirty();
  return QwtPlot::eventFilter(watched, event);
}

bool TracePlot::mouseEvent(QEvent* event) {
  switch (event->type()) {
    case QEvent::Wheel:
      wheel(*static_cast<QWheelEvent*>(event));
      return true;
    case QEvent::MouseButtonPress: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      if (mouse->button() != Qt::LeftButton) return false;
      setFocus(Qt::MouseFocusReason);
      grab(mouse->position(), mouse->modifiers().testFlag(Qt::ControlModifier));
      return true;
    }
    case QEvent::MouseMove:
      drag(static_cast<QMouseEvent*>(event)->position());
      return false;
    case QEvent::MouseButtonRelease:
      release(static_cast<QMouseEvent*>(event)->position().x());
      drag_ = Drag::kNone;
      canvas()->setCursor(Qt::CrossCursor);
      return false;
    case QEvent::MouseButtonDblClick:
      fitValues();
      return true;
    case QEvent::Leave:
      pointer_x_.reset();
      cursors_->setPointer(std::nullopt);
      return false;
    case QEvent::ContextMenu: {
      const auto* menu = static_cast<QContextMenuEvent*>(event);
      Q_EMIT menuRequested(menu->globalPos(), timeAt(menu->pos().x()));
      return true;
    }
    default:
      return false;
  }
}

void TracePlot::wheel(const QWheelEvent& event) {
  const double notches = event.angleDelta().y() / 120.0;
  if (event.modifiers().testFlag(Qt::ControlModifier)) {
    const double y = invTransform(QwtPlot::yLeft, event.position().y());
    const double factor = std::pow(kZoomPerNotch, notches);
    fixValues(y + (range_.low() - y) * factor, y + (range_.high() - y) * factor);
  } else if (event.modifiers().testFlag(Qt::ShiftModifier)) {
    view_->pan(static_cast<Nanoseconds>(-notches * 0.1 * static_cast<double>(view_->span())));
  } else if (notches != 0) {
    view_->zoom(std::pow(kZoomPerNotch, notches), timeAt(event.position().x()));
  }
}

bool TracePlot::onLevel(double y) const {
  return level_->level() && std::abs(transform(QwtPlot::yLeft, *level_->level()) - y) <= kGrabDistance;
}

void TracePlot::grab(const QPointF& place, bool overlay) {
  const double x = place.x();
  if (overlay) {
    drag_ = Drag::kOverlay;
    drag_x_ = grab_x_ = x;
    return canvas()->setCursor(Qt::SizeHorCursor);
  }
  drag_ = onLevel(place.y()) ? Drag::kLevel : Drag::kPan;
  drag_x_ = grab_x_ = x;
  const auto reach =
      static_cast<Nanoseconds>(kGrabDistance * static_cast<double>(grid_.width) * canvas()->devicePixelRatioF());
  for (const auto which : {CursorSet::kA, CursorSet::kB}) {
    const auto time = cursors_->at(which);
    if (time && std::llabs(*time - timeAt(x)) <= reach)
      drag_ = which == CursorSet::kA ? Drag::kCursorA : Drag::kCursorB;
  }
  if (drag_ == Drag::kLevel) return canvas()->setCursor(Qt::SplitVCursor);
  canvas()->setCursor(drag_ == Drag::kPan ? Qt::ClosedHandCursor : Qt::SplitHCursor);
}

/// A click that moved nothing goes to the event below it, also where a cursor stands on it.
void TracePlot::release(double x) {
  if (drag_ == Drag::kNone || x != grab_x_) return;
  const auto reach =
      static_cast<Nanoseconds>(kGrabDistance * static_cast<double>(grid_.width) * canvas()->devicePixelRatioF());
  if (const auto mark = marks_->nearest(timeAt(x), reach)) Q_EMIT eventClicked(mark->time);
}

void TracePlot::drag(const QPointF& place) {
  const double x = place.x();
  pointer_x_ = x;
  cursors_->setPointer(timeAt(x));
  if (drag_ == Drag::kLevel) Q_EMIT triggerLevelDragged(std::round(invTransform(QwtPlot::yLeft, place.y())));
  if (drag_ == Drag::kCursorA) cursors_->set(CursorSet::kA, timeAt(x));
  if (drag_ == Drag::kCursorB) cursors_->set(CursorSet::kB, timeAt(x));
  if ((drag_ != Drag::kPan && drag_ != Drag::kOverlay) || x == drag_x_) return;
  const double per_pixel = static_cast<double>(view_->span()) / std::max(canvas()->contentsRect().width(), 1);
  const auto by = static_cast<Nanoseconds>((x - drag_x_) * per_pixel);
  drag_x_ = x;
  drag_ == Drag::kOverlay ? Q_EMIT overlayDragged(by) : view_->pan(-by);
}

}  // namespace syncline::ui
