// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/histogram_plot.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/plots/plot_colors.h"
#include "ui/plots/round_step.h"
#include "ui/plots/small_font.h"
#include "ui/text/units.h"
#include "ui/theme/theme.h"
#include "ui/widgets/spoken_value.h"

namespace syncline::ui {
namespace {

constexpr int kTitle = 15;  // of the counts, on its side
constexpr int kLeft = 46 + kTitle, kRight = 8, kTop = 6, kBottom = 32;
constexpr double kEndBar = 16, kEndGap = 5;
constexpr std::ptrdiff_t kNoBin = -2;

}  // namespace

HistogramPlot::HistogramPlot(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  speaksValue(*this);
}

void HistogramPlot::setData(const BinGrid& grid, std::vector<Steps> steps, double limit, const QString& unit) {
  if (grid == grid_ && steps == steps_ && limit == limit_ && unit == unit_) return;
  if (grid != grid_) chosen_ = kNoBin;
  grid_ = grid;
  steps_ = std::move(steps);
  limit_ = limit;
  unit_ = unit;
  std::uint64_t highest = 1;
  for (const auto& one : steps_) {
    for (const auto count : one.bins) highest = std::max(highest, count);
    highest = std::max({highest, one.below, one.above});
  }
  decades_ = std::max(1, static_cast<int>(std::floor(std::log10(static_cast<double>(highest)))) + 1);
  update();
}

void HistogramPlot::setChosen(std::ptrdiff_t bin) {
  chosen_ = bin;
  update();
}

QRectF HistogramPlot::area() const {
  return QRectF(rect()).adjusted(kLeft + kEndBar + kEndGap, kTop, -kRight - kEndBar - kEndGap, -kBottom);
}

double HistogramPlot::xOf(double value) const {
  return area().left() + (value - grid_.low) / (grid_.high - grid_.low) * area().width();
}

/// A single sample is seen: half a decade of room is below it.
double HistogramPlot::heightOf(std::uint64_t count) const {
  if (count == 0) return 0;
  return (std::log10(static_cast<double>(count)) + 0.5) / (decades_ + 0.5) * area().height();
}

QRectF HistogramPlot::binArea(std::ptrdiff_t bin) const {
  const auto all = area();
  if (bin < 0) return {all.left() - kEndGap - kEndBar, all.top(), kEndBar, all.height()};
  const auto bins = static_cast<std::ptrdiff_t>(grid_.bins);
  if (bin >= bins) return {all.right() + kEndGap, all.top(), kEndBar, all.height()};
  const double width = all.width() / static_cast<double>(bins);
  return {all.left() + static_cast<double>(bin) * width, all.top(), width, all.height()};
}

std::ptrdiff_t HistogramPlot::binAt(const QPointF& point) const {
  const auto all = area();
  if (point.y() < all.top() || point.y() > all.bottom() + 4) return kNoBin;
  const auto bins = static_cast<std::ptrdiff_t>(grid_.bins);
  if (binArea(-1).contains(point)) return -1;
  if (binArea(bins).contains(point)) return bins;
  if (point.x() < all.left() || point.x() >= all.right()) return kNoBin;
  return std::min(static_cast<std::ptrdiff_t>((point.x() - all.left()) / all.width() * static_cast<double>(bins)),
                  bins - 1);
}

void HistogramPlot::drawAxes(QPainter& painter) const {
  const auto all = area();
  const QLocale locale;
  const auto text = theme::mutedText(palette());
  for (int decade = 0; decade <= decades_; ++decade) {
    const double y = all.bottom() - (decade + 0.5) / (decades_ + 0.5) * all.height();
    painter.setPen(QPen(plot_colors::grid(palette()), 0));
    painter.drawLine(QPointF(kLeft, y), QPointF(width() - kRight, y));
    const int every = decades_ * painter.fontMetrics().height() > all.height() ? 2 : 1;
    if (decade % every != 0) continue;
    painter.setPen(text);
    painter.drawText(QRectF(0, y - 10, kLeft - 4, 20), Qt::AlignRight | Qt::AlignVCenter, countDecadeText(decade));
  }
  const double step = roundStep((grid_.high - grid_.low) * 64 / std::max(all.width(), 64.0));
  const int digits = std::max(0, -static_cast<int>(std::floor(std::log10(step))));
  for (double value = std::ceil(grid_.low / step) * step; value <= grid_.high * (1 + 1e-9); value += step) {
    painter.setPen(QPen(plot_colors::grid(palette()), 0));
    painter.drawLine(QPointF(xOf(value), all.top()), QPointF(xOf(value), all.bottom()));
    painter.setPen(text);
    auto label = locale.toString(std::abs(value) < step / 1e6 ? 0 : value, 'f', digits);
    painter.drawText(QRectF(xOf(value) - 40, all.bottom() + 1, 80, 15), Qt::AlignCenter, label);
  }
  painter.setPen(text);
  painter.drawText(QRectF(kLeft, height() - 16, width() - kLeft - kRight, 15), Qt::AlignCenter,
                   unit_.isEmpty() ? tr("Value") : tr("Value / %1").arg(unit_));
  const auto count = tr("Number of values");
  const auto high = painter.fontMetrics().horizontalAdvance(count);
  if (high <= all.height()) {
    painter.save();
    painter.translate(0, all.center().y());
    painter.rotate(-90);
    painter.drawText(QRectF(-high, 0, 2.0 * high, kTitle), Qt::AlignCenter, count);
    painter.restore();
  }
  painter.drawText(binArea(-1).adjusted(-8, 0, 8, 16), Qt::AlignHCenter | Qt::AlignBottom, QStringLiteral("<"));
  painter.drawText(binArea(static_cast<std::ptrdiff_t>(grid_.bins)).adjusted(-8, 0, 8, 16),
                   Qt::AlignHCenter | Qt::AlignBottom, QStringLiteral("\u2265"));
}

void HistogramPlot::drawSteps(QPainter& painter, const Steps& steps) const {
  auto fill = steps.color;
  fill.setAlpha(steps_.size() == 1 ? 150 : 70);
  const double bottom = area().bottom();
  const auto bar = [&](std::ptrdiff_t bin, std::uint64_t count) {
    if (count == 0) return;
    auto box = binArea(bin);
    box.setTop(bottom - heightOf(count));
    painter.fillRect(box, fill);
    painter.setPen(QPen(steps.color, 0));
    painter.drawLine(box.topLeft(), box.topRight());
  };
  bar(-1, steps.below);
  bar(static_cast<std::ptrdiff_t>(steps.bins.size()), steps.above);
  double before = 0;
  for (std::size_t i = 0; i < steps.bins.size(); ++i) {
    bar(static_cast<std::ptrdiff_t>(i), steps.bins[i]);
    const double now = heightOf(steps.bins[i]);
    const double x = binArea(static_cast<std::ptrdiff_t>(i)).left();
    painter.setPen(QPen(steps.color, 0));
    if (now != before) painter.drawLine(QPointF(x, bottom - before), QPointF(x, bottom - now));
    before = now;
  }
}

void HistogramPlot::drawLimit(QPainter& painter) const {
  if (limit_ <= 0) return;
  painter.setPen(QPen(plot_colors::limitLine(palette()), 0, Qt::DashLine));
  for (const double value : {-limit_, limit_}) {
    if (value < grid_.low || value > grid_.high) continue;
    painter.drawLine(QPointF(xOf(value), area().top()), QPointF(xOf(value), area().bottom()));
  }
  const bool outside = limit_ > grid_.high;
  const auto text = tr("limit \u00B1%1 %2").arg(QLocale().toString(limit_, 'g', 6), unit_) +
                    (outside ? QStringLiteral(" \u2192") : QString());
  QRectF box(0, 0, painter.fontMetrics().horizontalAdvance(text) + 6, painter.fontMetrics().height());
  const double x = outside ? area().right() : xOf(limit_);
  box.moveTopLeft(QPointF(std::max(area().left(), x - box.width() - 2), area().top() + 1));
  auto background = palette().color(QPalette::Base);
  background.setAlpha(215);
  painter.fillRect(box, background);
  painter.setPen(plot_colors::limitLine(palette()));
  painter.drawText(box, Qt::AlignCenter, text);
}

void HistogramPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setFont(smallFont(font()));
  painter.fillRect(QRectF(rect()).adjusted(kLeft, kTop, -kRight, -kBottom), palette().color(QPalette::Base));
  drawAxes(painter);
  for (const auto& one : steps_) drawSteps(painter, one);
  drawLimit(painter);
  if (chosen_ > kNoBin) {
    painter.setPen(QPen(palette().color(QPalette::Text), 0));
    painter.drawRect(binArea(chosen_).adjusted(0, 0, -1, -1));
  }
  if (hasFocus()) {
    painter.setPen(QPen(palette().color(QPalette::Highlight), 0));
    painter.drawRect(QRectF(rect()).adjusted(kLeft, kTop, -kRight - 1, -kBottom - 1));
  }
}

