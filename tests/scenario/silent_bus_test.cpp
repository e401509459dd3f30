// SPDX-License-Identifier: Apache-2.0
// Nobody answers for longer than slaves may be silent, and who was the reason.
#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "protocol/al_state.h"
#include "tests/scenario/two_axes_run.h"

namespace syncline {
namespace {

class SilentBus : public test::TwoAxesRun {};

/// No link was lost and nobody was without power: no plug is loose and no supply is weak.
TEST_P(SilentBus, WhoseFramesGetLostAccusesNoSlave) {
  const auto cycle = std::get<1>(GetParam());
  for (const int slave : {-1, 0, 2}) {
    auto run = machine;
    run.fault(FaultKind::kLoseFrames, 8 * kSecond, slave).count =
        static_cast<std::uint32_t>(250 * kMillisecond / cycle);
    run.run(18 * kSecond);
    SCOPED_TRACE("in front of " + std::to_string(slave) + ":\n" + run.said());
    EXPECT_FALSE(run.report.history.slaves.front().absences.empty()) << "it was too short";
    EXPECT_FALSE(run.found(code::kSlaveWasAbsent));
    EXPECT_FALSE(run.found(code::kFramesLostByCable));
    EXPECT_FALSE(run.found(code::kMasterLostLock)) << "of which nobody hears the time";
    // Who had his outputs all the same tells that they passed him.
    EXPECT_EQ(run.found(code::kFramesLostBehind, 1), slave == 2);
    EXPECT_EQ(run.found(code::kFramesLost), slave != 2);
    EXPECT_EQ(run.report.state, AlState::kOp);
    EXPECT_EQ(run.report.dcm.state, SyncState::kInSync);
  }
}

TEST_P(SilentBus, WithoutPowerOrLinkIsAbsent) {
  for (const auto kind : {FaultKind::kSlaveOff, FaultKind::kCableBreak}) {
    for (const auto length : {200 * kMillisecond, kSecond}) {
      auto run = machine;
      run.fault(kind, 8 * kSecond, 0).until = 8 * kSecond + length;
      run.run(18 * kSecond);
      SCOPED_TRACE(std::to_string(length) + " ns:\n" + run.said());
      EXPECT_TRUE(run.found(code::kSlaveWasAbsent, 0));
      EXPECT_FALSE(run.found(code::kFramesLost) || run.found(code::kFramesLostInFront));
    }
  }
}

/// A plug that is loose for less than anybody is missed for: quartzes run apart without the time, and the way of those
/// behind a branch is another one for some cycles. No clock has done anything.
TEST_P(SilentBus, ForAMomentIsThePlug) {
  auto& network = machine.network;
  network.add(test::io8());
  // The first drive alone at port D of the terminal, in front of the others.
  network.sim.slaves[1].parent_port = 3;
  network.project.slaves[1].previous = PreviousPort{0, 3};
  network.sim.slaves[2].parent = 0;
  network.project.slaves[2].previous = PreviousPort{0, 1};
  for (const auto& [slave, milliseconds] : {std::pair{0, 60}, {0, 20}, {1, 3}, {1, 9}}) {
    for (Nanoseconds phase = 0; phase < 4 * kMillisecond; phase += 377 * kMicrosecond) {
      auto run = machine;
      const auto from = 8 * kSecond + phase;
      run.fault(FaultKind::kCableBreak, from, slave).until = from + milliseconds * kMillisecond;
      run.run(14 * kSecond);
      SCOPED_TRACE(std::to_string(slave) + ", " + std::to_string(milliseconds) + " ms:\n" + run.said());
      EXPECT_TRUE(run.found(code::kLinkLost, slave));
      for (const auto code : {code::kWindowLeft, code::kMasterLostLock, code::kMissedByMovedClock})
        EXPECT_FALSE(run.found(code)) << code;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, SilentBus,
                         ::testing::Combine(::testing::Values(DcmMode::kBusShift, DcmMode::kMasterShift),
                                            ::testing::Values(kMillisecond, 4 * kMillisecond)));

}  // namespace
}  // namespace syncline
