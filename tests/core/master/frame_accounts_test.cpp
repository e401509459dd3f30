// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "link/fault_link.h"
#include "master/master_service.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

/// A line of terminals behind a link that loses and delays answers while the bus is in OP.
class FrameAccounts : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  VirtualClock clock;
  FaultLink* link = nullptr;
  std::unique_ptr<MasterService> service;
  Snapshot snapshot;
  std::int64_t told_lost = 0, told_late = 0, taken_back = 0;

  void SetUp() override {
    test::SimulatedNetwork network;
    for (int i = 0; i < 3; ++i) network.add(test::io8());
    auto faulty = std::make_unique<FaultLink>(network.link(clock), clock, LinkFaults{});
    link = faulty.get();
    service = std::make_unique<MasterService>(std::move(faulty), clock);
    service->channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
    (void)service->step();
    run(kSecond);
    ASSERT_EQ(snapshot.state, AlState::kOp);
    ASSERT_EQ(snapshot.lost_frames, 0U);
  }
  void run(Nanoseconds duration) {
    service->run_for(duration);
    for (const auto& event : service->channels().events.drain()) {
      if (event.kind == EventKind::kFramesLost) told_lost += event.a;
      if (event.kind == EventKind::kFramesLate) told_late += event.a, taken_back += event.c;
    }
    service->channels().snapshot.read(snapshot);
  }
  /// Then nothing is under way any more, and all has been told.
  void finish() {
    link->set_faults({});
    run(6 * kSecond);
  }
};

TEST_P(FrameAccounts, AreTrueToTheFrame) {
  link->set_faults(
      {.lose_request = 0.01, .lose_reply = 0.02, .late = 0.03, .late_by = 3 * kMillisecond, .seed = GetParam()});
  run(3 * kSecond);
  finish();
  const auto& injected = link->injected();
  EXPECT_GT(injected.lost, 20U);
  EXPECT_GT(injected.late, 20U);
  EXPECT_EQ(snapshot.lost_frames, injected.lost);
  EXPECT_EQ(snapshot.late_frames, injected.late);
  EXPECT_EQ(told_late, static_cast<std::int64_t>(injected.late));
  EXPECT_EQ(told_lost - taken_back, static_cast<std::int64_t>(injected.lost));
}

TEST_P(FrameAccounts, AreTrueAfterAStandstillOfTheWire) {
  // Longer than the patience with frames that say nothing, shorter than their indices rest.
  link->set_faults({.late = 1, .late_by = 80 * kMillisecond, .seed = GetParam()});
  run(200 * kMillisecond);
  finish();
  EXPECT_EQ(snapshot.lost_frames, 0U);
  EXPECT_EQ(snapshot.late_frames, link->injected().late);
  EXPECT_EQ(told_late, static_cast<std::int64_t>(snapshot.late_frames));
  EXPECT_EQ(told_lost, taken_back);
  EXPECT_GT(taken_back, 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, FrameAccounts, ::testing::Values(1, 2, 3));

}  // namespace
}  // namespace syncline
