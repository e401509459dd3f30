// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "support/types.h"

namespace syncline::dc {

/// Tells a step of the reference clock (or of the host's) from what is only a wrong send stamp: the 64-bit time is
/// compared with what was predicted, so that a step by whole cycles is seen too. A stamp is wrong once and by any
/// amount; a clock that has stepped is off by the same amount in all readings that follow, and three of them are
/// enough; or off by less each time, where it is led back at once. Three wrong stamps in a row may agree, too, but a
/// frame that left later than its stamp says comes back later, and a clock's step delays no frame: such a reading says
/// nothing, be it of a step or of where the clock is.
class ClockStepDetector {
 public:
  explicit ClockStepDetector(Nanoseconds limit) : limit_(static_cast<double>(limit)) {}
  void start() { *this = ClockStepDetector(static_cast<Nanoseconds>(limit_)); }
  /// Readings are elsewhere from now on, or soon will be: what was learned of them is no more worth anything.
  void look_elsewhere();
  struct Reading {
    std::optional<Nanoseconds> step;  // by how much the reference clock has stepped forward, when that is now sure, ns
    double doubt = 0;                 // so much of it, ns, may be its stamp's alone, which then is all that is strange
  };
  /// One reading; `doubt`: so much later than `host_time` it may have been taken, at least 0.
  Reading observe(Nanoseconds host_time, Nanoseconds reference_time, Nanoseconds doubt = 0);

 private:
  static constexpr int kSure = 3;
  struct Strange {
    Nanoseconds host_time = 0;
    double surprise = 0;  // ns
  };
  /// While the line is young: of no use for it, because its frame was held up and few before it were.
  [[nodiscard]] bool spoils_line(double doubt, double gate);
  /// A strange reading; true when its frame was held up, or those before it were and nothing has changed.
  [[nodiscard]] bool take_held(double surprise, double doubt, double gate);
  void follow(double surprise, double passed);
  [[nodiscard]] std::optional<double> sure_step(const Strange& reading, double gate);

  double limit_;
  bool started_ = false;
  Nanoseconds host_ = 0, reference_ = 0;  // where the line is
  double fraction_ = 0;                   // of a nanosecond, to the reference time
  double rate_ = 0;                       // reference clock's rate minus host's
  double scatter_ = 0;                    // mean of |surprise|, ns
  int unsettled_ = 0;                     // readings of which nothing is learned yet
  int readings_ = 0, strange_ = 0;
  int spoiling_ = 0;  // readings in a row
  std::array<Strange, kSure> last_strange_{};
  std::optional<double> held_;  // surprise of the last reading, where its frame was held up
};

}  // namespace syncline::dc
