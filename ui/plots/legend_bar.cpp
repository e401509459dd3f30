// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/legend_bar.h"

#include <QHelpEvent>
#include <QPainter>
#include <QStringList>
#include <QToolTip>
#include <algorithm>
#include <utility>

#include "ui/text/joined_text.h"
#include "ui/theme/theme.h"
#include "ui/widgets/spoken_value.h"

namespace syncline::ui {
namespace {

constexpr int kSwatch = 10, kGap = 3, kBetween = 8, kLongestName = 110;
constexpr int kStretch = 25;  // updates, some seconds: digits that are gone for so long leave their room

}  // namespace

LegendBar::LegendBar(QWidget* parent) : QWidget(parent) {
  auto small = font();
  small.setPointSizeF(small.pointSizeF() * 0.92);
  setFont(small);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  speaksValue(*this);
}

void LegendBar::setEntries(std::vector<Entry> entries) {
  if (entries == entries_) return;
  const bool next_stretch = ++updates_ % kStretch == 0;
  rooms_.resize(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    auto& room = rooms_[i];
    if (i >= entries_.size() || entries_[i].name != entries[i].name) room = {};
    if (next_stretch) room = {0, room.latest};
    room.latest = std::max(room.latest, fontMetrics().horizontalAdvance(entries[i].value));
  }
  entries_ = std::move(entries);
  sayValue(*this, text());
  setToolTip(parts().join(u'\n'));
  update();
}

QString LegendBar::text() const { return joinedClauses(parts()); }

QStringList LegendBar::parts() const {
  QStringList parts;
  for (const auto& entry : entries_) parts << entry.name + u' ' + entry.value;
  return parts;
}

QString LegendBar::about() const {
  QStringList lines;
  for (const auto& entry : entries_) {
    lines << entry.name + u' ' + entry.value;
    if (const auto more = about_ ? about_(entry) : QString(); !more.isEmpty()) lines << QStringLiteral("\u2003") + more;
  }
  return lines.join(u'\n');
}

/// Made when it is wanted: it looks at a second of each signal.
bool LegendBar::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip || entries_.empty()) return QWidget::event(event);
  QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), about(), this);
  return true;
}

QSize LegendBar::sizeHint() const { return {200, fontMetrics().height() + 2}; }
QSize LegendBar::minimumSizeHint() const { return {60, fontMetrics().height() + 2}; }

QString LegendBar::shownName(const Entry& entry, Names names) const {
  if (names == Names::kWhole) return entry.name;
  if (names == Names::kShort && !entry.short_name.isEmpty()) return entry.short_name;
  return fontMetrics().elidedText(entry.name, Qt::ElideRight, kLongestName);
}

LegendBar::Names LegendBar::namesThatFit() const {
  for (const auto names : {Names::kWhole, Names::kElided}) {
    int all = -kBetween;
    for (std::size_t i = 0; i < entries_.size(); ++i) all += widthOf(i, names) + kBetween;
    if (all <= width()) return names;
  }
  return Names::kShort;
}

int LegendBar::widthOf(std::size_t entry, Names names) const {
  return kSwatch + 2 * kGap + fontMetrics().horizontalAdvance(shownName(entries_[entry], names)) +
         rooms_[entry].width();
}

void LegendBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const auto names = namesThatFit();
  int x = 0;
  const auto write = [&](const QString& text, const QColor& color) {
    const int wide = fontMetrics().horizontalAdvance(text);
    painter.setPen(color);
    painter.drawText(QRect(x, 0, wide + 1, height()), Qt::AlignVCenter, text);
    x += wide;
  };
  const auto muted = theme::mutedText(palette());
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const auto& entry = entries_[i];
    const auto rest = QStringLiteral("+%1").arg(entries_.size() - i);
    const int reserve = i + 1 < entries_.size() ? kBetween + fontMetrics().horizontalAdvance(rest) : 0;
    if (x > 0 && x + widthOf(i, names) + reserve > width()) return write(rest, muted);
    const bool broad = entry.shape == SeriesItem::Shape::kEnvelope;
    painter.fillRect(QRect(x, height() / 2 - (broad ? 4 : 1), kSwatch, broad ? 8 : 3), entry.color);
    x += kSwatch + kGap;
    write(shownName(entry, names), muted);
    x += kGap;
    const int value_at = x;
    write(entry.value, palette().color(QPalette::WindowText));
    x = value_at + rooms_[i].width() + kBetween;
  }
}

}  // namespace syncline::ui