QString HistogramPlot::textOf(std::ptrdiff_t bin) const {
  const QLocale locale;
  const auto bins = static_cast<std::ptrdiff_t>(grid_.bins);
  const auto number = [&](double value) { return locale.toString(value, 'g', 6) + u' ' + unit_; };
  auto text = bin < 0       ? tr("below %1").arg(number(grid_.low))
              : bin >= bins ? tr("%1 and more").arg(number(grid_.high))
                            : tr("%1 to %2")
                                  .arg(number(grid_.low + static_cast<double>(bin) * grid_.width()),
                                       number(grid_.low + static_cast<double>(bin + 1) * grid_.width()));
  for (const auto& one : steps_) {
    const auto count = bin < 0 ? one.below : bin >= bins ? one.above : one.bins[static_cast<std::size_t>(bin)];
    text += u'\n' + one.name + QStringLiteral(": ") + countText(count);
  }
  return text;
}

void HistogramPlot::mousePressEvent(QMouseEvent* event) {
  const auto bin = binAt(event->position());
  if (event->button() != Qt::LeftButton || bin == kNoBin) return QWidget::mousePressEvent(event);
  setChosen(bin);
  Q_EMIT binClicked(bin);
}

void HistogramPlot::mouseMoveEvent(QMouseEvent* event) {
  const auto bin = binAt(event->position());
  setToolTip(bin == kNoBin ? QString() : textOf(bin));
}

void HistogramPlot::keyPressEvent(QKeyEvent* event) {
  const int by = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
  if (by == 0) return QWidget::keyPressEvent(event);
  const auto bins = static_cast<std::ptrdiff_t>(grid_.bins);
  setChosen(chosen_ == kNoBin ? (by > 0 ? -1 : bins) : std::clamp<std::ptrdiff_t>(chosen_ + by, -1, bins));
  Q_EMIT binClicked(chosen_);
}

}  // namespace syncline::ui
