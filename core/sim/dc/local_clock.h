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
/// All of it is arithmetic on whole numbers, so that a run is the same on every machine and compiler.
class LocalClock {
 public:
  /// Nominal tick of the ESC's counter, ns.
  static constexpr std::uint64_t kTick = 10;
  static constexpr Nanoseconds kNever = INT64_MAX;

  LocalClock(const OscillatorConfig& config, Nanoseconds power_on, std::uint64_t seed);

  /// When the quartz will have wandered, or warmed up; kNever: it does not.
  [[nodiscard]] Nanoseconds next_change() const { return next_change_; }
  /// Commits what changes the rate up to `time`, in steps of 100 ms (longer ones when more than an hour passes at
  /// once). True: the rate is another.
  bool advance_to(Nanoseconds time) {
    if (time < next_change_) return false;
    change_until(time);
    return true;
  }
  /// What the counter shows: the value of the last tick.
  [[nodiscard]] std::uint64_t sample(Nanoseconds time) const {
    const auto raw = whole(raw_at(time));
    return raw - raw % kTick - whole(correction_at(time) + kOne / 2);
  }
  /// The counter without its granularity, ns.
  [[nodiscard]] std::uint64_t exact(Nanoseconds time) const { return whole(raw_at(time) - correction_at(time)); }
  /// Both, for little more than one of them.
  struct Reading {
    std::uint64_t sample = 0, exact = 0;
  };
  [[nodiscard]] Reading read(Nanoseconds time) const {
    const auto raw = raw_at(time), correction = correction_at(time);
    const auto shown = whole(raw);
    return {shown - shown % kTick - whole(correction + kOne / 2), whole(raw - correction)};
  }
  /// The counter at `time`, and how fast it is: what it showed a little earlier can be told from it later.
  struct Moment;
  [[nodiscard]] Moment moment(Nanoseconds time) const;
  /// First true time at which exact() reached `local`, which was shortly before `moment`, at the same rate.
  [[nodiscard]] static Nanoseconds time_before(const Moment& moment, std::uint64_t local);
  /// To 1 in 128: any quartz and any correction in use.
  [[nodiscard]] bool runs_nearly_true() const {
    const auto deviation = raw_rate_ - correction_rate_ - kOne;
    return deviation < kOne >> 7 && -deviation < kOne >> 7;
  }
  /// First true time from `from` on at which exact() reaches `local`: `from` when that is past, kNever when true time
  /// ends before.
  [[nodiscard]] Nanoseconds time_of(std::uint64_t local, Nanoseconds from) const;

  /// True time in which the counter, as fast as it is now, goes on by `local` ns (a short while), rounded up.
  [[nodiscard]] Nanoseconds true_duration(std::uint64_t local) const {
    return static_cast<Nanoseconds>(passing_time(local, 0));
  }

  /// Relative slow-down from the time control loop, at most a tenth, effective from `time` on.
  void set_correction(double relative, Nanoseconds time) { set_correction_rate(rate_of(relative), time); }
  /// The same with a rate_of().
  void set_correction_rate(std::int64_t rate, Nanoseconds time) {
    advance_to(time);
    commit_correction(time);
    loop_rate_ = rate;
    correction_rate_ = by_quartz(loop_rate_);
  }
  /// A relative deviation in the clock's arithmetic; no clock is further off than a tenth.
  [[nodiscard]] static std::int64_t rate_of(double relative);
  /// The counter jumps by `delta` ns (a fault).
  void step(Nanoseconds delta) { raw_ += static_cast<Fixed>(delta) * kOne; }

 private:
  // What follows runs several times for every slave and frame.
  /// Nanoseconds in parts of 2^-60: what the rates resolve is less than a picosecond in a day.
  __extension__ using Fixed = __int128;
  __extension__ using Unsigned = unsigned __int128;
  static constexpr unsigned kFractionBits = 60;
  static constexpr std::int64_t kOne = std::int64_t{1} << kFractionBits;

  /// The counter's word: it wraps.
  [[nodiscard]] static std::uint64_t whole(Fixed value) { return static_cast<std::uint64_t>(value >> kFractionBits); }
  /// A rate by the quartz, by true time.
  [[nodiscard]] std::int64_t by_quartz(std::int64_t rate) const {
    return static_cast<std::int64_t>(static_cast<Fixed>(rate) * raw_rate_ >> kFractionBits);
  }
  [[nodiscard]] Fixed raw_at(Nanoseconds time) const { return raw_ + static_cast<Fixed>(time - raw_time_) * raw_rate_; }
  [[nodiscard]] Fixed correction_at(Nanoseconds time) const {
    return correction_ + static_cast<Fixed>(time - correction_time_) * correction_rate_;
  }
  /// The control loop changes the rate of the correction in nearly every frame, and the quartz keeps its own.
  void commit_correction(Nanoseconds time) {
    correction_ = correction_at(time);
    correction_time_ = time;
  }
  void commit(Nanoseconds time) {
    commit_correction(time);
    raw_ = raw_at(time);
    raw_time_ = time;
  }
  /// The rates are those of the quartz as it is now.
  void take_rates();
  void change_until(Nanoseconds time);
  [[nodiscard]] Unsigned passing_time(std::uint64_t ahead, std::uint64_t fraction) const;
  [[nodiscard]] double moved_at(Nanoseconds time) const;
  /// When the next change of the rate behind `time` is due, `step` later at most; kNever: none.
  [[nodiscard]] Nanoseconds next_move(Nanoseconds time, Nanoseconds step) const;

  double ppm_, wander_ = 0, wander_limit_, moved_ = 0;
  std::vector<RateChange> changes_;
  Random random_;
  Nanoseconds next_wander_, next_move_;
  // Of every frame, and therefore together:
  Nanoseconds next_change_;
  Nanoseconds raw_time_, correction_time_;              // committed true time; the rate has been the same since
  Fixed raw_;                                           // uncorrected counter then
  Fixed correction_ = 0;                                // subtracted until then
  std::int64_t raw_rate_ = kOne, correction_rate_ = 0;  // of both by true time
  std::int64_t loop_rate_ = 0;                          // of the correction by the quartz
};

struct LocalClock::Moment {
  Nanoseconds time = 0;
  Fixed shown = 0;
  std::int64_t rate = kOne;
  std::uint64_t sample = 0;  // sample() then
  /// exact() then.
  [[nodiscard]] std::uint64_t exact() const { return whole(shown); }
};

inline LocalClock::Moment LocalClock::moment(Nanoseconds time) const {
  const auto raw = raw_at(time), correction = correction_at(time);
  const auto counted = whole(raw);
  return {time, raw - correction, raw_rate_ - correction_rate_,
          counted - counted % kTick - whole(correction + kOne / 2)};
}

}  // namespace syncline::sim
