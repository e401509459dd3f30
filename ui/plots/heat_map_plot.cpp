// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/heat_map_plot.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "record/run_record.h"
#include "ui/plots/cursor_item.h"
#include "ui/plots/round_step.h"
#include "ui/plots/signal_source.h"
#include "ui/plots/small_font.h"
#include "ui/plots/time_view.h"
#include "ui/theme/theme.h"
#include "ui/widgets/spoken_value.h"

namespace syncline::ui {
namespace {

constexpr int kHeatTop = 2, kHeatRight = 12, kHeatBottom = 32, kEventsHeight = 9;
constexpr int kMostNameWidth = 130;
constexpr double kHighestRow = 30, kMarkReach = 5;  // pixels
constexpr double kHeatZoomPerNotch = 0.8;
constexpr int kHeatPage = 10;  // rows

}  // namespace

HeatMapPlot::HeatMapPlot(TimeView* view, CursorSet* cursors, QWidget* parent)
    : QWidget(parent), view_(view), cursors_(cursors), scale_(palette()) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  speaksValue(*this);
  updateTheme();
  connect(view_, &TimeView::changed, this, &HeatMapPlot::markDirty);
  connect(cursors_, &CursorSet::changed, this, qOverload<>(&QWidget::update));
  connect(cursors_, &CursorSet::pointerMoved, this, qOverload<>(&QWidget::update));
}

void HeatMapPlot::setRecord(const RunRecord* record) {
  record_ = record;
  cells_.forget();
  rows_.clear();
  measureNames();
  image_ = QImage();
  missing_ = {};
  pointed_.reset();
  pointed_mark_.reset();
  dirty_ = true;
}

void HeatMapPlot::setRows(std::vector<Row> rows) {
  if (rows == rows_) return;
  rows_ = std::move(rows);
  drawn_full_ = 0;
  measureNames();
  dirty_ = true;
}

void HeatMapPlot::setSelected(int slave) {
  if (slave == std::exchange(selected_, slave)) return;
  update();
}

void HeatMapPlot::measureNames() {
  const QFontMetrics metrics(smallFont(font()));
  widest_name_ = 20;
  for (const auto& row : rows_) widest_name_ = std::max(widest_name_, metrics.horizontalAdvance(row.name));
}

int HeatMapPlot::namesWidth() const { return std::min({widest_name_, kMostNameWidth, width() / 3}) + 8; }

double HeatMapPlot::rowHeight() const {
  const double room = std::max(height() - kHeatTop - kEventsHeight - kHeatBottom, 1);
  return std::min(room / static_cast<double>(std::max<std::size_t>(rows_.size(), 1)), kHighestRow);
}

QRectF HeatMapPlot::area() const {
  const int left = namesWidth();
  return {static_cast<double>(left), kHeatTop, static_cast<double>(std::max(width() - left - kHeatRight, 1)),
          rowHeight() * static_cast<double>(std::max<std::size_t>(rows_.size(), 1))};
}

QRectF HeatMapPlot::eventsArea() const {
  auto box = area();
  box.setTop(box.bottom());
  box.setHeight(kEventsHeight);
  return box;
}

QRectF HeatMapPlot::rowArea(std::size_t row) const {
  auto box = area();
  box.setTop(box.top() + rowHeight() * static_cast<double>(row));
  box.setHeight(rowHeight());
  return box;
}

QRectF HeatMapPlot::pixelsOf(const QRect& part) const {
  if (part.isEmpty()) return {};
  const auto all = area();
  const double wide = all.width() / image_.width();
  const double high = all.height() / image_.height();
  const QRectF place(all.left() + part.left() * wide, all.top() + part.top() * high, part.width() * wide,
                     part.height() * high);
  return all.intersected(QRectF(place.toAlignedRect()));
}

std::ptrdiff_t HeatMapPlot::rowOf(int slave) const {
  const auto found = std::ranges::find(rows_, static_cast<std::size_t>(slave), &Row::slave);
  return slave < 0 || found == rows_.end() ? -1 : found - rows_.begin();
}

ColumnGrid HeatMapPlot::grid() const {
  return {cells_.grid().origin, cells_.grid().width, static_cast<int>(cells_.grid().columns)};
}

