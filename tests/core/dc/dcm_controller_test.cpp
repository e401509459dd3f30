// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/dcm_controller.h"

#include <gtest/gtest.h>

#include "dc/dcm/bus_cycle_check.h"
#include "dc/dcm/drift_estimator.h"
#include "dcm_plant.h"
#include "protocol/dcm_error.h"

namespace syncline::dc {
namespace {

TEST(DcmController, FactoryFollowsTheMode) {
  const auto make = [](DcmMode mode) { return make_dcm_controller(settings_for(mode), kMillisecond, 666'667); };
  for (const auto mode : {DcmMode::kOff, DcmMode::kMasterShift, DcmMode::kBusShift}) {
    auto controller = make(mode);
    ASSERT_NE(controller, nullptr);
    controller->start(0, 333'333, 0);
    EXPECT_EQ(controller->reference_write(0, 0).has_value(), mode == DcmMode::kBusShift);
  }
}

TEST(DcmController, OffControlsNothingAndShowsTheNaturalDrift) {
  PlantOptions options;
  options.mode = DcmMode::kOff;
  options.reference_ppm = 50;
  DcmPlant plant(options);
  plant.run_until(2);
  EXPECT_NEAR(plant.last().state.drift_ppm, 50, 0.2);
  EXPECT_NEAR(static_cast<double>(plant.last().state.error), 100'000, 500);  // 2 s at 50 ppm
  EXPECT_FALSE(plant.last().state.in_sync);
  EXPECT_EQ(plant.last().state.adjust, 0);
}

TEST(DcmController, ErrorIsPositiveWhenTheFrameIsLateInTheGrid) {
  for (const auto mode : {DcmMode::kOff, DcmMode::kMasterShift, DcmMode::kBusShift}) {
    auto controller = make_dcm_controller(settings_for(mode), kMillisecond, 600'000);
    controller->start(0, 5'400'000, 0);
    (void)controller->observe({kMillisecond, kMillisecond, 6'402'000});
    EXPECT_EQ(controller->state().error, 2'000) << static_cast<int>(mode);
  }
}

TEST(DcmController, KnownLatenessOfTheHostIsNoErrorOfTheSchedule) {
  for (const auto mode : {DcmMode::kOff, DcmMode::kMasterShift, DcmMode::kBusShift}) {
    auto controller = make_dcm_controller(settings_for(mode), kMillisecond, 600'000);
    controller->start(0, 5'400'000, 0);
    (void)controller->observe({kMillisecond + 30'000, kMillisecond, 6'430'000});
    EXPECT_EQ(controller->state().error, 0) << static_cast<int>(mode);
  }
}

TEST(DcmController, LateFramesShortenTheNextPeriod) {
  auto controller = make_dcm_controller(settings_for(DcmMode::kMasterShift), kMillisecond, 600'000);
  controller->start(0, 5'400'000, 0);
  EXPECT_LT(controller->observe({kMillisecond, kMillisecond, 6'402'000}).period_adjust, 0);
}

TEST(DcmController, SetValueOutsideTheCycleIsInvalid) {
  for (const auto mode : {DcmMode::kMasterShift, DcmMode::kBusShift}) {
    for (const Nanoseconds set_value : {Nanoseconds{0}, Nanoseconds{-1}, kMillisecond}) {
      auto controller = make_dcm_controller(settings_for(mode), kMillisecond, set_value);
      controller->start(0, 0, 0);
      (void)controller->observe({0, 0, 0});
      EXPECT_EQ(controller->state().error_code, kDcmErrorInvalidSetValue) << set_value;
    }
  }
}

TEST(DcmController, TheFirstAndTheLastNanosecondOfTheCycleAreValidSetValues) {
  for (const auto mode : {DcmMode::kMasterShift, DcmMode::kBusShift}) {
    for (const Nanoseconds set_value : {Nanoseconds{1}, kMillisecond - 1}) {
      auto controller = make_dcm_controller(settings_for(mode), kMillisecond, set_value);
      controller->start(0, 0, 0);
      (void)controller->observe({0, 0, 0});
      EXPECT_NE(controller->state().error_code, kDcmErrorInvalidSetValue) << set_value;
    }
  }
}

TEST(DcmController, CyclesOfAnotherLengthThanConfiguredAreTold) {
  for (const auto mode : {DcmMode::kMasterShift, DcmMode::kBusShift}) {
    auto controller = make_dcm_controller(settings_for(mode), kMillisecond, 600'000);
    controller->start(0, 400'000, 0);
    for (Nanoseconds time = 0; time < 3 * kSecond; time += 2 * kMillisecond) {
      (void)controller->observe({time, time, 400'000 + time});
    }
    EXPECT_EQ(controller->state().error_code, kDcmErrorBusCycleWrong);
  }
}

TEST(BusCycleCheck, ToleratesAFewCyclesThatWereLeftOutAndRecovers) {
  BusCycleCheck check(kMillisecond);
  Nanoseconds time = 0;
  const auto run = [&](int cycles, int leave_out_every) {
    for (int i = 1; i <= cycles; ++i) {
      check.observe(time, true);
      time += kMillisecond * (i % leave_out_every == 0 ? 2 : 1);
    }
  };
  run(3'000, 100);  // 1 %
  EXPECT_FALSE(check.wrong());
  run(3'000, 20);  // 5 %
  EXPECT_TRUE(check.wrong());
  run(3'000, 1'000'000);
  EXPECT_FALSE(check.wrong());
}

/// A standstill is told as that; a host that has one after the other has another cycle time.
TEST(BusCycleCheck, OneStandstillIsNoOtherCycleTime) {
  constexpr Nanoseconds cycle = 4 * kMillisecond;
  BusCycleCheck check(cycle);
  Nanoseconds time = 0;
  const auto run = [&](int cycles) {
    for (int i = 0; i < cycles; ++i) check.observe(time += cycle, true);
  };
  run(400);
  time += 105 * kMillisecond;
  run(400);
  EXPECT_FALSE(check.wrong());
  for (int i = 0; i < 20; ++i) {
    time += 20 * kMillisecond;
    run(20);
  }
  EXPECT_TRUE(check.wrong());
}

TEST(BusCycleCheck, ASecondInWhichNothingCameBackProvesNothing) {
  BusCycleCheck check(kMillisecond);
  Nanoseconds time = 0;
  for (int i = 0; i < 10'000; ++i) {
    // Away for 200 ms every 900 ms; then the adapter is opened again, and that takes 40 ms.
    const auto phase = i % 900;
    check.observe(time, phase >= 200);
    time += phase == 199 ? 41 * kMillisecond : kMillisecond;
    EXPECT_FALSE(check.wrong());
  }
}

TEST(DriftEstimator, IsExactForAClockThatRunsAway) {
  DriftEstimator drift;
  EXPECT_FALSE(drift.valid());
  for (Nanoseconds time = 0; time <= kSecond; time += kMillisecond) {
    (void)drift.observe(time, 7 * kSecond + time + time / 10'000);
  }
  ASSERT_TRUE(drift.valid());
  EXPECT_NEAR(drift.ppm(), 100, 0.01);
}

TEST(DriftEstimator, AveragesTheStampsNoiseAway) {
  DriftEstimator drift;
  Random random(5);
  for (Nanoseconds time = 0; time <= 10 * kSecond; time += kMillisecond) {
    (void)drift.observe(time + static_cast<Nanoseconds>(3'000 * random.normal()), time - time / 20'000);
  }
  EXPECT_NEAR(drift.ppm(), -50, 8);
}

TEST(DriftEstimator, FollowsAChangeWithinSeconds) {
  DriftEstimator drift;
  Nanoseconds reference = 0;
  for (Nanoseconds time = 0; time <= 20 * kSecond; time += kMillisecond) {
    (void)drift.observe(time, reference);
    reference += kMillisecond + (time < 10 * kSecond ? 50 : -50);
  }
  EXPECT_NEAR(drift.ppm(), -50, 2);
}

}  // namespace
}  // namespace syncline::dc
