// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/substitute_push.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "dc/clock_registers.h"
#include "dc/dcm/dcm_controller.h"
#include "protocol/speed_counter.h"
#include "support/random.h"

namespace syncline::dc {
namespace {

/// A clock behind the loop of those who follow, as an ESC has it once it leads: its average of time differences is that
/// of a leader (64), its average of the quartz its own (256).
class FollowersLoop {
 public:
  FollowersLoop(Nanoseconds cycle, double quartz_ppm)
      : cycle_(static_cast<double>(cycle)), start_(speed_counter_start(cycle)), quartz_(quartz_ppm * 1e-6) {
    rate_ = quartz_ * 5.0 * start_ * start_;  // which it has learned while it followed
  }
  /// One message with the time that it ought to show; how fast it goes then against the host, ns a cycle.
  double tell(double told) {
    mean_ += (time_ - told - mean_) / 64;
    const double wanted = rate_ + mean_;
    rate_ += (wanted - rate_) / 256;
    const double goes = cycle_ * (quartz_ - speed_counter_rate(start_, static_cast<std::int32_t>(std::lround(wanted))));
    time_ += goes;
    return goes;
  }
  [[nodiscard]] double time() const { return time_; }  // less the host's
  void set(double time) { time_ = time; }

 private:
  double cycle_;
  std::uint16_t start_;
  double quartz_;
  double time_ = 0, mean_ = 0, rate_ = 0;
};

struct Moved {
  double largest = 0;  // ns from its place, in the end
  double fastest = 0;  // ns a cycle, all the time
};
/// A substitute in cycles of this length that is `away` ns when it begins to lead, told by a host with such stamps.
Moved lead(Nanoseconds cycle, double away, double stamp_error) {
  FollowersLoop clock(cycle, 3);
  clock.set(away);
  SubstitutePush push(3'000);
  push.start();
  Random random(5);
  Moved moved;
  constexpr int kCycles = 20'000;
  for (int i = 0; i < kCycles; ++i) {
    const auto sent = i * cycle;
    const auto stamp = sent + static_cast<Nanoseconds>(stamp_error * random.normal());
    const auto told = push.told_at(stamp);
    const auto passes = sent + std::llround(clock.time());
    const double goes = clock.tell(told ? static_cast<double>(*told - sent) : clock.time());
    (void)push.take({stamp, sent, passes}, passes - stamp);
    moved.fastest = std::max(moved.fastest, std::abs(goes));
    if (i > kCycles / 2) moved.largest = std::max(moved.largest, std::abs(clock.time()));
  }
  return moved;
}

TEST(SubstitutePush, BringsTheClockHomeInCyclesOfAnyLengthAndDoesNotSwing) {
  for (const auto cycle : {100 * kMicrosecond, 500 * kMicrosecond, kMillisecond, 4 * kMillisecond, 20 * kMillisecond}) {
    const auto moved = lead(cycle, 600, 0);
    EXPECT_LT(moved.largest, 30) << cycle;
    EXPECT_LT(moved.fastest, 6) << cycle;
  }
}

TEST(SubstitutePush, LeavesTheStampsErrorsInNobody) {
  for (const auto cycle : {500 * kMicrosecond, kMillisecond, 4 * kMillisecond}) {
    const auto moved = lead(cycle, 0, 200);
    EXPECT_LT(moved.largest, 100) << cycle;
    EXPECT_LT(moved.fastest, 5) << cycle;
  }
}

}  // namespace
}  // namespace syncline::dc