Nanoseconds HeatMapPlot::timeAt(double x) const {
  const double column = (x - area().left()) / area().width() * static_cast<double>(cells_.grid().columns);
  return cells_.grid().origin + static_cast<Nanoseconds>(std::llround(column * static_cast<double>(grid().width)));
}

void HeatMapPlot::refresh() {
  if (record_ == nullptr || !std::exchange(dirty_, false)) return;
  const auto columns = ColumnGrid::of(view_->begin(), view_->end(), static_cast<int>(area().width()));
  cells_.show(record_->samples(), {columns.origin, columns.width, static_cast<std::size_t>(columns.columns)});
  full_ = limitOf(record_->limits(), Signal::kSlaveDeviation);
  makeImage();
  // What is under the pointer moves on.
  if (pointer_) point(pointer_);
  update();
}

/// A pixel a cell; where rows are lower than a pixel, one for the worst of those that share it.
void HeatMapPlot::makeImage() {
  const auto columns = cells_.grid().columns;
  const auto lines = std::min(rows_.size(), static_cast<std::size_t>(std::max(area().height(), 1.0)));
  if (lines == 0 || columns == 0 || cells_.slaves() == 0) {
    image_ = QImage();
    missing_ = {};
    return;
  }
  if (full_ <= 0) {
    float largest = 0;
    for (const auto& row : rows_) largest = std::max(largest, std::ranges::max(cells_.row(row.slave)));
    full_ = roundStep(std::max(static_cast<double>(largest), 1.0));
  }
  const QSize size(static_cast<int>(columns), static_cast<int>(lines));
  if (image_.size() != size) {
    image_ = QImage(size, QImage::Format_ARGB32_Premultiplied);
    drawn_full_ = 0;
  }
  // While time goes on the colours move on with their cells: what is new is little.
  const auto carried = std::exchange(drawn_full_, full_) == full_ ? cells_.carried() : SlaveCells::Carried{};
  for (std::size_t line = 0; line < lines; ++line) {
    if (carried.begin < carried.end) {
      auto* pixels = reinterpret_cast<QRgb*>(image_.scanLine(static_cast<int>(line)));
      const auto* source = pixels + static_cast<std::ptrdiff_t>(carried.begin) + carried.moved;
      std::memmove(pixels + carried.begin, source, (carried.end - carried.begin) * sizeof(QRgb));
    }
    drawLine(line, 0, carried.begin);
    drawLine(line, carried.end, columns);
  }
  findMissing();
}

void HeatMapPlot::drawLine(std::size_t line, std::size_t begin, std::size_t end) {
  const auto lines = static_cast<std::size_t>(image_.height());
  const auto part = static_cast<float>(1 / full_);
  worst_.assign(end - begin, SlaveCells::kNoReading);
  for (auto row = line * rows_.size() / lines; row < (line + 1) * rows_.size() / lines; ++row) {
    if (rows_[row].slave >= cells_.slaves()) continue;
    const auto cells = cells_.row(rows_[row].slave).subspan(begin);
    for (std::size_t i = 0; i < worst_.size(); ++i) worst_[i] = std::max(worst_[i], cells[i]);
  }
  auto* pixels = reinterpret_cast<QRgb*>(image_.scanLine(static_cast<int>(line))) + begin;
  for (std::size_t i = 0; i < worst_.size(); ++i) pixels[i] = worst_[i] < 0 ? 0 : scale_.color(worst_[i] * part);
}

void HeatMapPlot::findMissing() {
  missing_ = {};
  const auto columns = image_.width();
  const auto lines = static_cast<std::size_t>(image_.height());
  for (std::size_t line = 0; line < lines; ++line) {
    if (rows_[line * rows_.size() / lines].is_reference) continue;
    const auto* pixels = reinterpret_cast<const QRgb*>(image_.constScanLine(static_cast<int>(line)));
    const auto* first = std::find(pixels, pixels + columns, 0U);
    if (first == pixels + columns) continue;
    const auto* last = pixels + columns;
    while (last[-1] != 0) --last;
    missing_ |= QRect(static_cast<int>(first - pixels), static_cast<int>(line), static_cast<int>(last - first), 1);
  }
}

