// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "diagnosis/run_diagnosis.h"
#include "findings/figure.h"
#include "findings/finding.h"
#include "findings/run_codes.h"
#include "tests/core/diagnosis/healthy_report.h"
#include "trace/run_report.h"

namespace syncline {
namespace {

using test::codes;
using test::healthy;
using test::kStart;
using test::miss;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

TEST(RunDiagnosis, AHealthyRunHasNone) { EXPECT_THAT(codes(healthy()), IsEmpty()); }

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

TEST(RunDiagnosis, WhatFirmwareFindsWhenItGoesOnAgainIsToldWithItsStandstill) {
  auto report = healthy();
  auto& slave = report.history.slaves[1];
  miss(report, 1, dc::MissCause::kUnknown, 1);
  slave.missed.note(kStart + 8 * kSecond, 1);
  slave.pdi_watchdog.note(kStart + 5 * kSecond, 1);
  EXPECT_THAT(codes(report), Contains(code::kMissedUnexplained)) << "seconds later";
  slave.pdi_silent.note(kStart + 7'500 * kMillisecond, 0, 0, kStart + 5 * kSecond);
  EXPECT_THAT(codes(report), ElementsAre(code::kFirmwareHung));
  slave.missed.note(kStart + 20 * kSecond, 1);
  EXPECT_THAT(codes(report), Contains(code::kMissedUnexplained)) << "and once more without it";
}

/// The way to the external clock is none that anybody left; what leaves it is no matter of the host's schedule.
TEST(RunDiagnosis, TheExternalClockIsToldApartFromTheSchedule) {
  auto report = healthy();
  report.dcm.mode = DcmMode::kDcx;
  auto& losses = report.history.master_losses;
  const auto apart = [](int second, Nanoseconds size, dc::SyncObstacle why) {
    return RunHistory::SyncLoss{kStart + second * kSecond, -1, size, why, kStart + (second + 1) * kSecond};
  };
  losses.push_back(apart(1, 300'000, dc::SyncObstacle::kToExternalClock));
  EXPECT_THAT(codes(report), ElementsAre());
  losses.push_back(apart(5, -20'000, dc::SyncObstacle::kExternalClock));
  losses.push_back(apart(9, 9'000, dc::SyncObstacle::kExternalClock));
  const auto left = diagnose(report);
  ASSERT_THAT(codes(report), ElementsAre(code::kExternalClockLeft));
  EXPECT_EQ(left[0].from, kStart + 5 * kSecond);
  EXPECT_EQ(left[0].to, kStart + 10 * kSecond);
  EXPECT_THAT(describe(left[0]), HasSubstr("is 2 times, first at"));
  EXPECT_THAT(describe(left[0]), HasSubstr("up to 20 us away"));
  losses.pop_back();
  losses.back().back.reset();
  report.dcm.state = SyncState::kOutOfSync;
  report.dcm.obstacle = dc::SyncObstacle::kExternalClock;
  report.dcm.external_error_ns = -16'000;
  for (int i = 0; i < 100; ++i) report.lateness_histogram.add(report.cycle_time / 8);
  const auto away = diagnose(report);
  ASSERT_THAT(codes(report), ElementsAre(code::kExternalClockNotMet));
  EXPECT_THAT(describe(away[0]), HasSubstr("is 16 us away from the external clock. To go there takes some 2 s."));
}

TEST(RunDiagnosis, OutputsTooLateWithAnEventMissedByAHeldFrameAreToldWithIt) {
  auto report = healthy();
  miss(report, 1, dc::MissCause::kFrameHeldUp, 2);
  auto& missed = report.history.slaves[1].missed;
  auto& late = report.slaves[1].evidence.outputs.shift_too_short;
  missed.note(kStart + 5 * kSecond, 1);
  missed.note(kStart + 15 * kSecond, 1);
  late.total = 2;
  EXPECT_THAT(codes(report), Contains(code::kShiftTooShort)) << "nobody knows when";
  report.history.slaves[1].shift_too_short.note(kStart + 5'500 * kMillisecond, 1);
  report.history.slaves[1].shift_too_short.note(kStart + 19 * kSecond, 1);
  EXPECT_THAT(codes(report), ElementsAre(code::kMissedByHeldFrames));
  late.total = 3;
  report.history.slaves[1].shift_too_short.note(kStart + 40 * kSecond, 1);
  EXPECT_THAT(codes(report), Contains(code::kShiftTooShort)) << "at another time, too";
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

/// Also where none of them was missed: it is not its SYNC0 that has to move.
TEST(RunDiagnosis, OutputsThatCameTooLateInHeldFramesAskForNoOtherShift) {
  auto report = healthy();
  auto& slave = report.slaves[1];
  slave.sync0_margin = 480 * kMicrosecond;
  slave.evidence.calc_and_copy_ns = 30'000;
  slave.evidence.outputs.shift_too_short = {3, false, kStart + 6 * kSecond};
  report.history.slaves[1].shift_too_short.note(kStart + 6 * kSecond, 3);
  EXPECT_THAT(codes(report), ElementsAre(code::kShiftTooShort));
  report.history.held_frames.note(kStart + 5'500 * kMillisecond, 1, 300 * kMicrosecond);
  EXPECT_THAT(codes(report), ElementsAre(code::kShiftTooShort)) << "that leaves it enough";
  report.history.held_frames.note(kStart + 5'500 * kMillisecond, 1, 460 * kMicrosecond);
  EXPECT_THAT(codes(report), ElementsAre(code::kMissedByHeldFrames));
  EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("because frames were held up on their way, by up to 460 us."));
  report.history.slaves[1].shift_too_short.note(kStart + 60 * kSecond, 1);
  EXPECT_THAT(codes(report), ElementsAre(code::kShiftTooShort)) << "at another time, too";
}

/// A frame that was held up may have left a little late, too; and what the slave counted of it, nobody else saw.
TEST(RunDiagnosis, WhatAHeldFrameThatLeftLateDoesIsItsDoing) {
  auto report = healthy();
  auto& slave = report.slaves[1];
  slave.sync0_margin = 480 * kMicrosecond;
  slave.evidence.calc_and_copy_ns = 30'000;
  slave.evidence.outputs.shift_too_short = {1, false, kStart + 6 * kSecond};
  report.history.slaves[1].shift_too_short.note(kStart + 6 * kSecond, 1);
  miss(report, 1, dc::MissCause::kUnknown, 1);
  report.history.slaves[1].missed.note(kStart + 6 * kSecond, 1);
  report.history.held_frames.note(kStart + 5'500 * kMillisecond, 1, 444 * kMicrosecond);
  EXPECT_THAT(codes(report), Contains(code::kMissedUnexplained)) << "6 us more would have done";
  report.history.held_frames.note(kStart + 5'500 * kMillisecond, 1, 446 * kMicrosecond);
  EXPECT_THAT(codes(report), ElementsAre(code::kMissedByHeldFrames));
}

/// Nor is it the host that is too late, where frames that left as late as ever were held up by far more than that.
TEST(RunDiagnosis, FramesThatComeBehindSync0BecauseTheyWereHeldUpAreNotTheHosts) {
  auto report = healthy();
  auto& slave = report.slaves[1];
  slave.sync0_margin = 240 * kMicrosecond;
  slave.evidence.calc_and_copy_ns = 30 * kMicrosecond;
  report.history.frame_lateness.add(60 * kMicrosecond);
  miss(report, 1, dc::MissCause::kFrameLate, 3);
  report.history.slaves[1].missed.note(kStart + 6 * kSecond, 3);
  EXPECT_THAT(codes(report), ElementsAre(code::kMissedByLateFrames));
  auto& held = report.history.held_frames;
  held.note(kStart + 5'500 * kMillisecond, 1, 20 * kMicrosecond);
  EXPECT_THAT(codes(report), ElementsAre(code::kMissedByLateFrames)) << "by so little";
  held.note(kStart + 5'500 * kMillisecond, 1, 186 * kMicrosecond);
  EXPECT_THAT(codes(report), ElementsAre(code::kMissedByHeldFrames));
  test::fall(report, 1, 6 * kSecond, 0x001A);
  EXPECT_THAT(codes(report), ElementsAre(code::kSlaveFellByMisses));
  EXPECT_THAT(describe(diagnose(report)[0]), HasSubstr("held up on their way"));
  slave.sync0_margin = 60 * kMicrosecond;
  for (int i = 0; i < 200; ++i) report.history.frame_lateness.add(295 * kMicrosecond);
  EXPECT_THAT(codes(report), ElementsAre(code::kSlaveFellByLateFrames)) << "too late without that";
}

/// The longer the cycle, the further are slaves behind a clock that follows an old time.
TEST(RunDiagnosis, HeldFramesOfLongCyclesTakeTheSlavesFurtherAway) {
  auto report = healthy();
  report.dcm.mode = DcmMode::kLinkLayerRefClock;
  report.dc.monitored = true;
  report.cycle_time = 2 * kMillisecond;
  RunHistory::SyncLoss loss{kStart + 5 * kSecond, 1, 2'276, dc::SyncObstacle::kClockStep, kStart + 6 * kSecond};
  loss.held = 200 * kMicrosecond;
  report.history.slave_losses.push_back(loss);
  EXPECT_THAT(codes(report), ElementsAre(code::kReferenceWrittenLate));
  report.history.slave_losses.back().held = 100 * kMicrosecond;
  EXPECT_THAT(codes(report), ElementsAre(code::kWindowLeft)) << "that is not all of it";
  report.cycle_time = kMillisecond;
  report.history.slave_losses.back().held = 200 * kMicrosecond;
  EXPECT_THAT(codes(report), ElementsAre(code::kWindowLeft));
}

TEST(RunDiagnosis, NobodyWasLedUpAgainWhereAllAreDown) {
  auto report = healthy();
  report.state = AlState::kSafeop;
  for (std::size_t i = 0; i < 3; ++i) {
    test::fall(report, i, 5 * kSecond, 0x001B);
    report.history.slaves[i].falls.push_back(*report.history.slaves[i].fall);
  }
  EXPECT_THAT(codes(report), ElementsAre(code::kSlaveFell, code::kSlaveFell, code::kSlaveFell));
  report.slaves[0].al_status = static_cast<std::uint16_t>(AlState::kSafeop);
  EXPECT_THAT(codes(report), Not(Contains(code::kSlaveHadFallen))) << "its error was acknowledged, and no more";
  report.slaves[0].al_status = static_cast<std::uint16_t>(AlState::kOp);
  EXPECT_THAT(codes(report), Contains(code::kSlaveHadFallen));
}

/// It has no outputs for a while when it is taken to INIT.
TEST(RunDiagnosis, AWatchdogThatExpiresWhileItsSlaveIsLedUpAnewIsNoTrouble) {
  auto report = healthy();
  auto& history = report.history.slaves[1];
  history.process_data_watchdog.note(kStart + 8 * kSecond, 1);
  EXPECT_THAT(codes(report), ElementsAre(code::kOutputsWatchdog));
  history.recoveries.note(kStart + 7'500 * kMillisecond, 1);
  EXPECT_THAT(codes(report), IsEmpty());
}

/// One alone cannot be compared with others.
TEST(RunDiagnosis, TheOnlyOneThatFollowsIsNotBlamedForAStepThatTheMasterSaw) {
  auto report = healthy();
  report.dc.followers = 1;
  report.history.slave_losses.push_back(test::loss(1, 500'000));
  const auto blamed = [&](int slave) {
    return std::ranges::any_of(diagnose(report), [&](const Finding& finding) {
      return finding.code == code::kWindowLeft && finding.place.slave == slave;
    });
  };
  EXPECT_TRUE(blamed(1));
  report.history.master_losses.push_back(
      {kStart + 5 * kSecond + 3 * kMillisecond, -1, -500'000, dc::SyncObstacle::kClockStep, kStart + 6 * kSecond});
  EXPECT_TRUE(blamed(0));
  report.dc.followers = 2;
  EXPECT_TRUE(blamed(1)) << "the other one did not move";
}

/// It is compared with the others to some ten ns before it leads again.
TEST(RunDiagnosis, AReferenceClockThatComesHomeIsNoClockThatSteps) {
  auto report = healthy();
  report.history.slave_losses.push_back(test::loss(-1, 151));
  EXPECT_THAT(codes(report), ElementsAre(code::kWindowLeft));
  report.history.lead_changes.note(kStart + 5 * kSecond, 1);
  EXPECT_THAT(codes(report), IsEmpty());
  report.history.slave_losses.push_back(test::loss(-1, 500));
  EXPECT_THAT(codes(report), ElementsAre(code::kWindowLeft)) << "that is more";
}

/// The first one had no power for a moment, and no frame came by.
TEST(RunDiagnosis, WhatIsMissedWhileSomebodyIsAwayAsksForNoPlaceWhereFramesAreLost) {
  auto report = healthy();
  report.history.lost_frames.note(kStart + 5 * kSecond + 97 * kMillisecond, 97, 0, kStart + 5 * kSecond);
  report.lost_frames = 97;
  miss(report, 1, dc::MissCause::kFrameLost, 97);
  auto unseen = report;
  unseen.history.lost_frames = {};
  EXPECT_THAT(codes(unseen), Contains(code::kMissedByLostFrames)) << "nothing of them excuses it";
  report.history.slaves[1].missed.note(kStart + 5 * kSecond + 97 * kMillisecond, 97);
  EXPECT_THAT(codes(report), Contains(code::kMissedByLostFrames));
  report.history.slaves[0].absences.note(kStart + 5 * kSecond + 97 * kMillisecond, 1);
  EXPECT_THAT(codes(report), Not(Contains(code::kMissedByLostFrames)));
  EXPECT_THAT(codes(report), Contains(code::kSlaveWasAbsent));
  report.history.lost_frames.note(kStart + 15 * kSecond, 3);
  EXPECT_THAT(codes(report), Contains(code::kMissedByLostFrames)) << "and at another time";
}

/// With the answers that said which of them.
TEST(RunDiagnosis, WhatASlaveCountsWhileFramesGetLostIsNoRiddle) {
  auto report = healthy();
  miss(report, 1, dc::MissCause::kFrameLost, 7);
  miss(report, 1, dc::MissCause::kUnknown, 11);
  report.history.slaves[1].missed.note(kStart + 6 * kSecond, 18);
  report.lost_frames = 17;
  report.history.lost_frames.note(kStart + 5'800 * kMillisecond, 17);
  EXPECT_THAT(codes(report), Contains(code::kMissedUnexplained)) << "fewer than it counts";
  report.history.lost_frames.note(kStart + 5'800 * kMillisecond, 30);
  EXPECT_THAT(codes(report), Not(Contains(code::kMissedUnexplained)));
  const auto findings = diagnose(report);
  const auto lost = std::ranges::find(findings, code::kMissedByLostFrames, &Finding::code);
  ASSERT_NE(lost, findings.end());
  EXPECT_THAT(describe(*lost), HasSubstr("missed 18 SM2 events, 18 of them because frames were lost"));
}

}  // namespace
}  // namespace syncline
