// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/cycle_plot.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/plots/plot_colors.h"
#include "ui/plots/small_font.h"
#include "ui/text/units.h"
#include "ui/theme/theme.h"
#include "ui/widgets/spoken_value.h"

namespace syncline::ui {
namespace {

constexpr double kLeastStrength = 0.2;  // of the oldest

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

Sync0Period CyclePlot::period() const { return {*this, picture_.period}; }
QRectF CyclePlot::area() const { return period().area(); }
double CyclePlot::xOf(Nanoseconds phase) const { return period().xOf(static_cast<double>(phase)); }

void CyclePlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (picture_.period <= 0) return;
  period().drawMarks(painter);
  std::uint64_t most = 1;
  for (const auto& bin : picture_.figures.bins) most = std::max(most, bin.count);
  drawCounts(painter, most);
  drawBars(painter, most);
  drawNominal(painter);
  period().drawSync0(painter, picture_.calc_and_copy);
}

/// A single arrival is seen: a decade of room is below it.
double CyclePlot::heightOf(std::uint64_t count, std::uint64_t most) const {
  return area().height() * (std::log10(static_cast<double>(count)) + 1) / (std::log10(static_cast<double>(most)) + 1);
}

void CyclePlot::drawCounts(QPainter& painter, std::uint64_t most) const {
  const auto box = area();
  painter.setFont(smallFont(font()));
  const double high = painter.fontMetrics().height();
  const double apart = heightOf(10, most) - heightOf(1, most);
  const int every = apart < high ? 2 : 1;
  const int decades = static_cast<int>(std::log10(static_cast<double>(most)) + 1e-9);
  std::uint64_t count = 1;
  for (int decade = 0; decade <= decades; ++decade, count *= 10) {
    const double y = box.bottom() - heightOf(count, most);
    painter.setPen(QPen(plot_colors::grid(palette()), 0));
    painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
    if (decade % every != 0) continue;
    painter.setPen(theme::mutedText(palette()));
    painter.drawText(QRectF(0, y - high, box.left() - 4, 2 * high), Qt::AlignRight | Qt::AlignVCenter,
                     countDecadeText(decade));
  }
}

void CyclePlot::drawBars(QPainter& painter, std::uint64_t most) const {
  const auto box = area();
  const auto bins = static_cast<double>(picture_.figures.bins.size());
  for (std::size_t i = 0; i < picture_.figures.bins.size(); ++i) {
    const auto& bin = picture_.figures.bins[i];
    if (bin.count == 0) continue;
    const double height = heightOf(bin.count, most);
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
  if (x - width / 2 < box.left() + Sync0Period::kSide || x + width / 2 > box.right() - Sync0Period::kSide) return;
  painter.drawText(QRectF(x - width / 2, 0, width, Sync0Period::kTop), Qt::AlignCenter, word);
}

}  // namespace syncline::ui
