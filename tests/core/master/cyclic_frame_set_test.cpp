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

/// An ENI's image may begin with bytes that no command has.
TEST(CyclicFrameSet, MarksWhatIsKnownWhereItStandsInTheImage) {
  test::SimulatedNetwork network;
  for (int i = 0; i < 2; ++i) network.add(test::io8());
  auto config = network.compiled();
  constexpr std::uint32_t kOffset = 16;
  config.image.command_data_offset = kOffset;
  config.image.input_bytes += kOffset;
  config.image.output_bytes += kOffset;
  CyclicFrameSet set(config);
  set.select(AlState::kOp);
  set.prepare(0, true);
  std::vector<std::uint8_t> known(set.inputs().size());
  set.mark_known_inputs(known);
  EXPECT_EQ(std::ranges::count(known, 0), static_cast<std::ptrdiff_t>(known.size()));
  const auto& commands = config.cyclic.at(0).frames.at(0).commands;
  const auto process_data = std::ranges::find(commands, Command::kLrw, &CyclicCmd::command);
  ASSERT_NE(process_data, commands.end());
  for (auto* frame : set.frames()) {
    for (auto* datagram : frame->datagrams()) {
      datagram->answered = true;
      datagram->wkc = process_data->expected_wkc.value_or(0);
    }
  }
  (void)set.evaluate();
  set.mark_known_inputs(known);
  const auto begin = std::ranges::find(known, 0xFF);
  EXPECT_EQ(begin - known.begin(), static_cast<std::ptrdiff_t>(kOffset));
}

/// Of two slaves with a frame each; and where an ENI's offsets lead to no command it may be any of them.
TEST(CyclicFrameSet, KnowsWhoseOutputsCameBack) {
  test::SimulatedNetwork network;
  for (int i = 0; i < 3; ++i) network.add(test::large_io());
  auto config = network.compiled();
  ASSERT_EQ(config.cyclic.at(0).frames.size(), 3U);
  config.slaves[2].send->bit_start = 1U << 20;
  CyclicFrameSet set(config);
  set.select(AlState::kOp);
  set.prepare(0, true);
  const auto answer = [&](std::size_t frame) {
    for (auto* datagram : set.frames()[frame]->datagrams()) datagram->answered = true;
  };
  answer(0);
  answer(2);
  EXPECT_TRUE(set.brought_outputs(0));
  EXPECT_FALSE(set.brought_outputs(1));
  EXPECT_FALSE(set.brought_outputs(2));
  answer(1);
  EXPECT_TRUE(set.brought_outputs(1));
}

/// Of three slaves with a frame each, the last of which goes with every second cycle.
TEST(CyclicFrameSet, KnowsTheFrameOfASlave) {
  test::SimulatedNetwork network;
  for (int i = 0; i < 3; ++i) network.add(test::large_io());
  auto& project = network.project;
  project.master.tasks.push_back({.name = "slow", .multiple = 2});
  project.master.sync_units.push_back({.name = "slow", .task = "slow"});
  project.slaves[2].output_unit = project.slaves[2].input_unit = "slow";
  project.slaves[2].dc.op_mode.clear();
  const auto config = network.compiled();
  CyclicFrameSet set(config);
  set.select(AlState::kOp);
  for (int slot = 0; slot < 4; ++slot) {
    set.prepare(slot, true);
    const auto frames = set.frames();
    ASSERT_EQ(frames.size(), slot % 2 == 0 ? 3U : 2U);
    for (const bool outputs : {true, false}) {
      EXPECT_EQ(set.frame_with(outputs, 0), frames[0]);
      EXPECT_EQ(set.frame_with(outputs, 1), frames[1]);
      EXPECT_EQ(set.frame_with(outputs, 2), slot % 2 == 0 ? frames[2] : nullptr);
    }
  }
}

}  // namespace
}  // namespace syncline
