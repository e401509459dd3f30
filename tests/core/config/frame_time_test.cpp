// SPDX-License-Identifier: Apache-2.0
#include "config/frame_time.h"

#include <gtest/gtest.h>

#include "config/cyclic_frame.h"
#include "config/network_config.h"
#include "config/process_image.h"
#include "protocol/command.h"

namespace syncline {
namespace {

CyclicFrame frame_of(std::uint16_t bytes) {
  CyclicCmd cmd;
  cmd.command = Command::kLrw;
  cmd.data_length = bytes;
  CyclicFrame frame;
  frame.commands = {cmd};
  return frame;
}

TEST(FrameTime, ACycleNeedsItsFramesAndTheWayThroughAllSlaves) {
  NetworkConfig config;
  config.slaves.resize(1000);
  config.cyclic.resize(2);
  config.cyclic[0].frames = {frame_of(1486), frame_of(4)};
  config.cyclic[1].frames = {frame_of(100)};
  const auto base = cycle_need(config);
  EXPECT_EQ(base.wire, 123'040 + 6'720);
  EXPECT_EQ(base.travel, 1'000'000);
  EXPECT_EQ(base.all(), base.wire + base.travel);
  EXPECT_EQ(cycle_need(config, true).wire, base.wire + wire_time(frame_of(100)));
}

TEST(FrameTime, ASlaveHasItsOutputsWhenTheirFrameHasPassed) {
  NetworkConfig config;
  config.slaves.resize(4);
  config.cyclic.resize(1);
  auto second = frame_of(4);
  second.commands[0].output_offset = 1486;
  config.cyclic[0].frames = {frame_of(1486), second};
  config.slaves[0].send = ImageRange{0, 16};
  config.slaves[1].send = ImageRange{1486 * 8, 32};
  config.slaves[2].send = ImageRange{1485 * 8, 16};
  EXPECT_EQ(outputs_wire_time(config, 0), 123'040);
  EXPECT_EQ(outputs_wire_time(config, 1), 123'040 + 6'720);
  EXPECT_EQ(outputs_wire_time(config, 2), 123'040 + 6'720) << "in both";
  EXPECT_EQ(outputs_wire_time(config, 3), 0) << "has none";
}

TEST(FrameTime, TheWayThroughASlaveIsShorterAtEBus) {
  NetworkConfig config;
  config.slaves.resize(5);
  config.slaves[0].physics = "YKY";  // a coupler, reached over a cable
  config.slaves[1].physics = config.slaves[2].physics = "KK";
  config.slaves[3].physics = "YY";
  EXPECT_EQ(travel_time(config), 3 * kMicrosecond + 2 * 300) << "the last one does not say";
}

TEST(FrameTime, WithoutFramesNothingIsUnderWay) {
  NetworkConfig config;
  config.slaves.resize(3);
  EXPECT_EQ(cycle_need(config).all(), 0);
}

}  // namespace
}  // namespace syncline
