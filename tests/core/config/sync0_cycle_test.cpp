// SPDX-License-Identifier: Apache-2.0
#include "config/sync0_cycle.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "tests/support/sample_devices.h"

namespace syncline::compiler {
namespace {

DcOpMode both_syncs(DcTime cycle0, DcTime shift0, DcTime cycle1, DcTime shift1) {
  DcOpMode mode;
  mode.assign_activate = 0x0700;
  mode.cycle_time_sync0 = cycle0;
  mode.shift_time_sync0 = shift0;
  mode.cycle_time_sync1 = cycle1;
  mode.shift_time_sync1 = shift1;
  return mode;
}
DcTime value(std::int64_t ns) { return {.value_ns = ns, .factor = std::nullopt}; }
DcTime factor(int f, std::int64_t ns = 0) { return {.value_ns = ns, .factor = f}; }

TEST(DcTimes, FollowTheFactorsOfTheEsi) {
  const DcOpMode mode = sample::op_mode("m", 0x0300, 2);
  EXPECT_EQ(dc_times(mode, {}, kMillisecond).cycle_time0, 2 * kMillisecond);
  EXPECT_EQ(dc_times(sample::op_mode("m", 0x0300, -8), {}, kMillisecond).cycle_time0, 125'000);
  EXPECT_EQ(dc_times(sample::op_mode("m", 0x0300, 0), {}, kMillisecond).cycle_time0, 0);
}

TEST(DcTimes, Sync0WithoutACycleTimeMeansTheBusCycle) {
  DcOpMode mode;
  mode.assign_activate = 0x0300;
  EXPECT_EQ(dc_times(mode, {}, kMillisecond).cycle_time0, kMillisecond);
  EXPECT_EQ(dc_times(mode, {}, 250'000).cycle_time0, 250'000);
  DcSlaveSettings user;
  user.sync0.cycle_factor = 4;
  EXPECT_EQ(dc_times(mode, user, kMillisecond).cycle_time0, 4 * kMillisecond);
  mode.assign_activate = 0x0100;
  EXPECT_EQ(dc_times(mode, {}, kMillisecond).cycle_time0, 0) << "no SYNC0, no cycle";
}

TEST(DcTimes, NumbersThatNoDeviceMeansStayBounded) {
  constexpr int kInts[] = {std::numeric_limits<int>::min(), std::numeric_limits<int>::max()};
  constexpr std::int64_t kLongs[] = {0, std::numeric_limits<std::int64_t>::min(),
                                     std::numeric_limits<std::int64_t>::max()};
  for (const int f : kInts) {
    for (const std::int64_t v : kLongs) {
      const auto times =
          dc_times(both_syncs(factor(f, v), factor(f, v), factor(f, v), factor(f, v)), {}, 100 * kSecond);
      for (const auto time : {times.cycle_time0, times.cycle_time1, times.shift_time}) {
        EXPECT_LE(std::abs(time), 3'000 * kSecond);
      }
    }
  }
}

TEST(DcTimes, AFixedValueIsStrongerThanTheFactor) {
  EXPECT_EQ(dc_times(both_syncs(factor(1, 250'000), {}, {}, {}), {}, kMillisecond).cycle_time0, 250'000);
}

// Three published op modes: a servo terminal, an oversampling drive, an oversampling input terminal.
TEST(DcTimes, Sync1IsADelayAfterSync0) {
  const auto terminal = dc_times(both_syncs(factor(1), value(30'000), factor(-1), value(1'000)), {}, kMillisecond);
  EXPECT_EQ(terminal.cycle_time0, 1'000'000);
  EXPECT_EQ(terminal.shift_time, 30'000);
  EXPECT_EQ(terminal.cycle_time1, 1'000);
  const auto drive = dc_times(both_syncs(value(250'000), value(50'000), factor(-1), {}), {}, kMillisecond);
  EXPECT_EQ(drive.cycle_time1, 750'000);
  const auto input = dc_times(both_syncs(factor(-8), {}, factor(-1), {}), {}, kMillisecond);
  EXPECT_EQ(input.cycle_time0, 125'000);
  EXPECT_EQ(input.cycle_time1, 875'000);
}

TEST(DcTimes, Sync1CountsOnlyWhenItIsSwitchedOn) {
  auto mode = both_syncs(factor(1), {}, factor(1), value(5'000));
  mode.assign_activate = 0x0300;
  EXPECT_EQ(dc_times(mode, {}, kMillisecond).cycle_time1, 0);
}

TEST(DcTimes, ASync1WithoutCycleGoesWithSync0) {
  EXPECT_EQ(dc_times(both_syncs(factor(1), {}, {}, value(2'000)), {}, kMillisecond).cycle_time1, 2'000);
}

TEST(DcTimes, ShiftHasAValueAndAFactorTerm) {
  EXPECT_EQ(dc_times(both_syncs(factor(1), factor(-2, 1'000), {}, {}), {}, kMillisecond).shift_time, 501'000);
}

TEST(DcTimes, TheUsersSettingsReplaceThoseOfTheEsi) {
  DcSlaveSettings user;
  user.sync0.cycle_factor = -4;
  user.sync0.shift = -7'000;
  user.sync1.user_cycle = 600'000;
  user.sync1.shift = 100;
  const auto times = dc_times(both_syncs(factor(1), value(30'000), factor(-1), value(1'000)), user, kMillisecond);
  EXPECT_EQ(times.cycle_time0, 250'000);
  EXPECT_EQ(times.shift_time, -7'000);
  EXPECT_EQ(times.cycle_time1, 600'000 - 250'000 + 100);
  user.sync0.user_cycle = 125'000;
  EXPECT_EQ(dc_times(both_syncs(factor(1), {}, {}, {}), user, kMillisecond).cycle_time0, 125'000);
}

/// The master's input shift counts for slaves that latch inputs: as the ESI says (Input), unless the user does.
TEST(DcTimes, TheInputShiftCountsWhereSync0IsBasedOnTheInputs) {
  auto shift = value(30'000);
  shift.input = true;
  const auto mode = both_syncs(factor(1), shift, factor(-1), {});
  const auto plain = both_syncs(factor(1), value(30'000), factor(-1), {});
  constexpr Nanoseconds kInput = 700'000;
  DcSlaveSettings user;
  EXPECT_EQ(dc_times(mode, user, kMillisecond, kInput).shift_time, 730'000);
  EXPECT_EQ(dc_times(plain, user, kMillisecond, kInput).shift_time, 30'000);
  EXPECT_EQ(dc_times(mode, user, kMillisecond, kInput).cycle_time1, dc_times(mode, user, kMillisecond).cycle_time1)
      << "SYNC1 goes with SYNC0";
  user.sync0.shift = -5'000;
  EXPECT_EQ(dc_times(mode, user, kMillisecond, kInput).shift_time, 695'000) << "on top of the user's shift";
  user.input_reference = false;
  EXPECT_EQ(dc_times(mode, user, kMillisecond, kInput).shift_time, -5'000);
  user.input_reference = true;
  EXPECT_EQ(dc_times(plain, user, kMillisecond, kInput).shift_time, 695'000);
}

TEST(DcTimes, TellsWhenADivisionIsNotExact) {
  EXPECT_TRUE(dc_times(sample::op_mode("m", 0x0300, -8), {}, kMillisecond).exact);
  EXPECT_FALSE(dc_times(sample::op_mode("m", 0x0300, -3), {}, kMillisecond).exact);
}

}  // namespace
}  // namespace syncline::compiler
