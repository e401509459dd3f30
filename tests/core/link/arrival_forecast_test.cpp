// SPDX-License-Identifier: Apache-2.0
#include "link/arrival_forecast.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace syncline {
namespace {

constexpr Nanoseconds kStart = 5 * kSecond;

TEST(ArrivalForecast, KnowsTheNextFrameOfACycle) {
  ArrivalForecast forecast;
  Random random(3);
  Nanoseconds time = kStart;
  unsigned within = 0;
  for (int cycle = 0; cycle < 1000; ++cycle) {
    const auto came = time + static_cast<Nanoseconds>(random.uniform(-3000, 3000));
    if (const auto window = forecast.next()) {
      EXPECT_LE(window->until - window->from, 100 * kMicrosecond) << "a tenth of the cycle";
      within += came >= window->from && came <= window->until ? 1 : 0;
    }
    forecast.arrived(came);
    forecast.arrived(came + 20 * kMicrosecond);  // a second frame of the same cycle
    time += kMillisecond;
  }
  EXPECT_GE(within, 970U);
}

TEST(ArrivalForecast, FollowsAMasterThatChangesItsCycle) {
  ArrivalForecast forecast;
  Nanoseconds time = kStart;
  for (int cycle = 0; cycle < 50; ++cycle) forecast.arrived(time += kMillisecond);
  ASSERT_TRUE(forecast.next());
  for (int cycle = 0; cycle < 50; ++cycle) forecast.arrived(time += 4 * kMillisecond);
  const auto window = forecast.next();
  ASSERT_TRUE(window);
  EXPECT_LE(window->from, time + 4 * kMillisecond);
  EXPECT_GE(window->until, time + 4 * kMillisecond);
}

TEST(ArrivalForecast, SaysNothingOfFramesThatComeAtAnyTime) {
  ArrivalForecast forecast;
  Random random(4);
  Nanoseconds time = kStart;
  unsigned said = 0;
  for (int frame = 0; frame < 2000; ++frame) {
    forecast.arrived(time += static_cast<Nanoseconds>(random.uniform(200e3, 3e6)));
    said += forecast.next() ? 1 : 0;
  }
  EXPECT_LE(said, 20U);
}

/// A tenth of it would be less than a timer is good for.
TEST(ArrivalForecast, LeavesTheProcessorAloneInShortCycles) {
  ArrivalForecast forecast;
  Nanoseconds time = kStart;
  for (int cycle = 0; cycle < 100; ++cycle) forecast.arrived(time += 125 * kMicrosecond);
  EXPECT_FALSE(forecast.next());
}

}  // namespace
}  // namespace syncline
