// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "support/types.h"

namespace syncline {

/// Nanoseconds from CLOCK_MONOTONIC to the calendar's time since the DC epoch, right to some ten nanoseconds: both
/// clocks are read several times in turn, and the pair with the shortest way between counts. Any thread.
[[nodiscard]] Nanoseconds calendar_shift();

/// What is added to CLOCK_MONOTONIC to get the time since the DC epoch. All programs of this machine that run at the
/// same time use one value, or those that keep several networks in phase would disagree as soon as somebody sets the
/// calendar clock between their starts. The first program takes it from the calendar and leaves it in a small file in
/// shared memory; it holds as long as one of them runs. A calendar that is set meanwhile changes the time of nobody.
class SharedEpoch {
 public:
  /// Of the process; opened at the first call and kept to its end.
  [[nodiscard]] static const SharedEpoch& of_this_machine();
  /// `path`: of the file; `calendar`: says the shift when nobody has said it yet.
  explicit SharedEpoch(const std::string& path, const std::function<Nanoseconds()>& calendar = calendar_shift);
  ~SharedEpoch();
  SharedEpoch(const SharedEpoch&) = delete;
  SharedEpoch& operator=(const SharedEpoch&) = delete;

  [[nodiscard]] Nanoseconds shift() const { return shift_; }
  /// False: the file cannot be had, and the shift is this program's own reading of the calendar.
  [[nodiscard]] bool shared() const { return fd_ >= 0; }

 private:
  [[nodiscard]] bool take_part(const std::function<Nanoseconds()>& calendar);

  int fd_ = -1;
  Nanoseconds shift_ = 0;
};

}  // namespace syncline
