// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/pill.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

#include "ui/widgets/spoken_value.h"

namespace syncline::ui {
namespace {

constexpr int kPillPadding = 8;
constexpr int kMark = 8;
constexpr int kPillGap = 6;
constexpr int kLeastCharacters = 24;  // painted in the narrowest place: a state, and not why

/// Full disc, half a disc in its ring, ring, triangle, square: told apart without colour.
void drawMark(QPainter& painter, const QRectF& box, theme::Tone tone) {
  switch (tone) {
    case theme::Tone::kWarning:
      painter.drawPolygon(QPolygonF({{box.center().x(), box.top()}, box.bottomRight(), box.bottomLeft()}));
      break;
    case theme::Tone::kBad:
      painter.drawRect(box);
      break;
    case theme::Tone::kNeutral:
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(box.adjusted(1, 1, -1, -1));
      break;
    case theme::Tone::kBusy: {
      constexpr int kDegree = 16;  // a chord's angles are of sixteenths
      painter.drawChord(box, 90 * kDegree, 180 * kDegree);
      painter.setPen(QPen(painter.brush().color(), 1.0));
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(box.adjusted(0.5, 0.5, -0.5, -0.5));
      break;
    }
    default:
      painter.drawEllipse(box);
  }
}

}  // namespace

Pill::Pill(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
  speaksValue(*this);
}

void Pill::setState(theme::Tone tone, const QString& text) {
  if (tone == tone_ && text == text_) return;
  const bool resized =
      text.size() != text_.size() || fontMetrics().horizontalAdvance(text) != fontMetrics().horizontalAdvance(text_);
  tone_ = tone;
  text_ = text;
  sayValue(*this, text);
  if (resized) updateGeometry();
  update();
}

QSize Pill::sizeHint() const {
  const auto metrics = fontMetrics();
  return {metrics.horizontalAdvance(text_) + 2 * kPillPadding + kMark + kPillGap, metrics.height() + 6};
}

QSize Pill::minimumSizeHint() const {
  const auto whole = sizeHint();
  const int least = kLeastCharacters * fontMetrics().averageCharWidth() + 2 * kPillPadding + kMark + kPillGap;
  return {std::min(whole.width(), least), whole.height()};
}

QString Pill::shown() const {
  const int room = width() - 2 * kPillPadding - kMark - kPillGap;
  // The eliding counts parts of a pixel, which the size hint rounds off.
  return fontMetrics().horizontalAdvance(text_) <= room ? text_ : fontMetrics().elidedText(text_, Qt::ElideRight, room);
}

bool Pill::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip || shown() == text_) return QWidget::event(event);
  QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                     toolTip().isEmpty() ? text_ : text_ + u'\n' + toolTip(), this);
  return true;
}

void Pill::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const auto color = theme::toneColor(palette(), tone_);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme::toneFill(palette(), tone_));
  const QRectF area = QRectF(rect());
  painter.drawRoundedRect(area, area.height() / 2, area.height() / 2);
  painter.setPen(QPen(color, tone_ == theme::Tone::kNeutral ? 1.5 : 0.01));
  painter.setBrush(color);
  drawMark(painter, QRectF(kPillPadding, area.center().y() - kMark / 2.0, kMark, kMark), tone_);
  painter.setPen(color);
  painter.drawText(area.adjusted(kPillPadding + kMark + kPillGap, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, shown());
}

}  // namespace syncline::ui
