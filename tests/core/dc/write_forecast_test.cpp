// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/write_forecast.h"

#include <gtest/gtest.h>

#include "dc/dcm/dcm_controller.h"

namespace syncline::dc {
namespace {

DcmObservation reading(Nanoseconds send_time, Nanoseconds reference_time) {
  DcmObservation observation;
  observation.send_time = send_time;
  observation.reference_time = reference_time;
  return observation;
}

TEST(WriteForecast, KnowsNothingBeforeTheFirstReading) { EXPECT_FALSE(WriteForecast(3'000).at(kSecond)); }

TEST(WriteForecast, CountsOnAtTheClocksOwnRate) {
  WriteForecast forecast(3'000);
  (void)forecast.take(reading(kSecond, 7 * kSecond), 0, false);
  EXPECT_EQ(forecast.at(kSecond + 10 * kMillisecond), 7 * kSecond + 10 * kMillisecond);
  EXPECT_EQ(forecast.at(kSecond + 10 * kMillisecond, 40), 7 * kSecond + 10 * kMillisecond + 400);
  EXPECT_EQ(forecast.at(kSecond + 10 * kMillisecond, -25), 7 * kSecond + 10 * kMillisecond - 250);
}

/// From the stamp to the driver: learned by a twentieth of what it is off, by 50 ns a reading at most.
TEST(WriteForecast, LearnsTheUsualWayToTheDriver) {
  WriteForecast forecast(3'000);
  auto late = reading(kSecond, 7 * kSecond);
  late.way_out = 800;
  (void)forecast.take(late, 0, false);
  EXPECT_EQ(forecast.usual_way(), 40);
  for (int i = 0; i < 300; ++i) (void)forecast.take(late, 0, false);
  EXPECT_EQ(forecast.usual_way(), 800);
  late.way_out = 90'000;
  (void)forecast.take(late, 0, false);
  EXPECT_EQ(forecast.usual_way(), 850);
}

TEST(WriteForecast, StartsAnew) {
  WriteForecast forecast(3'000);
  (void)forecast.take(reading(kSecond, 7 * kSecond), 0, false);
  forecast.start();
  EXPECT_FALSE(forecast.at(kSecond));
}

}  // namespace
}  // namespace syncline::dc
