// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/legend_bar.h"

#include <QPainter>
#include <QStringList>

#include "ui/theme.h"

namespace syncline::ui {
namespace {

constexpr int kSwatch = 14, kGap = 4, kBetween = 12;

}  // namespace

LegendBar::LegendBar(QWidget* parent) : QWidget(parent) {
  auto small = font();
  small.setPointSizeF(small.pointSizeF() * 0.92);
  setFont(small);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void LegendBar::setEntries(std::vector<Entry> entries) {
  if (entries == entries_) return;
  entries_ = std::move(entries);
  setAccessibleDescription(text());
  setToolTip(text().replace(QStringLiteral("; "), QStringLiteral("\n")));
  update();
}

QString LegendBar::text() const {
  QStringList parts;
  for (const auto& entry : entries_) parts << entry.name + u' ' + entry.value;
  return parts.join(QStringLiteral("; "));
}

QSize LegendBar::sizeHint() const { return {200, fontMetrics().height() + 2}; }
QSize LegendBar::minimumSizeHint() const { return {60, fontMetrics().height() + 2}; }

void LegendBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const auto metrics = fontMetrics();
  int x = 0;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const auto& entry = entries_[i];
    const int name_width = metrics.horizontalAdvance(entry.name);
    const int value_width = metrics.horizontalAdvance(entry.value);
    const int width_needed = kSwatch + kGap + name_width + kGap + value_width;
    const auto rest = QStringLiteral("+%1").arg(entries_.size() - i);
    const int reserve = i + 1 < entries_.size() ? kBetween + metrics.horizontalAdvance(rest) : 0;
    if (x > 0 && x + width_needed + reserve > width()) {
      painter.setPen(theme::mutedText(palette()));
      painter.drawText(QRect(x, 0, width() - x, height()), Qt::AlignVCenter, rest);
      break;
    }
    const bool broad = entry.shape == SeriesItem::Shape::kEnvelope;
    painter.fillRect(QRect(x, height() / 2 - (broad ? 4 : 1), kSwatch, broad ? 8 : 3), entry.color);
    x += kSwatch + kGap;
    painter.setPen(theme::mutedText(palette()));
    painter.drawText(QRect(x, 0, name_width + 1, height()), Qt::AlignVCenter, entry.name);
    x += name_width + kGap;
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRect(x, 0, value_width + 1, height()), Qt::AlignVCenter, entry.value);
    x += value_width + kBetween;
  }
}

}  // namespace syncline::ui
