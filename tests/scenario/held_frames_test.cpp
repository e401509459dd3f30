// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <tuple>

#include "tests/scenario/two_axes_run.h"
#include "tests/support/diagnosed_run.h"
#include "tests/support/machine_devices.h"
#include "tests/support/small_machines.h"

namespace syncline {
namespace {

class HeldFrames : public ::testing::TestWithParam<DcmMode> {
 protected:
  test::DiagnosedRun machine;
  void SetUp() override {
    test::add_two_axes(machine.network);
    machine.network.project.master.dc.dcm.mode = GetParam();
    machine.network.project.master.dc.sync_window.enabled = true;
  }
};

/// One frame, 1 ms cycle, outputs some 650 us before SYNC0.
TEST_P(HeldFrames, AreTheCauseOfWhatTheyDo) {
  for (const int us : {100, 300, 600, 1300, 3000}) {
    auto run = machine;
    run.hold_frames(5 * kSecond, 5 * kSecond + kMillisecond, us * kMicrosecond);
    run.run(12 * kSecond);
    SCOPED_TRACE(std::to_string(us) + " us:\n" + run.said());
    EXPECT_EQ(run.report.lost_frames, 0U);
    EXPECT_EQ(run.report.late_frames > 0, us > 1000);
    for (const int axis : {1, 2}) {
      const auto& missed = *run.report.slaves.at(static_cast<std::size_t>(axis)).sm2_missed;
      EXPECT_EQ(missed.missed > 0, us >= 600);
      EXPECT_EQ(missed.by_cause[static_cast<std::size_t>(dc::MissCause::kFrameHeldUp)], missed.missed);
      EXPECT_EQ(run.found(code::kMissedByHeldFrames, axis), us == 600 || us == 1300);
      EXPECT_EQ(run.found(code::kSlaveFellByMisses, axis), us == 3000);
      // One cause, and one advice.
      EXPECT_FALSE(run.found(code::kShiftTooShort, axis));
    }
    // Only where the reference clock is written does an old time move anybody, and no clock stepped.
    EXPECT_EQ(run.found(code::kReferenceWrittenLate), us > 1000 && GetParam() == DcmMode::kBusShift);
    EXPECT_FALSE(run.found(code::kWindowLeft));
    EXPECT_FALSE(run.found(code::kMasterLostLock));
    EXPECT_EQ(run.accuses(), us >= 600);
  }
}

/// What is late alike in many frames one behind the other is no clock that has stepped, and nobody runs after it.
TEST_P(HeldFrames, ManyInARowAccuseNoClock) {
  for (const int frames : {2, 4, 8, 20, 50}) {
    for (const int us : {30, 100, 300, 600}) {
      auto run = machine;
      run.hold_frames(5 * kSecond, 5 * kSecond + frames * kMillisecond, us * kMicrosecond);
      run.run(12 * kSecond);
      SCOPED_TRACE(std::to_string(frames) + " frames, " + std::to_string(us) + " us:\n" + run.said());
      EXPECT_FALSE(run.found(code::kMasterLostLock));
      EXPECT_FALSE(run.found(code::kWindowLeft));
      for (const int axis : {1, 2}) {
        EXPECT_FALSE(run.found(code::kMissedByMovedClock, axis));
        EXPECT_EQ(run.found(code::kMissedByHeldFrames, axis), us == 600);
      }
      // In bus shift an old time moves the clock that it is written to.
      EXPECT_EQ(run.found(code::kReferenceWrittenLate), us > 100 && GetParam() == DcmMode::kBusShift);
    }
  }
}

/// So much before SYNC0 that a drive may or may not get them in time.
TEST_P(HeldFrames, ThatLeaveHardlyAnyTimeAskForNoOtherShift) {
  for (const int us : {560, 580, 600, 620, 640}) {
    for (const int frames : {1, 12}) {
      auto run = machine;
      run.hold_frames(5 * kSecond, 5 * kSecond + frames * kMillisecond, us * kMicrosecond);
      run.run(12 * kSecond);
      SCOPED_TRACE(std::to_string(frames) + " frames, " + std::to_string(us) + " us:\n" + run.said());
      for (const int axis : {1, 2}) {
        const auto& slave = run.report.slaves.at(static_cast<std::size_t>(axis));
        EXPECT_FALSE(run.found(code::kShiftTooShort, axis));
        EXPECT_EQ(run.found(code::kMissedByHeldFrames, axis),
                  slave.sm2_missed->missed > 0 || slave.evidence.outputs.shift_too_short.total > 0);
      }
    }
  }
}

/// Nothing came back for longer than slaves may be silent, and then all of it: nobody was away, no plug is loose.
TEST_P(HeldFrames, OfAllSlavesAreNoAbsence) {
  for (const bool coming_back : {false, true}) {
    auto run = machine;
    constexpr auto kLong = 108 * kMillisecond;
    run.hold_frames(5 * kSecond, 5 * kSecond + kLong, kLong, coming_back);
    run.run(12 * kSecond);
    SCOPED_TRACE(run.said());
    EXPECT_EQ(run.report.lost_frames, 0U);
    EXPECT_FALSE(run.report.history.slaves.front().absences.empty());
    EXPECT_FALSE(run.found(code::kSlaveWasAbsent));
    EXPECT_TRUE(run.found(code::kFramesLate));
    EXPECT_FALSE(run.found(code::kMasterLostLock));
    for (const int axis : {1, 2}) {
      // Outputs that come in time serve the drive, whatever becomes of its answer; without them it falls, and whoever
      // did not answer is led up again.
      const auto& slave = run.report.slaves.at(static_cast<std::size_t>(axis));
      EXPECT_EQ(al_state_of(slave.al_status), AlState::kOp);
      EXPECT_EQ(run.found(code::kSlaveHadFallen, axis), !coming_back);
      if (!coming_back) continue;
      EXPECT_EQ(slave.sm2_missed->missed, 0U);
      EXPECT_EQ(slave.sm2_missed->integrator_highest, 0U);
      EXPECT_FALSE(run.found(code::kMissedByHeldFrames, axis));
    }
  }
}

/// Nobody monitors the slaves, and nobody's clock has stepped.
TEST(HeldFramesUnmonitored, AccuseNoClock) {
  test::DiagnosedRun run;
  test::add_two_axes(run.network);
  run.hold_frames(5 * kSecond, 5 * kSecond + kMillisecond, 1300 * kMicrosecond);
  run.run(12 * kSecond);
  EXPECT_TRUE(run.found(code::kReferenceWrittenLate)) << run.said();
  EXPECT_FALSE(run.found(code::kSlaveClockOff)) << run.said();
}

INSTANTIATE_TEST_SUITE_P(Modes, HeldFrames, ::testing::Values(DcmMode::kBusShift, DcmMode::kMasterShift));

/// In every cycle and in the modes that move the host, or the reference clock with or without its error in mind.
class HeldSeries : public test::TwoAxesRun {};

TEST_P(HeldSeries, IsTheCauseOfWhatItDoesToTheClocks) {
  const auto [mode, cycle] = GetParam();
  for (const bool coming_back : {false, true}) {
    for (const int frames : {1, 3, 10, 200}) {
      for (const int us : {30, 200, 450}) {
        // Of a cycle of 500 us all come too late for a tenth of a second, and on which way they were held up nobody
        // sees.
        if (coming_back && cycle == 500 * kMicrosecond && us == 450 && frames == 200) continue;
        auto run = machine;
        run.hold_frames(5 * kSecond, 5 * kSecond + frames * cycle, us * kMicrosecond, coming_back);
        run.run(12 * kSecond);
        SCOPED_TRACE(std::to_string(frames) + " frames, " + std::to_string(us) + " us, " +
                     (coming_back ? "coming back:\n" : "on their way out:\n") + run.said());
        EXPECT_TRUE(run.report.dcm.state == SyncState::kInSync && run.report.dc.state == SyncState::kInSync);
        for (const auto code : {code::kMasterLostLock, code::kWindowLeft, code::kMissedByMovedClock, code::kDcmError})
          EXPECT_FALSE(run.found(code)) << code;
        EXPECT_FALSE((coming_back || mode == DcmMode::kMasterShift) && run.found(code::kReferenceWrittenLate));
      }
    }
  }
}

/// Nor has the external clock gone anywhere.
TEST(HeldFramesInDcx, AreWhatTookTheReferenceClockAway) {
  for (const int frames : {1, 3, 31}) {
    test::DiagnosedRun run;
    test::add_two_axes(run.network);
    run.network.add(test::bridge(), "sync-bridge");
    run.network.sim.slaves.back().external_time = [](Nanoseconds time) { return std::optional(time); };
    auto& master = run.network.project.master;
    master.cycle_time = 2 * kMillisecond;
    master.dc.dcm.mode = DcmMode::kDcx;
    master.dc.sync_window.enabled = true;
    // With a frame what is written behind it in the same cycle, which would take it back.
    const auto begin = 60 * kSecond + master.cycle_time / 2;
    run.hold_frames(begin, begin + frames * master.cycle_time, 480 * kMicrosecond);
    run.run(80 * kSecond);
    SCOPED_TRACE(std::to_string(frames) + " frames:\n" + run.said());
    EXPECT_TRUE(run.found(code::kReferenceWrittenLate));
    for (const auto code : {code::kExternalClockLeft, code::kMasterLostLock, code::kWindowLeft})
      EXPECT_FALSE(run.found(code)) << code;
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, HeldSeries,
                         ::testing::Combine(::testing::Values(DcmMode::kBusShift, DcmMode::kMasterShift,
                                                              DcmMode::kMasterRefClock),
                                            ::testing::Values(500 * kMicrosecond, kMillisecond, 4 * kMillisecond)));

}  // namespace
}  // namespace syncline
