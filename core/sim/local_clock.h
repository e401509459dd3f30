// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "config/sim_config.h"
#include "support/random.h"
#include "support/types.h"

namespace syncline::sim {

/// Local time of one ESC: a quartz with its own error and slow wander, counted in ticks of 10 ns, and
/// the rare 9 ns and 11 ns steps by which the time control loop corrects it (ESC data sheet I, 9.1.4).
/// `time` arguments are true time and never lie before the last advance_to().
class LocalClock {
 public:
  /// Nominal tick of the ESC's counter, ns.
  static constexpr std::uint64_t kTick = 10;

  LocalClock(const OscillatorConfig& config, Nanoseconds power_on, std::uint64_t seed);

  /// Commits everything up to `time`; the quartz wanders in steps of 100 ms.
  void advance_to(Nanoseconds time);
  /// What the counter shows: the value of the last tick.
  [[nodiscard]] std::uint64_t sample(Nanoseconds time) const;
  /// The counter without its granularity, ns.
  [[nodiscard]] std::uint64_t exact(Nanoseconds time) const;
  /// First true time at which exact() reaches `local`; the committed time when that is past.
  [[nodiscard]] Nanoseconds time_of(std::uint64_t local) const;

  /// Relative slow-down from the time control loop, effective from the committed time on.
  void set_correction(double relative) { correction_rate_ = relative; }
  /// The counter jumps by `delta` ns (a fault).
  void step(Nanoseconds delta) { raw_ += static_cast<std::uint64_t>(delta); }
  /// Deviation of the uncorrected quartz from true time at the moment.
  [[nodiscard]] double ppm() const { return ppm_ + wander_; }

 private:
  void commit(Nanoseconds time);
  /// Nanoseconds that the uncorrected counter gains on true time from the committed time to `time`.
  [[nodiscard]] double raw_gain(Nanoseconds time) const;
  [[nodiscard]] double correction(Nanoseconds time) const;

  Nanoseconds time_;            // committed true time
  std::uint64_t raw_;           // uncorrected counter at time_, whole ns
  double raw_fraction_ = 0;
  double correction_ = 0;       // ns subtracted so far
  double correction_rate_ = 0;
  double ppm_, wander_ = 0, wander_limit_;
  Nanoseconds next_wander_;
  Random random_;
};

}  // namespace syncline::sim
