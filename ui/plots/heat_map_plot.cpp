// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/heat_map_plot.h"

#include <qwt_scale_map.h>

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/plots/plot_colors.h"
#include "ui/plots/round_step.h"
#include "ui/plots/signal_source.h"
#include "ui/plots/small_font.h"
#include "ui/plots/time_axis.h"
#include "ui/theme/theme.h"

namespace syncline::ui {
namespace {

constexpr int kHeatTop = 2, kHeatRight = 12, kHeatBottom = 32;
constexpr int kMostNameWidth = 130;
constexpr double kHighestRow = 30, kLowestSeparated = 6;
constexpr double kHeatZoomPerNotch = 0.8;
constexpr int kHeatPage = 10;  // rows

}  // namespace

HeatMapPlot::HeatMapPlot(TimeView* view, CursorSet* cursors, QWidget* parent)
    : QWidget(parent), view_(view), cursors_(cursors), scale_(palette()) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
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
  pointed_.reset();
  dirty_ = true;
}

void HeatMapPlot::setRows(std::vector<Row> rows) {
  if (rows == rows_) return;
  rows_ = std::move(rows);
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
  const double room = std::max(height() - kHeatTop - kHeatBottom, 1);
  return std::min(room / static_cast<double>(std::max<std::size_t>(rows_.size(), 1)), kHighestRow);
}

QRectF HeatMapPlot::area() const {
  const int left = namesWidth();
  return {static_cast<double>(left), kHeatTop, static_cast<double>(std::max(width() - left - kHeatRight, 1)),
          rowHeight() * static_cast<double>(std::max<std::size_t>(rows_.size(), 1))};
}

QRectF HeatMapPlot::rowArea(std::size_t row) const {
  auto box = area();
  box.setTop(box.top() + rowHeight() * static_cast<double>(row));
  box.setHeight(rowHeight());
  return box;
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
  if (pointer_) point(spotAt(*pointer_));
  update();
}