QPointF HeatMapPlot::placeOf(std::size_t slave, std::size_t column) const {
  const auto box = rowArea(static_cast<std::size_t>(std::max<std::ptrdiff_t>(rowOf(static_cast<int>(slave)), 0)));
  const auto columns = static_cast<double>(std::max<std::size_t>(cells_.grid().columns, 1));
  const double x = box.left() + (static_cast<double>(column) + 0.5) * box.width() / columns;
  return {std::floor(x), std::floor(box.center().y())};
}

std::optional<HeatMapPlot::Spot> HeatMapPlot::spotAt(const QPointF& pixel) const {
  const auto all = area();
  if (!all.contains(pixel) || image_.isNull()) return std::nullopt;
  // What a pixel shows is what lies in its middle.
  const auto point = QPointF(std::floor(pixel.x()), std::floor(pixel.y())) + QPointF(0.5, 0.5);
  const auto columns = cells_.grid().columns;
  const auto lines = static_cast<std::size_t>(image_.height());
  const auto column = std::min(
      static_cast<std::size_t>((point.x() - all.left()) / all.width() * static_cast<double>(columns)), columns - 1);
  const auto line = std::min(
      static_cast<std::size_t>((point.y() - all.top()) / all.height() * static_cast<double>(lines)), lines - 1);
  const Row* worst = nullptr;
  for (auto row = line * rows_.size() / lines; row < (line + 1) * rows_.size() / lines; ++row) {
    const auto& one = rows_[row];
    if (one.is_reference || one.slave >= cells_.slaves()) continue;
    if (worst == nullptr || cells_.row(one.slave)[column] > cells_.row(worst->slave)[column]) worst = &one;
  }
  if (worst == nullptr) return std::nullopt;
  return Spot{worst->slave, timeAt(point.x()), column};
}

std::optional<HeatMapPlot::MarkSpot> HeatMapPlot::markAt(const QPointF& pixel) const {
  const double pixels = kMarkReach * static_cast<double>(cells_.grid().columns) / area().width();
  const auto reach = static_cast<Nanoseconds>(pixels * static_cast<double>(columnWidth()));
  const auto time = timeAt(pixel.x());
  if (eventsArea().contains(pixel)) {
    const auto found = marks_.nearest(time, reach);
    return found ? std::optional(MarkSpot{*found, false}) : std::nullopt;
  }
  std::optional<MarkSpot> found;
  for (const auto& mark : marks_.within(time - reach, time + reach + 1)) {
    const auto row = rowOf(mark.slave);
    if (row < 0) continue;
    const double away = std::abs(rowArea(static_cast<std::size_t>(row)).center().y() - pixel.y());
    if (away > std::max(rowHeight() / 2, kMarkReach)) continue;
    if (!found || std::llabs(mark.time - time) < std::llabs(found->mark.time - time)) found = MarkSpot{mark, true};
  }
  return found;
}

Nanoseconds HeatMapPlot::momentOf(std::size_t slave, std::size_t column) const {
  const auto& grid = cells_.grid();
  const auto begin = grid.origin + static_cast<Nanoseconds>(column) * grid.width;
  auto moment = begin + grid.width / 2;
  float largest = -1;
  record_->samples()
      .series(Signal::kSlaveDeviation, slave)
      .for_each(begin, begin + grid.width, [&](Nanoseconds time, float value) {
        if (!(std::abs(value) > largest)) return;
        largest = std::abs(value);
        moment = time;
      });
  return moment;
}

void HeatMapPlot::point(const std::optional<QPointF>& place) {
  pointer_ = place;
  pointed_ = place ? spotAt(*place) : std::nullopt;
  pointed_mark_ = place ? markAt(*place) : std::nullopt;
  setCursor(pointed_mark_ ? Qt::PointingHandCursor : Qt::ArrowCursor);
  cursors_->setPointer(pointed_ ? std::optional(pointed_->time) : std::nullopt);
  Q_EMIT pointedChanged();
}

void HeatMapPlot::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
  drag_x_ = event->position().x();
  dragged_ = false;
}

