// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>

#include "support/random.h"
#include "tests/scenario/machine_run.h"
#include "tests/support/cases.h"
#include "tests/support/own_devices.h"
#include "tests/support/small_machines.h"

namespace syncline {
namespace {

/// A slave goes away while the bus is brought up: as when it is lost in OP, the others go on, and it is brought back.
class LostAtStart : public test::MachineRun {
 protected:
  void make(std::uint64_t seed, DcmMode mode = DcmMode::kBusShift) {
    network = {};
    network.add(test::io8());
    network.add(test::servo(), "servo-y");
    network.add(test::io8());
    network.add(test::servo(), "servo-y");
    Random random(seed);
    test::give_random_clocks(network, random);
    network.sim.host_jitter = JitterProfile::quiet();
    network.project.master.dc.sync_window.enabled = true;
    network.project.master.dc.dcm.mode = mode;
    // The host's jitter reaches the reference clock as it is.
    if (mode == DcmMode::kMasterRefClock) network.project.master.dc.sync_window.exponent = 9;
  }
};

TEST_F(LostAtStart, OthersReachOpWithoutIt) {
  make(1);
  // Until long after the start: pulled in PREOP.
  fault(FaultKind::kCableBreak, 3, 3500 * kMillisecond, 30 * kSecond);
  go_online();
  EXPECT_EQ(count(kind_of<events::SlaveLost>), 1U) << log();
  EXPECT_EQ(count(kind_of<events::Failure>), 0U) << "the lost slave is told as that: " << log();
  EXPECT_EQ(count(kind_of<events::Online>), 1U) << log();
  for (int slave = 0; slave < 3; ++slave) EXPECT_EQ(snapshot.slaves[slave].al_status, 8) << slave << "\n" << log();
  EXPECT_EQ(snapshot.state, AlState::kNone) << "nobody knows what the lost one is in";
  run_until(10 * kSecond);
  for (int slave = 0; slave < 3; ++slave) EXPECT_EQ(snapshot.slaves[slave].al_status, 8) << slave << "\n" << log();
  EXPECT_EQ(snapshot.wkc_errors, 0U) << log();
}

/// While others are sent objects it has nothing to do; what it is asked behind that it does not get.
TEST_F(LostAtStart, ATerminalThatWaitsForDrivesIsLostAsOthersAre) {
  for (auto begin = 1200 * kMillisecond; begin < 3200 * kMillisecond; begin += 40 * kMillisecond) {
    make(5, DcmMode::kMasterShift);
    network.add(sample::own("SL-1100"));  // has no SyncManagers to be set, but is asked for its state
    network.add(test::io8());
    fault(FaultKind::kSlowMailbox, 1, 0, 30 * kSecond);
    network.sim.faults.back().value_ns = 30 * kMillisecond;
    fault(FaultKind::kSlaveOff, 4, begin, begin + 2500 * kMillisecond);
    go_online();
    run_until(begin + 14 * kSecond);
    EXPECT_EQ(snapshot.state, AlState::kOp) << begin << "\n" << log();
    EXPECT_EQ(count(kind_of<events::Failure>), 0U) << begin << "\n" << log();
  }
}

/// SYNCLINE_OUTAGES=n tries n moments and lengths.
TEST_F(LostAtStart, AllAreInOpInTheEndWhoeverGoesWhenForHowLong) {
  const char* wish = std::getenv("SYNCLINE_OUTAGES");
  const int tries = wish != nullptr ? std::atoi(wish) : test::cases(60);
  constexpr std::array kModes{DcmMode::kBusShift, DcmMode::kMasterShift, DcmMode::kMasterRefClock,
                              DcmMode::kLinkLayerRefClock};
  Random random(7);
  for (int i = 1; i <= tries; ++i) {
    const auto mode = kModes[static_cast<std::size_t>(i) % kModes.size()];
    make(static_cast<std::uint64_t>(i), mode);
    const auto kind = random.uniform() < 0.5 ? FaultKind::kCableBreak : FaultKind::kSlaveOff;
    const auto slave = static_cast<int>(random.uniform(0, 4));
    // From when there is a cycle until all have been in OP for a while.
    const auto begin = static_cast<Nanoseconds>(1.2e9 + 3e9 * random.uniform());
    const auto length = static_cast<Nanoseconds>(1e8 * std::pow(30.0, random.uniform()));
    fault(kind, slave, begin, begin + length);
    go_online();
    run_until(begin + length + 12 * kSecond);
    const auto name = fmt::format("case {}, {}: {} of slave {} at {} ms for {} ms\n", i, dcm_mode_name(mode),
                                  kind == FaultKind::kCableBreak ? "cable" : "power", slave, begin / kMillisecond,
                                  length / kMillisecond);
    EXPECT_EQ(snapshot.state, AlState::kOp) << name << log();
    EXPECT_EQ(snapshot.dc.state, SyncState::kInSync) << name << log();
  }
}

}  // namespace
}  // namespace syncline
