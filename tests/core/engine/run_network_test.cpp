// SPDX-License-Identifier: Apache-2.0
#include "engine/run_network.h"

#include <gtest/gtest.h>

#include "engine/opened_link.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

/// A bring-up on the virtual clock is one step of the master, in which nobody else could take what it measures.
TEST(RunNetwork, KeepsEachCycleOfALongBringUp) {
  test::SimulatedNetwork network;
  network.add(test::io8());
  network.add(test::io8());
  network.project.master.cycle_time = 250 * kMicrosecond;
  network.project.master.dc.dcm.start_delay_ms = 20'000;
  OpenedLink opened;
  opened.clock = std::make_unique<VirtualClock>();
  opened.link = network.link(*opened.clock);
  ASSERT_TRUE(opened.link);
  std::uint64_t next = 0, gaps = 0;
  RunRequest request;
  request.duration = 22 * kSecond;
  request.on_samples = [&](std::span<const CycleSample> samples) {
    for (const auto& sample : samples) {
      gaps += sample.cycle != next ? 1 : 0;
      next = sample.cycle + 1;
    }
  };
  const auto outcome = run_network(network.compiled(), std::move(opened), request);
  ASSERT_TRUE(outcome);
  EXPECT_FALSE(outcome->error);
  EXPECT_EQ(outcome->report.state, AlState::kOp);
  EXPECT_GT(next, 20'000U * 4);
  EXPECT_EQ(next, outcome->report.cycles);
  EXPECT_EQ(gaps, 0U);
}

}  // namespace
}  // namespace syncline
