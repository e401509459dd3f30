// SPDX-License-Identifier: Apache-2.0
#include "trace/sync0_slaves.h"

#include <gtest/gtest.h>

#include "config/cyclic_frame.h"
#include "config/frame_time.h"
#include "config/network_config.h"
#include "config/process_image.h"
#include "config/sync_grid.h"
#include "protocol/command.h"

namespace syncline {
namespace {

NetworkConfig slaves_with_sync0(std::vector<Nanoseconds> periods) {
  CyclicCmd command;
  command.command = Command::kLrw;
  command.data_length = 200;
  NetworkConfig config;
  config.cyclic.resize(1);
  config.cyclic[0].cycle_time = kMillisecond;
  config.cyclic[0].frames.resize(1);
  config.cyclic[0].frames[0].commands = {command};
  for (const auto period : periods) {
    auto& slave = config.slaves.emplace_back();
    slave.dc = SlaveDcConfig{true, false, period, 0, 40 * kMicrosecond, 0x0300};
    slave.send = ImageRange{0, 64};
  }
  return config;
}

TEST(Sync0Slaves, AreWhatTheConfigurationSays) {
  const auto config = slaves_with_sync0({kMillisecond, 4 * kMillisecond, 250 * kMicrosecond, 0});
  const auto wire = wire_time(config.cyclic[0].frames[0]);
  const auto shift = 40 * kMicrosecond;
  EXPECT_EQ(sync0_slaves(config), (std::vector<Sync0Slave>{{kMillisecond, shift, wire, 1},
                                                           {4 * kMillisecond, shift, wire, 4},
                                                           {250 * kMicrosecond, shift, wire, 0},
                                                           {kMillisecond, shift, wire, 1}}));
}

TEST(Sync0Slaves, WithoutSync0OrOutputsNothingIsKnown) {
  auto config = slaves_with_sync0({kMillisecond, kMillisecond, kMillisecond});
  config.slaves[0].dc.reset();
  config.slaves[1].dc->assign_activate = 0;
  config.slaves[2].send.reset();
  EXPECT_EQ(sync0_slaves(config), std::vector<Sync0Slave>(3));
}

/// Primes of milliseconds: all of them meet once in more than a minute, so nobody knows with which cycle each began.
TEST(Sync0Slaves, AGridOfMoreThanAMinuteHidesSlowSync0) {
  const auto config = slaves_with_sync0({41 * kMillisecond, 43 * kMillisecond, 47 * kMillisecond, kMillisecond / 2});
  EXPECT_FALSE(sync_grid(config));
  const auto slaves = sync0_slaves(config);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(slaves[i], Sync0Slave{}) << i;
  EXPECT_EQ(slaves[3].period, kMillisecond / 2) << "in each cycle alike";
  EXPECT_EQ(sync_grid(slaves_with_sync0({4 * kMillisecond, 6 * kMillisecond})), 12 * kMillisecond);
}

}  // namespace
}  // namespace syncline
