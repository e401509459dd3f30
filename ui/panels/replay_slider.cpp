// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/replay_slider.h"

#include <QMouseEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QWheelEvent>
#include <algorithm>

#include "ui/session/recording_replay.h"
#include "ui/theme/theme.h"

namespace syncline::ui {
namespace {

constexpr int kSliderSteps = 1'000'000, kTickHeight = 5;
constexpr int kSliderHeight = 24;  // the ticks below the handle

}  // namespace

ReplaySlider::ReplaySlider(RecordingReplay& replay, QWidget* parent)
    : QSlider(Qt::Horizontal, parent), replay_(replay) {
  setRange(0, kSliderSteps);
  setSingleStep(kSliderSteps / 1000);
  setPageStep(kSliderSteps / 20);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(90, kSliderHeight);
  connect(this, &QSlider::valueChanged, this, [this](int value) {
    const auto span = replay_.end() - replay_.begin();
    // In two parts: the span of a day times the steps is more than there are numbers.
    Q_EMIT momentChosen(replay_.begin() + span / kSliderSteps * value + span % kSliderSteps * value / kSliderSteps);
  });
}

int ReplaySlider::valueOf(Nanoseconds moment) const {
  const auto span = std::max<Nanoseconds>(replay_.end() - replay_.begin(), 1);
  const double part = static_cast<double>(moment - replay_.begin()) / static_cast<double>(span);
  return std::clamp(static_cast<int>(part * kSliderSteps + 0.5), 0, kSliderSteps);
}

void ReplaySlider::showMoment() {
  if (isSliderDown()) return;
  const QSignalBlocker quiet(this);
  setValue(valueOf(replay_.moment()));
}

/// Where the middle of the handle goes.
QRect ReplaySlider::grooveOf() const {
  const int handle = style()->pixelMetric(QStyle::PM_SliderLength, nullptr, this);
  return rect().adjusted(handle / 2, 0, -handle / 2, 0);
}

void ReplaySlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) {
    const auto groove = grooveOf();
    setValue(QStyle::sliderValueFromPosition(0, kSliderSteps, static_cast<int>(event->position().x()) - groove.left(),
                                             groove.width(), layoutDirection() == Qt::RightToLeft));
  }
  QSlider::mousePressEvent(event);
}

void ReplaySlider::wheelEvent(QWheelEvent* event) { hasFocus() ? QSlider::wheelEvent(event) : event->ignore(); }

void ReplaySlider::paintEvent(QPaintEvent* event) {
  QSlider::paintEvent(event);
  QPainter painter(this);
  const auto groove = grooveOf();
  const auto bad = theme::toneColor(palette(), theme::Tone::kBad);
  const auto good = theme::toneColor(palette(), theme::Tone::kGood);
  int before = -1;
  bool fault = false;
  for (const auto& mark : replay_.marks()) {
    const int x = groove.left() + QStyle::sliderPositionFromValue(0, kSliderSteps, valueOf(mark.time), groove.width());
    // Of those that share a place a fault is seen.
    if (x == before && (fault || !mark.fault)) continue;
    before = x;
    fault = mark.fault;
    const auto color = mark.note ? palette().color(QPalette::WindowText) : mark.fault ? bad : good;
    painter.fillRect(x, height() - kTickHeight, 2, kTickHeight, color);
  }
}

}  // namespace syncline::ui
