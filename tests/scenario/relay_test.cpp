// SPDX-License-Identifier: Apache-2.0
// Between master and bus there is something that delays or loses frames: a switch, a relay, a bad line.
#include <gtest/gtest.h>

#include "app/cli/event_text.h"
#include "channels/command.h"
#include "channels/master_channels.h"
#include "channels/snapshot.h"
#include "link/fault_link.h"
#include "master/master_service.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

struct Through {
  explicit Through(const LinkFaults& faults, DcmMode mode) {
    network.add(test::io8());
    network.add(test::servo(), "servo-y");
    network.add(test::servo(), "servo-y");
    for (std::size_t i = 0; i < 3; ++i) network.sim.slaves[i].oscillator.ppm = 37.0 - 31.0 * static_cast<double>(i);
    network.project.master.dc.dcm.mode = mode;
    network.project.master.dc.sync_window.enabled = true;
    const auto jitter = JitterProfile::quiet();
    clock.set_wakeup_jitter(jitter, faults.seed);
    const auto start = clock.now();
    auto bus = sim::SimBus::create(network.sim, start);
    auto link = make_simulated_link("sim", std::move(*bus), clock, SimulatedHost{jitter.stamp_error, faults.seed});
    MasterService service(std::make_unique<FaultLink>(std::move(link), clock, faults), clock);
    service.channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
    service.run_for(20 * kSecond);
    for (const auto& event : service.channels().events.drain()) log += cli::event_text(event, start) + "\n";
    service.channels().snapshot.read(snapshot);
  }
  VirtualClock clock;
  test::SimulatedNetwork network;
  std::string log;
  Snapshot snapshot;
};

constexpr DcmMode kModes[] = {DcmMode::kBusShift, DcmMode::kMasterShift};

TEST(Relay, EveryReplyLaterByAConstantTimeIsNoObstacle) {
  for (const auto mode : kModes) {
    LinkFaults faults;
    faults.late = 1;
    faults.late_by = 300 * kMicrosecond;
    const Through through(faults, mode);
    EXPECT_EQ(through.snapshot.state, AlState::kOp) << through.log;
    EXPECT_EQ(through.snapshot.dc.state, SyncState::kInSync) << through.log;
    EXPECT_EQ(through.snapshot.dcm.state, SyncState::kInSync) << through.log;
    EXPECT_EQ(through.snapshot.lost_frames, 0U);
  }
}

TEST(Relay, AFrameOfAHundredMayBeLost) {
  for (const auto mode : kModes) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      LinkFaults faults;
      faults.seed = seed;
      (seed % 2 == 0 ? faults.lose_request : faults.lose_reply) = 0.01;
      const Through through(faults, mode);
      EXPECT_EQ(through.snapshot.dc.state, SyncState::kInSync) << seed << "\n" << through.log;
      EXPECT_EQ(through.snapshot.dcm.state, SyncState::kInSync) << seed << "\n" << through.log;
      // What a drive makes of missed SM2 events is the drive's; it has been in OP.
      EXPECT_NE(through.log.find("-> OP"), std::string::npos) << seed << "\n" << through.log;
    }
  }
}

}  // namespace
}  // namespace syncline
