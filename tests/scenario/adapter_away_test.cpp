// SPDX-License-Identifier: Apache-2.0
// The master's own network adapter is switched off or unplugged for a while, and the bus comes back with it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "protocol/al_state.h"
#include "support/random.h"
#include "tests/support/diagnosed_run.h"
#include "tests/support/small_machines.h"

namespace syncline {
namespace {

constexpr auto kDown = kind_of<events::LinkDown>, kUp = kind_of<events::LinkUp>;

class AdapterAway : public ::testing::Test {
 protected:
  test::DiagnosedRun machine;
  void SetUp() override { test::add_two_axes(machine.network); }
  [[nodiscard]] std::vector<EventKind> link_events() const {
    std::vector<EventKind> all;
    for (const auto& event : machine.events) {
      const auto kind = event.kind();
      if (kind == kDown || kind == kUp || kind == kind_of<events::BringUpAgain>) all.push_back(kind);
    }
    return all;
  }
  [[nodiscard]] const Finding* finding(std::string_view code) const {
    const auto found = std::ranges::find(machine.findings, code, &Finding::code);
    return found == machine.findings.end() ? nullptr : &*found;
  }
};

TEST_F(AdapterAway, ForASecondIsToldAndTheBusComesBackToOp) {
  machine.adapter_off(6 * kSecond, 7 * kSecond);
  machine.run(20 * kSecond);
  EXPECT_EQ(machine.report.state, AlState::kOp) << machine.said();
  EXPECT_THAT(link_events(), testing::ElementsAre(kDown, kUp));
  ASSERT_NE(finding(code::kAdapterWasAway), nullptr) << machine.said();
  EXPECT_THAT(describe(*finding(code::kAdapterWasAway)), testing::HasSubstr("for 1 s"));
  // One cause, told once: no slave and no cable is accused of it.
  for (const auto code : {code::kSlaveWasAbsent, code::kSlaveAbsent, code::kSlaveAbsentBehindCable, code::kFramesLost,
                          code::kOutputsWatchdog}) {
    EXPECT_FALSE(machine.found(code)) << machine.said();
  }
}

TEST_F(AdapterAway, WhenItStaysAwayThatIsWhatIsWrong) {
  machine.adapter_off(6 * kSecond, 100 * kSecond);
  machine.run(9 * kSecond);
  EXPECT_THAT(link_events(), testing::ElementsAre(kDown));
  ASSERT_NE(finding(code::kAdapterAway), nullptr) << machine.said();
  EXPECT_EQ(finding(code::kAdapterAway)->severity, Severity::kError);
  EXPECT_FALSE(machine.found(code::kSlaveAbsent)) << machine.said();
}

TEST_F(AdapterAway, AgainAndAgainForAsLongAsItLikes) {
  Random random(3);
  for (Nanoseconds at = 6 * kSecond; at < 60 * kSecond;) {
    const auto length = static_cast<Nanoseconds>(1 + random.next() % 30) * 100 * kMillisecond;
    machine.adapter_off(at, at + length);
    at += length + 10 * kSecond;
  }
  machine.run(75 * kSecond);
  EXPECT_EQ(machine.report.state, AlState::kOp) << machine.said();
  EXPECT_EQ(link_events().size(), 2 * machine.network.sim.faults.size());
}

/// Away once while the bus is brought up, with other clocks at another time for each seed.
void run_away_during_bring_up(test::DiagnosedRun& machine, std::uint64_t seed) {
  Random random(seed);
  test::add_two_axes(machine.network);
  test::give_random_clocks(machine.network, random);
  machine.network.project.master.dc.sync_window.enabled = true;
  const auto from = static_cast<Nanoseconds>(random.uniform(0, 4e9));
  const auto length = static_cast<Nanoseconds>(random.uniform(20e6, 2e9));
  machine.adapter_off(from, from + length);
  machine.run(14 * kSecond);
}

/// Frames that were under way then come back late, and the slaves leave the window meanwhile: by the adapter.
TEST(AdapterAwayDuringBringUp, IsNoFrameThatWasHeldUp) {
  test::DiagnosedRun machine;
  run_away_during_bring_up(machine, 1956937);
  EXPECT_FALSE(machine.report.history.slave_losses.empty()) << "nobody left the window: it says nothing";
  EXPECT_TRUE(machine.found(code::kAdapterWasAway)) << machine.said();
  EXPECT_FALSE(machine.found(code::kReferenceWrittenLate)) << machine.said();
}

/// What was begun of a bring-up is begun again, whatever it was.
TEST(AdapterAwayProperty, AtAnyTimeOfTheBringUpTheBusReachesOpAndNobodyIsAccused) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    test::DiagnosedRun machine;
    run_away_during_bring_up(machine, seed);
    const auto& away = machine.network.sim.faults.front();
    RC_LOG() << "away from " << away.at << " to " << away.until << "\n" << machine.said();
    RC_ASSERT(machine.report.state == AlState::kOp);
    RC_ASSERT(machine.report.dc.state == SyncState::kInSync);
    RC_ASSERT(machine.report.dcm.state == SyncState::kInSync);
    for (const auto& finding : machine.findings) {
      RC_ASSERT(finding.severity == Severity::kNote || finding.code == code::kAdapterWasAway);
    }
  }));
}

