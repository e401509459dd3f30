// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/heat_legend.h"

#include <QPainter>
#include <cmath>

#include "ui/plots/hatch.h"
#include "ui/plots/heat_scale.h"
#include "ui/text/units.h"
#include "ui/theme/theme.h"
#include "ui/widgets/spoken_value.h"

namespace syncline::ui {
namespace {

constexpr int kBarWidth = 90, kBarHeight = 10, kBox = 14, kTextGap = 5, kApart = 12;

}  // namespace

HeatLegend::HeatLegend(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
  speaksValue(*this);
  setToolTip(
      tr("The largest magnitude of register 0x092C in each cell. Between two readings the older one holds; a cell is "
         "hatched where the slave was not read for longer than a few readings take, or no frame came back."));
}

void HeatLegend::setScale(double full, bool is_limit) {
  if (full == full_ && is_limit == is_limit_) return;
  full_ = full;
  is_limit_ = is_limit;
  sayValue(*this, text());
  updateGeometry();
  update();
}

QString HeatLegend::fullText() const {
  const auto value = timeText(static_cast<Nanoseconds>(std::llround(full_)));
  return is_limit_ ? tr("limit %1").arg(value) : value;
}

QString HeatLegend::text() const {
  auto said = QStringLiteral("0 \u2013 ") + fullText();
  if (is_limit_) said += QStringLiteral(", ") + tr("over");
  return said + QStringLiteral(", ") + tr("no reading");
}

QSize HeatLegend::sizeHint() const {
  const auto metrics = fontMetrics();
  int wide = metrics.horizontalAdvance(u'0') + kTextGap + kBarWidth + kTextGap + metrics.horizontalAdvance(fullText());
  wide += kApart + kBox + kTextGap + metrics.horizontalAdvance(tr("no reading"));
  if (is_limit_) wide += kApart + kBox + kTextGap + metrics.horizontalAdvance(tr("over"));
  return {wide + 4, metrics.height() + 2};
}

void HeatLegend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const auto metrics = fontMetrics();
  const HeatScale scale(palette());
  int x = 0;
  const int top = (height() - kBarHeight) / 2;
  const auto say = [&](const QString& text) {
    painter.setPen(theme::mutedText(palette()));
    const int wide = metrics.horizontalAdvance(text);
    painter.drawText(QRect(x, 0, wide + 2, height()), Qt::AlignVCenter | Qt::AlignLeft, text);
    x += wide + kTextGap;
  };
  const auto box = [&](const auto& fill, int wide) {
    const QRect place(x, top, wide, kBarHeight);
    painter.fillRect(place, palette().color(QPalette::Base));
    fill(place);
    painter.setPen(QPen(theme::outline(palette()), 0));
    painter.drawRect(place.adjusted(0, 0, -1, -1));
    x += wide + kTextGap;
  };
  say(QStringLiteral("0"));
  for (int i = 0; i < kBarWidth; ++i) {
    painter.fillRect(QRect(x + i, top, 1, kBarHeight), QColor(scale.color(static_cast<float>(i) / (kBarWidth - 1))));
  }
  x += kBarWidth + kTextGap;
  say(fullText());
  if (is_limit_) {
    x += kApart - kTextGap;
    box([&](const QRect& place) { painter.fillRect(place, QColor(scale.over())); }, kBox);
    say(tr("over"));
  }
  x += kApart - kTextGap;
  box([&](const QRect& place) { fillHatched(painter, place, noReadingColor(palette())); }, kBox);
  say(tr("no reading"));
}

}  // namespace syncline::ui
