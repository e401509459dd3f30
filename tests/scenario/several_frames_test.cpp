// SPDX-License-Identifier: Apache-2.0
// A cycle of more than one frame: what becomes of one of them is nothing to the slaves of the others.
#include <gtest/gtest.h>

#include <span>

#include "config/project.h"
#include "tests/support/diagnosed_run.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

TEST(SeveralFrames, OneThatIsLostIsNoMissOfSlavesOfTheOther) {
  for (const int lost : {0, 1}) {
    test::DiagnosedRun run;
    for (int i = 0; i < 2; ++i) run.network.add(test::large_io());
    run.network.project.master.dc.sync_window.enabled = true;
    ASSERT_EQ(run.network.compiled().cyclic.front().frames.size(), 2U);
    // One of the two in every thousandth cycle, once the machine is up.
    constexpr std::size_t kLarge = 800;
    unsigned frames = 0, losses = 0;
    run.loses = [&](std::span<const std::uint8_t> frame) {
      if (frame.size() < kLarge) return false;
      const auto cycle = frames / 2, which = frames++ % 2;
      if (cycle < 5'000 || cycle % 1'000 != 0 || which != static_cast<unsigned>(lost)) return false;
      ++losses;
      return true;
    };
    run.run(15 * kSecond);
    ASSERT_GT(losses, 3U);
    for (const int slave : {0, 1}) {
      const auto& missed = run.report.slaves[static_cast<std::size_t>(slave)].sm2_missed;
      ASSERT_TRUE(missed);
      EXPECT_EQ(missed->missed, slave == lost ? losses : 0U) << "slave " << slave << "\n" << run.said();
    }
    EXPECT_TRUE(run.found(code::kFramesLost)) << run.said();
    EXPECT_FALSE(run.found(code::kMissedUnexplained)) << run.said();
  }
}

}  // namespace
}  // namespace syncline