/// Too short for anybody to be missed, long enough for drives to fall.
TEST(AdapterAwayProperty, DrivesThatFellForAMomentWithoutAdapterComeBack) {
  for (const auto length : {10, 15, 21, 30, 45}) {
    test::DiagnosedRun machine;
    test::add_two_axes(machine.network);
    machine.adapter_off(6 * kSecond, 6 * kSecond + length * kMillisecond);
    machine.run(12 * kSecond);
    EXPECT_EQ(machine.report.state, AlState::kOp) << length << " ms\n" << machine.said();
    EXPECT_FALSE(machine.found(code::kSlaveFellByMisses)) << machine.said();
  }
}

/// A frame that lay in the card while it was away is no late one of the card.
TEST(AdapterAwayProperty, FramesOfAnOutageAccuseNotTheWayThroughTheCard) {
  std::uint64_t late = 0;
  // Whether one lies there when it goes away is a matter of microseconds.
  for (Nanoseconds phase = 0; phase < kMillisecond; phase += 20 * kMicrosecond) {
    Random random(412275854916);
    test::DiagnosedRun machine;
    test::add_two_axes(machine.network);
    test::give_random_clocks(machine.network, random);
    machine.network.project.master.dc.sync_window.enabled = true;
    // The host comes too late to take it before.
    const auto from = 6'000'000'000 + phase;
    machine.fault(FaultKind::kHostStall, from - 100 * kMicrosecond).value_ns = 150 * kMicrosecond;
    machine.adapter_off(from, 6'300'000'000);
    machine.run(8 * kSecond);
    late += machine.report.late_frames;
    EXPECT_FALSE(machine.found(code::kFramesLate)) << machine.said();
  }
  EXPECT_GT(late, 0U) << "some are to have one";
}

TEST_F(AdapterAway, InTheMiddleOfABringUpThatIsToldAndBegunAgain) {
  machine.adapter_off(200 * kMillisecond, 900 * kMillisecond);
  machine.run(12 * kSecond);
  EXPECT_EQ(machine.report.state, AlState::kOp) << machine.said();
  EXPECT_THAT(link_events(), testing::ElementsAre(kDown, kUp, kind_of<events::BringUpAgain>));
  EXPECT_TRUE(machine.found(code::kAdapterWasAway)) << machine.said();
}

TEST_F(AdapterAway, WhenTheBusIsSoughtItIsWaitedForToo) {
  machine.adapter_off(0, 900 * kMillisecond);
  machine.run(15 * kSecond);
  EXPECT_EQ(machine.report.state, AlState::kOp) << machine.said();
}

}  // namespace
}  // namespace syncline
