// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

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

  /// How moments are told on the axis: before now while it follows, else since the run began; always since it began;
  /// the time of day in UTC; the number of the cycle; the system time of the reference clock.
  enum class Notation : std::uint8_t { kBeforeNow, kSinceStart, kUtc, kCycle, kDcTime };
  void setNotation(Notation notation);
  [[nodiscard]] Notation notation() const { return notation_; }
  /// What a run knows of its moments; empty where it does not.
  struct Clocks {
    /// The number of the latest cycle at or before a time of the host clock.
    std::function<std::optional<std::uint64_t>(Nanoseconds)> cycle_at{};
    /// The system time of the reference clock then, ns since 2000-01-01.
    std::function<std::optional<Nanoseconds>(Nanoseconds)> dc_time_at{};
  };
  void setClocks(Clocks clocks) { clocks_ = std::move(clocks); }
  [[nodiscard]] const Clocks& clocks() const { return clocks_; }
  /// Shows what `other` shows, in the same way.
  void copy(const TimeView& other);
  /// What there is, and how moments are told, is as there; the stretch is its own.
  void follow(const TimeView& other);

  /// What the store holds; called once a tick. Moves the stretch when following.
  void setBounds(Nanoseconds first, Nanoseconds last);
  /// Following again from an empty store; the span stays.
  void reset();
  /// Whether there is a now: a recording has none, and nothing of it is followed or frozen. What is followed again has
  /// the span that it had.
  void setFollowable(bool followable);
  [[nodiscard]] bool isFollowable() const { return followable_; }
  /// Whether what is followed goes on: of a run that has ended the newest sample is no "now".
  void setGoesOn(bool goes_on);
  [[nodiscard]] bool goesOn() const { return goes_on_; }

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
  Notation notation_ = Notation::kBeforeNow;
  Clocks clocks_;
  bool followable_ = true, goes_on_ = true;
  Nanoseconds span_ = 10 * kSecond;
  Nanoseconds followed_span_ = span_;  // of what is followed, while something is shown that is not
  std::optional<Nanoseconds> origin_;
  Nanoseconds end_ = 0, first_ = 0, last_ = 0;
};

}  // namespace syncline::ui
