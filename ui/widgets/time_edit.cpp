// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/time_edit.h"

#include <QSignalBlocker>
#include <QWheelEvent>
#include <cmath>

namespace syncline::ui {

TimeEdit::TimeEdit(QWidget* parent) : QDoubleSpinBox(parent) {
  setDecimals(3);
  setSuffix(QStringLiteral(" \u00B5s"));
  setKeyboardTracking(false);
  setAccelerated(true);
  setAlignment(Qt::AlignRight);
  setFocusPolicy(Qt::StrongFocus);
  setRangeNs(0, 100 * kMillisecond);
  connect(this, &QDoubleSpinBox::valueChanged, this, [this] { Q_EMIT editedNs(valueNs()); });
}

void TimeEdit::setRangeNs(Nanoseconds minimum, Nanoseconds maximum) {
  setRange(static_cast<double>(minimum) / 1e3, static_cast<double>(maximum) / 1e3);
}

Nanoseconds TimeEdit::valueNs() const { return std::llround(value() * 1e3); }

void TimeEdit::showNs(Nanoseconds value) {
  const QSignalBlocker quiet(this);
  setValue(static_cast<double>(value) / 1e3);
}

void TimeEdit::wheelEvent(QWheelEvent* event) {
  // A page that scrolls must not change values on its way.
  if (hasFocus()) {
    QDoubleSpinBox::wheelEvent(event);
  } else {
    event->ignore();
  }
}

}  // namespace syncline::ui
