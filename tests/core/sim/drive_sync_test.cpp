// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/core/sim/drive_bed.h"

namespace syncline::test {
namespace {

constexpr std::uint32_t kRange = 0x06090030, kReadOnly = 0x06010002, kWrongState = 0x08000022;

TEST(DriveSync, ObjectsAreCompleteAndWritableWhereTheDriveHasTheChoice) {
  for (const std::string type : {"SL-SV7", "SL-XE2"}) {
    DriveBed drive(type);
    for (const std::uint16_t index : {0x1C32, 0x1C33}) {
      EXPECT_EQ(drive.read(index, 0), 0x20U);
      for (std::uint8_t sub = 1; sub <= 0x0D; ++sub)
        EXPECT_NE(drive.read(index, sub), 0xDEADBEEF) << type << " " << int{sub};
      EXPECT_EQ(drive.read(index, 0x20), 0U);
      const bool chooses = type == "SL-XE2";  // the servo's type tells what the SYNC signals made of it
      EXPECT_EQ(drive.write(index, 1, {2, 0}), chooses ? 0U : kReadOnly);
      for (const std::uint8_t other : {1, 3, 0x22, 0x77}) {
        EXPECT_EQ(drive.write(index, 1, {other, 0}), chooses ? kRange : kReadOnly) << int{other};
      }
      EXPECT_EQ(drive.write(index, 2, {0, 0, 0, 0}), kReadOnly);
      EXPECT_EQ(drive.write(index, 4, {0xFF, 0}), kReadOnly);
      EXPECT_EQ(drive.write(index, 0x0B, {0, 0}), kReadOnly);
    }
    EXPECT_EQ(drive.read(0x1C32, 4) & 0x0FU, 0x05U) << "free run and SYNC0";
    drive.start_sync0(1'000'000);
    ASSERT_EQ(drive.to_safeop(), 4);
    EXPECT_EQ(drive.write(0x1C32, 1, {0, 0}), type == "SL-XE2" ? kWrongState : kReadOnly);
    EXPECT_EQ(drive.read(0x1C32, 2), 1'000'000U);
    EXPECT_EQ(drive.read(0x1C32, 0x0A), 1'000'000U);
  }
}

TEST(DriveSync, ServoFollowsTheSignalsAndDriveCItsObject) {
  DriveBed servo("SL-SV7");
  ASSERT_EQ(servo.to_safeop(), 4);
  EXPECT_EQ(servo.read(0x1C32, 1), 0U);
  EXPECT_EQ(servo.read(0x1C32, 2), 125'000U) << "its own timer";
  EXPECT_EQ(servo.read(0x1C32, 0x0A), 0U);
  DriveBed synchronised("SL-SV7");
  synchronised.start_sync0(2'000'000);
  ASSERT_EQ(synchronised.to_safeop(), 4);
  EXPECT_EQ(synchronised.read(0x1C32, 1), 2U);
  EXPECT_EQ(synchronised.read(0x1C33, 1), 2U);

  DriveBed asks("SL-XE2");
  ASSERT_EQ(asks.write(0x1C32, 1, {2, 0}), 0U);
  EXPECT_EQ(asks.to_safeop(), 0x12) << "SYNC0 is wanted and nobody switches it on";
  EXPECT_EQ(asks.probe.al_code(0), 0x0030);
  DriveBed free("SL-XE2");
  free.start_sync0(1'000'000);
  ASSERT_EQ(free.to_safeop(), 4);
  EXPECT_EQ(free.read(0x1C32, 1), 2U) << "default of the ESI of a Copley XE2";
  DriveBed without("SL-XE2");
  EXPECT_EQ(without.to_safeop(), 4) << "a default that nobody has written asks for nothing";
}

TEST(DriveSync, CycleRulesOfTheServo) {
  for (const auto& [cycle, code] : std::vector<std::pair<std::uint32_t, int>>{
           {125'000, 0}, {250'000, 0}, {4'000'000, 0}, {62'500, 0x0036}, {187'500, 0x0036}, {4'125'000, 0x0035}}) {
    DriveBed drive("SL-SV7");
    drive.start_sync0(cycle);
    EXPECT_EQ(drive.to_safeop(), code == 0 ? 4 : 0x12) << cycle;
    EXPECT_EQ(drive.probe.al_code(0), code) << cycle;
  }
}

TEST(DriveSync, Sync1KeepsTheStepOfTheCycleToo) {
  for (const auto& [delay, code] : std::vector<std::pair<std::uint32_t, int>>{{500'000, 0}, {100'001, 0x0037}}) {
    DriveBed drive("SL-XE2");
    drive.start_sync0(1'000'000, delay);
    drive.to_safeop();
    EXPECT_EQ(drive.probe.al_code(0), code) << delay;
  }
}

TEST(DriveSync, GetCycleTimeMeasuresTheLargestTimes) {
  DriveBed drive("SL-SV7");
  drive.start_sync0(1'000'000);
  ASSERT_EQ(drive.to_op(), 8);
  EXPECT_EQ(drive.read(0x1C32, 6), 62'500U) << "the worst case, until it is measured";
  drive.cycles(5);
  EXPECT_EQ(drive.write(0x1C32, 8, {2, 0}), kRange);
  EXPECT_EQ(drive.write(0x1C32, 8, {1, 0}), 0U);
  drive.cycles(1);
  const auto first = drive.read(0x1C32, 6);
  drive.cycles(50);
  const auto later = drive.read(0x1C32, 6);
  EXPECT_GE(first, 46'000U);
  EXPECT_GT(later, first);
  EXPECT_LE(later, 62'500U);
  EXPECT_GE(drive.read(0x1C32, 5), later) << "copying and delay make the shortest cycle";
  EXPECT_EQ(drive.write(0x1C32, 8, {0, 0}), 0U);
  drive.cycles(5);
  const auto stopped = drive.read(0x1C32, 6);
  drive.cycles(200);
  EXPECT_EQ(drive.read(0x1C32, 6), stopped);
}

TEST(DriveSync, OutputsThatComeTooLateForTheirSync0AreTheNextOnes) {
  DriveBed drive("SL-SV7");
  drive.start_sync0(1'000'000);
  EXPECT_EQ(drive.write(0x10F1, 2, {0, 0}), 0U);
  ASSERT_EQ(drive.to_op(), 8);
  drive.cycles(20);
  const auto missed = drive.read(0x1C32, 0x0C);
  drive.cycles(1);
  const auto missed_by_reading = drive.read(0x1C32, 0x0C) - missed;
  drive.cycles(5);
  auto before = drive.read(0x1C32, 0x0C);
  EXPECT_EQ(drive.read(0x1C32, 0x0D), 0U);
  drive.cycles(40, 30 * kMicrosecond);  // each frame less than calc and copy in front of SYNC0
  const auto late = drive.read(0x1C32, 0x0D);
  EXPECT_GE(late, 38U);
  EXPECT_LE(drive.read(0x1C32, 0x0C) - before, 2 * missed_by_reading + 3) << "one cycle old, but there in each cycle";
  // Now early, now late: every late one leaves a SYNC0 without outputs.
  drive.cycles(5);
  before = drive.read(0x1C32, 0x0C);
  for (int i = 0; i < 20; ++i) {
    drive.frame(600 * kMicrosecond);
    drive.probe.pass(drive.next_sync() + kMicrosecond - drive.probe.now);
    drive.frame(30 * kMicrosecond);
  }
  EXPECT_GE(drive.read(0x1C32, 0x0C) - before, 19U);
}

TEST(DriveSync, TheServosCounterEndsWithOpAndTheOtherOnesDoesNot) {
  for (const std::string type : {"SL-SV7", "SL-XE2"}) {
    const std::uint8_t place = type == "SL-SV7" ? 0x0C : 0x0B;
    DriveBed drive(type);
    ASSERT_EQ(drive.write(0x10F1, 2, {0, 0}), 0U);
    drive.start_sync0(1'000'000);
    ASSERT_EQ(drive.to_op(), 8);
    for (int i = 0; i < 5; ++i) drive.lose();
    EXPECT_GE(drive.read(0x1C32, place), 5U) << type;
    ASSERT_EQ(drive.probe.request(0, 4), 4);
    if (type == "SL-SV7") {
      EXPECT_EQ(drive.read(0x1C32, place), 0U);
    } else {
      EXPECT_GE(drive.read(0x1C32, place), 5U);
    }
  }
}

TEST(DriveSync, LimitOfTheIntegratorSaysAfterHowManyMissesTheAlarmComes) {
  for (const auto& [limit, misses] : std::vector<std::pair<std::uint8_t, int>>{{3, 1}, {9, 3}, {15, 5}, {0, 0}}) {
    DriveBed drive("SL-SV7");
    ASSERT_EQ(drive.write(0x10F1, 2, {limit, 0}), 0U);
    drive.start_sync0(1'000'000);
    ASSERT_EQ(drive.to_op(), 8);
    drive.cycles(30);
    for (int i = 0; i + 1 < misses; ++i) drive.lose();
    EXPECT_EQ(drive.probe.bus->peek(0, reg::kAlStatus, 1)[0], 8) << int{limit};
    for (int i = 0; i < (misses == 0 ? 20 : 1); ++i) drive.lose();
    drive.probe.pass(20 * kMicrosecond);
    EXPECT_EQ(drive.probe.bus->peek(0, reg::kAlStatus, 1)[0], misses == 0 ? 8 : 0x14) << int{limit};
    if (misses == 0) {
      EXPECT_GE(drive.read(0x1C32, 0x0C), 20U) << "counts without a limit, too";
    }
  }
}

TEST(DriveSync, TheOtherDriveNamesMissedEventsAsTheCause) {
  DriveBed drive("SL-XE2");
  ASSERT_EQ(drive.write(0x1C32, 1, {2, 0}), 0U);
  drive.start_sync0(1'000'000);
  ASSERT_EQ(drive.to_op(), 8);
  drive.cycles(30);
  for (int i = 0; i < 3; ++i) drive.lose();
  drive.probe.pass(20 * kMicrosecond);
  EXPECT_EQ(drive.probe.bus->peek(0, reg::kAlStatus, 1)[0], 0x14);
  EXPECT_EQ(drive.probe.al_code(0), 0x0034);
}

TEST(DriveSync, TheAlarmStopsTheMotionUntilAFaultReset) {
  DriveBed drive("SL-SV7");
  drive.start_sync0(1'000'000);
  ASSERT_EQ(drive.to_op(), 8);
  for (const std::uint16_t word : {0x06, 0x07, 0x0F}) {
    drive.controlword = word;
    drive.cycles(2);
  }
  EXPECT_EQ(drive.statusword() & 0x6F, 0x27) << "operation enabled";
  for (int i = 0; i < 40; ++i) {
    drive.target += 100;
    drive.cycles(1);
  }
  EXPECT_GT(drive.position(), 3000);
  for (int i = 0; i < 4; ++i) drive.lose();
  EXPECT_EQ(drive.status(), 0x14);
  EXPECT_EQ(drive.read(0x603F, 0), 0x0A12U);
  EXPECT_EQ(drive.statusword() & 0x4F, 0x08) << "fault";
  const auto stopped = drive.position();
  drive.probe.request(0, 0x14);
  drive.probe.write(0, reg::kAlControl, le_bytes(std::uint16_t{8}));
  drive.target += 1000;
  drive.cycles(10);
  ASSERT_EQ(drive.status(), 8);
  EXPECT_EQ(drive.statusword() & 0x4F, 0x08) << "still";
  EXPECT_EQ(drive.position(), stopped);
  drive.controlword = 0x80;
  drive.cycles(2);
  EXPECT_EQ(drive.statusword() & 0x4F, 0x40);
  EXPECT_EQ(drive.read(0x603F, 0), 0U);
}

TEST(DriveSync, AnApplicationThatIsTooSlowExceedsItsCycles) {
  FaultConfig slow;
  slow.kind = FaultKind::kSlowApplication;
  slow.slave = 0;
  slow.at = 700 * kMillisecond;
  slow.until = 720 * kMillisecond;
  slow.value_ns = 300 * kMicrosecond;
  DriveBed drive("SL-SV7", {slow});
  drive.start_sync0(250'000);
  ASSERT_EQ(drive.write(0x10F1, 2, {0, 0}), 0U);
  ASSERT_EQ(drive.to_op(), 8);
  drive.cycles(100);
  EXPECT_EQ(drive.read(0x1C32, 0x0B), 0U);
  while (drive.probe.now < VirtualClock::kDefaultStart + 740 * kMillisecond) drive.cycles(10);
  EXPECT_NEAR(drive.read(0x1C32, 0x0B), 80, 4) << "20 ms of cycles of 250 us";
}

TEST(DriveSync, AnApplicationThatIsTooSlowAndRunsByItselfTakesItsOutputsAndRenewsItsInputsSeldom) {
  FaultConfig slow;
  slow.kind = FaultKind::kSlowApplication;
  slow.slave = 0;
  slow.at = 700 * kMillisecond;
  slow.until = 900 * kMillisecond;
  slow.value_ns = 10 * kMillisecond;
  DriveBed drive("SL-SV7", {slow});
  ASSERT_EQ(drive.to_op(), 8);
  const auto cycles_until = [&](std::uint16_t word, std::uint16_t shown) {
    drive.controlword = word;
    int cycles = 0;
    for (; cycles < 40 && (drive.statusword() & 0x6F) != shown; ++cycles) drive.cycles(1);
    return cycles;
  };
  EXPECT_LE(cycles_until(0x06, 0x21), 3);
  EXPECT_LE(cycles_until(0x07, 0x23), 3);
  while (drive.probe.now < VirtualClock::kDefaultStart + 750 * kMillisecond) drive.cycles(1);
  EXPECT_GE(cycles_until(0x06, 0x21), 8) << "a pass of ten cycles";
  while (drive.probe.now < VirtualClock::kDefaultStart + 950 * kMillisecond) drive.cycles(1);
  EXPECT_LE(cycles_until(0x07, 0x23), 3) << "fast again";
}

TEST(DriveSync, InputShiftTimeSaysWhenInputsAreLatched) {
  for (const std::uint32_t shift : {0U, 400'000U}) {
    DriveBed drive("SL-SV7");
    ASSERT_EQ(drive.write(0x1C33, 3, le_bytes(shift)), 0U);
    drive.start_sync0(1'000'000);
    ASSERT_EQ(drive.to_op(), 8);
    for (const std::uint16_t word : {0x06, 0x07, 0x0F}) {
      drive.controlword = word;
      drive.cycles(2);
    }
    for (int i = 0; i < 30; ++i) {
      drive.target += 1000;
      drive.cycles(1);
    }
    // The position of this cycle's SYNC0, or of 400 us later: so much further.
    drive.probe.pass(drive.next_sync() + 900 * kMicrosecond - drive.probe.now);
    const auto early = drive.position();
    const auto expected = shift == 0 ? 0 : 400;
    EXPECT_NEAR(drive.target - 1000 - early, -expected, 60) << shift;
  }
  DriveBed drive("SL-SV7");
  ASSERT_EQ(drive.write(0x1C33, 3, le_bytes(std::uint32_t{1'000'000})), 0U);
  drive.start_sync0(1'000'000);
  EXPECT_EQ(drive.to_safeop(), 0x12);
  EXPECT_EQ(drive.probe.al_code(0), 0x0030);
}

TEST(DriveSync, CyclicModesOfTheServoNeedSync0) {
  DriveBed drive("SL-SV7");
  ASSERT_EQ(drive.to_op(), 8);
  const auto run = [&] {
    for (const std::uint16_t word : {0x06, 0x07, 0x0F, 0x1F}) {
      drive.controlword = word;
      drive.cycles(20);
    }
    return drive.position();
  };
  drive.target = 5000;
  EXPECT_EQ(run(), 0) << "CSP in free run";
  EXPECT_EQ(drive.read(0x6061, 0), 0U);
  drive.mode = 1;
  drive.cycles(1);
  run();
  drive.cycles(300);
  EXPECT_EQ(drive.position(), 5000) << "profile position in free run";
  // Controlword bit 6: the new set-point counts from the last one.
  for (const std::uint16_t word : {0x4F, 0x5F}) {
    drive.target = 300;
    drive.controlword = word;
    drive.cycles(300);
  }
  EXPECT_EQ(drive.position(), 5300) << "relative";
  for (const std::uint16_t word : {0x0F, 0x1F}) {
    drive.controlword = word;
    drive.cycles(600);
  }
  EXPECT_EQ(drive.position(), 300) << "absolute again";
  EXPECT_EQ(drive.read(0x6061, 0), 1U);
}

}  // namespace
}  // namespace syncline::test
