// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "diagnosis/run_diagnosis.h"
#include "findings/finding.h"
#include "findings/run_codes.h"
#include "tests/core/diagnosis/healthy_report.h"
#include "trace/run_report.h"

namespace syncline {
namespace {

using test::codes;
using test::fall;
using test::healthy;
using test::kStart;
using test::loss;
using test::miss;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(DriveFalls, BlamesNoLateFramesForTheFallOfADriveWhoseSync0IsMisplaced) {
  auto report = healthy();
  miss(report, 1, dc::MissCause::kFrameLate, 4);
  report.history.slaves[1].missed.note(kStart + 15 * kSecond, 4);
  report.history.slaves[1].fall = {kStart + 15 * kSecond, 0x14, 0x1A};
  report.slaves[1].al_status = 0x14;
  report.slaves[1].al_status_code = 0x1A;
  report.slaves[1].evidence.sync0 = {kStart, false, 400'000};
  EXPECT_THAT(codes(report), Contains(code::kSlaveFellByMisses));
  EXPECT_THAT(codes(report), Not(Contains(code::kSlaveFellByLateFrames)));
}

TEST(DriveFalls, AStandstillBeforeAllAreInOpIsToldWhereSlavesFellByIt) {
  auto report = healthy();
  report.history.reached_op = false;
  report.history.stalls.note(kStart + 5 * kSecond, 20, 21 * kMillisecond);
  EXPECT_THAT(codes(report), Not(Contains(code::kHostStalled)));
  auto& missed = report.slaves[1].sm2_missed.emplace();
  missed.known = true;
  missed.missed = 20;
  missed.by_cause[static_cast<std::size_t>(dc::MissCause::kCyclesLeftOut)] = 20;
  EXPECT_THAT(codes(report), Contains(code::kHostStalled));
}

TEST(DriveFalls, WorkingCountersAfterAFallAreItsConsequence) {
  auto report = healthy();
  report.history.wrong_counters.note(kStart + 5 * kSecond, 30);
  EXPECT_THAT(codes(report), ElementsAre(code::kWorkingCounter));
  report.history.slaves[1].fall = RunHistory::Fall{kStart + 5 * kSecond, 0x14, 0x1A};
  EXPECT_THAT(codes(report), ElementsAre(code::kWorkingCounterExplained));
}

TEST(DriveFalls, ADriveThatFellThoughAllWasGoodFellByItself) {
  auto report = healthy();
  fall(report, 1, 5 * kSecond);
  EXPECT_THAT(codes(report), ElementsAre(code::kSlaveFellByItself));
  report.history.lost_frames.note(kStart + 5 * kSecond - 5 * kMillisecond, 3);
  EXPECT_EQ(codes(report).front(), code::kSlaveFell) << "something was wrong: nothing is claimed";
  miss(report, 1, dc::MissCause::kFrameLost, 3);
  EXPECT_EQ(codes(report).front(), code::kSlaveFellByMisses);
}

TEST(DriveFalls, WhatHappensLongAfterTheMasterFoundBackIsNotDoneByItsTimeUnlocked) {
  auto report = healthy();
  report.history.master_losses.push_back(
      {kStart + kSecond, -1, 5'000, dc::SyncObstacle::kControlError, kStart + 2 * kSecond});
  auto fallen = report;
  fall(fallen, 1, 5 * kSecond, 0x2C);
  EXPECT_THAT(codes(fallen), Contains(code::kSlaveFellByItself));
  fall(fallen, 1, 3 * kSecond / 2, 0x2C);
  EXPECT_THAT(describe(diagnose(fallen)[0]), HasSubstr("frames slid through its SYNC0"));
  fall(fallen, 1, 5 * kSecond, 0x2C);
  fallen.dcm.state = SyncState::kOutOfSync;
  fallen.history.master_losses.front().back.reset();
  EXPECT_THAT(describe(diagnose(fallen)[0]), HasSubstr("frames slid through its SYNC0")) << "it has not found back";

  miss(report, 1, dc::MissCause::kUnknown, 4);
  report.history.slaves[1].missed.note(kStart + 6 * kSecond, 4);
  EXPECT_THAT(codes(report), Contains(code::kMissedUnexplained));
  report.history.slaves[1].missed = {};
  report.history.slaves[1].missed.note(kStart + 2 * kSecond, 5);
  report.history.slaves[1].missed.note(kStart + 6 * kSecond, 4);
  EXPECT_THAT(codes(report), Contains(code::kMissedUnlocked)) << "most of them";
}

TEST(DriveFalls, AnEarlierFallSaysWhatWasWrongJustBefore) {
  auto report = healthy();
  report.history.slaves[1].falls.push_back({kStart + 5 * kSecond, 0x14, 0x34});
  EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("led up again. Check that SYNC pulses"));
  report.history.lost_frames.note(kStart + 5 * kSecond - 8 * kMillisecond, 3);
  EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("just before: frames were lost. Check what else is told"));
  report.history.slaves[1].falls.front().al_status_code = 0x1D;
  EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("led up again. Check")) << "no error of its synchronisation";
}

/// It fell by them once, and was led up again.
TEST(DriveFalls, WhatADriveMissedLongBeforeIsNotWhyItFell) {
  auto report = healthy();
  fall(report, 1, 200 * kSecond, 0x2C);
  miss(report, 1, dc::MissCause::kFrameLost, 3);
  report.history.lost_frames.note(kStart + 90 * kSecond, 3);
  report.history.slaves[1].missed.note(kStart + 90 * kSecond, 3);
  EXPECT_THAT(codes(report), Contains(code::kSlaveFellByItself));
  EXPECT_THAT(codes(report), Not(Contains(code::kSlaveFellByMisses)));
  report.history.slaves[1].missed.note(kStart + 201 * kSecond, 3);
  EXPECT_THAT(codes(report), Contains(code::kSlaveFellByMisses)) << "its counter tells a little later";
}

TEST(DriveFalls, ADriveFallsByWhatWasJustBeforeAndNotByWhatItGotOver) {
  auto report = healthy();
  fall(report, 1, 9 * kSecond);
  miss(report, 1, dc::MissCause::kFrameLate, 16);
  report.slaves[1].sm2_missed->by_cause[static_cast<std::size_t>(dc::MissCause::kCyclesLeftOut)] = 4;
  EXPECT_EQ(codes(report).front(), code::kSlaveFellByLateFrames);
  report.history.stalls.note(kStart + 3 * kSecond, 4, 5 * kMillisecond);
  EXPECT_EQ(codes(report).front(), code::kSlaveFellByLateFrames) << "long before";
  report.history.stalls.note(kStart + 9 * kSecond - 2 * kMillisecond, 4, 5 * kMillisecond);
  EXPECT_EQ(codes(report).front(), code::kSlaveFellByMisses);
  EXPECT_THAT(describe(diagnose(report)[0]),
              HasSubstr("The cause of 4 of the missed events: the host left cycles out"));
  report.history.lost_frames.note(kStart + 9 * kSecond - 2 * kMillisecond, 2);
  EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("the host left cycles out")) << "none was missed by them";
  report.history.slaves[1].missed.note(kStart + 9 * kSecond, 5);
  EXPECT_EQ(codes(report).front(), code::kSlaveFellByMisses);
  report.history.slaves[1].missed.note(kStart + 9 * kSecond, 11);
  EXPECT_EQ(codes(report).front(), code::kSlaveFellByLateFrames) << "it did not get over them: they went on until then";
}

TEST(DriveFalls, ASlaveThatFellWhenAClockHadMovedIsToldAsThat) {
  auto report = healthy();
  fall(report, 1, 5 * kSecond);
  auto step = loss(-1, 700'000);
  step.obstacle = dc::SyncObstacle::kClockStep;
  step.time = kStart + 5 * kSecond - 100 * kMillisecond;
  report.history.slave_losses.push_back(step);
  EXPECT_THAT(codes(report), Contains(code::kSlaveFellByMovedClock));
  EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("outputs are meant for, the reference clock has stepped. Mend"));
  report.history.slave_losses.front().size = 300;
  EXPECT_THAT(codes(report), Contains(code::kSlaveFellByItself)) << "its SYNC0 has more room than that";
  report.slaves[1].evidence.sync0.time = kStart;
  report.slaves[1].evidence.sync0.off_ns = 300'000;
  EXPECT_THAT(codes(report), testing::AllOf(Contains(code::kSlaveFell), Contains(code::kSync0Misplaced)))
      << "no clock to mend";
}

TEST(DriveFalls, ASlaveThatFellAfterItsFirmwareHadStoodStillIsToldAsThat) {
  auto report = healthy();
  auto& history = report.history.slaves[1];
  fall(report, 1, 9 * kSecond, 0x2C);
  history.pdi_watchdog.note(kStart + 7 * kSecond, 1);
  EXPECT_THAT(codes(report), ElementsAre(code::kSlaveFellByHang, code::kFirmwareHung));
  EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("expired at 7.000 s"));
  // One that was over long before is no reason, one that is told to go on until then is.
  history.pdi_watchdog = {};
  history.pdi_watchdog.note(kStart + 2 * kSecond, 1);
  EXPECT_EQ(codes(report).front(), code::kSlaveFellByItself);
  auto lying = report;
  lying.history.slaves[1].late_outputs.note(kStart + 8 * kSecond, 1);
  EXPECT_EQ(codes(lying).front(), code::kSlaveFellByHang);
  history.silent_from = kStart + 3 * kSecond;
  history.silent_to = kStart + 6 * kSecond;
  EXPECT_EQ(codes(report).front(), code::kSlaveFellByHang);
  // What was seen to make it miss outputs says more; one that came after the fall says nothing.
  auto missed = report;
  miss(missed, 1, dc::MissCause::kFrameLost, 3);
  EXPECT_EQ(codes(missed).front(), code::kSlaveFellByMisses);
  history.fall->time = kStart + kSecond;
  EXPECT_EQ(codes(report).front(), code::kSlaveFellByItself);
}

