// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/trace_plot.h"

#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_scale_div.h>
#include <qwt_scale_widget.h>

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/plots/band_item.h"
#include "ui/plots/cursor_item.h"
#include "ui/plots/event_marks_item.h"
#include "ui/plots/gap_item.h"
#include "ui/plots/limit_band_item.h"
#include "ui/plots/plot_colors.h"
#include "ui/plots/small_font.h"
#include "ui/plots/time_axis.h"
#include "ui/plots/time_view.h"
#include "ui/plots/trigger_level_item.h"
#include "ui/plots/unit_scale_draw.h"
#include "ui/text/units.h"
#include "ui/theme/theme.h"
#include "ui/widgets/spoken_value.h"

namespace syncline::ui {
namespace {

constexpr double kGrabDistance = 5;  // logical pixels about a cursor line
constexpr double kZoomPerNotch = 0.8;
constexpr int kValueLabelExtent = 38;  // keeps the canvas where it is when labels get longer
constexpr int kBorder = 7;
constexpr double kMostBands = 0.5;  // of the height, beside curves
constexpr double kHighestBand = 15, kHighestBandAlone = 22;
constexpr double kLimitWithin = 6;  // a limit this many times the data is still shown to scale

QwtText titleText(const QString& quantity, const QString& unit, const QPalette& palette, const QFont& font) {
  QwtText title(unit.isEmpty() ? quantity : quantity + QStringLiteral(" / ") + unit);
  title.setFont(font);
  title.setColor(theme::mutedText(palette));
  return title;
}

}  // namespace

TracePlot::TracePlot(const Options& options, TimeView* view, CursorSet* cursors, QWidget* parent)
    : QwtPlot(parent),
      view_(view),
      cursors_(cursors),
      lines_(new QwtPlotGrid),
      band_(new LimitBandItem),
      limit_words_(new LimitWordsItem(*band_)),
      cursor_item_(new CursorItem(cursors)),
      gaps_(new GapItem),
      marks_(new EventMarksItem),
      level_(new TriggerLevelItem),
      time_draw_(new UnitScaleDraw),
      axes_{std::make_unique<ValueAxis>(*this, QwtPlot::yLeft, options),
            std::make_unique<ValueAxis>(*this, QwtPlot::yRight, options)} {
  speaksValue(*this);
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
  for (const auto axis : {QwtPlot::xBottom, QwtPlot::yLeft, QwtPlot::yRight}) {
    axisScaleDraw(axis)->enableComponent(QwtAbstractScaleDraw::Backbone, false);
    axisScaleDraw(axis)->setTickLength(QwtScaleDiv::MinorTick, 0);
    axisScaleDraw(axis)->setTickLength(QwtScaleDiv::MediumTick, 0);
    axisScaleDraw(axis)->setTickLength(QwtScaleDiv::MajorTick, 3);
    axisWidget(axis)->setMargin(0);
    axisWidget(axis)->setSpacing(1);
  }
  for (const auto& axis : axes_) axisScaleDraw(axis->id())->setMinimumExtent(kValueLabelExtent);
  // Room for half a label at each end, used or not: the canvases of a row stay aligned.
  for (const auto& axis : axes_) axisWidget(axis->id())->setMinBorderDist(kBorder, kBorder);
  axisWidget(QwtPlot::xBottom)->setMinBorderDist(kBorder, 2 * kBorder);
  for (QwtPlotItem* item :
       {static_cast<QwtPlotItem*>(lines_), static_cast<QwtPlotItem*>(band_), static_cast<QwtPlotItem*>(limit_words_),
        static_cast<QwtPlotItem*>(cursor_item_), static_cast<QwtPlotItem*>(gaps_), static_cast<QwtPlotItem*>(marks_),
        static_cast<QwtPlotItem*>(level_)}) {
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

BandItem* TracePlot::addBand(const QString& title) {
  auto* band = new BandItem(title);
  band->setColors(theme::mutedText(palette()), palette().color(QPalette::Base));
  band->attach(this);
  state_bands_.push_back(band);
  return band;
}

void TracePlot::setSide(SeriesItem& item, Side side) { item.setYAxis(axes_[side]->id()); }

void TracePlot::setRightReserved(bool reserved) {
  if (reserved != std::exchange(right_reserved_, reserved)) markDirty();
}

void TracePlot::setLimit(double limit, const QString& label, Side side) {
  limit_side_ = side;
  band_->setYAxis(axes_[side]->id());
  limit_words_->setYAxis(axes_[side]->id());
  band_->setLimit(limit, label);
  markDirty();
}

void TracePlot::setWantedLimit(double limit, const QString& label) {
  if (limit == band_->wanted() || drag_ == Drag::kLimit) return;
  band_->setWanted(limit, label);
  markDirty();
}

void TracePlot::setTimeView(TimeView* view, bool own) {
  if (view == view_) return;
  own_time_ = own;
  disconnect(view_, nullptr, this, nullptr);
  view_ = view;
  connect(view_, &TimeView::changed, this, &TracePlot::markDirty);
  markDirty();
}

void TracePlot::setTriggerLevel(std::optional<double> level, Side side) {
  if (level == level_->level() && level_->yAxis() == axes_[side]->id()) return;
  level_->setYAxis(axes_[side]->id());
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
  for (auto* band : state_bands_) {
    band->setColors(theme::mutedText(palette()), palette().color(QPalette::Base));
    band->forgetColors();
  }
  for (const auto axis : {QwtPlot::xBottom, QwtPlot::yLeft, QwtPlot::yRight}) {
    axisWidget(axis)->setPalette(axis_palette);
    setAxisFont(axis, small);
  }
  canvas()->setFont(small);
  updateTimeAxis();
  updateValueAxes();
  markDirty();
}

bool TracePlot::onScreen() const {
  return isVisible() && !window()->isMinimized() && !canvas()->visibleRegion().isEmpty();
}

bool TracePlot::refresh() {
  if (!dirty_ || !onScreen()) return false;
  redraw();
  return true;
}

void TracePlot::redraw() {
  dirty_ = false;
  prepare();
  updateTimeAxis();
  updateValueAxes();
  replot();
}

double TracePlot::layBands() {
  const auto shown = std::ranges::count_if(state_bands_, &BandItem::isVisible);
  if (shown == 0) return 0;
  const bool alone = std::ranges::none_of(items_, &SeriesItem::isVisible);
  const double high = std::max(canvas()->contentsRect().height(), 1);
  const double room = alone ? high - 2 : high * kMostBands;
  const double lane = std::min(alone ? kHighestBandAlone : kHighestBand, room / static_cast<double>(shown));
  int number = 0;
  for (auto* band : state_bands_) {
    if (!band->isVisible()) continue;
    band->prepare(grid_);
    band->setLane(number++, lane);
  }
  return alone ? 0 : lane * static_cast<double>(shown) / high;
}

void TracePlot::prepare() {
  const double ratio = canvas()->devicePixelRatioF();
  const int columns = static_cast<int>(std::lround(canvas()->contentsRect().width() * ratio));
  grid_ = ColumnGrid::of(view_->begin(), view_->end(), columns);
  std::array<AxisLimits, 2> seen{AxisLimits{1, 0}, AxisLimits{1, 0}};
  std::array<bool, 2> used{true, false};
  for (auto* item : items_) {
    if (!item->isVisible()) continue;
    const auto side = item->yAxis() == axes_[kRight]->id() ? kRight : kLeft;
    used[side] = true;
    item->setHoldUntil(view_->last());
    item->prepare(grid_);
    const auto extent = item->extent();
    if (!extent) continue;
    auto& [low, high] = seen[side];
    const bool first = low > high;
    low = first ? static_cast<double>(extent->min) : std::min(low, static_cast<double>(extent->min));
    high = first ? static_cast<double>(extent->max) : std::max(high, static_cast<double>(extent->max));
  }
  const double headroom = layBands();
  // The pointer stays where it is on the screen while the data pass below it.
  if (pointer_x_) cursors_->setPointer(timeAt(*pointer_x_));
  cursor_item_->prepare(grid_);
  gaps_->prepare(grid_);
  marks_->prepare(grid_);
  auto& [low, high] = seen[limit_side_];
  if (const double limit = band_->limit(); limit > 0 && low <= high) {
    if (limit <= kLimitWithin * std::max(std::abs(low), std::abs(high))) {
      low = std::min(low, -limit);
      high = std::max(high, limit);
    }
  }
  for (const auto side : {kLeft, kRight}) axes_[side]->update(seen[side].low, seen[side].high, headroom);
  const bool right = used[kRight] || right_reserved_;
  if (right != isAxisVisible(axes_[kRight]->id())) setAxisVisible(axes_[kRight]->id(), right);
  axes_[kRight]->setNumbers(used[kRight]);
  const bool states_alone =
      std::ranges::any_of(state_bands_, &BandItem::isVisible) && std::ranges::none_of(items_, &SeriesItem::isVisible);
  axes_[kLeft]->setNumbers(!states_alone);
  lines_->enableY(!states_alone);
}

void TracePlot::updateTimeAxis() {
  const int most = std::clamp(canvas()->width() / 52, 2, 8);
  const auto axis = timeAxisOf(*view_, most);
  time_draw_->setDivisor(axis.divisor);
  time_draw_->setTicks(axis.ticks);
  setAxisMaxMajor(QwtPlot::xBottom, most);
  if (axis.labelled) {
    QList<double> places;
    for (const auto& tick : axis.ticks) places.append(tick.value);
    setAxisScaleDiv(QwtPlot::xBottom, QwtScaleDiv(axis.begin, axis.end, {}, {}, places));
  } else {
    setAxisScale(QwtPlot::xBottom, axis.begin, axis.end);
  }
  const auto quantity = own_time_ ? tr("%1 (not linked)").arg(axis.quantity) : axis.quantity;
  const auto title = titleText(quantity, axis.unit, palette(), canvas()->font());
  if (axisTitle(QwtPlot::xBottom) != title) setAxisTitle(QwtPlot::xBottom, title);
}

void TracePlot::updateValueAxes() {
  const int height = canvas()->contentsRect().height();
  for (const auto& axis : axes_) axis->apply(palette(), canvas()->font(), height);
}

void TracePlot::fitValues() {
  for (const auto& axis : axes_) axis->fit();
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
      if (const auto limit = std::exchange(dragged_limit_, std::nullopt)) Q_EMIT limitDragged(*limit);
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
    auto& axis = *axes_[sideAt(event.position())];
    axis.zoom(invTransform(axis.id(), event.position().y()), std::pow(kZoomPerNotch, notches));
    markDirty();
  } else if (event.modifiers().testFlag(Qt::ShiftModifier)) {
    view_->pan(static_cast<Nanoseconds>(-notches * 0.1 * static_cast<double>(view_->span())));
  } else if (notches != 0) {
    view_->zoom(std::pow(kZoomPerNotch, notches), timeAt(event.position().x()));
  }
}

/// The axis that is nearer, where there are two.
TracePlot::Side TracePlot::sideAt(const QPointF& place) const {
  const bool right = isAxisVisible(axes_[kRight]->id()) && place.x() > canvas()->contentsRect().width() / 2.0;
  return right ? kRight : kLeft;
}

bool TracePlot::onLevel(double y) const {
  return level_->level() && std::abs(transform(level_->yAxis(), *level_->level()) - y) <= kGrabDistance;
}

bool TracePlot::onLimit(double y) const {
  if (!limitMovable()) return false;
  const auto near = [&](double value) { return std::abs(transform(band_->yAxis(), value) - y) <= kGrabDistance; };
  return near(band_->limit()) || near(-band_->limit());
}

void TracePlot::grab(const QPointF& place, bool overlay) {
  const double x = place.x();
  dragged_limit_.reset();
  if (overlay) {
    drag_ = Drag::kOverlay;
    drag_x_ = grab_x_ = x;
    return canvas()->setCursor(Qt::SizeHorCursor);
  }
  drag_ = onLevel(place.y()) ? Drag::kLevel : onLimit(place.y()) ? Drag::kLimit : Drag::kPan;
  drag_x_ = grab_x_ = x;
  const auto reach =
      static_cast<Nanoseconds>(kGrabDistance * static_cast<double>(grid_.width) * canvas()->devicePixelRatioF());
  for (const auto which : {CursorSet::kA, CursorSet::kB}) {
    const auto time = cursors_->at(which);
    if (time && std::llabs(*time - timeAt(x)) <= reach)
      drag_ = which == CursorSet::kA ? Drag::kCursorA : Drag::kCursorB;
  }
  if (drag_ == Drag::kLevel || drag_ == Drag::kLimit) return canvas()->setCursor(Qt::SplitVCursor);
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
  if (drag_ == Drag::kLevel) Q_EMIT triggerLevelDragged(std::round(invTransform(level_->yAxis(), place.y())));
  if (drag_ == Drag::kLimit) {
    dragged_limit_ = std::round(std::abs(invTransform(band_->yAxis(), place.y())));
    band_->setWanted(*dragged_limit_, tr("project \u00B1%1").arg(timeText(static_cast<Nanoseconds>(*dragged_limit_))));
    markDirty();
  }
  if (drag_ == Drag::kCursorA) cursors_->set(CursorSet::kA, timeAt(x));
  if (drag_ == Drag::kCursorB) cursors_->set(CursorSet::kB, timeAt(x));
  if ((drag_ != Drag::kPan && drag_ != Drag::kOverlay) || x == drag_x_) return;
  const double per_pixel = static_cast<double>(view_->span()) / std::max(canvas()->contentsRect().width(), 1);
  const auto by = static_cast<Nanoseconds>((x - drag_x_) * per_pixel);
  drag_x_ = x;
  drag_ == Drag::kOverlay ? Q_EMIT overlayDragged(by) : view_->pan(-by);
}

}  // namespace syncline::ui
