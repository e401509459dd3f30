// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/notice_bar.h"

#include <QEvent>
#include <QPainter>

namespace syncline::ui {

NoticeBar::NoticeBar(theme::Tone tone, Qt::Edge towards, QWidget* parent)
    : QFrame(parent), tone_(tone), towards_(towards) {}

void NoticeBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme::toneFill(palette(), tone_));
  painter.setPen(theme::outline(palette()));
  const bool top = towards_ == Qt::TopEdge;
  painter.drawLine(top ? rect().topLeft() : rect().bottomLeft(), top ? rect().topRight() : rect().bottomRight());
}

void NoticeBar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) update();
}

}  // namespace syncline::ui
