// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/master_shift.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dcm_plant.h"
#include "protocol/dcm_error.h"

namespace syncline::dc {
namespace {

PlantOptions master_shifted(JitterProfile jitter, double ppm = 50) {
  PlantOptions options;
  options.mode = DcmMode::kMasterShift;
  options.jitter = jitter;
  options.reference_ppm = ppm;
  options.slave_ppm = {ppm + 30, ppm - 90};
  return options;
}

TEST(MasterShift, LocksAfterTheSettleTimeAndStays) {
  for (const auto& jitter : {JitterProfile::none(), JitterProfile::quiet(), JitterProfile::desktop()}) {
    for (const double ppm : {-400.0, -50.0, 0.0, 50.0, 400.0}) {
      DcmPlant plant(master_shifted(jitter, ppm));
      plant.run_until(20);
      EXPECT_LT(plant.in_sync_at(), 1.6) << ppm;
      EXPECT_EQ(plant.times_lost(), 0) << ppm;
      EXPECT_LT(plant.worst(&PlantCycle::grid_error, 10), 30) << ppm;
      EXPECT_NEAR(plant.last().state.drift_ppm, ppm, 0.1);
      EXPECT_EQ(plant.last().state.error_code, 0U);
    }
  }
}

/// What it says of itself: all that it moved the timer by, and nothing when somebody else moves it.
TEST(MasterShift, CountsWhatItMovedTheTimerBy) {
  for (const auto mode : {DcmMode::kMasterShift, DcmMode::kMasterShiftByApp}) {
    MasterShift shift({.mode = mode, .set_value = {}}, kMillisecond, 400'000);
    shift.start(0, 10'600'000, 10 * kMillisecond);
    Nanoseconds moved = 0, schedule = 10 * kMillisecond;
    for (int i = 0; i < 50; ++i) {
      const auto action = shift.observe({schedule, schedule, schedule + 610'000});
      EXPECT_NE(shift.state().adjust, 0) << i;
      EXPECT_EQ(action.period_adjust, mode == DcmMode::kMasterShift ? shift.state().adjust : 0) << i;
      moved += action.period_adjust;
      EXPECT_EQ(shift.state().output_total, moved) << i;
      schedule += kMillisecond + action.period_adjust;
    }
    shift.start(0, schedule, schedule);
    EXPECT_EQ(shift.state().output_total, 0);
  }
}

TEST(MasterShift, OneSidedWakeUpDelayIsNoBias) {
  // The mean lateness of this host is 2.4 us; a loop that saw it would send that much too early.
  DcmPlant plant(master_shifted(JitterProfile::desktop()));
  plant.run_until(20);
  EXPECT_GT(plant.mean(&PlantCycle::jitter, 10), 2'000);
  EXPECT_LT(std::abs(plant.mean(&PlantCycle::grid_error, 10)), 20);
}

TEST(MasterShift, BringsAnyStartingPhaseToTheGrid) {
  for (const double error : {-490e3, -200e3, 4e3, 200e3, 499e3}) {
    auto options = master_shifted(JitterProfile::quiet());
    options.start_error = error;
    DcmPlant plant(options);
    plant.run_until(6);
    EXPECT_LT(plant.in_sync_at(), 2.5) << error;
    EXPECT_LT(plant.worst(&PlantCycle::grid_error, 5), 50) << error;
  }
}

TEST(MasterShift, NoPeriodIsBentByMoreThanAFiftiethAndTheWayBackOvershootsLittle) {
  auto options = master_shifted(JitterProfile::none());
  options.start_error = 490e3;
  DcmPlant plant(options);
  plant.run_until(3);
  double overshoot = 0;
  for (const auto& cycle : plant.cycles()) {
    EXPECT_LE(std::abs(cycle.state.adjust), 20'000);
    overshoot = std::max(overshoot, -cycle.grid_error);
  }
  EXPECT_LT(overshoot, 8'000);
}

TEST(MasterShift, HoldsAtShortAndLongCycles) {
  for (const Nanoseconds cycle : {62'500, 125'000, 250'000, 2'000'000, 4'000'000}) {
    auto options = master_shifted(JitterProfile::quiet());
    options.cycle = cycle;
    options.set_value = cycle * 2 / 3;
    DcmPlant plant(options);
    plant.run_until(8);
    EXPECT_LT(plant.in_sync_at(), 2) << cycle;
    EXPECT_LT(plant.worst(&PlantCycle::grid_error, 6), 100) << cycle;
  }
}

TEST(MasterShift, OneLateCycleLeavesTheScheduleAlone) {
  auto options = master_shifted(JitterProfile::quiet());
  options.late = [](int cycle) { return cycle == 8'000 ? 900e3 : 0.0; };
  DcmPlant plant(options);
  plant.run_until(12);
  EXPECT_EQ(plant.times_lost(), 0);
  EXPECT_LT(plant.worst(&PlantCycle::grid_error, 5, 7.9995), 30);
  // 0.9 ms at 50 ppm: the clock really is that much further when the late frame passes.
  EXPECT_LT(plant.worst(&PlantCycle::grid_error, 8.001), 30);
}

TEST(MasterShift, AFrameStampedWrongIsGated) {
  // Late by 60 us without the host knowing: the schedule must not follow it.
  class Plain {
   public:
    Plain() { controller.start(666'667, 0, 0); }
    Nanoseconds cycle(Nanoseconds error) {
      time += kMillisecond;
      return controller.observe({time, time, time + error}).period_adjust;
    }
    MasterShift controller{settings_for(DcmMode::kMasterShift), kMillisecond, 666'667};
    Nanoseconds time = 0;
  } plain;
  for (int i = 0; i < 3000; ++i) plain.cycle(0);
  ASSERT_TRUE(plain.controller.state().in_sync);
  EXPECT_EQ(plain.cycle(60'000), 0);
  EXPECT_TRUE(plain.controller.state().in_sync);
  // An error that does not go away is the truth, and is corrected.
  Nanoseconds moved = 0;
  for (int i = 0; i < 40; ++i) moved += plain.cycle(60'000);
  EXPECT_LT(moved, -5'000);
}

TEST(MasterShift, CoastsWithTheLearnedDriftWhileFramesAreLost) {
  auto options = master_shifted(JitterProfile::quiet(), 400);
  options.lost = [](int cycle) { return cycle >= 8'000 && cycle < 8'150; };
  DcmPlant plant(options);
  plant.run_until(12);
  EXPECT_EQ(plant.times_lost(), 0);
  // 150 cycles at 400 ppm without the integral would be 60 us.
  EXPECT_LT(plant.worst(&PlantCycle::grid_error, 8), 200);
}

TEST(MasterShift, SilenceOfTheReferenceClockLosesTheLock) {
  auto options = master_shifted(JitterProfile::quiet());
  options.lost = [](int cycle) { return cycle >= 5'000 && cycle < 6'000; };
  DcmPlant plant(options);
  plant.run_until(5.1);
  EXPECT_TRUE(plant.last().state.in_sync);
  plant.run_until(5.5);
  EXPECT_FALSE(plant.last().state.in_sync);
  plant.run_until(9);
  EXPECT_TRUE(plant.last().state.in_sync);
  EXPECT_FALSE(plant.reported(kDcmErrorOutOfLimit)) << "nobody knows of an error";
  EXPECT_EQ(plant.times_lost(), 1);
}

TEST(MasterShift, NoSlowBeatBetweenTheTwoClocks) {
  DcmPlant plant(master_shifted(JitterProfile::desktop(), 50));
  plant.run_until(70);
  // A schedule that slid through the grid would need 20 s for a cycle at 50 ppm; means of 5 s show it.
  for (double from = 10; from < 65; from += 5) {
    EXPECT_LT(std::abs(plant.mean(&PlantCycle::grid_error, from, from + 5)), 10) << from;
  }
}

TEST(MasterShift, ToleratesSendStampsOfAFewMicroseconds) {
  auto options = master_shifted(JitterProfile::desktop());
  options.stamp_noise = 3'000;
  DcmPlant plant(options);
  plant.run_until(30);
  EXPECT_LT(plant.in_sync_at(), 2);
  EXPECT_EQ(plant.times_lost(), 0);
  EXPECT_LT(plant.rms(&PlantCycle::grid_error, 10), 500);
  EXPECT_NEAR(plant.last().state.drift_ppm, 50, 8);
}

TEST(MasterShift, DriftBeyond600PpmIsReportedThoughBalanced) {
  for (const double ppm : {-800.0, 800.0}) {
    DcmPlant plant(master_shifted(JitterProfile::quiet(), ppm));
    plant.run_until(5);
    EXPECT_EQ(plant.last().state.error_code, kDcmErrorDriftTooHigh);
    EXPECT_NEAR(plant.last().state.drift_ppm, ppm, 1);
    EXPECT_LT(plant.worst(&PlantCycle::grid_error, 4), 200);
  }
  DcmPlant plant(master_shifted(JitterProfile::quiet(), 590));
  plant.run_until(5);
  EXPECT_FALSE(plant.reported(kDcmErrorDriftTooHigh));
}

TEST(MasterShift, RepeatsItselfBitByBit) {
  DcmPlant first(master_shifted(JitterProfile::desktop())), second(master_shifted(JitterProfile::desktop()));
  first.run_until(3);
  second.run_until(3);
  ASSERT_EQ(first.cycles().size(), second.cycles().size());
  for (std::size_t i = 0; i < first.cycles().size(); ++i) {
    ASSERT_EQ(first.cycles()[i].state.adjust, second.cycles()[i].state.adjust);
    ASSERT_EQ(first.cycles()[i].grid_error, second.cycles()[i].grid_error);
  }
}

TEST(MasterShift, SwingsAtTheFrequencyOfItsGains) {
  DcmSettings settings;
  settings.mode = DcmMode::kMasterShift;
  settings.gain_ppt = 100;
  settings.drift_error_gain = 3;
  EXPECT_NEAR(loop_frequency(settings, kMillisecond).value(), 11.25, 0.01) << "0.05 * sqrt(2) radians a cycle";
  EXPECT_NEAR(loop_frequency(settings, 2 * kMillisecond).value(), 5.63, 0.01);
  settings.drift_error_gain = 1;
  EXPECT_FALSE(loop_frequency(settings, kMillisecond)) << "critically damped";
  settings.drift_error_gain = 3;
  settings.mode = DcmMode::kBusShift;
  EXPECT_FALSE(loop_frequency(settings, kMillisecond)) << "not this loop alone";
}

}  // namespace
}  // namespace syncline::dc
