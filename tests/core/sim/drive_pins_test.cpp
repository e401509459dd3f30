// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "sim/segment/pin_trace.h"
#include "tests/core/sim/drive_bed.h"

namespace syncline::test {
namespace {

constexpr unsigned kSync0Pin = 1, kServoPin = 2, kFramePin = 3;

class DrivePins : public testing::Test {
 protected:
  static void configure(DriveBed& drive) {
    EXPECT_EQ(drive.write(0x2193, 1, function(11)), 0U);
    EXPECT_EQ(drive.write(0x2193, 2, function(0x200)), 0U);
    EXPECT_EQ(drive.write(0x2193, 3, function(12)), 0U);
  }
  /// Five words, the first of which is the function (ESI of a Copley XE2).
  static std::vector<std::uint8_t> function(std::uint16_t value) {
    std::vector<std::uint8_t> data(10);
    store_le(std::span(data).first(2), value);
    return data;
  }
  static std::vector<Nanoseconds> rising(DriveBed& drive, unsigned pin) {
    drive.probe.bus->advance_to(drive.probe.now);
    std::vector<Nanoseconds> times;
    for (const auto& edge : drive.probe.bus->pin_edges(0, pin)) {
      if (edge.level) times.push_back(edge.time);
    }
    return times;
  }
  /// Distance from each of the last SYNC0 edges to the nearest edge of the servo period.
  static Nanoseconds largest_distance(DriveBed& drive, std::size_t last) {
    const auto syncs = rising(drive, kSync0Pin), periods = rising(drive, kServoPin);
    Nanoseconds largest = 0;
    for (std::size_t i = syncs.size() - 1 - last; i + 1 < syncs.size(); ++i) {
      Nanoseconds nearest = INT64_MAX;
      for (const auto period : periods) nearest = std::min(nearest, std::abs(period - syncs[i]));
      largest = std::max(largest, nearest);
    }
    return largest;
  }
};

TEST_F(DrivePins, ConfigurationTakesTheKnownFunctionsOnly) {
  DriveBed drive("SL-XE2");
  configure(drive);
  EXPECT_EQ(drive.read(0x2193, 2), 0x200U);
  EXPECT_EQ(drive.write(0x2193, 1, function(13)), 0x06090030U);
  EXPECT_EQ(drive.write(0x2193, 1, {11, 0}), 0x06070013U) << "too short";
  EXPECT_EQ(drive.write(0x2193, 8, function(11)), 0x06090011U);
}

TEST_F(DrivePins, ServoPeriodSlidesOntoSync0) {
  for (const double ppm : {0.0, 50.0, -100.0}) {
    DriveBed drive("SL-XE2", {}, ppm);
    configure(drive);
    drive.start_sync0(1'000'000);
    ASSERT_EQ(drive.to_safeop(), 4);
    drive.probe.pass(20 * kMillisecond);
    EXPECT_EQ(drive.read(0x21B4, 0), 0x05U) << "not yet";
    EXPECT_GT(largest_distance(drive, 5), 5 * kMicrosecond);
    drive.probe.pass(480 * kMillisecond);
    EXPECT_EQ(drive.read(0x21B4, 0), 0x07U);
    EXPECT_LE(largest_distance(drive, 100), 200) << "in a correct system both edges come together";
    const auto syncs = rising(drive, kSync0Pin);
    EXPECT_NEAR(static_cast<double>(syncs.back() - syncs[syncs.size() - 2]), 1'000'000 / (1 + ppm * 1e-6), 20);
  }
}

TEST_F(DrivePins, ACurrentLoopMultipleLeavesTheServoPeriodBehind) {
  DriveBed drive("SL-XE2");
  configure(drive);
  drive.start_sync0(312'500);
  ASSERT_EQ(drive.to_safeop(), 4);
  drive.probe.pass(500 * kMillisecond);
  EXPECT_EQ(drive.read(0x21B4, 0), 0x01U);
  EXPECT_GT(largest_distance(drive, 100), 60 * kMicrosecond);
  // The current loop, four periods of which make a servo period, comes together with SYNC0.
  const auto syncs = rising(drive, kSync0Pin), periods = rising(drive, kServoPin);
  const auto distance = std::abs(syncs.back() - periods.back()) % 62'500;
  EXPECT_LE(std::min(distance, 62'500 - distance), 200);
}

TEST_F(DrivePins, AClockStepUnlocksThePllForAWhile) {
  FaultConfig step;
  step.kind = FaultKind::kClockStep;
  step.slave = 0;
  step.at = 600 * kMillisecond;
  step.value_ns = 100'000;
  DriveBed drive("SL-XE2", {step});
  configure(drive);
  drive.start_sync0(1'000'000);
  ASSERT_EQ(drive.to_safeop(), 4);
  drive.probe.pass(500 * kMillisecond);
  EXPECT_EQ(drive.read(0x21B4, 0), 0x07U);
  drive.probe.pass(VirtualClock::kDefaultStart + 610 * kMillisecond - drive.probe.now);
  EXPECT_EQ(drive.read(0x21B4, 0), 0x05U);
  drive.probe.pass(600 * kMillisecond);
  EXPECT_EQ(drive.read(0x21B4, 0), 0x07U);
}

TEST_F(DrivePins, OpWaitsForThePll) {
  DriveBed drive("SL-XE2");
  drive.start_sync0(1'000'000);
  ASSERT_EQ(drive.to_safeop(), 4);
  drive.outputs();
  drive.probe.pass(8 * kMillisecond);
  EXPECT_EQ(drive.probe.request(0, 8), 4) << "not yet, and not refused";
  EXPECT_EQ(drive.read(0x21B4, 0), 0x05U);
  drive.cycles(300);
  EXPECT_EQ(drive.read(0x21B4, 0), 0x07U);
  EXPECT_EQ(drive.status(), 8);
}

TEST_F(DrivePins, OpIsRefusedWhenThePllNeverLocks) {
  std::vector<FaultConfig> steps;
  for (int i = 0; i < 400; ++i) {
    FaultConfig step;
    step.kind = FaultKind::kClockStep;
    step.slave = 0;
    step.at = (20 + 10 * i) * kMillisecond;
    step.value_ns = i % 2 == 0 ? 80'000 : -80'000;
    steps.push_back(step);
  }
  DriveBed drive("SL-XE2", steps);
  drive.start_sync0(1'000'000);
  ASSERT_EQ(drive.to_safeop(), 4);
  drive.outputs();
  drive.probe.pass(8 * kMillisecond);
  EXPECT_EQ(drive.probe.request(0, 8), 4);
  drive.cycles(2100);
  EXPECT_EQ(drive.status(), 0x14);
  EXPECT_EQ(drive.probe.al_code(0), 0x0032);
}

TEST_F(DrivePins, FramesShowOnTheirPin) {
  DriveBed drive("SL-XE2");
  configure(drive);
  const auto before = rising(drive, kFramePin).size();
  drive.probe.pass(kMillisecond);
  drive.outputs();
  const auto sent = drive.probe.now - 20 * kMicrosecond;
  const auto edges = drive.probe.bus->pin_edges(0, kFramePin);
  ASSERT_EQ(edges.size(), 2 * before + 2);
  EXPECT_NEAR(static_cast<double>(edges[edges.size() - 2].time - sent), 0, 1000);
  EXPECT_NEAR(static_cast<double>(edges.back().time - edges[edges.size() - 2].time), 5'760, 1000)
      << "64 bytes and preamble";
}

TEST_F(DrivePins, TypeSaysWhetherOutputsWaitForSync0) {
  for (const std::uint8_t type : {0, 2}) {
    DriveBed drive("SL-XE2");
    ASSERT_EQ(drive.write(0x1C32, 1, {type, 0}), 0U);
    ASSERT_EQ(drive.write(0x1C33, 1, {0, 0}), 0U);  // inputs of the last servo period
    drive.start_sync0(1'000'000);
    ASSERT_EQ(drive.to_op(), 8);
    drive.controlword = 0x06;
    drive.cycles(2);
    drive.controlword = 0x07;
    drive.frame(600 * kMicrosecond);
    drive.probe.pass(300 * kMicrosecond);  // a servo period later, before SYNC0
    EXPECT_EQ(drive.statusword() & 0x6F, type == 0 ? 0x23 : 0x21);
    drive.probe.pass(600 * kMicrosecond);
    EXPECT_EQ(drive.statusword() & 0x6F, 0x23);
  }
}

}  // namespace
}  // namespace syncline::test
