// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/cyclic_frame_set.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "protocol/registers.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

/// An ENI may ask for a latch of the receive times in every cycle; the master latches when it measures, not between.
TEST(CyclicFrameSet, LatchesNoReceiveTimesByItself) {
  test::SimulatedNetwork network;
  network.add(test::io8());
  network.project.master.dc.continuous_propagation_compensation = true;
  const auto config = network.compiled();
  const auto& commands = config.cyclic.at(0).frames.at(0).commands;
  ASSERT_TRUE(std::ranges::any_of(commands, [](const CyclicCmd& command) {
    return command.command == Command::kBwr && command.ado == reg::kReceiveTimePort0;
  }));
  CyclicFrameSet set(config);
  set.select(AlState::kOp);
  set.prepare(0, true);
  std::size_t seen = 0;
  for (const auto* frame : set.frames()) {
    for (const auto* datagram : frame->datagrams()) {
      EXPECT_NE(datagram->command, Command::kBwr);
      ++seen;
    }
  }
  EXPECT_GE(seen, commands.size());
}

}  // namespace
}  // namespace syncline
