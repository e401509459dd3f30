// SPDX-License-Identifier: Apache-2.0
#include <qwt_scale_map.h>

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "ui/plots/cursor_item.h"
#include "ui/plots/hatch.h"
#include "ui/plots/heat_map_plot.h"
#include "ui/plots/plot_colors.h"
#include "ui/plots/round_step.h"
#include "ui/plots/small_font.h"
#include "ui/plots/time_axis.h"
#include "ui/plots/time_view.h"
#include "ui/theme/theme.h"

namespace syncline::ui {
namespace {

constexpr double kLowestSeparated = 6, kMarkHeight = 7;

}  // namespace

void HeatMapPlot::drawRows(QPainter& painter) const {
  const auto all = area();
  const auto base = palette().color(QPalette::Base);
  // Colours hide what lies below: only what has none is hatched.
  if (const auto below = image_.isNull() ? all : pixelsOf(missing_); !below.isEmpty()) {
    painter.fillRect(below, base);
    fillHatched(painter, below, noReadingColor(palette()));
  }
  if (!image_.isNull()) painter.drawImage(all, image_);
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
  const auto all = area();
  const auto axis = timeAxisOf(*view_, std::max(static_cast<int>(all.width() / 64), 2));
  const double foot = eventsArea().bottom();
  const double begin = axis.begin / axis.divisor;
  const double end = axis.end / axis.divisor;
  const auto mark = [&](double x, const QString& label) {
    painter.setPen(QPen(plot_colors::envelope(palette()), 0));
    painter.drawLine(QPointF(x, foot), QPointF(x, foot + 3));
    painter.setPen(theme::mutedText(palette()));
    QRectF box(x - 40, foot + 3, 80, 14);
    box.moveRight(std::min(box.right(), width() - 1 + 40.0 - painter.fontMetrics().horizontalAdvance(label) / 2.0));
    painter.drawText(box, Qt::AlignCenter, label);
  };
  for (const auto& tick : axis.ticks) mark(all.left() + (tick.value - begin) / (end - begin) * all.width(), tick.label);
  const double step = roundStep((end - begin) * 64 / std::max(all.width(), 64.0));
  const int digits = std::clamp(-static_cast<int>(std::floor(std::log10(step) + 1e-9)), 0, 9);
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  for (double tick = std::ceil(begin / step - 1e-9) * step; !axis.labelled && tick <= end + step * 1e-6; tick += step) {
    auto label = locale.toString(std::abs(tick) < step / 1e6 ? 0 : tick, 'f', digits);
    if (label.startsWith(u'-')) label.replace(0, 1, QChar(0x2212));
    mark(all.left() + (tick - begin) / (end - begin) * all.width(), label);
  }
  painter.setPen(theme::mutedText(palette()));
  painter.drawText(QRectF(all.left(), foot + 16, all.width(), 15), Qt::AlignCenter,
                   axis.unit.isEmpty() ? axis.quantity : axis.quantity + QStringLiteral(" / ") + axis.unit);
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

/// A mark on the cells has an edge in the colour of the ground: it shall be seen on any colour of the scale.
void HeatMapPlot::drawEvents(QPainter& painter, const QwtScaleMap& x) {
  marks_.prepare(grid());
  marks_.draw(&painter, x, QwtScaleMap(), eventsArea());
  const auto all = area();
  const double width = all.width() / std::max(grid().columns, 1);
  std::map<std::pair<std::ptrdiff_t, std::int64_t>, bool> of_slaves;
  for (const auto& mark : marks_.within(grid().origin, grid().end())) {
    if (const auto row = rowOf(mark.slave); row >= 0)
      of_slaves[{row, static_cast<std::int64_t>(grid().column_of(mark.time))}] |= mark.fault;
  }
  painter.setRenderHint(QPainter::Antialiasing, true);
  painter.setPen(QPen(palette().color(QPalette::Base), 1));
  for (const auto& [place, fault] : of_slaves) {
    const auto row = rowArea(static_cast<std::size_t>(place.first));
    const double at = all.left() + (static_cast<double>(place.second) + 0.5) * width;
    drawEventMark(painter, {at, row.center().y() + kMarkHeight / 2}, fault, marks_.color(fault));
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
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
  drawEvents(painter, x);
  auto cursors = CursorItem(cursors_);
  cursors.setColors(plot_colors::cursor(palette()), palette().color(QPalette::Base));
  cursors.prepare(grid());
  cursors.draw(&painter, x, QwtScaleMap(), all);
  if (!hasFocus()) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 0));
  painter.drawRect(all.adjusted(0, 0, -1, -1));
}

}  // namespace syncline::ui
