// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/value_label.h"

#include <QHelpEvent>
#include <QPainter>
#include <QStyle>
#include <QToolTip>

#include <algorithm>

namespace syncline::ui {
namespace {

/// What stands between figures, or between statements, of a line.
const QString kBetween[] = {QStringLiteral("   "), QStringLiteral(" \u00B7 ")};

/// The last place before `from` where one of them ends; -1: there is none.
qsizetype lastEnd(const QString& text, qsizetype from) {
  qsizetype last = -1;
  for (const auto& between : kBetween) last = std::max(last, text.lastIndexOf(between, from));
  return last;
}

/// As many of the figures as there is room for: a number that ends in an ellipsis reads as another one.
QString elidedFigures(const QString& text, const QFontMetrics& metrics, int room) {
  for (auto end = lastEnd(text, -1); end > 0; end = lastEnd(text, end - 1)) {
    const auto shown = text.left(end) + QStringLiteral(" \u2026");
    if (metrics.horizontalAdvance(shown) <= room) return shown;
  }
  return metrics.elidedText(text, Qt::ElideRight, room);
}

}  // namespace

void ValueLabel::setLeastCharacters(int count) {
  least_characters_ = count;
  updateGeometry();
}

QSize ValueLabel::minimumSizeHint() const {
  const auto usual = QLabel::minimumSizeHint();
  return {std::min(usual.width(), least_characters_ * fontMetrics().averageCharWidth()), usual.height()};
}

void ValueLabel::setText(const QString& text, const QString& shorter) {
  shorter_ = shorter;
  shortened_ = text;
  setText(text);
  update();
}

QString ValueLabel::shown() const {
  const auto room = contentsRect();
  if (wordWrap()) {
    // In lines below each other all of it is there, unless a word is longer than a line.
    const auto lines = fontMetrics().boundingRect(room, Qt::TextWordWrap, text());
    if (lines.width() <= room.width() && lines.height() <= room.height()) return text();
  }
  const bool fits = fontMetrics().horizontalAdvance(text()) <= room.width();
  const bool has_shorter = !shorter_.isEmpty() && shortened_ == text();
  if (fits) return text();
  return elidedFigures(has_shorter ? shorter_ : text(), fontMetrics(), room.width());
}

QString ValueLabel::hint() const {
  if (shown() == text()) return toolTip();
  return toolTip().isEmpty() ? text() : text() + QLatin1Char('\n') + toolTip();
}

bool ValueLabel::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QLabel::event(event);
  QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), hint(), this);
  return true;
}

void ValueLabel::paintEvent(QPaintEvent* event) {
  const auto text_shown = shown();
  if (text_shown == text()) return QLabel::paintEvent(event);
  QPainter painter(this);
  const auto where = QStyle::visualAlignment(layoutDirection(), alignment());
  style()->drawItemText(&painter, contentsRect(), static_cast<int>(where), palette(), isEnabled(), text_shown,
                        foregroundRole());
}

}  // namespace syncline::ui
