// SPDX-License-Identifier: Apache-2.0
#include "trace/reference_times.h"

#include <gtest/gtest.h>

#include <vector>

#include "channels/cycle_sample.h"

namespace syncline {
namespace {

constexpr Nanoseconds kHost = 800'000'000 * kSecond, kReference = 900'000'000 * kSecond;

/// A reference clock that is 50 ppm fast and steps by 20 ms after two seconds.
Nanoseconds reference(Nanoseconds since) {
  return kReference + since + since / 20'000 + (since >= 2 * kSecond ? 20 * kMillisecond : 0);
}

std::vector<CycleSample> cycles(int from, int to) {
  std::vector<CycleSample> samples;
  for (int i = from; i < to; ++i) {
    CycleSample sample;
    sample.send_time = kHost + i * kMillisecond;
    sample.reference_time = static_cast<decltype(sample.reference_time)>(reference(i * kMillisecond));
    sample.flags = CycleSample::kReferenceValid;
    samples.push_back(sample);
  }
  return samples;
}

TEST(ReferenceTimes, TellsWhatTheFramesRead) {
  ReferenceTimes times;
  EXPECT_EQ(times.at(kHost), std::nullopt);
  for (int part = 0; part < 40; ++part) times.add(cycles(part * 100, part * 100 + 100));
  for (const int ms : {0, 1, 50, 99, 100, 1234, 1999, 2000, 2001, 3999})
    EXPECT_NEAR(static_cast<double>(*times.at(kHost + ms * kMillisecond) - reference(ms * kMillisecond)), 0, 2) << ms;
  EXPECT_EQ(times.at(kHost - 1), std::nullopt);
  EXPECT_TRUE(times.at(kHost + 5 * kSecond));
  EXPECT_EQ(times.at(kHost + 20 * kSecond), std::nullopt) << "nobody knows what it did since";
}

TEST(ReferenceTimes, ReachesNotAcrossALongSilence) {
  ReferenceTimes times;
  times.add(cycles(0, 10));
  times.add(cycles(60'000, 60'010));
  EXPECT_EQ(times.at(kHost + 30 * kSecond), std::nullopt);
  EXPECT_TRUE(times.at(kHost + 60 * kSecond));
}

TEST(ReferenceTimes, WhatIsNotValidIsNoReading) {
  ReferenceTimes times;
  auto samples = cycles(0, 10);
  for (auto& sample : samples) sample.flags = 0;
  times.add(samples);
  EXPECT_EQ(times.at(kHost), std::nullopt);
}

}  // namespace
}  // namespace syncline