/// A pixel a cell; where rows are lower than a pixel, one for the worst of those that share it.
void HeatMapPlot::makeImage() {
  const auto columns = cells_.grid().columns;
  const auto lines = std::min(rows_.size(), static_cast<std::size_t>(std::max(area().height(), 1.0)));
  if (lines == 0 || columns == 0 || cells_.slaves() == 0) {
    image_ = QImage();
    return;
  }
  if (full_ <= 0) {
    float largest = 0;
    for (const auto& row : rows_) largest = std::max(largest, std::ranges::max(cells_.row(row.slave)));
    full_ = roundStep(std::max(static_cast<double>(largest), 1.0));
  }
  const QSize size(static_cast<int>(columns), static_cast<int>(lines));
  if (image_.size() != size) image_ = QImage(size, QImage::Format_ARGB32_Premultiplied);
  const auto part = static_cast<float>(1 / full_);
  std::vector<float> worst(columns);
  for (std::size_t line = 0; line < lines; ++line) {
    std::ranges::fill(worst, SlaveCells::kNoReading);
    for (auto row = line * rows_.size() / lines; row < (line + 1) * rows_.size() / lines; ++row) {
      if (rows_[row].slave >= cells_.slaves()) continue;
      const auto cells = cells_.row(rows_[row].slave);
      for (std::size_t i = 0; i < columns; ++i) worst[i] = std::max(worst[i], cells[i]);
    }
    auto* pixels = reinterpret_cast<QRgb*>(image_.scanLine(static_cast<int>(line)));
    for (std::size_t i = 0; i < columns; ++i) pixels[i] = worst[i] < 0 ? 0 : scale_.color(worst[i] * part);
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

void HeatMapPlot::drawRows(QPainter& painter) const {
  const auto all = area();
  painter.fillRect(all, palette().color(QPalette::Base));
  painter.fillRect(all, QBrush(noReadingColor(palette()), Qt::BDiagPattern));
  if (!image_.isNull()) painter.drawImage(all, image_);
  const auto base = palette().color(QPalette::Base);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto box = rowArea(i);
    if (rows_[i].is_reference) {
      painter.fillRect(box, base);
      painter.setPen(theme::mutedText(palette()));
      if (box.height() >= painter.fontMetrics().height() - 2)
        painter.drawText(box.adjusted(6, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, tr("reference clock"));
    }
    if (box.height() < kLowestSeparated || i == 0) continue;
    painter.setPen(QPen(base, 0));
    painter.drawLine(box.topLeft(), box.topRight());
  }
}

/// As many as have room; that of the marked row in any case.
void HeatMapPlot::drawNames(QPainter& painter) const {
  const double high = painter.fontMetrics().height();
  const auto step = static_cast<std::size_t>(std::max(std::ceil(high / rowHeight() - 0.1), 1.0));
  const bool any_marked = rowOf(selected_) >= 0;
  const auto marked = static_cast<std::size_t>(std::max<std::ptrdiff_t>(rowOf(selected_), 0));
  const auto box = [&](std::size_t row) {
    QRectF at(0, rowArea(row).center().y() - high / 2, area().left() - 5, high);
    at.moveBottom(std::min(at.bottom(), area().bottom() + high / 2));
    return at;
  };
  const auto draw = [&](std::size_t row, const QColor& color) {
    const auto at = box(row);
    painter.setPen(color);
    painter.drawText(at, Qt::AlignRight | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(rows_[row].name, Qt::ElideRight, static_cast<int>(at.width())));
  };
  for (std::size_t row = 0; row < rows_.size(); row += step) {
    if (any_marked && std::abs(box(row).center().y() - box(marked).center().y()) < high) continue;
    draw(row, theme::mutedText(palette()));
  }
  if (!any_marked) return;
  painter.fillRect(box(marked).adjusted(0, 0, 3, 0), palette().color(QPalette::Highlight));
  draw(marked, palette().color(QPalette::HighlightedText));
}

void HeatMapPlot::drawTimes(QPainter& painter) const {
  const auto axis = timeAxisOf(*view_);
  const auto all = area();
  const double begin = axis.begin / axis.divisor;
  const double end = axis.end / axis.divisor;
  const double step = roundStep((end - begin) * 64 / std::max(all.width(), 64.0));
  const int digits = std::clamp(-static_cast<int>(std::floor(std::log10(step) + 1e-9)), 0, 9);
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  for (double tick = std::ceil(begin / step - 1e-9) * step; tick <= end + step * 1e-6; tick += step) {
    const double x = all.left() + (tick - begin) / (end - begin) * all.width();
    painter.setPen(QPen(plot_colors::envelope(palette()), 0));
    painter.drawLine(QPointF(x, all.bottom()), QPointF(x, all.bottom() + 3));
    painter.setPen(theme::mutedText(palette()));
    auto label = locale.toString(std::abs(tick) < step / 1e6 ? 0 : tick, 'f', digits);
    if (label.startsWith(u'-')) label.replace(0, 1, QChar(0x2212));
    QRectF box(x - 40, all.bottom() + 3, 80, 14);
    box.moveRight(std::min(box.right(), width() - 1 + 40.0 - painter.fontMetrics().horizontalAdvance(label) / 2.0));
    painter.drawText(box, Qt::AlignCenter, label);
  }
  painter.setPen(theme::mutedText(palette()));
  painter.drawText(QRectF(all.left(), all.bottom() + 16, all.width(), 15), Qt::AlignCenter,
                   axis.quantity + QStringLiteral(" / ") + axis.unit);
}

void HeatMapPlot::drawSelection(QPainter& painter) const {
  const auto row = rowOf(selected_);
  if (row < 0) return;
  auto box = rowArea(static_cast<std::size_t>(row));
  if (box.height() < 4) box.adjust(0, box.height() / 2 - 2, 0, 2 - box.height() / 2);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette().color(QPalette::Text), 0));
  painter.drawRect(box.adjusted(0, 0, -1, -0.5));
}

void HeatMapPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setFont(smallFont(font()));
  drawRows(painter);
  drawNames(painter);
  drawTimes(painter);
  drawSelection(painter);
  const auto all = area();
  QwtScaleMap x;
  x.setPaintInterval(all.left(), all.right());
  auto cursors = CursorItem(cursors_);
  cursors.setColors(plot_colors::cursor(palette()), palette().color(QPalette::Base));
  cursors.prepare(grid());
  cursors.draw(&painter, x, QwtScaleMap(), all);
  if (!hasFocus()) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 0));
  painter.drawRect(all.adjusted(0, 0, -1, -1));
}

void HeatMapPlot::point(const std::optional<Spot>& spot) {
  pointed_ = spot;
  cursors_->setPointer(spot ? std::optional(spot->time) : std::nullopt);
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
  pointer_ = event->position();
  point(spotAt(*pointer_));
}

/// A click marks the slave, and the moment with cursor A, as the keys do.
void HeatMapPlot::mouseReleaseEvent(QMouseEvent* event) {
  if (!std::exchange(drag_x_, std::nullopt) || dragged_) return;
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

void HeatMapPlot::leaveEvent(QEvent*) {
  pointer_.reset();
  point(std::nullopt);
}

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
  if (event->type() == QEvent::PaletteChange) scale_ = HeatScale(palette());
  dirty_ = true;
}

}  // namespace syncline::ui
