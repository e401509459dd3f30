// SPDX-License-Identifier: Apache-2.0
#include "trace/signal_quality.h"

#include <gtest/gtest.h>

#include <set>
#include <string_view>
#include <vector>

#include "channels/cycle_sample.h"
#include "channels/snapshot.h"

namespace syncline {
namespace {

using Clock = SignalInfo::Clock;

/// Two seconds of cycles of 1 ms in which one of four slaves is read in turn; every tenth frame is lost.
class SignalQualityTest : public testing::Test {
 protected:
  SignalQualityTest() {
    std::vector<CycleSample> samples;
    for (std::uint64_t cycle = 1; cycle <= 2000; ++cycle) {
      CycleSample s;
      s.cycle = cycle;
      s.send_time = static_cast<Nanoseconds>(cycle) * kMillisecond;
      s.stamped_by = StampSource::kKernel;
      if (cycle % 10 == 0) {
        s.flags = CycleSample::kFrameLost;
      } else {
        s.flags = CycleSample::kFollowersRead | CycleSample::kDcmActive | CycleSample::kReferenceValid |
                  CycleSample::kSlaveFollows;
        s.stamp_doubt_ns = cycle == 1500 - 1 ? 2400 : 300;
        s.slave_position = static_cast<std::int16_t>(cycle % 4);
      }
      samples.push_back(s);
    }
    store.append(samples);
  }
  SampleStore store{{.slaves = 4}};
  static constexpr Nanoseconds kNow = 2000 * kMillisecond;
};

TEST_F(SignalQualityTest, RateAndAgeAreThoseOfReadingsThatHaveAValue) {
  const auto every_cycle = quality_of(store, Signal::kDeviation, 0, kNow);
  EXPECT_NEAR(every_cycle.rate.value_or(0), 900, 1);
  EXPECT_EQ(every_cycle.age, kMillisecond) << "the frame of the last cycle was lost";
  const auto in_turn = quality_of(store, Signal::kSlaveDeviation, 3, kNow);
  EXPECT_NEAR(in_turn.rate.value_or(0), 250, 1);
  EXPECT_EQ(in_turn.age, kMillisecond);
  EXPECT_EQ(quality_of(store, Signal::kSlaveDeviation, 1, kNow).age, 3 * kMillisecond);
}

TEST_F(SignalQualityTest, EachClockHasItsDoubt) {
  EXPECT_EQ(quality_of(store, Signal::kDeviation, 0, kNow).value_doubt, kSlaveClockStep);
  EXPECT_EQ(quality_of(store, Signal::kRoundTrip, 0, kNow).value_doubt, 2400) << "the worst of the second before";
  EXPECT_EQ(quality_of(store, Signal::kDcmError, 0, kNow).value_doubt, 2410);
  EXPECT_EQ(quality_of(store, Signal::kDcmError, 0, 1400 * kMillisecond).value_doubt, 310);
  EXPECT_EQ(quality_of(store, Signal::kWkcReceived, 0, kNow).value_doubt, std::nullopt) << "a count is no time";
  EXPECT_EQ(quality_of(store, Signal::kStampDoubt, 0, kNow).value_doubt, std::nullopt);
  EXPECT_EQ(quality_of(store, Signal::kDeviation, 0, kNow).time_doubt, 2400);
  EXPECT_EQ(quality_of(store, Signal::kDeviation, 0, kNow).stamped_by, StampSource::kKernel);
}

TEST_F(SignalQualityTest, WhatIsReadNowAndThenIsAsOldAsItsReading) {
  for (const Nanoseconds read : {400, 900, 1400}) {
    Snapshot snapshot;
    snapshot.time = read * kMillisecond + 20 * kMillisecond;
    snapshot.slaves.resize(4);
    snapshot.slaves[2].present = true;
    snapshot.slaves[2].evidence.ports_time = read * kMillisecond;
    store.append(snapshot);
  }
  const auto count = quality_of(store, port_signal(1, PortSignal::kLostLinks), 2, kNow);
  EXPECT_EQ(count.age, 600 * kMillisecond);
  EXPECT_EQ(count.rate, 2.0);
  EXPECT_EQ(count.time_doubt, 500 * kMillisecond) << "it may have changed any time since the reading before";
  const auto never = quality_of(store, port_signal(1, PortSignal::kLostLinks), 1, kNow);
  EXPECT_EQ(never.age, std::nullopt);
  EXPECT_EQ(never.rate, std::nullopt);
}

/// A recording keeps the changes of counts: how often they were read is not known by them.
TEST_F(SignalQualityTest, ChangesAreNoReadings) {
  const std::vector<Nanoseconds> times{100 * kMillisecond, 1300 * kMillisecond};
  const std::vector<float> values{1, 2};
  store.restore(Signal::kPdiErrors, 0, times, values, kNow);
  const auto count = quality_of(store, Signal::kPdiErrors, 0, kNow);
  EXPECT_EQ(count.rate, std::nullopt);
  EXPECT_EQ(count.age, 0);
}

TEST(SignalQuality, OfNoRunNothingIsKnown) {
  const SampleStore none({.slaves = 1});
  EXPECT_EQ(quality_of(none, Signal::kDcmError, 0, 0), (SignalQuality{.rate = {},
                                                                      .age = {},
                                                                      .clock = Clock::kBoth,
                                                                      .value_doubt = {},
                                                                      .stamped_by = StampSource::kUntold,
                                                                      .time_doubt = {}}));
}

TEST(SignalQuality, NamesAreToldApart) {
  std::set<std::string_view> names;
  for (int source = 0; source < kStampSources; ++source) names.insert(name_of(static_cast<StampSource>(source)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kStampSources));
  std::set<std::string_view> clocks;
  for (const auto clock : {Clock::kNone, Clock::kHost, Clock::kSlaves, Clock::kBoth}) clocks.insert(name_of(clock));
  EXPECT_EQ(clocks.size(), 4U);
}

}  // namespace
}  // namespace syncline
