// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "support/types.h"

namespace syncline::sim {

/// Timer of a drive's servo loop: runs on a quartz of its own until SYNC0 leads it. Times are true time.
class ServoClock {
 public:
  /// `ppm`: error of the quartz; `phase`: of the free-running timer.
  ServoClock(Nanoseconds period, double ppm, Nanoseconds phase);

  /// The next start of a servo period when it lies before `time`; each is given once, in order.
  [[nodiscard]] std::optional<Nanoseconds> take_before(Nanoseconds time);
  /// Passes over all periods before `time` at once; false when there is none.
  bool skip_before(Nanoseconds time);
  /// At most the last `most` of the periods before `time` are still to be given.
  void keep_last(Nanoseconds most, Nanoseconds time) {
    if (next_ && time - *next_ > most * period_) (void)skip_before(time - most * period_);
  }

  /// The next period starts at `sync0`: for timers that SYNC0 restarts.
  void restart(Nanoseconds sync0);
  /// The PLL compares with a SYNC0 and moves the timer by at most 1 us. `grid`: what is aligned, a period or the part
  /// of it whose multiple the SYNC0 cycle is.
  void follow(Nanoseconds sync0, Nanoseconds grid);
  /// No SYNC0 leads any more.
  void release();
  [[nodiscard]] bool locked() const { return good_ >= kGoodToLock; }
  /// Start of the servo period behind the last SYNC0, ns.
  [[nodiscard]] Nanoseconds phase_error() const { return phase_error_; }
  [[nodiscard]] Nanoseconds period() const { return period_; }

 private:
  static constexpr int kGoodToLock = 16;  // SYNC0s in a row within the lock window
  static constexpr unsigned kFractionBits = 32;
  static constexpr std::int64_t kOne = std::int64_t{1} << kFractionBits;
  void set_length();
  /// So much later, in parts of a ns.
  void pass(std::int64_t length);

  Nanoseconds period_;
  double quartz_ = 1, trim_ = 0;  // length of the period by the quartz, relative; correction by the PLL
  Nanoseconds phase_;
  std::optional<Nanoseconds> next_;
  std::int64_t length_ = 0;     // of the period, in parts of 2^-32 ns
  std::uint32_t fraction_ = 0;  // behind next_, in such parts
  Nanoseconds phase_error_ = 0;
  int good_ = 0;
};

}  // namespace syncline::sim
