// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/cycle_plot.h"

#include <QFontMetricsF>
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

constexpr double kLeastStrength = 0.2;  // of the oldest
constexpr double kCycleSide = 34, kCycleTop = 20, kCycleFoot = 20;
constexpr int kMarks = 8;

}  // namespace

CyclePlot::CyclePlot(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  speaksValue(*this);
  setToolTip(tr(
      "From one SYNC0 to the next: when the frame with the slave's outputs had ended there, in system time. Bars are "
      "logarithmic counts and fade with the age of their latest arrival; the dotted line is where outputs nominally "
      "come "
      "by the set value; shaded is what the slave needs for calculating and copying."));
}

void CyclePlot::setPicture(Picture picture) {
  if (picture == picture_) return;
  picture_ = std::move(picture);
  update();
}

QRectF CyclePlot::area() const { return QRectF(rect()).adjusted(kCycleSide, kCycleTop, -kCycleSide, -kCycleFoot); }

double CyclePlot::xOf(Nanoseconds phase) const {
  return area().left() + area().width() * static_cast<double>(phase) / static_cast<double>(picture_.period);
}

void CyclePlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (picture_.period <= 0) return;
  drawAxis(painter);
  drawBars(painter);
  drawNominal(painter);
  drawSync0(painter);
}

void CyclePlot::drawAxis(QPainter& painter) const {
  const auto box = area();
  painter.setFont(smallFont(font()));
  const double step = roundStep(static_cast<double>(picture_.period) / kMarks);
  for (double at = 0; at <= static_cast<double>(picture_.period); at += step) {
    const auto phase = static_cast<Nanoseconds>(std::llround(at));
    painter.setPen(QPen(plot_colors::grid(palette()), 0));
    painter.drawLine(QPointF(xOf(phase), box.top()), QPointF(xOf(phase), box.bottom()));
    painter.setPen(theme::mutedText(palette()));
    painter.drawText(QRectF(xOf(phase) - kCycleSide, box.bottom() + 2, 2 * kCycleSide, kCycleFoot),
                     Qt::AlignHCenter | Qt::AlignTop, cycleText(phase));
  }
}

void CyclePlot::drawBars(QPainter& painter) const {
  const auto box = area();
  std::uint64_t most = 1;
  for (const auto& bin : picture_.figures.bins) most = std::max(most, bin.count);
  const double full = std::log10(static_cast<double>(most)) + 1;
  const auto bins = static_cast<double>(picture_.figures.bins.size());
  for (std::size_t i = 0; i < picture_.figures.bins.size(); ++i) {
    const auto& bin = picture_.figures.bins[i];
    if (bin.count == 0) continue;
    const double height = box.height() * (std::log10(static_cast<double>(bin.count)) + 1) / full;
    const double age = static_cast<double>(picture_.end - bin.newest) /
                       static_cast<double>(std::max<Nanoseconds>(picture_.end - picture_.begin, 1));
    auto color = plot_colors::trace(palette(), 0);
    color.setAlphaF(static_cast<float>(1 - (1 - kLeastStrength) * std::clamp(age, 0.0, 1.0)));
    const double left = box.left() + box.width() * static_cast<double>(i) / bins;
    painter.fillRect(QRectF(left, box.bottom() - height, std::max(box.width() / bins, 1.0), height), color);
  }
}

void CyclePlot::drawNominal(QPainter& painter) const {
  if (!picture_.nominal) return;
  const auto box = area();
  const double x = xOf(*picture_.nominal);
  painter.setPen(QPen(palette().color(QPalette::Text), 1, Qt::DotLine));
  painter.drawLine(QPointF(x, box.top()), QPointF(x, box.bottom()));
  // Not where it would run into the word at either SYNC0.
  painter.setFont(smallFont(font()));
  const auto word = tr("nominal");
  const double width = QFontMetricsF(painter.font()).horizontalAdvance(word) + 4;
  if (x - width / 2 < box.left() + kCycleSide || x + width / 2 > box.right() - kCycleSide) return;
  painter.drawText(QRectF(x - width / 2, 0, width, kCycleTop), Qt::AlignCenter, word);
}

void CyclePlot::drawSync0(QPainter& painter) const {
  const auto box = area();
  if (picture_.calc_and_copy) {
    const double left = xOf(std::max<Nanoseconds>(picture_.period - *picture_.calc_and_copy, 0));
    painter.fillRect(QRectF(left, box.top(), box.right() - left, box.height()), plot_colors::limitFill(palette()));
    painter.setPen(QPen(plot_colors::limitLine(palette()), 0, Qt::DashLine));
    painter.drawLine(QPointF(left, box.top()), QPointF(left, box.bottom()));
  }
  painter.setFont(smallFont(font()));
  for (const double x : {box.left(), box.right()}) {
    painter.setPen(QPen(palette().color(QPalette::Text), 2));
    painter.drawLine(QPointF(x, box.top()), QPointF(x, box.bottom()));
    painter.drawText(QRectF(x - kCycleSide, 0, 2 * kCycleSide, kCycleTop), Qt::AlignCenter, QStringLiteral("SYNC0"));
  }
}

}  // namespace syncline::ui
