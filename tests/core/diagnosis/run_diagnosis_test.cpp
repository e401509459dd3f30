// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/run_diagnosis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "channels/values/miss_cause.h"
#include "channels/values/sync_obstacle_text.h"
#include "config/dcm_settings.h"
#include "findings/figure.h"
#include "findings/finding.h"
#include "findings/run_codes.h"
#include "protocol/al_state.h"
#include "trace/run_history.h"
#include "trace/run_report.h"

namespace syncline {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

constexpr Nanoseconds kStart = 100 * kSecond;

/// A machine of a terminal and two axes that ran for 20 s without any trouble.
RunReport healthy() {
  RunReport report;
  report.state = AlState::kOp;
  report.cycle_time = kMillisecond;
  report.history.begin = kStart;
  report.history.end = report.time = kStart + 20 * kSecond;
  report.history.reached_op = true;
  report.history.slaves.resize(3);
  for (std::uint16_t i = 0; i < 3; ++i) {
    RunReport::Slave slave;
    slave.position = i;
    slave.al_status = static_cast<std::uint16_t>(AlState::kOp);
    slave.present = true;
    slave.parent = i - 1;
    slave.parent_port = 1;
    if (i > 0) {
      slave.sync0_margin = 660 * kMicrosecond;
      slave.sync0_cycle = kMillisecond;
      slave.sm2_missed = Sm2MissedStatus{};
      slave.sm2_missed->valid = slave.sm2_missed->known = true;
      slave.sm2_missed->limit = 9;
    }
    report.slaves.push_back(slave);
  }
  report.sync_window_enabled = true;
  report.dc.enabled = report.dc.monitored = true;
  report.dc.state = SyncState::kInSync;
  report.dc.reference_clock = 0;
  report.dc.limit_ns = 127;
  report.dcm.mode = DcmMode::kBusShift;
  report.dcm.state = SyncState::kInSync;
  for (int i = 0; i < 20000; ++i) {
    report.history.frame_lateness.add(5 * kMicrosecond);
    report.lateness_histogram.add(5 * kMicrosecond);
  }
  return report;
}

std::vector<std::string_view> codes(const RunReport& report) {
  std::vector<std::string_view> all;
  for (const auto& finding : diagnose(report)) all.push_back(finding.code);
  return all;
}

void miss(RunReport& report, std::size_t slave, dc::MissCause cause, std::uint32_t count) {
  auto& status = *report.slaves[slave].sm2_missed;
  status.missed += count;
  status.by_cause[static_cast<std::size_t>(cause)] += count;
  status.integrator_highest = 6;
}

TEST(RunDiagnosis, AHealthyRunHasNone) { EXPECT_THAT(codes(healthy()), IsEmpty()); }

RunHistory::SyncLoss loss(int slave, std::int64_t size) {
  return {kStart + 5 * kSecond, slave, size, dc::SyncObstacle::kNone, kStart + 6 * kSecond};
}

TEST(RunDiagnosis, AClockThatMovesByMoreThanThereIsRoomExplainsMisses) {
  auto report = healthy();
  miss(report, 1, dc::MissCause::kUnknown, 4);
  report.history.slaves[1].missed.note(kStart + 5500 * kMillisecond, 4);
  report.history.slave_losses.push_back(loss(1, 700'000));
  EXPECT_THAT(codes(report), Contains(code::kMissedByMovedClock));
  EXPECT_THAT(codes(report), Not(Contains(code::kMissedUnexplained)));
}

TEST(RunDiagnosis, AClockThatLeavesTheWindowByALittleExplainsNone) {
  auto report = healthy();
  miss(report, 1, dc::MissCause::kUnknown, 4);
  report.history.slaves[1].missed.note(kStart + 5500 * kMillisecond, 4);
  report.history.slave_losses.push_back(loss(1, 300));
  EXPECT_THAT(codes(report), Contains(code::kMissedUnexplained));
  EXPECT_THAT(codes(report), Not(Contains(code::kMissedByMovedClock)));
}

TEST(RunDiagnosis, AMovedClockExplainsNoMissesOfAnotherTime) {
  auto report = healthy();
  miss(report, 1, dc::MissCause::kUnknown, 4);
  report.history.slaves[1].missed.note(kStart + 15 * kSecond, 4);
  report.history.slave_losses.push_back(loss(1, 700'000));
  EXPECT_THAT(codes(report), Contains(code::kMissedUnexplained));
}

TEST(RunDiagnosis, SaysToWhichSideSync0IsMisplaced) {
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

TEST(RunDiagnosis, BlamesNoLateFramesForTheFallOfADriveWhoseSync0IsMisplaced) {
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

/// One in a thousand frames is later than there is room: what a clock moves beside that makes no difference.
TEST(RunDiagnosis, AClockThatMovesByLessThanFramesAreLateExplainsNone) {
  auto report = healthy();
  report.slaves[1].sync0_margin = 4 * kMicrosecond;
  miss(report, 1, dc::MissCause::kUnknown, 4);
  report.history.slaves[1].missed.note(kStart + 5500 * kMillisecond, 4);
  report.history.slave_losses.push_back(loss(1, 143));
  EXPECT_THAT(codes(report), Not(Contains(code::kMissedByMovedClock)));
}

TEST(RunDiagnosis, NobodysOwnClockWasOutOfPlaceWhoseReadingsWereSmall) {
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
TEST(RunDiagnosis, WhereNothingHoldsTheFramesNeitherSlavesNorTheirSync0AreBlamed) {
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

TEST(RunDiagnosis, ALaterSync0IsNoHelpAgainstFramesThatSlideThroughIt) {
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
TEST(RunDiagnosis, WhileWhoLeadsIsAwayThereIsNothingToBeOutOfSyncWith) {
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

TEST(RunDiagnosis, AStateThatNobodyHasReadIsNoState) {
  auto report = healthy();
  report.slaves[1].al_status = 0;
  EXPECT_THAT(codes(report), IsEmpty());
}

TEST(RunDiagnosis, FirmwareThatGoesOnIsAWarningAndOneThatHangsAnError) {
  auto report = healthy();
  auto& history = report.history.slaves[1];
  history.pdi_watchdog.note(kStart + 5 * kSecond, 1);
  ASSERT_THAT(codes(report), ElementsAre(code::kFirmwareHung));
  EXPECT_EQ(diagnose(report)[0].severity, Severity::kWarning);
  history.mailbox_silences = 12;
  history.silent_from = kStart + 6 * kSecond;
  history.silent_to = report.history.end - kSecond;
  EXPECT_EQ(diagnose(report)[0].code, code::kFirmwareHangs);
  EXPECT_EQ(diagnose(report)[0].severity, Severity::kError);
}

/// At the first port of slave 2, between two readings.
void damage(RunReport& report, Nanoseconds read, std::uint64_t frames, Nanoseconds since) {
  report.history.slaves[2].port_errors[0].note(read, frames);
  report.history.slaves[2].damage[0].note(read, frames, 0, since);
}

/// Frames that are damaged for a while silence all slaves, and none of them was away.
TEST(RunDiagnosis, NobodyWasAwayBecauseEveryFrameWasDamaged) {
  auto report = healthy();
  report.history.lost_frames.note(kStart + 5 * kSecond + 300 * kMillisecond, 300, 0, kStart + 5 * kSecond);
  for (auto& slave : report.history.slaves) {
    slave.absences.note(kStart + 5300 * kMillisecond, 1, 0, kStart + 5100 * kMillisecond);
  }
  damage(report, kStart + 5400 * kMillisecond, 255, kStart + 4900 * kMillisecond);
  report.slaves[2].evidence.ports[0].at_least = true;
  EXPECT_THAT(codes(report), ElementsAre(code::kPortErrors, code::kFramesLostByNoise));
  report.history.slaves[0].lost_links[0].note(kStart + 5400 * kMillisecond, 1);
  EXPECT_EQ(codes(report).front(), code::kSlaveWasAbsent) << "the plug of the first slave";
}

TEST(RunDiagnosis, AStandstillIsToldWhereItKeptTheClocksFromComingInSync) {
  auto report = healthy();
  report.history.reached_op = false;
  report.history.stalls.note(kStart + 5 * kSecond, 20, 21 * kMillisecond);
  report.dcm.state = SyncState::kBusy;
  report.dcm.obstacle = dc::SyncObstacle::kCyclesLeftOut;
  EXPECT_THAT(codes(report), Contains(code::kHostStalled));
}

TEST(RunDiagnosis, WrongCountersOfTwoCausesHaveTheirOwnTimes) {
  auto report = healthy();
  report.history.wrong_counters.note(kStart + 5 * kSecond, 30);
  report.history.wrong_counters.note(kStart + 15 * kSecond, 7);
  report.history.slaves[1].fall = RunHistory::Fall{kStart + 5 * kSecond, 0x14, 0x1A};
  const auto findings = diagnose(report);
  ASSERT_THAT(codes(report), ElementsAre(code::kWorkingCounter, code::kWorkingCounterExplained));
  EXPECT_EQ(findings[0].from, kStart + 15 * kSecond);
  EXPECT_EQ(findings[1].to, kStart + 5 * kSecond);
}

/// Where nobody monitors: those that follow are off at once and to the same side.
TEST(RunDiagnosis, TheReferenceClockIsNamedWhereAllThatFollowItMovedAlike) {
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

/// Drives that had their outputs say where frames are lost, where one frame carries all of them.
TEST(RunDiagnosis, LooksForLostFramesBehindWhoHadThem) {
  auto report = healthy();
  report.history.lost_frames.note(kStart + 5 * kSecond, 20);
  for (auto& slave : report.slaves) {
    if (slave.sm2_missed) slave.sm2_missed->time = kStart + 10 * kSecond;
  }
  EXPECT_THAT(codes(report), ElementsAre(code::kFramesLostBehind));
  report.first_wire_time = 10 * kMicrosecond;
  report.wire_time = 30 * kMicrosecond;
  EXPECT_THAT(codes(report), ElementsAre(code::kFramesLost)) << "another frame of the cycle may have been lost";
  report = healthy();
  report.history.lost_frames.note(kStart + 5 * kSecond, 20);
  report.history.op_reached = kStart + 6 * kSecond;
  EXPECT_THAT(codes(report), ElementsAre(code::kFramesLost)) << "nobody counted then";
}

TEST(RunDiagnosis, SaysNothingOfCountersThatWereNotReadSinceFramesWereLost) {
  auto report = healthy();
  for (auto& slave : report.slaves) slave.evidence.ports_time = kStart + 19 * kSecond;
  report.history.lost_frames.note(kStart + 18 * kSecond, 2);
  EXPECT_THAT(codes(report), ElementsAre(code::kFramesLost));
  report.history.lost_frames.note(kStart + 19'500 * kMillisecond, 1);
  const auto findings = diagnose(report);
  ASSERT_THAT(codes(report), ElementsAre(code::kFramesLost, code::kFramesLostLast));
  EXPECT_THAT(describe(findings[0]), HasSubstr("2 frames"));
  EXPECT_THAT(describe(findings[1]), HasSubstr("1 frame did not come back at the end"));
}

TEST(RunDiagnosis, FramesThatALooseLinkCostsAreToldWithIt) {
  auto report = healthy();
  report.history.lost_frames.note(kStart + 5 * kSecond, 7);
  report.history.slaves[0].lost_links[0].note(kStart + 5060 * kMillisecond, 1);
  const auto findings = diagnose(report);
  ASSERT_THAT(codes(report), ElementsAre(code::kLinkLost, code::kFramesLostByCable));
  EXPECT_THAT(describe(findings[1]), HasSubstr("when slave 0 lost its link"));
}

TEST(RunDiagnosis, SlavesThatAreStillAwayAfterTheReferenceClockHasSteppedAreNotInsideAgain) {
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

/// Each drive has missed some of them, the more the further behind it stands: they are lost here and there.
TEST(RunDiagnosis, NamesNoPlaceWhereFramesAreLostHereAndThere) {
  constexpr auto kFrameLost = static_cast<std::size_t>(dc::MissCause::kFrameLost);
  auto report = healthy();
  report.history.lost_frames.note(kStart + 5 * kSecond, 40);
  const auto missed = [&](std::size_t slave, std::uint32_t count) {
    auto& status = *report.slaves[slave].sm2_missed;
    status.time = kStart + 10 * kSecond;
    status.missed = status.by_cause[kFrameLost] = count;
  };
  missed(1, 8);
  missed(2, 16);
  EXPECT_THAT(codes(report), Contains(code::kFramesLost));
  missed(1, 0);
  missed(2, 38);
  EXPECT_THAT(codes(report), Contains(code::kFramesLostBehind)) << "between the two";
}

/// What they bring into sentences has to be known to the translations.
TEST(RunDiagnosis, EachObstacleIsAPhraseOfFindings) {
  const auto phrases = finding_phrases();
  for (int i = 1; i <= static_cast<int>(dc::SyncObstacle::kSettling); ++i) {
    const auto text = dc::obstacle_text(static_cast<dc::SyncObstacle>(i));
    EXPECT_NE(std::ranges::find(phrases, text), phrases.end()) << text;
  }
}

TEST(RunDiagnosis, NamesTheCableWhereTheBusEnds) {
  auto report = healthy();
  report.slaves[1].present = report.slaves[2].present = false;
  report.history.slaves[1].absences.note(kStart + 6 * kSecond, 1);
  report.history.slaves[1].absent = true;
  report.history.slaves[1].cable = RunHistory::Cable{0, 1};
  const auto findings = diagnose(report);
  ASSERT_THAT(codes(report), ElementsAre(code::kSlaveAbsentBehindCable));
  EXPECT_EQ(findings[0].place.slave, 1);
  EXPECT_EQ(findings[0].severity, Severity::kError);
  EXPECT_THAT(describe(findings[0]),
              HasSubstr("No answer from slaves 1 to 2 since 6.000 s: nothing comes back over the cable at "
                        "slave 0 port B"));
}

TEST(RunDiagnosis, MissesOfLostFramesDoNotAskForAnotherSync0) {
  auto report = healthy();
  miss(report, 1, dc::MissCause::kFrameLost, 12);
  report.history.lost_frames.note(kStart + 5 * kSecond, 12);
  EXPECT_THAT(codes(report), ElementsAre(code::kMissedByLostFrames, code::kFramesLost));
  EXPECT_THAT(describe(diagnose(report)[0]), Not(HasSubstr("ncrease")));
}

TEST(RunDiagnosis, LostFramesWithErrorsAtAPortAreNoise) {
  auto report = healthy();
  report.history.lost_frames.note(kStart + 5 * kSecond, 3);
  damage(report, kStart + 5 * kSecond + 20 * kMillisecond, 3, kStart + 4900 * kMillisecond);
  EXPECT_THAT(codes(report), ElementsAre(code::kPortErrors, code::kFramesLostByNoise));
  EXPECT_EQ(diagnose(report)[1].place.slave, 2);
}

/// A port that was read in between says that they were none of its doing, and no noise loses more frames than it
/// damages.
TEST(RunDiagnosis, NoiseIsToldForNoMoreFramesThanItCanHaveCost) {
  auto report = healthy();
  report.history.lost_frames.note(kStart + 5 * kSecond, 3);
  report.history.lost_frames.note(kStart + 5300 * kMillisecond, 6);
  damage(report, kStart + 5320 * kMillisecond, 2, kStart + 5200 * kMillisecond);
  EXPECT_THAT(codes(report), ElementsAre(code::kPortErrors, code::kFramesLost, code::kFramesLostByNoise));
  EXPECT_THAT(describe(diagnose(report)[1]), HasSubstr("7 frames"));
  EXPECT_THAT(describe(diagnose(report)[2]), HasSubstr("2 frames"));
  damage(report, kStart + 5510 * kMillisecond, 1, kStart + 5320 * kMillisecond);
  report.history.lost_frames.note(kStart + 5600 * kMillisecond, 9, 0, kStart + 5520 * kMillisecond);
  EXPECT_THAT(describe(diagnose(report)[2]), HasSubstr("3 frames")) << "each of them once";
}

TEST(RunDiagnosis, LostFramesOfAStandingHostAreTheHosts) {
  auto report = healthy();
  report.history.stalls.note(kStart + 5 * kSecond, 40, 41 * kMillisecond);
  report.history.lost_frames.note(kStart + 5 * kSecond, 1);
  EXPECT_THAT(codes(report), ElementsAre(code::kFramesLostByHost, code::kHostStalled));
}

TEST(RunDiagnosis, TellsWhoHeldTheHostWhereItsKernelCounts) {
  auto report = healthy();
  report.history.stalls.note(kStart + 5 * kSecond, 3, 4 * kMillisecond);
  report.host.held = 4 * kMillisecond;
  EXPECT_THAT(codes(report), ElementsAre(code::kHostStalled));
  report.host.held_by_others = 3 * kMillisecond;
  EXPECT_THAT(codes(report), ElementsAre(code::kHostStalledByOthers));
  EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("Of 4 ms"));
  report.host.held_by_others = 30 * kMicrosecond;
  EXPECT_THAT(codes(report), ElementsAre(code::kHostTimerLate));
  EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("it was stopped, or its timer came late"));
}

TEST(RunDiagnosis, NamesTheThreadThatKeptTheProcessorLongest) {
  auto report = healthy();
  report.history.stalls.note(kStart + 5 * kSecond, 3, 4 * kMillisecond);
  report.host.held = 4 * kMillisecond;
  report.host.held_by_others = 3 * kMillisecond;
  report.host.holder = {{"kcleaner"}, true, 3600 * kMicrosecond, 20};
  EXPECT_THAT(codes(report), ElementsAre(code::kHostHeldByKernel));
  EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("kcleaner kept a processor longest, 3.6 ms at a time"));
  report.host.holder.kernel = false;
  EXPECT_THAT(codes(report), ElementsAre(code::kHostHeldByProgram));
  report.host.holder.at_a_time = 20 * kMicrosecond;  // whoever it was, not this one
  EXPECT_THAT(codes(report), ElementsAre(code::kHostStalledByOthers));
  report.host.holder.at_a_time = 4 * kMillisecond;
  report.host.held_by_others = 0;  // nobody made it wait
  EXPECT_THAT(codes(report), ElementsAre(code::kHostTimerLate));
}

TEST(RunDiagnosis, AStandstillBeforeAllAreInOpIsToldWhereSlavesFellByIt) {
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

TEST(RunDiagnosis, SaysHowMuchMoreTimeLateFramesNeed) {
  auto report = healthy();
  report.slaves[1].sync0_margin = 30 * kMicrosecond;
  report.slaves[1].evidence.calc_and_copy_ns = 20 * kMicrosecond;
  for (int i = 0; i < 200; ++i) report.history.frame_lateness.add(295 * kMicrosecond);
  miss(report, 1, dc::MissCause::kFrameLate, 40);
  const auto findings = diagnose(report);
  ASSERT_FALSE(findings.empty());
  ASSERT_EQ(findings[0].code, code::kMissedByLateFrames);
  const auto more = std::ranges::find(findings[0].figures, "more", &Figure::name);
  EXPECT_GE(more->value, 285 * kMicrosecond);
  EXPECT_LE(more->value, 310 * kMicrosecond);
  EXPECT_THAT(describe(findings[0]), HasSubstr("Increase the set value by"));
}

/// One event missed by an odd late frame is not why the outputs of thousands of cycles came too late.
TEST(RunDiagnosis, OutputsThatComeTooLateInEachCycleAreToldBesideAnEventMissed) {
  auto report = healthy();
  auto& slave = report.slaves[1];
  slave.sync0_margin = 13 * kMicrosecond;
  slave.evidence.calc_and_copy_ns = 30 * kMicrosecond;
  slave.evidence.outputs.shift_too_short.total = 6120;
  slave.evidence.outputs.shift_too_short.time = kStart + 6 * kSecond;
  report.history.slaves[1].shift_too_short.note(kStart + kSecond, 6120);
  miss(report, 1, dc::MissCause::kFrameLate, 1);
  EXPECT_THAT(codes(report), UnorderedElementsAre(code::kMissedByLateFrames, code::kShiftTooShort));
  // Where frames leave enough when they are on time, it is one cause with two consequences.
  slave.sync0_margin = 40 * kMicrosecond;
  EXPECT_THAT(codes(report), ElementsAre(code::kMissedByLateFrames));
}

TEST(RunDiagnosis, NobodyIsNamedWhoIsWithinTheLimit) {
  auto report = healthy();
  report.dc.state = SyncState::kOutOfSync;
  report.slaves[1].deviation_ns = 96;
  EXPECT_THAT(codes(report), ElementsAre(code::kSlavesOutOfSync));
  report.dc.culprit = 2;
  report.slaves[2].deviation_ns = -300;
  ASSERT_THAT(codes(report), ElementsAre(code::kSlaveLeftWindow));
  EXPECT_EQ(diagnose(report)[0].place.slave, 2);
}

TEST(RunDiagnosis, WhoLeftTheWindowIsNamedAlsoWhenItsLastReadingIsInsideAgain) {
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

TEST(RunDiagnosis, WhatIsNotKnownIsNotCalledOutOfSync) {
  auto report = healthy();
  report.dc.state = SyncState::kUnknown;
  EXPECT_THAT(codes(report), ElementsAre(code::kSlavesSyncUnknown));
  report.dc.state = SyncState::kBusy;
  EXPECT_THAT(codes(report), ElementsAre(code::kSlavesOutOfSync)) << "they never were";
}

TEST(RunDiagnosis, OneClockIsNotAskedToBeMonitored) {
  auto report = healthy();
  report.dc.monitored = false;
  EXPECT_THAT(codes(report), ElementsAre(code::kNothingToMonitor));
  report.sync_window_enabled = false;
  EXPECT_THAT(codes(report), ElementsAre(code::kNotMonitored));
  report.history.slaves[2].off.note(kStart + 8 * kSecond, 3, 900'000);
  EXPECT_THAT(codes(report), ElementsAre(code::kSlaveClockOff, code::kNotMonitored));
}

TEST(RunDiagnosis, WhereNobodyFollowsNobodyIsOutOfSync) {
  auto report = healthy();
  report.dc.state = SyncState::kNotMonitored;
  EXPECT_THAT(codes(report), ElementsAre(code::kNothingToMonitor));
}

TEST(RunDiagnosis, WorkingCountersAfterAFallAreItsConsequence) {
  auto report = healthy();
  report.history.wrong_counters.note(kStart + 5 * kSecond, 30);
  EXPECT_THAT(codes(report), ElementsAre(code::kWorkingCounter));
  report.history.slaves[1].fall = RunHistory::Fall{kStart + 5 * kSecond, 0x14, 0x1A};
  EXPECT_THAT(codes(report), ElementsAre(code::kWorkingCounterExplained));
}

TEST(RunDiagnosis, ADriveThatFellThoughAllWasGoodFellByItself) {
  auto report = healthy();
  report.slaves[1].al_status = 0x14;
  report.slaves[1].al_status_code = 0x1A;
  report.history.slaves[1].fall = RunHistory::Fall{kStart + 5 * kSecond, 0x14, 0x1A};
  EXPECT_THAT(codes(report), ElementsAre(code::kSlaveFellByItself));
  report.history.lost_frames.note(kStart + 5 * kSecond - 5 * kMillisecond, 3);
  EXPECT_EQ(codes(report).front(), code::kSlaveFell) << "something was wrong: nothing is claimed";
  miss(report, 1, dc::MissCause::kFrameLost, 3);
  EXPECT_EQ(codes(report).front(), code::kSlaveFellByMisses);
}

TEST(RunDiagnosis, WhatHappensLongAfterTheMasterFoundBackIsNotDoneByItsTimeUnlocked) {
  auto report = healthy();
  report.history.master_losses.push_back(
      {kStart + kSecond, -1, 5'000, dc::SyncObstacle::kControlError, kStart + 2 * kSecond});
  auto fallen = report;
  fallen.slaves[1].al_status = 0x14;
  fallen.slaves[1].al_status_code = 0x2C;
  auto& fall = fallen.history.slaves[1].fall;
  fall = RunHistory::Fall{kStart + 5 * kSecond, 0x14, 0x2C};
  EXPECT_THAT(codes(fallen), Contains(code::kSlaveFellByItself));
  fall->time = kStart + 3 * kSecond / 2;
  EXPECT_THAT(describe(diagnose(fallen)[0]), HasSubstr("frames slid through its SYNC0"));
  fall->time = kStart + 5 * kSecond;
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

TEST(RunDiagnosis, AnEarlierFallSaysWhatWasWrongJustBefore) {
  auto report = healthy();
  report.history.slaves[1].falls.push_back({kStart + 5 * kSecond, 0x14, 0x34});
  EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("led up again. Check that SYNC pulses"));
  report.history.lost_frames.note(kStart + 5 * kSecond - 8 * kMillisecond, 3);
  EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("just before: frames were lost. Check what else is told"));
  report.history.slaves[1].falls.front().al_status_code = 0x1D;
  EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("led up again. Check")) << "no error of its synchronisation";
}

TEST(RunDiagnosis, ADriveFallsByWhatWasJustBeforeAndNotByWhatItGotOver) {
  auto report = healthy();
  report.slaves[1].al_status = 0x14;
  report.slaves[1].al_status_code = 0x1A;
  report.history.slaves[1].fall = RunHistory::Fall{kStart + 9 * kSecond, 0x14, 0x1A};
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

TEST(RunDiagnosis, ASlaveThatFellWhenAClockHadMovedIsToldAsThat) {
  auto report = healthy();
  report.slaves[1].al_status = 0x14;
  report.slaves[1].al_status_code = 0x1A;
  report.history.slaves[1].fall = RunHistory::Fall{kStart + 5 * kSecond, 0x14, 0x1A};
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

TEST(RunDiagnosis, ASlaveThatFellAfterItsFirmwareHadStoodStillIsToldAsThat) {
  auto report = healthy();
  auto& history = report.history.slaves[1];
  report.slaves[1].al_status = 0x14;
  report.slaves[1].al_status_code = 0x2C;
  history.fall = RunHistory::Fall{kStart + 9 * kSecond, 0x14, 0x2C};
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

TEST(RunDiagnosis, ACycleThatAMovedSync0CutShortIsNotTheFirmwares) {
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
TEST(RunDiagnosis, AReferenceClockThatMovesIsLedByTheHostsWhereThatIsSo) {
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

/// No loop follows anybody by hundreds of microseconds in a cycle.
TEST(RunDiagnosis, AReferenceClockThatJumpsFurtherThanItCanBeLedIsLedByNobody) {
  auto report = healthy();
  report.dcm.mode = DcmMode::kBusShift;
  report.history.slave_losses = {{kStart + 8 * kSecond, -1, 5'000, dc::SyncObstacle::kClockStep, kStart + 9 * kSecond}};
  const auto words = [&report] { return describe(diagnose(report).front()); };
  EXPECT_THAT(words(), HasSubstr("a time service may have moved"));
  report.history.slave_losses.front().size = -400'000;
  EXPECT_THAT(words(), AllOf(HasSubstr("The reference clock stepped"), Not(HasSubstr("time service"))));
}

TEST(RunDiagnosis, ASync0ThatIsMisplacedIsNotAlsoTooTight) {
  auto report = healthy();
  report.slaves[1].sync0_margin = 40'000;
  report.slaves[1].evidence.calc_and_copy_ns = 62'500;
  EXPECT_THAT(codes(report), Contains(code::kSync0TooTight));
  report.slaves[1].evidence.sync0.time = kStart + kSecond;
  report.slaves[1].evidence.sync0.off_ns = 400'000;
  EXPECT_THAT(codes(report), ElementsAre(code::kSync0Misplaced)) << "a larger set value is no cure for it";
}

TEST(RunDiagnosis, WhatAMisplacedSync0LeavesAFrameIsNoMeasureOfTheHost) {
  auto report = healthy();
  report.slaves[1].sync0_margin = 4'000;
  ASSERT_THAT(codes(report), Contains(code::kHostLate));
  report.slaves[1].evidence.sync0.time = kStart + kSecond;
  report.slaves[1].evidence.sync0.off_ns = 400'000;
  EXPECT_THAT(codes(report), ElementsAre(code::kSync0Misplaced));
}

TEST(RunDiagnosis, ADriveThatGetsItsOutputsTooShortlyBeforeSync0DidNotFallByItself) {
  auto report = healthy();
  report.slaves[1].al_status = 0x14;
  report.slaves[1].al_status_code = 0x1A;
  report.history.slaves[1].fall = RunHistory::Fall{kStart + 5 * kSecond, 0x14, 0x1A};
  report.slaves[1].sync0_margin = 53'300;
  report.slaves[1].evidence.calc_and_copy_ns = 62'500;
  ASSERT_THAT(codes(report), ElementsAre(code::kSlaveFell, code::kSync0TooTight));
  EXPECT_THAT(describe(diagnose(report)[1]), HasSubstr("it needs 62.5 us for its outputs"));
  report.slaves[1].evidence.calc_and_copy_ns = 40'000;
  EXPECT_THAT(codes(report), ElementsAre(code::kSlaveFellByItself));
}

TEST(RunDiagnosis, ADriveThatWasCutOffDidNotFallByItself) {
  auto report = healthy();
  report.slaves[1].al_status = 0x14;
  report.slaves[1].al_status_code = 0x1A;
  report.history.slaves[1].fall = RunHistory::Fall{kStart + 5 * kSecond, 0x14, 0x1A};
  report.history.slaves[1].absences.note(kStart + 4990 * kMillisecond, 1, 0, kStart + 4890 * kMillisecond);
  for (const std::uint32_t missed : {0U, 2U}) {
    miss(report, 1, dc::MissCause::kUnknown, missed);
    EXPECT_EQ(codes(report).front(), code::kSlaveFell) << missed;
    EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("it had been cut off from the master"));
  }
}

TEST(RunDiagnosis, ADriveWhoseClockJumpedDidNotFallByItself) {
  auto report = healthy();
  report.slaves[1].al_status = 0x14;
  report.slaves[1].al_status_code = 0x1A;
  report.history.slaves[1].fall = RunHistory::Fall{kStart + 5 * kSecond, 0x14, 0x1A};
  report.history.slave_losses.push_back({kStart + 4998 * kMillisecond, 2, 442'000, {}, kStart + 7 * kSecond});
  EXPECT_EQ(codes(report).front(), code::kSlaveFellByItself) << "it was another one's clock";
  report.history.slave_losses.front().slave = 1;
  EXPECT_EQ(codes(report).front(), code::kSlaveFellByMovedClock);
}

TEST(RunDiagnosis, ADriveThatFellByLateFramesNeedsALaterSync0) {
  auto report = healthy();
  report.slaves[1].al_status = 0x14;
  report.slaves[1].al_status_code = 0x1A;
  report.history.slaves[1].fall = RunHistory::Fall{kStart + 5 * kSecond, 0x14, 0x1A};
  miss(report, 1, dc::MissCause::kFrameLate, 3);
  const auto findings = diagnose(report);
  ASSERT_EQ(findings.front().code, code::kSlaveFellByLateFrames);
  EXPECT_THAT(describe(findings.front()), HasSubstr("Increase the set value by"));
}

TEST(RunDiagnosis, OutputsThatCouldNotComeAreNoTroubleOfTheirOwn) {
  auto report = healthy();
  auto& slave = report.history.slaves[1];
  slave.process_data_watchdog.note(kStart + 7 * kSecond, 1);
  EXPECT_THAT(codes(report), ElementsAre(code::kOutputsWatchdog));
  slave.absences.note(kStart + 6900 * kMillisecond, 1, 0, kStart + 5 * kSecond);
  EXPECT_THAT(codes(report), ElementsAre(code::kSlaveWasAbsent));
  slave.process_data_watchdog.note(kStart + 9 * kSecond, 1);
  EXPECT_THAT(codes(report), testing::Contains(code::kOutputsWatchdog)) << "this one came long after";
}

TEST(RunDiagnosis, WhatASlaveMissedWhileItWasCutOffIsItsAbsence) {
  auto report = healthy();
  report.slaves[1].sync0_cycle = kMillisecond;
  miss(report, 1, dc::MissCause::kUnknown, 1'900);
  EXPECT_THAT(codes(report), testing::Contains(code::kMissedUnexplained));
  report.history.slaves[1].absences.note(kStart + 6 * kSecond, 1, 0, kStart + 5 * kSecond);
  EXPECT_THAT(codes(report), testing::Not(testing::Contains(code::kMissedUnexplained)));
  miss(report, 1, dc::MissCause::kUnknown, 30'000);
  EXPECT_THAT(codes(report), testing::Contains(code::kMissedUnexplained)) << "more than it was away for";
}

/// A plug that is loose for a cycle: frames turn back in front of those behind it.
TEST(RunDiagnosis, WhatSlavesMissBehindALooseLinkIsTheLinks) {
  auto report = healthy();
  report.history.wrong_counters.note(kStart + 5 * kSecond, 1);
  miss(report, 1, dc::MissCause::kUnknown, 1);
  EXPECT_THAT(codes(report), Contains(code::kMissedUnexplained));
  EXPECT_THAT(codes(report), Contains(code::kWorkingCounter));
  report.history.slaves[1].lost_links[0].note(kStart + 5060 * kMillisecond, 1);
  EXPECT_THAT(codes(report), ElementsAre(code::kLinkLost, code::kWorkingCounterExplained));
  // Both ends of the cable count: it is the slave behind it whose data were missing.
  report.history.slaves[0].lost_links[1].note(kStart + 5060 * kMillisecond, 1);
  const auto findings = diagnose(report);
  const auto counter = std::ranges::find(findings, code::kWorkingCounterExplained, &Finding::code);
  ASSERT_NE(counter, findings.end());
  const auto who = std::ranges::find(counter->figures, "slave", &Figure::name);
  ASSERT_NE(who, counter->figures.end());
  EXPECT_EQ(who->value, 1);
  miss(report, 1, dc::MissCause::kUnknown, 7);
  EXPECT_THAT(codes(report), Contains(code::kMissedUnexplained)) << "more than cycles in which it was passed over";
}

/// While the host stands still nobody gets outputs, or the time.
TEST(RunDiagnosis, WhatAStandstillOfTheHostDoesIsToldWithIt) {
  auto report = healthy();
  report.history.stalls.note(kStart + 5 * kSecond, 200, 201 * kMillisecond, kStart + 4800 * kMillisecond);
  report.history.slaves[1].process_data_watchdog.note(kStart + 5 * kSecond, 1);
  report.history.slave_losses.push_back({kStart + 5 * kSecond, 1, 306, {}, kStart + 6 * kSecond});
  EXPECT_THAT(codes(report), ElementsAre(code::kHostStalled));
  report.history.slave_losses.push_back({kStart + 5 * kSecond, 1, 500'000, {}, kStart + 6 * kSecond});
  EXPECT_THAT(codes(report), Contains(code::kWindowLeft)) << "no quartz runs away so fast";
}

TEST(RunDiagnosis, FramesThatAStandstillOfTheHostHoldsAreHeldByIt) {
  auto report = healthy();
  miss(report, 1, dc::MissCause::kFrameHeldUp, 2);
  report.history.slaves[1].missed.note(kStart + 5 * kSecond + 200 * kMillisecond, 2);
  EXPECT_THAT(codes(report), ElementsAre(code::kMissedByHeldFrames));
  report.history.stalls.note(kStart + 5 * kSecond, 1, 2 * kMillisecond, kStart + 4998 * kMillisecond);
  EXPECT_THAT(codes(report), ElementsAre(code::kMissedByHost, code::kHostStalled));
}

TEST(RunDiagnosis, AnOutageExcusesNoFramesThatWereLostAtAnotherTime) {
  auto report = healthy();
  report.slaves[1].sync0_cycle = kMillisecond;
  miss(report, 1, dc::MissCause::kFrameLost, 900);
  report.history.link_outages.note(kStart + 6 * kSecond, 1, 0, kStart + 5 * kSecond);
  EXPECT_THAT(codes(report), testing::Not(testing::Contains(code::kMissedByLostFrames)));
  report.history.lost_frames.note(kStart + 5500 * kMillisecond, 900);
  EXPECT_THAT(codes(report), testing::Not(testing::Contains(code::kMissedByLostFrames))) << "those of the outage";
  report.history.lost_frames.note(kStart + 20 * kSecond, 12);
  EXPECT_THAT(codes(report), testing::Contains(code::kMissedByLostFrames));
}

TEST(RunDiagnosis, TheWindowThatSomebodyLeavesWhenASlaveComesBackIsItsReturn) {
  auto report = healthy();
  report.history.slave_losses.push_back({kStart + 6 * kSecond, -1, 167, {}, kStart + 7 * kSecond});
  EXPECT_THAT(codes(report), testing::Contains(code::kWindowLeft));
  report.history.slaves[2].absences.note(kStart + 6 * kSecond, 1, 0, kStart + 5 * kSecond);
  EXPECT_THAT(codes(report), testing::Not(testing::Contains(code::kWindowLeft)));
}

TEST(RunDiagnosis, AllThatLeaveTheWindowToTheSameSideHaveNotMovedThemselves) {
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
TEST(RunDiagnosis, WhoLeftTheWindowBeforeTheCulpritIsToldAsWell) {
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

TEST(RunDiagnosis, FramesThatAllCameBackLateAreNoAbsence) {
  auto report = healthy();
  for (auto& slave : report.history.slaves)
    slave.absences.note(kStart + 5108 * kMillisecond, 1, 0, kStart + 5100 * kMillisecond);
  EXPECT_THAT(codes(report), ElementsAre(code::kSlaveWasAbsent));
  report.history.late_frames.note(kStart + 5108 * kMillisecond, 1, 107 * kMillisecond);
  report.late_frames = 108;
  EXPECT_THAT(codes(report), ElementsAre(code::kFramesLate));
  report.history.lost_frames.note(kStart + 5050 * kMillisecond, 1);
  EXPECT_THAT(codes(report), Contains(code::kSlaveWasAbsent)) << "one of them did not";
}

TEST(RunDiagnosis, AMailboxThatWasSilentIsToldWhenItAnswersAgain) {
  auto report = healthy();
  report.history.slaves[1].mailbox_silences = 4;
  EXPECT_THAT(codes(report), IsEmpty());
  report.history.slaves[1].mailbox_silences = 5;
  EXPECT_THAT(codes(report), ElementsAre(code::kMailboxSilent));
}

TEST(RunDiagnosis, LostLinksOfHotConnectGroupsAreMeantToBe) {
  auto report = healthy();
  report.history.slaves[1].lost_links[1].note(kStart + 5 * kSecond, 1);
  EXPECT_THAT(codes(report), ElementsAre(code::kLinkLost));
  report.slaves[2].optional = true;
  EXPECT_THAT(codes(report), IsEmpty());
}

TEST(RunDiagnosis, EveryPlaceholderIsFilled) {
  auto report = healthy();
  report.slaves[1].present = false;
  report.slaves[2].al_status = 0x14;
  report.slaves[2].al_status_code = 0x1A;
  report.history.stalls.note(kStart + 9 * kSecond, 40, 41 * kMillisecond);
  report.history.late_frames.note(kStart + kSecond, 1, 5000);
  report.late_frames = 1;
  for (auto& slave : report.history.slaves) {
    slave.port_errors[0].note(kStart + kSecond, 2);
    slave.lost_links[1].note(kStart + kSecond, 2);
    slave.pdi_watchdog.note(kStart + kSecond, 1);
    slave.process_data_watchdog.note(kStart + kSecond, 1);
    slave.outputs_exceeded.note(kStart + kSecond, 1);
    slave.mailbox_silences = 9;
  }
  for (auto& slave : report.slaves) {
    slave.evidence.outputs.exceeded.total = 1;
    slave.evidence.outputs.shift_too_short.total = 1;
    slave.evidence.inputs.shift_too_short.total = 1;
  }
  report.history.lost_frames.note(kStart + 15 * kSecond, 3);
  report.history.wrong_counters.note(kStart + 15 * kSecond, 3);
  for (const auto cause : {dc::MissCause::kFrameLost, dc::MissCause::kUnknown}) miss(report, 2, cause, 5);
  report.history.slave_losses.push_back({kStart + kSecond, -1, 500, {}, {}});
  report.history.master_losses.push_back({kStart + kSecond, -1, 500, {}, {}});
  const auto filled = [&report] {
    for (const auto& finding : diagnose(report)) EXPECT_THAT(describe(finding), Not(HasSubstr("{"))) << finding.code;
  };
  filled();
  report.dcm.state = SyncState::kOutOfSync;
  report.dc.state = SyncState::kUnknown;
  filled();
  report.dcm.error_code = 0x981201C2;
  filled();
}

/// 333 us on the wire and 570 us through the slaves: what slaves are asked for has no room beside it.
RunReport crowded() {
  auto report = healthy();
  report.wire_time = 333'280;
  report.first_wire_time = 123'040;
  report.round_trip = 123'040 + 570'000;
  report.cycles = 5000;
  report.late_frames = 100;
  report.history.late_frames.note(kStart + kSecond, 100, 500);
  report.slaves[1].al_status = report.slaves[2].al_status = static_cast<std::uint16_t>(AlState::kSafeop);
  return report;
}

TEST(RunDiagnosis, ACycleThatIsTooShortIsToldInPlaceOfWhatItCauses) {
  const auto findings = diagnose(crowded());
  ASSERT_FALSE(findings.empty());
  EXPECT_EQ(findings[0].code, "cycle-too-short");
  EXPECT_EQ(findings[0].severity, Severity::kError);
  EXPECT_EQ(findings[0].place.key, "master.cycle_time_us");
  EXPECT_THAT(describe(findings[0]), HasSubstr("it takes 903.3 us, 333.28 us on the wire and 570 us on their way"));
  const auto all = codes(crowded());
  EXPECT_THAT(all, Not(testing::Contains(code::kSlaveBehind)));
  EXPECT_THAT(all, Not(testing::Contains(code::kFramesLate)));
}

TEST(RunDiagnosis, ALongerCycleIsNotAccused) {
  auto report = crowded();
  report.cycle_time = 2 * kMillisecond;
  EXPECT_THAT(codes(report), Not(testing::Contains("cycle-too-short")));
  report = crowded();
  report.late_frames = 0;
  report.slaves = healthy().slaves;
  EXPECT_THAT(codes(report), Not(testing::Contains("cycle-too-short"))) << "nobody suffers";
}

TEST(RunDiagnosis, ACycleInWhichNoFrameComesBackIsTooShort) {
  auto report = crowded();
  report.round_trip.reset();
  report.cycle_time = 500 * kMicrosecond;
  report.late_frames = 10'000;
  report.history.late_frames.note(kStart + 2 * kSecond, 9'900, 298'000);
  for (auto& slave : report.slaves) slave.present = false;
  for (auto& slave : report.history.slaves) slave.absences.note(kStart, 1);
  EXPECT_EQ(codes(report).front(), "cycle-too-short");
  EXPECT_THAT(codes(report), Not(testing::Contains(code::kSlaveAbsent)));
}

}  // namespace
}  // namespace syncline
