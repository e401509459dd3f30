// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/sync0_period.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QWidget>
#include <algorithm>
#include <cmath>

#include "ui/plots/plot_colors.h"
#include "ui/plots/round_step.h"
#include "ui/plots/small_font.h"
#include "ui/text/units.h"
#include "ui/theme/theme.h"

namespace syncline::ui {
namespace {

constexpr int kMarks = 8;  // at most
constexpr int kTooLateAlpha = 30, kWordAlpha = 200;

}  // namespace

Sync0Period::Sync0Period(const QWidget& plot, Nanoseconds period, double left)
    : plot_(plot), period_(period), area_(QRectF(plot.rect()).adjusted(left, kTop, -kSide, -kFoot)) {}

void Sync0Period::drawMarks(QPainter& painter) const {
  const auto palette = plot_.palette();
  painter.setFont(smallFont(plot_.font()));
  const double step = roundStep(static_cast<double>(period_) / kMarks);
  for (double at = 0; at <= static_cast<double>(period_); at += step) {
    const double x = xOf(at);
    painter.setPen(QPen(plot_colors::grid(palette), 0));
    painter.drawLine(QPointF(x, area_.top()), QPointF(x, area_.bottom()));
    painter.setPen(theme::mutedText(palette));
    painter.drawText(QRectF(x - kSide, area_.bottom() + 2, 2 * kSide, kFoot), Qt::AlignHCenter | Qt::AlignTop,
                     cycleText(static_cast<Nanoseconds>(std::llround(at))));
  }
}

void Sync0Period::drawSync0(QPainter& painter, std::optional<Nanoseconds> calc_and_copy) const {
  const auto palette = plot_.palette();
  if (calc_and_copy) {
    const double left = xOf(static_cast<double>(std::max<Nanoseconds>(period_ - *calc_and_copy, 0)));
    auto too_late = plot_colors::limitLine(palette);  // what comes there is not used by this SYNC0
    too_late.setAlpha(kTooLateAlpha);
    painter.fillRect(QRectF(left, area_.top(), area_.right() - left, area_.height()), too_late);
    painter.setPen(QPen(plot_colors::limitLine(palette), 0, Qt::DashLine));
    painter.drawLine(QPointF(left, area_.top()), QPointF(left, area_.bottom()));
    nameLine(painter, left);
  }
  painter.setFont(smallFont(plot_.font()));
  for (const double x : {area_.left(), area_.right()}) {
    painter.setPen(QPen(palette.color(QPalette::Text), 2));
    painter.drawLine(QPointF(x, area_.top()), QPointF(x, area_.bottom()));
    painter.drawText(QRectF(x - kSide, 0, 2 * kSide, kTop), Qt::AlignCenter, QStringLiteral("SYNC0"));
  }
}

/// In front of the line, where there is room: behind it stands the SYNC0.
void Sync0Period::nameLine(QPainter& painter, double x) const {
  painter.setFont(smallFont(plot_.font()));
  const auto word = QCoreApplication::translate("CyclePlot", "calculating and copying");
  const QFontMetricsF metrics(painter.font());
  const QRectF box(x - metrics.horizontalAdvance(word) - 8, area_.top() + 2, metrics.horizontalAdvance(word) + 4,
                   metrics.height());
  if (box.left() < area_.left() + 4) return;
  auto ground = plot_.palette().color(QPalette::Base);
  ground.setAlpha(kWordAlpha);
  painter.fillRect(box, ground);
  painter.setPen(plot_colors::limitLine(plot_.palette()));
  painter.drawText(box, Qt::AlignCenter, word);
}

}  // namespace syncline::ui
