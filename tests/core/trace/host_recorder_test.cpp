// SPDX-License-Identifier: Apache-2.0
#include "trace/host_recorder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "channels/cycle_sample.h"
#include "protocol/al_state.h"
#include "support/clock.h"
#include "support/jitter_profile.h"
#include "support/random.h"

namespace syncline {
namespace {

constexpr Nanoseconds kCycle = kMillisecond;

/// A run of a host with a known profile; the reference clock runs 40 ppm faster than the host.
std::vector<CycleSample> run_with(const JitterProfile& profile, int cycles, bool reference = true) {
  Random random(7);
  std::vector<CycleSample> samples;
  Nanoseconds scheduled = VirtualClock::kDefaultStart;
  for (int i = 0; i < cycles; ++i, scheduled += kCycle) {
    CycleSample sample;
    sample.master_state = static_cast<std::uint8_t>(AlState::kOp);
    const auto late = static_cast<Nanoseconds>(profile.wake_up.at(random.uniform()));
    const auto error = static_cast<Nanoseconds>(profile.stamp_error.at(random.uniform()));
    sample.wake_lateness_ns = static_cast<std::int32_t>(late);
    sample.send_time = scheduled + late;
    sample.round_trip_ns = static_cast<std::int32_t>(20'000 + error);
    if (reference) {
      const auto left = sample.send_time + error - VirtualClock::kDefaultStart;
      sample.flags |= CycleSample::kReferenceValid;
      sample.reference_time = 5 * kSecond + left + static_cast<Nanoseconds>(static_cast<double>(left) * 40e-6);
    }
    samples.push_back(sample);
  }
  return samples;
}

JitterProfile known() {
  JitterProfile profile;
  profile.wake_up = {{{0, 100}, {0.5, 500}, {0.99, 5'000}, {1, 40'000}}};
  profile.stamp_error = {{{0, 0}, {0.5, 300}, {0.9, 800}, {0.99, 3'000}, {0.999, 12'000}, {1, 72'000}}};
  return profile;
}

void expect_as_known(const JitterProfile& profile, double tolerance) {
  // Beside the corners of the curves: at a corner the next observation may be seven times as large.
  for (const double part : {0.4, 0.8, 0.95, 0.995}) {
    const auto wake_up = known().wake_up.at(part), error = known().stamp_error.at(part);
    EXPECT_NEAR(profile.wake_up.at(part), wake_up, 0.15 * wake_up + 50) << part;
    EXPECT_NEAR(profile.stamp_error.at(part), error, 0.15 * error + tolerance) << part;
  }
}

TEST(HostRecorder, FindsTheProfileAgainInARunWithAReferenceClock) {
  HostRecorder recorder(kCycle);
  recorder.add(run_with(known(), 60'000));
  EXPECT_EQ(recorder.cycles(), 60'000U);
  const auto profile = recorder.profile();
  expect_as_known(profile, 300);  // the median of its neighbours stands for a reading without error
  EXPECT_GT(profile.stamp_error.at(1), 40'000);
  EXPECT_EQ(profile.stalls_per_second, 0);
}

TEST(HostRecorder, TakesRoundTripsWhereThereIsNoReferenceClock) {
  HostRecorder recorder(kCycle);
  recorder.add(run_with(known(), 60'000, false));
  expect_as_known(recorder.profile(), 700);  // bins are a 32nd of the round trip
}

TEST(HostRecorder, GapsAreStalls) {
  auto samples = run_with(known(), 10'000);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].send_time += static_cast<Nanoseconds>(i / 2'000) * 5 * kMillisecond;
    samples[i].reference_time += static_cast<Nanoseconds>(i / 2'000) * 5 * kMillisecond;
  }
  HostRecorder recorder(kCycle);
  recorder.add(samples);
  const auto profile = recorder.profile();
  EXPECT_NEAR(profile.stalls_per_second, 0.4, 0.01);
  EXPECT_NEAR(profile.stall.at(0.5), 5e6, 0.2e6);
}

TEST(HostRecorder, CyclesWithoutProcessDataDoNotCount) {
  auto samples = run_with(known(), 100);
  for (auto& sample : samples) sample.master_state = static_cast<std::uint8_t>(AlState::kPreop);
  HostRecorder recorder(kCycle);
  recorder.add(samples);
  EXPECT_EQ(recorder.cycles(), 0U);
  EXPECT_EQ(recorder.profile(), JitterProfile::none());
  // A host that makes a machine fall is that host.
  for (auto& sample : samples) sample.master_state = static_cast<std::uint8_t>(AlState::kSafeop);
  recorder.add(samples);
  EXPECT_EQ(recorder.cycles(), 100U);
}

}  // namespace
}  // namespace syncline
