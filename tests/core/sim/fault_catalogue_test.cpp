// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "protocol/system_time_difference.h"
#include "sim/device/al_checks.h"
#include "tests/core/sim/drive_bed.h"

/// Each fault of a scenario does to registers what the machine's real counterpart does to them (docs/scenarios.md lists
/// which symptom each one has).
namespace syncline::test {
namespace {

constexpr Nanoseconds kMs = kMillisecond;

FaultConfig fault(FaultKind kind, int slave, Nanoseconds at, Nanoseconds until = 0, Nanoseconds value = 0) {
  FaultConfig result;
  result.kind = kind;
  result.slave = slave;
  result.at = at;
  result.until = until;
  result.value_ns = value;
  return result;
}

SimConfig two_clocks(std::vector<FaultConfig> faults) {
  auto config = line({sim_slave("SL-1100"), sim_slave("SL-SV7", "servo-y"), sim_slave("SL-1002")});
  config.faults = std::move(faults);
  return config;
}

std::uint64_t offset(SimProbe& probe, std::uint16_t slave) {
  return probe.read(slave, reg::kSystemTimeOffset, 8).value<std::uint64_t>();
}
std::uint32_t delay(SimProbe& probe, std::uint16_t slave) {
  return probe.read(slave, reg::kSystemTimeDelay, 4).value<std::uint32_t>();
}
std::int64_t deviation(SimProbe& probe, std::uint16_t slave) {
  return SystemTimeDifference{probe.read(slave, reg::kSystemTimeDifference, 4).value<std::uint32_t>()}.signed_value();
}
std::uint8_t counter(SimProbe& probe, std::uint16_t slave, std::uint16_t address) {
  return probe.read(slave, address, 1).data[0];
}
void distribute_time(SimProbe& probe, int cycles) {
  for (int i = 0; i < cycles; ++i) {
    probe.send(Command::kArmw, device_address(0, reg::kSystemTime), {0, 0, 0, 0});
    probe.pass(kMs - 20 * kMicrosecond);
  }
}

TEST(FaultCatalogue, ClockWritesThatAreIgnoredCountAsWritten) {
  SimProbe probe(two_clocks({fault(FaultKind::kIgnoredClockWrites, -1, 0, 10 * kMs)}));
  for (const std::uint16_t slave : {0, 1}) {
    EXPECT_EQ(probe.write(slave, reg::kSystemTimeOffset, le_bytes(std::uint64_t{123'456})).wkc, 1);
    EXPECT_EQ(probe.write(slave, reg::kSystemTimeDelay, le_bytes(std::uint32_t{800})).wkc, 1);
    EXPECT_EQ(offset(probe, slave), 0U);
    EXPECT_EQ(delay(probe, slave), 0U);
  }
  probe.pass(10 * kMs);
  probe.write(1, reg::kSystemTimeDelay, le_bytes(std::uint32_t{800}));
  EXPECT_EQ(delay(probe, 1), 800U);
}

TEST(FaultCatalogue, AClockThatNobodySetsIsFarAwayAndStaysSo) {
  auto config = two_clocks({fault(FaultKind::kIgnoredClockWrites, 1, 0)});
  config.slaves[1].oscillator.start_offset = 1'500 * kMs;
  SimProbe probe(config);
  probe.write(1, reg::kSystemTimeOffset, le_bytes(static_cast<std::uint64_t>(-1'500 * kMs)));
  distribute_time(probe, 1'000);
  EXPECT_NEAR(static_cast<double>(deviation(probe, 1)), 1.5e9, 2e6);
}

TEST(FaultCatalogue, AnOffsetThatSomebodyOverwritesIsSlewedForMinutes) {
  constexpr Nanoseconds kWrong = 600 * kMs;
  SimProbe probe(two_clocks({fault(FaultKind::kOffsetStep, 1, 100 * kMs, 0, kWrong)}));
  distribute_time(probe, 50);
  const auto before = offset(probe, 1);
  distribute_time(probe, 200);
  EXPECT_EQ(offset(probe, 1), before + kWrong) << "0x0920 tells it, unlike a step of the clock itself";
  const auto first = deviation(probe, 1);
  EXPECT_NEAR(static_cast<double>(first), kWrong, 2e6);
  distribute_time(probe, 2'000);
  // Never faster than 763 ppm: 600 ms take 13 minutes.
  EXPECT_LE(first - deviation(probe, 1), 2'000 * 763);
  EXPECT_GE(first - deviation(probe, 1), 2'000 * 600);
}

TEST(FaultCatalogue, AStartTimeThatHasPassedNeverFires) {
  DriveBed drive("SL-SV7", {fault(FaultKind::kWrongStartTime, 0, 0, 0, -50 * kMs)});
  drive.probe.pass(200 * kMs);
  drive.start_sync0(1'000'000);
  EXPECT_EQ(drive.to_op(), 0x14);
  EXPECT_EQ(drive.probe.al_code(0), sim::al_code::kNoSync);
  EXPECT_EQ(drive.probe.read(0, reg::kActivationStatus, 1).data[0] & 1, 1) << "the first SYNC0 is still to come";
  const auto next = drive.probe.read(0, reg::kStartTimeCyclicOperation, 8).value<std::uint64_t>();
  EXPECT_LT(next, drive.probe.read(0, reg::kSystemTime, 8).value<std::uint64_t>());
}

TEST(FaultCatalogue, AStartTimeOffByLessThanACycleMovesOneDriveAgainstTheOther) {
  auto config = line({sim_slave("SL-SV7", "servo-y"), sim_slave("SL-SV7", "servo-y")});
  config.faults = {fault(FaultKind::kWrongStartTime, 1, 0, 0, 250 * kMicrosecond)};
  SimProbe probe(config);
  for (const std::uint16_t slave : {0, 1}) {
    probe.write(slave, reg::kSync0CycleTime, le_bytes(std::uint32_t{1'000'000}));
    probe.write(slave, reg::kStartTimeCyclicOperation, le_bytes(std::uint64_t{20'000'000}));
    probe.write(slave, reg::kCyclicUnitControl, {0x00, 0x03});
  }
  probe.pass(50 * kMs);
  const auto next = [&](std::uint16_t slave) {
    return probe.read(slave, reg::kStartTimeCyclicOperation, 8).value<std::uint64_t>() % 1'000'000;
  };
  EXPECT_EQ(next(0), 0U);
  EXPECT_EQ(next(1), 250'000U);
}

TEST(FaultCatalogue, ASyncUnitLeftRunningLocksItsRegistersUntilItIsSwitchedOff) {
  SimProbe probe(two_clocks({fault(FaultKind::kSyncLeftRunning, 1, 0, 0, 3 * kMs)}));
  probe.pass(10 * kMs);
  EXPECT_EQ(probe.read(1, reg::kActivation, 1).data[0], 0x03) << "in INIT";
  probe.write(1, reg::kSync0CycleTime, le_bytes(std::uint32_t{1'000'000}));
  EXPECT_EQ(probe.read(1, reg::kSync0CycleTime, 4).value<std::uint32_t>(), 3'000'000U);
  probe.write(1, reg::kActivation, {0});
  probe.write(1, reg::kSync0CycleTime, le_bytes(std::uint32_t{1'000'000}));
  EXPECT_EQ(probe.read(1, reg::kSync0CycleTime, 4).value<std::uint32_t>(), 1'000'000U);
}

TEST(FaultCatalogue, ForeignFramesAreCountedByTheFirstProcessingUnitAlone) {
  auto foreign = fault(FaultKind::kForeignFrames, -1, 1 * kMs);
  foreign.count = 5;
  SimProbe probe(two_clocks({foreign}));
  probe.pass(20 * kMs);
  EXPECT_EQ(counter(probe, 0, reg::kProcessingUnitErrorCounter), 5);
  EXPECT_EQ(counter(probe, 1, reg::kProcessingUnitErrorCounter), 0);
  for (const std::uint16_t slave : {0, 1, 2}) EXPECT_EQ(counter(probe, slave, reg::kRxErrorCounter), 0) << slave;
}

TEST(FaultCatalogue, AFrameWaitsForAForeignOneOnTheWire) {
  SimProbe quiet(two_clocks({})), busy(two_clocks({fault(FaultKind::kForeignFrames, -1, 20 * kMicrosecond)}));
  for (auto* probe : {&quiet, &busy}) {
    probe->pass(21 * kMicrosecond);
    probe->read(0, reg::kType, 1);
  }
  EXPECT_EQ(busy.arrival - quiet.arrival, wire_time_ns(60) - 1'000);
}

TEST(FaultCatalogue, TwoSlavesWithAReversedCableStopAllFrames) {
  auto config = line({sim_slave("SL-1100"), sim_slave("SL-1002"), sim_slave("SL-1002")});
  config.slaves[2].parent = 0;
  config.slaves[2].parent_port = 2;
  auto reversed = fault(FaultKind::kReversedCable, 1, 10 * kMs, 40 * kMs);
  reversed.port = 1;
  config.faults = {reversed};
  reversed.slave = 2;
  reversed.at = 20 * kMs;
  config.faults.push_back(reversed);
  SimProbe probe(config);
  const auto on_bus = [&probe] { return probe.send(Command::kBrd, device_address(0, reg::kType), {0}); };
  EXPECT_EQ(on_bus().wkc, 3);
  probe.pass(12 * kMs);
  EXPECT_EQ(on_bus().wkc, 3) << "one of them is fine: its processing unit lies behind the closed port A";
  probe.pass(12 * kMs);
  EXPECT_TRUE(on_bus().lost);
  EXPECT_EQ(probe.bus->peek(2, reg::kProcessingUnitErrorCounter, 1)[0], 1)
      << "the circulating frame is destroyed there";
  probe.pass(20 * kMs);
  EXPECT_EQ(on_bus().wkc, 3);
}

TEST(FaultCatalogue, AReversedSlaveInTheMiddleIsProcessedOnTheWayBack) {
  auto config = two_clocks({});
  auto reversed = fault(FaultKind::kReversedCable, 1, 1 * kMs);
  reversed.port = 1;
  config.faults = {reversed};
  SimProbe probe(config);
  for (const std::uint16_t slave : {0, 1, 2})
    probe.write(slave, reg::kStationAddress, le_bytes(static_cast<std::uint16_t>(1001 + slave)));
  const auto address = [&probe](std::uint16_t position) {
    return probe.read(position, reg::kStationAddress, 2).value<std::uint16_t>();
  };
  ASSERT_EQ(address(1), 1002);
  probe.pass(2 * kMs);
  EXPECT_EQ(address(1), 1003);
  EXPECT_EQ(address(2), 1002);
  probe.send(Command::kBwr, device_address(0, reg::kReceiveTimePort0), {0, 0, 0, 0});
  const auto times = probe.read(2, reg::kReceiveTimePort0, 16).data;
  const auto port0 = load_le<std::uint32_t>(std::span(times)),
             port1 = load_le<std::uint32_t>(std::span(times).subspan(4));
  EXPECT_GT(static_cast<std::int32_t>(port0 - port1), 250) << "it came in by port B";
}

TEST(FaultCatalogue, APortTimeThatSticksIsOld) {
  auto stuck = fault(FaultKind::kStuckPortTime, 0, 10 * kMs, 20 * kMs);
  stuck.port = 1;
  SimProbe probe(two_clocks({stuck}));
  const auto latch = [&probe] {
    probe.send(Command::kBwr, device_address(0, reg::kReceiveTimePort0), {0, 0, 0, 0});
    const auto times = probe.read(0, reg::kReceiveTimePort0, 16).data;
    return static_cast<std::int32_t>(load_le<std::uint32_t>(std::span(times).subspan(4)) -
                                     load_le<std::uint32_t>(std::span(times)));
  };
  const auto right = latch();
  probe.pass(12 * kMs);
  EXPECT_LT(latch(), -11'000'000);
  probe.pass(10 * kMs);
  EXPECT_NEAR(latch(), right, 20);
}

TEST(FaultCatalogue, AClosedRingGivesTheLastSlaveATimeThatMeansNothing) {
  auto ring = fault(FaultKind::kClosedRing, 2, 0, 50 * kMs, 300);
  ring.port = 1;
  SimProbe probe(two_clocks({ring}));
  probe.pass(1 * kMs);
  EXPECT_EQ(probe.send(Command::kBrd, device_address(0, reg::kType), {0}).wkc, 3) << "frames come back all the same";
  EXPECT_EQ(probe.read(2, reg::kDlStatus, 2).value<std::uint16_t>() & 0x0820, 0x0820)
      << "port B: link, and communication";
  probe.send(Command::kBwr, device_address(0, reg::kReceiveTimePort0), {0, 0, 0, 0});
  const auto times = probe.read(2, reg::kReceiveTimePort0, 16).data;
  EXPECT_LT(static_cast<std::int32_t>(load_le<std::uint32_t>(std::span(times).subspan(4)) -
                                      load_le<std::uint32_t>(std::span(times))),
            0);
  probe.pass(60 * kMs);
  EXPECT_EQ(probe.read(2, reg::kDlStatus, 2).value<std::uint16_t>() & 0x0820, 0);
}

TEST(FaultCatalogue, ANoisyDelayMovesTheDeviationAtEachWrite) {
  auto noisy = fault(FaultKind::kNoisyDelay, 1, 100 * kMs, 400 * kMs, 500);
  noisy.period = 100 * kMs;
  SimProbe probe(two_clocks({noisy}));
  probe.write(1, reg::kSystemTimeDelay, le_bytes(std::uint32_t{800}));
  std::vector<std::uint32_t> seen;
  for (int i = 0; i < 6; ++i) {
    seen.push_back(delay(probe, 1));
    probe.pass(100 * kMs);
  }
  EXPECT_EQ(seen[0], 800U);
  for (int i = 1; i < 4; ++i) {
    EXPECT_NE(seen[i], seen[i - 1]);
    EXPECT_NEAR(seen[i], 800, 500);
  }
  EXPECT_EQ(seen[4], seen[3]);
}

TEST(FaultCatalogue, TheOlderEditionOfTheDataSheetHasTheOtherSign) {
  auto config = two_clocks({fault(FaultKind::kOffsetStep, 1, 5 * kMs, 0, 30'000)});
  SimProbe newer(config);
  config.slaves[1].dc.sign_of_older_edition = true;
  SimProbe older(config);
  for (auto* probe : {&newer, &older}) distribute_time(*probe, 50);
  EXPECT_GT(deviation(newer, 1), 1'000);
  EXPECT_EQ(deviation(older, 1), -deviation(newer, 1));
}

TEST(FaultCatalogue, SyncSignalsThatTheFirmwareIsNotToldOfLeaveItWaiting) {
  DriveBed drive("SL-SV7", {fault(FaultKind::kSilentSync, 0, 0)});
  drive.start_sync0(1'000'000);
  (void)drive.to_op();
  drive.cycles(300);
  EXPECT_EQ(drive.status(), 0x14);
  EXPECT_EQ(drive.probe.al_code(0), sim::al_code::kNoSync);
  EXPECT_EQ(drive.probe.read(0, reg::kActivationStatus, 1).data[0] & 1, 0) << "the signal has come";
  EXPECT_EQ(drive.probe.read(0, reg::kAlEventRequest, 4).value<std::uint32_t>() & 0x04, 0U);
}

TEST(FaultCatalogue, WhatIsWrongWithASlaveIsWrongAfterAPowerCycleTooUnlessThatMendsIt) {
  SimProbe probe(
      two_clocks({fault(FaultKind::kIgnoredClockWrites, 1, 0), fault(FaultKind::kSlaveOff, 1, 5 * kMs, 10 * kMs)}));
  probe.pass(20 * kMs);
  probe.write(1, reg::kSystemTimeDelay, le_bytes(std::uint32_t{800}));
  EXPECT_EQ(delay(probe, 1), 0U);
}

TEST(FaultCatalogue, SlowFirmwareExceedsItsCyclesAndMissesNoEvent) {
  DriveBed drive("SL-SV7", {fault(FaultKind::kSlowApplication, 0, 3 * kSecond, 6 * kSecond, 1'400'000)});
  drive.start_sync0(1'000'000);
  ASSERT_EQ(drive.to_op(), 8);
  while (drive.probe.now < VirtualClock::kDefaultStart + 4 * kSecond) drive.cycles(20);
  EXPECT_EQ(drive.status(), 8) << "frames come in time";
  const auto exceeded = drive.read(0x1C32, 0x0B);
  EXPECT_GT(exceeded, 500U);
  EXPECT_EQ(drive.read(0x1C32, 0x0C), 0U) << "missed";
  EXPECT_EQ(drive.read(0x1C32, 0x0D), 0U) << "shift too short";
}

TEST(FaultCatalogue, FirmwareThatHangsLetsItsWatchdogExpireOnce) {
  DriveBed drive("SL-SV7", {fault(FaultKind::kStopApplication, 0, 3 * kSecond, 4 * kSecond)});
  drive.probe.pass(2'900 * kMs);
  EXPECT_EQ(counter(drive.probe, 0, reg::kWatchdogCounterPdi), 0);
  drive.probe.pass(350 * kMs);
  EXPECT_EQ(counter(drive.probe, 0, reg::kWatchdogCounterPdi), 1);
  EXPECT_EQ(drive.probe.read(0, reg::kDlStatus, 2).value<std::uint16_t>() & 2, 0);
  drive.probe.pass(kSecond);
  EXPECT_EQ(counter(drive.probe, 0, reg::kWatchdogCounterPdi), 1);
  EXPECT_EQ(drive.probe.read(0, reg::kDlStatus, 2).value<std::uint16_t>() & 2, 2);
}

}  // namespace
}  // namespace syncline::test
