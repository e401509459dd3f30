// SPDX-License-Identifier: Apache-2.0
// The two overrides of the distributed clocks: the first slave leads, and all slaves take part.
#include <gtest/gtest.h>

#include "compile/compile.h"
#include "tests/support/sample_devices.h"

namespace syncline {
namespace {

/// Terminals with a clock, but for the first; none has a DC operation mode.
Project clocks_unused() {
  Project project;
  for (std::uint16_t i = 0; i < 4; ++i) {
    auto device = sample::digital_output();
    device.dc.reset();
    if (i > 0) device.dc.emplace().op_modes = {{"DC", "", 0x0300, {0, 1}, {}, {}, {}, {}}};
    project.slaves.push_back(default_slave(device, i));
    project.slaves.back().dc.op_mode.clear();
    if (i > 0) project.slaves.back().previous = PreviousPort{static_cast<std::uint16_t>(i - 1), 1};
  }
  return project;
}

bool distributes_time(const NetworkConfig& config, std::uint16_t position) {
  for (const auto& frame : config.cyclic.front().frames) {
    for (const auto& command : frame.commands) {
      if (command.command == Command::kArmw && command.ado == 0x0910)
        return command.adp == static_cast<std::uint16_t>(-position);
    }
  }
  return false;
}

TEST(DcOverride, AllSlavesTakePartWithoutAnOperationMode) {
  auto project = clocks_unused();
  auto without = compile(project);
  ASSERT_TRUE(without);
  EXPECT_FALSE(without->config.dc.enabled);
  project.master.dc.all_slaves = true;
  auto with = compile(project);
  ASSERT_TRUE(with);
  EXPECT_TRUE(with->config.dc.enabled);
  EXPECT_EQ(with->config.reference_clock(), 1);
  EXPECT_FALSE(with->config.slaves[0].dc);
  for (std::size_t i = 1; i < 4; ++i) {
    ASSERT_TRUE(with->config.slaves[i].dc);
    EXPECT_EQ(with->config.slaves[i].dc->assign_activate, 0);  // its clock is set, SYNC signals stay off
  }
  EXPECT_TRUE(distributes_time(with->config, 1));
}

TEST(DcOverride, FirstSlaveLeadsWhateverIsChosen) {
  auto project = clocks_unused();
  for (std::size_t i = 1; i < 4; ++i) project.slaves[i].dc.op_mode = "DC";
  project.master.dc.reference_clock = 3;
  auto chosen = compile(project);
  ASSERT_TRUE(chosen);
  EXPECT_EQ(chosen->config.reference_clock(), 3);
  project.master.dc.first_slave_is_reference_clock = true;
  auto first = compile(project);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->config.reference_clock(), 1);
  EXPECT_TRUE(distributes_time(first->config, 1));
}

}  // namespace
}  // namespace syncline
