// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "channels/values/sync_obstacle_text.h"
#include "diagnosis/run_diagnosis.h"
#include "findings/finding.h"
#include "findings/run_codes.h"
#include "tests/core/diagnosis/healthy_report.h"
#include "trace/run_report.h"

namespace syncline {
namespace {

using test::codes;
using test::healthy;
using test::kStart;
using test::loss;
using test::miss;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(MovedClocks, AClockThatMovesByMoreThanThereIsRoomExplainsMisses) {
  auto report = healthy();
  miss(report, 1, dc::MissCause::kUnknown, 4);
  report.history.slaves[1].missed.note(kStart + 5500 * kMillisecond, 4);
  report.history.slave_losses.push_back(loss(1, 700'000));
  EXPECT_THAT(codes(report), Contains(code::kMissedByMovedClock));
  EXPECT_THAT(codes(report), Not(Contains(code::kMissedUnexplained)));
}

TEST(MovedClocks, AClockThatLeavesTheWindowByALittleExplainsNone) {
  auto report = healthy();
  miss(report, 1, dc::MissCause::kUnknown, 4);
  report.history.slaves[1].missed.note(kStart + 5500 * kMillisecond, 4);
  report.history.slave_losses.push_back(loss(1, 300));
  EXPECT_THAT(codes(report), Contains(code::kMissedUnexplained));
  EXPECT_THAT(codes(report), Not(Contains(code::kMissedByMovedClock)));
}

TEST(MovedClocks, AMovedClockExplainsNoMissesOfAnotherTime) {
  auto report = healthy();
  miss(report, 1, dc::MissCause::kUnknown, 4);
  report.history.slaves[1].missed.note(kStart + 15 * kSecond, 4);
  report.history.slave_losses.push_back(loss(1, 700'000));
  EXPECT_THAT(codes(report), Contains(code::kMissedUnexplained));
}

TEST(MovedClocks, SaysToWhichSideSync0IsMisplaced) {
  for (const int off : {400'000, -400'000}) {
    auto report = healthy();
    report.slaves[1].evidence.sync0 = {kStart, false, off};
    const auto findings = diagnose(report);
    const auto found = std::ranges::find(findings, code::kSync0Misplaced, &Finding::code);
    ASSERT_NE(found, findings.end());
    EXPECT_THAT(describe(*found), HasSubstr(off > 0 ? "comes 400 us behind" : "comes 400 us before"));
    report.slaves[1].present = false;
    EXPECT_THAT(codes(report), Not(Contains(code::kSync0Misplaced))) << "it is told as absent";
  }
}

/// One in a thousand frames is later than there is room: what a clock moves beside that makes no difference.
TEST(MovedClocks, AClockThatMovesByLessThanFramesAreLateExplainsNone) {
  auto report = healthy();
  report.slaves[1].sync0_margin = 4 * kMicrosecond;
  miss(report, 1, dc::MissCause::kUnknown, 4);
  report.history.slaves[1].missed.note(kStart + 5500 * kMillisecond, 4);
  report.history.slave_losses.push_back(loss(1, 143));
  EXPECT_THAT(codes(report), Not(Contains(code::kMissedByMovedClock)));
}

TEST(MovedClocks, NobodysOwnClockWasOutOfPlaceWhoseReadingsWereSmall) {
  auto report = healthy();
  miss(report, 1, dc::MissCause::kUnknown, 4);
  report.history.slaves[1].missed.note(kStart + 5500 * kMillisecond, 4);
  report.slaves[1].deviation_max_ns = 12;
  report.history.slave_losses.push_back(loss(-1, 700'000));
  EXPECT_THAT(codes(report), Not(Contains(code::kMissedByMovedClock))) << "one of the others";
  report.slaves[1].deviation_max_ns = 700'000;
  EXPECT_THAT(codes(report), Contains(code::kMissedByMovedClock));
}

/// Frames of a master that nobody holds at the reference clock slide through every SYNC0.
TEST(MovedClocks, WhereNothingHoldsTheFramesNeitherSlavesNorTheirSync0AreBlamed) {
  for (const bool off : {true, false}) {
    auto report = healthy();
    report.dcm.mode = off ? DcmMode::kOff : DcmMode::kMasterShift;
    report.dcm.control_off = !off;
    report.dcm.state = off ? SyncState::kNotMonitored : SyncState::kOutOfSync;
    report.history.master_losses.push_back({kStart + kSecond, -1, 5000, dc::SyncObstacle::kControlError, {}});
    EXPECT_THAT(codes(report), IsEmpty()) << "nobody asked for it";
    miss(report, 1, dc::MissCause::kFrameLate, 4);
    ASSERT_THAT(codes(report), ElementsAre(code::kMissedUnlocked));
    EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("the master synchronisation is switched off"));
    report.slaves[1].al_status = 0x14;
    report.slaves[1].al_status_code = 0x1A;
    report.history.slaves[1].fall = RunHistory::Fall{kStart + 5 * kSecond, 0x14, 0x1A};
    EXPECT_EQ(codes(report).front(), code::kSlaveFellByMisses);
    EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("frames slid through its SYNC0"));
    report.slaves[1].sm2_missed->by_cause = {};
    report.slaves[1].sm2_missed->by_cause[static_cast<std::size_t>(dc::MissCause::kFrameHeldUp)] = 4;
    EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("frames slid through its SYNC0"));
    report.slaves[1].sm2_missed->missed = 0;
    EXPECT_EQ(codes(report).front(), code::kSlaveFell) << "not by itself";
    EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("frames slid through its SYNC0"));
  }
}

TEST(MovedClocks, ALaterSync0IsNoHelpAgainstFramesThatSlideThroughIt) {
  auto report = healthy();
  report.slaves[1].evidence.outputs.shift_too_short.total = 12;
  report.slaves[1].evidence.outputs.shift_too_short.time = kStart + 6 * kSecond;
  report.history.slaves[1].shift_too_short.note(kStart + 5 * kSecond, 12);
  EXPECT_THAT(codes(report), ElementsAre(code::kShiftTooShort));
  report.history.master_losses.push_back(
      {kStart + kSecond, -1, 5000, dc::SyncObstacle::kControlError, kStart + 8 * kSecond});
  EXPECT_THAT(codes(report), ElementsAre(code::kMasterLostLock, code::kMissedUnlocked));
  EXPECT_THAT(describe(diagnose(report)[1]), Not(HasSubstr("a shift of")));
}

/// The absence is told; that nobody could be in sync with who is not there follows from it.
TEST(MovedClocks, WhileWhoLeadsIsAwayThereIsNothingToBeOutOfSyncWith) {
  auto report = healthy();
  const auto leader = static_cast<std::size_t>(report.dc.reference_clock);
  report.history.master_losses.push_back(
      {kStart + 4 * kSecond, -1, 0, dc::SyncObstacle::kNoReferenceClock, kStart + 8 * kSecond});
  EXPECT_THAT(codes(report), Contains(code::kMasterLostLock));
  report.history.slaves[leader].absences.note(kStart + 6 * kSecond, 1, 0, kStart + 3990 * kMillisecond);
  EXPECT_THAT(codes(report), Not(Contains(code::kMasterLostLock)));
  report.history.master_losses.front().time -= 2 * kSecond;
  EXPECT_THAT(codes(report), Contains(code::kMasterLostLock)) << "before it went";
  report.history.master_losses.front() = {kStart + 4 * kSecond, -1, 0, dc::SyncObstacle::kNoReferenceClock, {}};
  report.dcm.state = SyncState::kOutOfSync;
  EXPECT_THAT(codes(report), Contains(code::kMasterNotLocked)) << "it has not found back";
}

TEST(MovedClocks, AStandstillIsToldWhereItKeptTheClocksFromComingInSync) {
  auto report = healthy();
  report.history.reached_op = false;
  report.history.stalls.note(kStart + 5 * kSecond, 20, 21 * kMillisecond);
  report.dcm.state = SyncState::kBusy;
  report.dcm.obstacle = dc::SyncObstacle::kCyclesLeftOut;
  EXPECT_THAT(codes(report), Contains(code::kHostStalled));
}

/// Where nobody monitors: those that follow are off at once and to the same side.
TEST(MovedClocks, TheReferenceClockIsNamedWhereAllThatFollowItMovedAlike) {
  auto report = healthy();
  report.dc.monitored = report.sync_window_enabled = false;
  const auto off = [&](std::size_t slave, Nanoseconds time, std::int32_t size) {
    report.history.slaves[slave].first_off_ns = size;
    report.history.slaves[slave].off.note(kStart + time, 3, std::abs(size));
  };
  off(1, 8 * kSecond, 20'000);
  EXPECT_EQ(diagnose(report)[0].place.slave, 1);
  off(2, 8 * kSecond + kMillisecond, 19'000);
  ASSERT_THAT(codes(report), ElementsAre(code::kSlaveClockOff, code::kNotMonitored));
  EXPECT_EQ(diagnose(report)[0].place.slave, 0);
  EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("It is that clock which moved"));
  report.history.slaves[2].first_off_ns = -19'000;
  EXPECT_THAT(codes(report), ElementsAre(code::kSlaveClockOff, code::kSlaveClockOff, code::kNotMonitored));
  report.history.slaves[2].first_off_ns = 19'000;
  report.history.slaves[0].absences.note(kStart + 8 * kSecond, 1);
  EXPECT_THAT(codes(report), Contains(code::kSlaveClockOff).Times(2)) << "who went has changed the frames' way";
}

TEST(MovedClocks, SlavesThatAreStillAwayAfterTheReferenceClockHasSteppedAreNotInsideAgain) {
  auto report = healthy();
  report.dc.state = SyncState::kOutOfSync;
  report.dc.over_limit = 2;
  report.dc.all_alike = true;
  report.history.slave_losses.push_back({kStart + 8 * kSecond, -1, 20'000, dc::SyncObstacle::kClockStep, {}});
  const auto finding = diagnose(report)[0];
  EXPECT_EQ(finding.place.slave, 0);
  EXPECT_THAT(facts_text(finding), HasSubstr("The reference clock stepped"));
  EXPECT_THAT(facts_text(finding), Not(HasSubstr("No reading is outside")));
}

/// What they bring into sentences has to be known to the translations.
TEST(MovedClocks, EachObstacleIsAPhraseOfFindings) {
  const auto phrases = finding_phrases();
  for (int i = 1; i <= static_cast<int>(dc::SyncObstacle::kSettling); ++i) {
    const auto text = dc::obstacle_text(static_cast<dc::SyncObstacle>(i));
    EXPECT_NE(std::ranges::find(phrases, text), phrases.end()) << text;
  }
}

TEST(MovedClocks, NobodyIsNamedWhoIsWithinTheLimit) {
  auto report = healthy();
  report.dc.state = SyncState::kOutOfSync;
  report.slaves[1].deviation_ns = 96;
  EXPECT_THAT(codes(report), ElementsAre(code::kSlavesOutOfSync));
  report.dc.culprit = 2;
  report.slaves[2].deviation_ns = -300;
  ASSERT_THAT(codes(report), ElementsAre(code::kSlaveLeftWindow));
  EXPECT_EQ(diagnose(report)[0].place.slave, 2);
}

TEST(MovedClocks, WhoLeftTheWindowIsNamedAlsoWhenItsLastReadingIsInsideAgain) {
  auto report = healthy();
  report.dc.state = SyncState::kOutOfSync;
  report.dc.since = kStart + 8 * kSecond;
  report.history.slave_losses.push_back({kStart + 6 * kSecond, 1, 500, {}, kStart + 7 * kSecond});
  EXPECT_EQ(diagnose(report)[0].place.slave, -1) << "that one has come back";
  report.history.slave_losses.push_back({kStart + 8 * kSecond, 2, -400, {}, {}});
  auto finding = diagnose(report)[0];
  EXPECT_EQ(finding.code, code::kSlavesOutOfSync);
  EXPECT_EQ(finding.place.slave, 2);
  EXPECT_THAT(facts_text(finding), HasSubstr("lave 2 left the sync window at 8.000 s (400 ns"));
  report.history.slave_losses.back() = {kStart + 8 * kSecond, -1, 20'000, dc::SyncObstacle::kClockStep, {}};
  finding = diagnose(report)[0];
  EXPECT_EQ(finding.place.slave, report.dc.reference_clock);
  EXPECT_THAT(facts_text(finding), HasSubstr("The reference clock stepped"));
}

TEST(MovedClocks, WhatIsNotKnownIsNotCalledOutOfSync) {
  auto report = healthy();
  report.dc.state = SyncState::kUnknown;
  EXPECT_THAT(codes(report), ElementsAre(code::kSlavesSyncUnknown));
  report.dc.state = SyncState::kBusy;
  EXPECT_THAT(codes(report), ElementsAre(code::kSlavesOutOfSync)) << "they never were";
}

TEST(MovedClocks, OneClockIsNotAskedToBeMonitored) {
  auto report = healthy();
  report.dc.monitored = false;
  EXPECT_THAT(codes(report), ElementsAre(code::kNothingToMonitor));
  report.sync_window_enabled = false;
  EXPECT_THAT(codes(report), ElementsAre(code::kNotMonitored));
  report.history.slaves[2].off.note(kStart + 8 * kSecond, 3, 900'000);
  EXPECT_THAT(codes(report), ElementsAre(code::kSlaveClockOff, code::kNotMonitored));
}

TEST(MovedClocks, WhereNobodyFollowsNobodyIsOutOfSync) {
  auto report = healthy();
  report.dc.state = SyncState::kNotMonitored;
  EXPECT_THAT(codes(report), ElementsAre(code::kNothingToMonitor));
}

TEST(MovedClocks, ACycleThatAMovedSync0CutShortIsNotTheFirmwares) {
  auto report = healthy();
  report.slaves[1].evidence.outputs.exceeded.total = 1;
  report.history.slaves[1].outputs_exceeded.note(kStart + 5500 * kMillisecond, 1);
  EXPECT_THAT(codes(report), ElementsAre(code::kFirmwareSlow));
  report.history.slave_losses.push_back(loss(1, 700'000));
  EXPECT_THAT(codes(report), Not(Contains(code::kFirmwareSlow)));
  report.slaves[1].evidence.outputs.exceeded.total = 4;
  report.history.slaves[1].outputs_exceeded.note(kStart + 9 * kSecond, 3);
  EXPECT_THAT(codes(report), Contains(code::kFirmwareSlow)) << "most of them came later";
}

/// Where it moved and they came back, are out still, or came back but not for the settle time; where that was before
/// another loss; and where nobody monitors.
TEST(MovedClocks, AReferenceClockThatMovesIsLedByTheHostsWhereThatIsSo) {
  const RunHistory::SyncLoss lasting{kStart + 8 * kSecond, -1, 128, dc::SyncObstacle::kClockStep, {}};
  std::vector<RunReport> reports(5, healthy());
  reports[0].history.slave_losses = {lasting};
  reports[0].history.slave_losses.front().back = kStart + 9 * kSecond;
  for (std::size_t i = 1; i < 4; ++i) {
    reports[i].dc.state = SyncState::kOutOfSync;
    reports[i].history.slave_losses = {lasting};
  }
  reports[1].dc.over_limit = 2;
  reports[3].history.slave_losses.push_back({kStart + 9 * kSecond, 1, 144, {}, {}});
  reports[4].dc.monitored = reports[4].sync_window_enabled = false;
  for (const std::size_t slave : {1U, 2U}) {
    reports[4].history.slaves[slave].first_off_ns = 20'000;
    reports[4].history.slaves[slave].off.note(kStart + 8 * kSecond, 3, 20'000);
  }
  const auto all = [](const RunReport& report) {
    std::string text;
    for (const auto& finding : diagnose(report)) text += describe(finding);
    return text;
  };
  for (auto& report : reports) {
    for (const auto mode : {DcmMode::kMasterShift, DcmMode::kDcx, DcmMode::kOff}) {
      report.dcm.mode = mode;
      EXPECT_THAT(all(report), AllOf(HasSubstr("eference clock"), Not(HasSubstr("time service"))));
    }
    for (const auto mode : {DcmMode::kBusShift, DcmMode::kMasterRefClock, DcmMode::kLinkLayerRefClock}) {
      report.dcm.mode = mode;
      report.dcm.control_off = false;
      EXPECT_THAT(all(report), HasSubstr(": it follows this host's clock, which a time service may have moved"));
      report.dcm.control_off = true;
      EXPECT_THAT(all(report), Not(HasSubstr("time service"))) << "nothing is moved";
    }
    report.dcm.control_off = false;
  }
}

/// In long cycles the way back takes some seconds.
TEST(MovedClocks, AReferenceClockOnItsWayBackAfterAnOutageIsMovedByNoTimeService) {
  auto report = healthy();
  report.dcm.mode = DcmMode::kBusShift;
  report.history.slave_losses = {{kStart + 8 * kSecond, -1, 5'000, dc::SyncObstacle::kClockStep, kStart + 9 * kSecond}};
  const auto words = [&report] {
    std::string text;
    for (const auto& finding : diagnose(report)) text += describe(finding);
    return text;
  };
  report.history.link_outages.note(kStart + 5 * kSecond, 1, 0, kStart + 3 * kSecond);
  EXPECT_THAT(words(), AllOf(HasSubstr("led back to this host's clock after the network adapter had been away"),
                             Not(HasSubstr("time service"))));
  report.history.slave_losses.front().time = kStart + 16 * kSecond;
  EXPECT_THAT(words(), AllOf(HasSubstr("a time service may have moved"), Not(HasSubstr("led back"))));
}

/// No loop follows anybody by hundreds of microseconds in a cycle.
TEST(MovedClocks, AReferenceClockThatJumpsFurtherThanItCanBeLedIsLedByNobody) {
  auto report = healthy();
  report.dcm.mode = DcmMode::kBusShift;
  report.history.slave_losses = {{kStart + 8 * kSecond, -1, 5'000, dc::SyncObstacle::kClockStep, kStart + 9 * kSecond}};
  const auto words = [&report] { return describe(diagnose(report).front()); };
  EXPECT_THAT(words(), HasSubstr("a time service may have moved"));
  report.history.slave_losses.front().size = -400'000;
  EXPECT_THAT(words(), AllOf(HasSubstr("The reference clock stepped"), Not(HasSubstr("time service"))));
}

TEST(MovedClocks, ASync0ThatIsMisplacedIsNotAlsoTooTight) {
  auto report = healthy();
  report.slaves[1].sync0_margin = 40'000;
  report.slaves[1].evidence.calc_and_copy_ns = 62'500;
  EXPECT_THAT(codes(report), Contains(code::kSync0TooTight));
  report.slaves[1].evidence.sync0.time = kStart + kSecond;
  report.slaves[1].evidence.sync0.off_ns = 400'000;
  EXPECT_THAT(codes(report), ElementsAre(code::kSync0Misplaced)) << "a larger set value is no cure for it";
}

TEST(MovedClocks, WhatAMisplacedSync0LeavesAFrameIsNoMeasureOfTheHost) {
  auto report = healthy();
  report.slaves[1].sync0_margin = 4'000;
  ASSERT_THAT(codes(report), Contains(code::kHostLate));
  report.slaves[1].evidence.sync0.time = kStart + kSecond;
  report.slaves[1].evidence.sync0.off_ns = 400'000;
  EXPECT_THAT(codes(report), ElementsAre(code::kSync0Misplaced));
}

TEST(MovedClocks, TheWindowThatSomebodyLeavesWhenASlaveComesBackIsItsReturn) {
  auto report = healthy();
  report.history.slave_losses.push_back({kStart + 6 * kSecond, -1, 167, {}, kStart + 7 * kSecond});
  EXPECT_THAT(codes(report), testing::Contains(code::kWindowLeft));
  report.history.slaves[2].absences.note(kStart + 6 * kSecond, 1, 0, kStart + 5 * kSecond);
  EXPECT_THAT(codes(report), testing::Not(testing::Contains(code::kWindowLeft)));
}

TEST(MovedClocks, AllThatLeaveTheWindowToTheSameSideHaveNotMovedThemselves) {
  auto report = healthy();
  report.history.slave_losses.push_back(
      {kStart + 6 * kSecond, -1, 20'000, dc::SyncObstacle::kClockStep, kStart + 7 * kSecond});
  const auto findings = diagnose(report);
  const auto found = std::ranges::find(findings, code::kWindowLeft, &Finding::code);
  ASSERT_NE(found, findings.end());
  EXPECT_EQ(found->place.slave, report.dc.reference_clock);
  EXPECT_THAT(facts_text(*found), testing::HasSubstr("The reference clock stepped"));
}

/// Who is out at the end, by little, does not hide who went out before, by much.
TEST(MovedClocks, WhoLeftTheWindowBeforeTheCulpritIsToldAsWell) {
  auto report = healthy();
  report.dc.state = SyncState::kOutOfSync;
  report.history.slave_losses = {{kStart + 6 * kSecond, 2, 242'000, {}, {}}, {kStart + 9 * kSecond, 1, 144, {}, {}}};
  auto findings = diagnose(report);
  const auto earlier = std::ranges::find(findings, code::kWindowLeft, &Finding::code);
  ASSERT_NE(earlier, findings.end());
  EXPECT_EQ(earlier->place.slave, 2);
  EXPECT_THAT(facts_text(*earlier), testing::HasSubstr("Before that, at 6.000 s, slave 2 had left"));
  EXPECT_THAT(codes(report), Contains(code::kSlavesOutOfSync));
  report.history.slave_losses.front().slave = 1;
  EXPECT_THAT(codes(report), Not(Contains(code::kWindowLeft))) << "the same one, again";
  report.history.slave_losses.front() = {kStart + 6 * kSecond, -1, 20'000, dc::SyncObstacle::kClockStep, {}};
  findings = diagnose(report);
  const auto step = std::ranges::find(findings, code::kWindowLeft, &Finding::code);
  ASSERT_NE(step, findings.end());
  EXPECT_EQ(step->place.slave, report.dc.reference_clock);
}

}  // namespace
}  // namespace syncline
