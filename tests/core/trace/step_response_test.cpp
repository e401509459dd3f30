// SPDX-License-Identifier: Apache-2.0
#include "trace/step_response.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "config/dcm_settings.h"
#include "dc/dcm/predicted_step.h"
#include "support/random.h"

namespace syncline {
namespace {

std::vector<StepResponse::Sample> course(std::size_t count, const std::function<double(double)>& value_at_ms) {
  std::vector<StepResponse::Sample> samples;
  for (std::size_t i = 0; i < count; ++i) {
    const auto time = static_cast<Nanoseconds>(i) * kMillisecond;
    samples.push_back({kSecond + time, value_at_ms(static_cast<double>(i))});
  }
  return samples;
}

TEST(StepResponse, OfAnExponentialIsWhatItsTimeConstantSays) {
  const auto found = step_response(course(1'000, [](double ms) { return 50 + 5'000 * std::exp(-ms / 20); }));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->final, 50, 0.1);
  EXPECT_NEAR(found->step, 5'000, 1);
  EXPECT_EQ(found->overshoot, 0);
  EXPECT_NEAR(static_cast<double>(*found->rise), 20e6 * std::log(10), 1.1e6);
  EXPECT_NEAR(static_cast<double>(*found->settled), 20e6 * std::log(20), 1.1e6);
}

TEST(StepResponse, OfASwingTellsTheOvershoot) {
  // Damping 0.2: the first swing beyond is exp(-pi * 0.2 / sqrt(1 - 0.04)) = 53 % of the step.
  const double damping = 0.2, turn = 0.05;
  const auto swing = [&](double ms) {
    const double natural = turn / std::sqrt(1 - damping * damping);
    return -3'000 * std::exp(-damping * natural * ms) *
           (std::cos(turn * ms) + damping / std::sqrt(1 - damping * damping) * std::sin(turn * ms));
  };
  const auto found = step_response(course(2'000, swing));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->overshoot, 0.527, 0.01);
  EXPECT_NEAR(found->step, -3'000, 1);
  ASSERT_TRUE(found->settled);
  EXPECT_GT(*found->settled, 200 * kMillisecond);
  EXPECT_LT(*found->settled, 310 * kMillisecond);
}

TEST(StepResponse, NoiseAndSingleLateStampsDoNotUnsettleIt) {
  Random random(4);
  const auto noisy = [&](double ms) {
    if (ms == 600) return 4'000.0;
    return 6'000 * std::exp(-ms / 10) + 60 * random.normal();
  };
  const auto found = step_response(course(1'000, noisy));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->noise, 60, 15);
  ASSERT_TRUE(found->settled);
  EXPECT_NEAR(static_cast<double>(*found->settled), 10e6 * std::log(20), 6e6);
}

TEST(StepResponse, NothingIsSaidWhereNoStepIsSeenAndNoTimeWhereItDoesNotSettle) {
  Random random(5);
  EXPECT_FALSE(step_response(course(500, [&](double) { return 40 * random.normal(); })));
  EXPECT_FALSE(step_response(course(10, [](double ms) { return 100 - ms; })));
  EXPECT_FALSE(step_response(course(100, [](double) { return 0; })));
  const auto rising = step_response(course(500, [](double ms) { return 10'000 - 10 * ms; }));
  ASSERT_TRUE(rising);
  EXPECT_FALSE(rising->settled && *rising->settled < 400 * kMillisecond);
}

/// The controller takes back a tenth of the phase in each cycle, whatever its gains; no swing without noise.
TEST(PredictedStep, IsTheControllersOwnCourse) {
  DcmSettings settings;
  settings.mode = DcmMode::kMasterShift;
  const auto errors = dc::predicted_step(settings, kMillisecond, 20'000, 500);
  ASSERT_EQ(errors.size(), 500U);
  EXPECT_NEAR(errors.front(), 20'000, 1);
  EXPECT_NEAR(errors.back(), 0, 50);
  std::vector<StepResponse::Sample> samples;
  for (std::size_t i = 0; i < errors.size(); ++i)
    samples.push_back({static_cast<Nanoseconds>(i) * kMillisecond, errors[i]});
  const auto found = step_response(samples);
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->settled);
  EXPECT_GT(*found->settled, 10 * kMillisecond);
  EXPECT_LT(*found->settled, 200 * kMillisecond);
  EXPECT_LT(found->overshoot, 0.3);
  settings.mode = DcmMode::kBusShift;
  EXPECT_TRUE(dc::predicted_step(settings, kMillisecond, 20'000, 500).empty()) << "the ESC's loop is part of it";
  settings.mode = DcmMode::kMasterShift;
  settings.control_off = true;
  EXPECT_TRUE(dc::predicted_step(settings, kMillisecond, 20'000, 500).empty());
}

}  // namespace
}  // namespace syncline
