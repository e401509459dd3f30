// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/bathtub_plot.h"

#include <qwt_clipper.h>
#include <qwt_painter.h>

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/plots/plot_colors.h"
#include "ui/text/units.h"
#include "ui/theme/theme.h"
#include "ui/widgets/spoken_value.h"

namespace syncline::ui {
namespace {

constexpr double kTubLeft = 52;
constexpr int kDecades = 9;

}  // namespace

BathtubPlot::BathtubPlot(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  speaksValue(*this);
  setToolTip(tr(
      "From one SYNC0 to the next: how probable it is that the outputs come later than a moment (the line that falls "
      "to the right), and earlier (the one that falls to the left). Dashed is what comes out if the rarest arrivals "
      "go on as they begin; shaded is what the slave needs for calculating and copying."));
}

void BathtubPlot::setPicture(Picture picture) {
  if (picture == picture_) return;
  picture_ = std::move(picture);
  update();
}

Sync0Period BathtubPlot::period() const { return {*this, picture_.period, kTubLeft}; }
QRectF BathtubPlot::area() const { return period().area(); }

QPointF BathtubPlot::placeOf(double phase, double probability) const {
  const auto box = area();
  return {period().xOf(phase), box.top() - box.height() * std::log10(probability) / kDecades};
}

void BathtubPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (picture_.period <= 0) return;
  period().drawMarks(painter);
  drawDecades(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  drawWall(painter, picture_.bathtub.early, false);
  drawWall(painter, picture_.bathtub.late, true);
  painter.setRenderHint(QPainter::Antialiasing, false);
  period().drawSync0(painter, picture_.calc_and_copy);
}

void BathtubPlot::drawDecades(QPainter& painter) const {
  const auto box = area();
  const auto grid = QPen(plot_colors::grid(palette()), 0);
  const int every = box.height() / kDecades < painter.fontMetrics().height() ? 3 : 1;
  for (int decade = 0; decade <= kDecades; ++decade) {
    const double y = placeOf(0, std::pow(10.0, -decade)).y();
    painter.setPen(grid);
    painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
    if (decade % every != 0) continue;
    painter.setPen(theme::mutedText(palette()));
    painter.drawText(QRectF(0, y - 10, kTubLeft - 5, 20), Qt::AlignRight | Qt::AlignVCenter, decadeText(decade));
  }
}

void BathtubPlot::drawWall(QPainter& painter, const std::vector<ArrivalBathtub::Point>& wall, bool late) const {
  QPolygonF seen, guessed;
  for (const auto& point : wall) {
    const double phase = late ? static_cast<double>(picture_.period) - point.room : point.room;
    const auto place = placeOf(phase, point.probability);
    if (point.extrapolated && guessed.isEmpty() && !seen.isEmpty()) guessed.append(seen.last());
    (point.extrapolated ? guessed : seen).append(place);
  }
  painter.setBrush(Qt::NoBrush);
  const auto color = plot_colors::trace(palette(), late ? 0 : 1);
  // An SVG has no clip.
  painter.setPen(QPen(color, 1.6));
  QwtPainter::drawPolyline(&painter, QwtClipper::clippedPolygonF(area(), seen));
  painter.setPen(QPen(color, 1.6, Qt::DashLine));
  QwtPainter::drawPolyline(&painter, QwtClipper::clippedPolygonF(area(), guessed));
}

}  // namespace syncline::ui
