// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/predicted_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "config/dcm_settings.h"

namespace syncline::dc {
namespace {

DcmSettings shifted() { return {.mode = DcmMode::kMasterShift, .set_value = {}}; }

TEST(PredictedStep, BeginsWithTheStepAndEndsWhereItWas) {
  for (const Nanoseconds step : {2'000, -2'000, 50'000}) {
    const auto errors = predicted_step(shifted(), kMillisecond, step, 8'000);
    ASSERT_EQ(errors.size(), 8'000U);
    EXPECT_EQ(errors.front(), static_cast<double>(step));
    EXPECT_LT(std::abs(errors.back()), 5) << step;
    EXPECT_LT(std::abs(errors[4'000]), std::abs(static_cast<double>(step)) / 4) << step;
  }
}

/// No step, no answer: it was settled before.
TEST(PredictedStep, IsNothingWithoutAStep) {
  for (const double error : predicted_step(shifted(), kMillisecond, 0, 500)) ASSERT_EQ(error, 0);
}

TEST(PredictedStep, IsOnlyThereWhereTheHostsTimerIsMoved) {
  EXPECT_TRUE(predicted_step(shifted(), 0, 1'000, 10).empty());
  for (const auto mode : {DcmMode::kOff, DcmMode::kBusShift, DcmMode::kMasterRefClock, DcmMode::kMasterShiftByApp}) {
    EXPECT_TRUE(predicted_step({.mode = mode, .set_value = {}}, kMillisecond, 1'000, 10).empty());
  }
  auto off = shifted();
  off.control_off = true;
  EXPECT_TRUE(predicted_step(off, kMillisecond, 1'000, 10).empty());
}

}  // namespace
}  // namespace syncline::dc
