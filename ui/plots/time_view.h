// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <optional>

#include "support/types.h"

namespace syncline::ui {

/// The stretch of time that linked plots show. Following, its end is the newest sample; any pan or zoom
/// leaves that and holds an absolute stretch while data go on arriving, until goLive(). Freezing is the
/// same with another word to the user: only the picture stops.
class TimeView final : public QObject {
  Q_OBJECT

 public:
  enum class Mode { kLive, kHistory, kFrozen };
  Q_ENUM(Mode)
  static constexpr Nanoseconds kMinSpan = 10 * kMicrosecond;
  static constexpr Nanoseconds kMaxSpan = 7 * 24 * 3600 * kSecond;

  using QObject::QObject;

  /// What the store holds; called once a tick. Moves the stretch when following.
  void setBounds(Nanoseconds first, Nanoseconds last);
  /// Following again from an empty store; the span stays.
  void reset();
  /// Whether there is a now: a recording has none, and nothing of it is followed or frozen. What is followed again has
  /// the span that it had.
  void setFollowable(bool followable);
  [[nodiscard]] bool isFollowable() const { return followable_; }

  [[nodiscard]] Mode mode() const { return mode_; }
  [[nodiscard]] Nanoseconds begin() const { return end_ - span_; }
  [[nodiscard]] Nanoseconds end() const { return end_; }
  [[nodiscard]] Nanoseconds span() const { return span_; }
  [[nodiscard]] Nanoseconds first() const { return first_; }
  [[nodiscard]] Nanoseconds last() const { return last_; }
  /// What times are counted from: the run's beginning, also where the store has forgotten it; first() unless it is set.
  void setOrigin(Nanoseconds origin) { origin_ = origin; }
  [[nodiscard]] Nanoseconds origin() const { return origin_.value_or(first_); }
  /// How far the picture is behind the newest sample; 0 when following.
  [[nodiscard]] Nanoseconds behind() const { return mode_ == Mode::kLive ? 0 : last_ - end_; }

  /// Length of the stretch; its end stays, and so does following.
  void setSpan(Nanoseconds span);
  /// `factor` < 1 shows less; `anchor` keeps its place on the screen.
  void zoom(double factor, Nanoseconds anchor);
  void pan(Nanoseconds by);
  void showAll();
  void goLive();
  void freeze();
  void goToStart();
  /// Puts it in the middle; leaves following.
  void goTo(Nanoseconds time);

 Q_SIGNALS:
  void changed();
  void modeChanged();

 private:
  void setMode(Mode mode);
  void moveTo(Nanoseconds end);

  Mode mode_ = Mode::kLive;
  bool followable_ = true;
  Nanoseconds span_ = 10 * kSecond;
  Nanoseconds followed_span_ = span_;  // of what is followed, while something is shown that is not
  std::optional<Nanoseconds> origin_;
  Nanoseconds end_ = 0, first_ = 0, last_ = 0;
};

}  // namespace syncline::ui