TEST(DriveFalls, ADriveThatGetsItsOutputsTooShortlyBeforeSync0DidNotFallByItself) {
  auto report = healthy();
  fall(report, 1, 5 * kSecond);
  report.slaves[1].sync0_margin = 53'300;
  report.slaves[1].evidence.calc_and_copy_ns = 62'500;
  ASSERT_THAT(codes(report), ElementsAre(code::kSlaveFell, code::kSync0TooTight));
  EXPECT_THAT(describe(diagnose(report)[1]), HasSubstr("it needs 62.5 us for its outputs"));
  report.slaves[1].evidence.calc_and_copy_ns = 40'000;
  EXPECT_THAT(codes(report), ElementsAre(code::kSlaveFellByItself));
}

TEST(DriveFalls, ADriveThatWasCutOffDidNotFallByItself) {
  auto report = healthy();
  fall(report, 1, 5 * kSecond);
  report.history.slaves[1].absences.note(kStart + 4990 * kMillisecond, 1, 0, kStart + 4890 * kMillisecond);
  for (const std::uint32_t missed : {0U, 2U}) {
    miss(report, 1, dc::MissCause::kUnknown, missed);
    EXPECT_EQ(codes(report).front(), code::kSlaveFell) << missed;
    EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("it had been cut off from the master"));
  }
}

TEST(DriveFalls, ADriveWhoseClockJumpedDidNotFallByItself) {
  auto report = healthy();
  fall(report, 1, 5 * kSecond);
  report.history.slave_losses.push_back({kStart + 4998 * kMillisecond, 2, 442'000, {}, kStart + 7 * kSecond});
  EXPECT_EQ(codes(report).front(), code::kSlaveFellByItself) << "it was another one's clock";
  report.history.slave_losses.front().slave = 1;
  EXPECT_EQ(codes(report).front(), code::kSlaveFellByMovedClock);
}

TEST(DriveFalls, ADriveThatFellByLateFramesNeedsALaterSync0) {
  auto report = healthy();
  fall(report, 1, 5 * kSecond);
  miss(report, 1, dc::MissCause::kFrameLate, 3);
  const auto findings = diagnose(report);
  ASSERT_EQ(findings.front().code, code::kSlaveFellByLateFrames);
  EXPECT_THAT(describe(findings.front()), HasSubstr("Increase the set value by"));
}

}  // namespace
}  // namespace syncline
