// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "config/sim_config.h"
#include "support/random.h"
#include "support/types.h"

namespace syncline::sim {

/// Local time of one ESC: a quartz with its own error and slow wander, counted in ticks of 10 ns, and
/// the rare 9 ns and 11 ns steps by which the time control loop corrects it (ESC data sheet I, 9.1.4).
/// `time` arguments are true time and never lie before the last advance_to() or set_correction().
class LocalClock {
 public:
  /// Nominal tick of the ESC's counter, ns.
  static constexpr std::uint64_t kTick = 10;

  LocalClock(const OscillatorConfig& config, Nanoseconds power_on, std::uint64_t seed);

  /// The quartz will have wandered, or warmed up, at `time`.
  [[nodiscard]] bool changes_until(Nanoseconds time) const { return next_change_ <= time; }
  /// Commits what changes the rate up to `time`, in steps of 100 ms. True: the rate is another.
  bool advance_to(Nanoseconds time) {
    if (!changes_until(time)) return false;
    change_until(time);
    return true;
  }
  /// What the counter shows: the value of the last tick.
  [[nodiscard]] std::uint64_t sample(Nanoseconds time) const {
    const std::uint64_t raw = raw_ + static_cast<std::uint64_t>(time - time_ + whole(raw_gain(time)));
    return raw - raw % kTick - static_cast<std::uint64_t>(whole(correction(time) + 0.5));
  }
  /// The counter without its granularity, ns.
  [[nodiscard]] std::uint64_t exact(Nanoseconds time) const {
    return raw_ + static_cast<std::uint64_t>(time - time_ + whole(raw_gain(time) - correction(time)));
  }
  /// First true time at which exact() reaches `local`; the last committed time when that is past.
  [[nodiscard]] Nanoseconds time_of(std::uint64_t local) const;

  /// Relative slow-down from the time control loop, effective from `time` on.
  void set_correction(double relative, Nanoseconds time) {
    advance_to(time);
    commit(time);
    correction_rate_ = relative;
  }
  /// The counter jumps by `delta` ns (a fault).
  void step(Nanoseconds delta) { raw_ += static_cast<std::uint64_t>(delta); }
  /// Deviation of the uncorrected quartz from true time at the moment.
  [[nodiscard]] double ppm() const { return ppm_ + wander_ + moved_; }

 private:
  // What follows runs several times for every slave and frame.
  /// Largest whole number not above `value`.
  [[nodiscard]] static std::int64_t whole(double value) {
    const auto towards_zero = static_cast<std::int64_t>(value);
    return towards_zero - (static_cast<double>(towards_zero) > value ? 1 : 0);
  }
  void commit(Nanoseconds time) {
    const double gain = raw_gain(time);
    const auto gained = whole(gain);
    correction_ = correction(time);
    raw_ += static_cast<std::uint64_t>(time - time_ + gained);
    raw_fraction_ = gain - static_cast<double>(gained);
    time_ = time;
  }
  /// Nanoseconds that the uncorrected counter gains on true time from the committed time to `time`.
  [[nodiscard]] double raw_gain(Nanoseconds time) const {
    return raw_fraction_ + static_cast<double>(time - time_) * ppm() * 1e-6;
  }
  [[nodiscard]] double correction(Nanoseconds time) const {
    return correction_ + static_cast<double>(time - time_) * (1 + ppm() * 1e-6) * correction_rate_;
  }
  void change_until(Nanoseconds time);
  [[nodiscard]] double moved_at(Nanoseconds time) const;
  /// When the next change of the rate behind `time` is due; INT64_MAX: none.
  [[nodiscard]] Nanoseconds next_move(Nanoseconds time) const;

  Nanoseconds time_;            // committed true time; the rate has been the same since
  std::uint64_t raw_;           // uncorrected counter at time_, whole ns
  double raw_fraction_ = 0;
  double correction_ = 0;       // ns subtracted so far
  double correction_rate_ = 0;
  double ppm_, wander_ = 0, wander_limit_, moved_ = 0;
  std::vector<RateChange> changes_;
  Nanoseconds next_wander_, next_move_, next_change_;
  Random random_;
};

}  // namespace syncline::sim