void HeatMapPlot::mouseMoveEvent(QMouseEvent* event) {
  const double x = event->position().x();
  if (drag_x_ && (dragged_ || std::abs(x - *drag_x_) >= QApplication::startDragDistance())) {
    const double per_pixel = static_cast<double>(view_->span()) / area().width();
    view_->pan(static_cast<Nanoseconds>((*drag_x_ - x) * per_pixel));
    drag_x_ = x;
    dragged_ = true;
  }
  point(event->position());
}

/// A click marks the slave, and the moment with cursor A, as the keys do; on an event it goes to that.
void HeatMapPlot::mouseReleaseEvent(QMouseEvent* event) {
  if (!std::exchange(drag_x_, std::nullopt) || dragged_) return;
  if (const auto spot = markAt(event->position())) {
    const auto& mark = spot->mark;
    if (rowOf(mark.slave) >= 0) {
      setSelected(mark.slave);
      Q_EMIT slaveSelected(selected_);
    }
    Q_EMIT eventClicked(mark.time);
    return;
  }
  const auto spot = spotAt(event->position());
  if (!spot) return;
  setSelected(static_cast<int>(spot->slave));
  cursors_->set(CursorSet::kA, momentOf(spot->slave, spot->column));
  Q_EMIT slaveSelected(selected_);
}

void HeatMapPlot::mouseDoubleClickEvent(QMouseEvent* event) {
  if (const auto spot = spotAt(event->position())) activate(spot->slave, spot->column);
}

void HeatMapPlot::activate(std::size_t slave, std::size_t column) {
  Q_EMIT momentActivated(static_cast<int>(slave), momentOf(slave, column));
}

void HeatMapPlot::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  if (event->modifiers().testFlag(Qt::ShiftModifier)) {
    view_->pan(static_cast<Nanoseconds>(-notches * 0.1 * static_cast<double>(view_->span())));
  } else if (notches != 0) {
    view_->zoom(std::pow(kHeatZoomPerNotch, notches), timeAt(event->position().x()));
  }
  event->accept();
}

void HeatMapPlot::leaveEvent(QEvent*) { point(std::nullopt); }

void HeatMapPlot::contextMenuEvent(QContextMenuEvent* event) {
  Q_EMIT menuRequested(event->globalPos(), timeAt(event->pos().x()));
}

void HeatMapPlot::step(int by) {
  std::vector<std::size_t> slaves;
  for (const auto& row : rows_) {
    if (!row.is_reference) slaves.push_back(row.slave);
  }
  if (slaves.empty()) return;
  const auto last = static_cast<std::ptrdiff_t>(slaves.size()) - 1;
  const auto now = std::ranges::find(slaves, static_cast<std::size_t>(std::max(selected_, 0)));
  const auto place = selected_ < 0 || now == slaves.end() ? (by > 0 ? 0 : last) : now - slaves.begin() + by;
  setSelected(static_cast<int>(slaves[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(place, 0, last))]));
  Q_EMIT slaveSelected(selected_);
}

void HeatMapPlot::activateSelected() {
  const auto slave = static_cast<std::size_t>(std::max(selected_, 0));
  if (selected_ < 0 || slave >= cells_.slaves() || cells_.row(slave).empty()) return;
  const auto cells = cells_.row(slave);
  const auto worst = std::ranges::max_element(cells);
  if (*worst >= 0) activate(slave, static_cast<std::size_t>(worst - cells.begin()));
}

void HeatMapPlot::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Up:
      return step(-1);
    case Qt::Key_Down:
      return step(1);
    case Qt::Key_PageUp:
      return step(-kHeatPage);
    case Qt::Key_PageDown:
      return step(kHeatPage);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return activateSelected();
    default:
      break;
  }
  // Time is the strip's.
  QWidget::keyPressEvent(event);
}

void HeatMapPlot::resizeEvent(QResizeEvent*) { dirty_ = true; }

void HeatMapPlot::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) measureNames();
  if (event->type() == QEvent::PaletteChange) updateTheme();
  dirty_ = true;
}

void HeatMapPlot::updateTheme() {
  scale_ = HeatScale(palette());
  drawn_full_ = 0;
  marks_.setColors(theme::toneColor(palette(), theme::Tone::kBad), theme::toneColor(palette(), theme::Tone::kGood),
                   palette().color(QPalette::WindowText));
}

}  // namespace syncline::ui
