// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/time_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace syncline::ui {

void TimeView::setBounds(Nanoseconds first, Nanoseconds last) {
  first_ = first;
  last_ = last;
  if (mode_ == Mode::kLive && end_ != last) {
    end_ = last;
    Q_EMIT changed();
  }
}

void TimeView::reset() {
  first_ = last_ = end_ = 0;
  origin_.reset();
  setMode(Mode::kLive);
  Q_EMIT changed();
}

void TimeView::setNotation(Notation notation) {
  if (notation == std::exchange(notation_, notation)) return;
  Q_EMIT changed();
}

void TimeView::copy(const TimeView& other) {
  follow(other);
  span_ = other.span_;
  end_ = other.end_;
  setMode(other.mode_);
  Q_EMIT changed();
}

void TimeView::follow(const TimeView& other) {
  clocks_ = other.clocks_;
  origin_ = other.origin_;
  setNotation(other.notation_);
  goes_on_ = other.goes_on_;
  if (followable_ != other.followable_) {
    setFollowable(other.followable_);
    span_ = other.span_;
    end_ = other.end_;
  }
  setBounds(other.first_, other.last_);
}

void TimeView::setSpan(Nanoseconds span) {
  span_ = std::clamp(span, kMinSpan, kMaxSpan);
  Q_EMIT changed();
}

void TimeView::zoom(double factor, Nanoseconds anchor) {
  const auto wanted =
      std::clamp(static_cast<double>(span_) * factor, static_cast<double>(kMinSpan), static_cast<double>(kMaxSpan));
  const double place = static_cast<double>(end_ - anchor) / static_cast<double>(span_);
  span_ = static_cast<Nanoseconds>(std::llround(wanted));
  moveTo(anchor + static_cast<Nanoseconds>(std::llround(place * wanted)));
}

void TimeView::pan(Nanoseconds by) { moveTo(end_ + by); }

void TimeView::showAll() {
  span_ = std::clamp(last_ - first_, kMinSpan, kMaxSpan);
  moveTo(last_);
}

void TimeView::setFollowable(bool followable) {
  if (followable != std::exchange(followable_, followable)) std::swap(span_, followed_span_);
  setMode(followable ? Mode::kLive : Mode::kHistory);
  Q_EMIT changed();
}

void TimeView::setGoesOn(bool goes_on) {
  if (goes_on == std::exchange(goes_on_, goes_on)) return;
  Q_EMIT modeChanged();
  Q_EMIT changed();
}

void TimeView::goLive() {
  end_ = last_;
  setMode(followable_ ? Mode::kLive : Mode::kHistory);
  Q_EMIT changed();
}

void TimeView::freeze() {
  if (followable_) setMode(Mode::kFrozen);
}

void TimeView::goTo(Nanoseconds time) { moveTo(time + span_ / 2); }

void TimeView::goToStart() { moveTo(first_ + span_); }

void TimeView::moveTo(Nanoseconds end) {
  // Half a stretch of nothing on either side is enough to find one's way back.
  const auto margin = span_ / 2;
  end_ = std::clamp(end, std::min(first_ + margin, last_), last_ + margin);
  if (mode_ == Mode::kLive) setMode(Mode::kHistory);
  Q_EMIT changed();
}

void TimeView::setMode(Mode mode) {
  if (mode_ == mode) return;
  mode_ = mode;
  Q_EMIT modeChanged();
}

}  // namespace syncline::ui
