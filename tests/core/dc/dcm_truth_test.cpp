// SPDX-License-Identifier: Apache-2.0
// What every controller says of its loop, held against clocks that are known.
#include <gtest/gtest.h>

#include <algorithm>

#include "dcm_plant.h"
#include "protocol/dcm_error.h"

namespace syncline::dc {
namespace {

TEST(DcmTruth, NeverInSyncBesideAnErrorCode) {
  for (const auto mode : {DcmMode::kMasterShift, DcmMode::kBusShift, DcmMode::kMasterRefClock}) {
    for (const double ppm : {-740.0, -680.0, 590.0, 680.0, 740.0}) {
      PlantOptions options;
      options.mode = mode;
      options.reference_ppm = ppm;
      options.jitter = JitterProfile::quiet();
      DcmPlant plant(options);
      plant.run_until(6);
      for (const auto& cycle : plant.cycles()) ASSERT_FALSE(cycle.state.in_sync && cycle.state.error_code != 0) << ppm;
      if (mode != DcmMode::kMasterShift) continue;
      EXPECT_EQ(plant.last().state.in_sync, ppm == 590) << ppm;
      EXPECT_EQ(plant.last().state.error_code, ppm == 590 ? 0 : kDcmErrorDriftTooHigh) << ppm;
    }
  }
}

TEST(DcmTruth, AStepOfTheReferenceClockIsOutOfSyncAtOnceInEveryMode) {
  for (const auto mode :
       {DcmMode::kMasterShift, DcmMode::kBusShift, DcmMode::kMasterRefClock, DcmMode::kLinkLayerRefClock}) {
    for (const double step : {-60e3, 6e3, 20e3, 1e6, -5e6}) {
      PlantOptions options;
      options.mode = mode;
      options.jitter = JitterProfile::quiet();
      options.clock_step = {8'000, step};
      DcmPlant plant(options);
      plant.run_until(8 - 1e-6);
      ASSERT_TRUE(plant.last().state.in_sync) << dcm_mode_name(mode);
      plant.run_until(8.004);
      EXPECT_FALSE(plant.last().state.in_sync) << dcm_mode_name(mode) << " " << step;
      const auto told =
          std::ranges::find_if(plant.cycles(), [](const auto& c) { return c.state.clock_step.has_value(); });
      ASSERT_NE(told, plant.cycles().end()) << dcm_mode_name(mode) << " " << step;
      EXPECT_NEAR(static_cast<double>(*told->state.clock_step), step, 1'000);
      const bool follows = mode == DcmMode::kMasterShift || mode == DcmMode::kBusShift;
      plant.run_until(follows ? 12 : 9);
      if (!follows) continue;
      EXPECT_LT(std::abs(plant.last().state.drift_ppm - (mode == DcmMode::kMasterShift ? 50 : 0)), 3);
      EXPECT_TRUE(plant.last().state.in_sync) << dcm_mode_name(mode) << " " << step;
    }
  }
}

TEST(DcmTruth, WithControlOffEveryModeShowsTheNaturalDriftAndWhatTheTimerWouldNeed) {
  for (const auto mode : {DcmMode::kMasterShift, DcmMode::kMasterShiftByApp, DcmMode::kBusShift,
                          DcmMode::kMasterRefClock, DcmMode::kLinkLayerRefClock, DcmMode::kDcx}) {
    auto settings = settings_for(mode);
    settings.control_off = true;
    const auto controller = make_dcm_controller(settings, kMillisecond, 600'000);
    controller->start(0, 5'400'000, 0);
    for (Nanoseconds time = kMillisecond; time < 10 * kSecond; time += kMillisecond) {
      ASSERT_FALSE(controller->reference_write(time, time));
      ASSERT_EQ(controller->observe({time, time, 5'400'000 + time + time / 20'000}).period_adjust, 0);
    }
    EXPECT_NEAR(controller->state().drift_ppm, 50, 0.1) << dcm_mode_name(mode);
    EXPECT_LT(controller->state().adjust, -50) << dcm_mode_name(mode);
    EXPECT_NEAR(controller->state().output_sum, -50, 1) << dcm_mode_name(mode);
  }
}

}  // namespace
}  // namespace syncline::dc
