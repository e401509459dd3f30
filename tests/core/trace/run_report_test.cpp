// SPDX-License-Identifier: Apache-2.0
#include "trace/run_report.h"

#include <gtest/gtest.h>

#include "config/frame_time.h"

namespace syncline {
namespace {

/// An ESC's outputs are valid at the end of their frame, and that is what SYNC0 must not come before.
TEST(RunReportTest, TheDistanceToSync0BeginsWhereTheFrameWithTheOutputsEnds) {
  CyclicCmd command;
  command.command = Command::kLrw;
  command.data_length = 200;
  NetworkConfig config;
  config.cyclic.resize(1);
  config.cyclic[0].frames.resize(1);
  config.cyclic[0].frames[0].commands = {command};
  config.slaves.resize(2);
  for (auto& slave : config.slaves) slave.dc = SlaveDcConfig{true, false, kMillisecond, 0, 40 * kMicrosecond, 0x0300};
  config.slaves[0].send = ImageRange{0, 64};

  Snapshot snapshot;
  snapshot.slaves.resize(2);
  for (auto& slave : snapshot.slaves) {
    slave.present = slave.dc_enabled = true;
    slave.propagation_delay_ns = 1'000;
  }
  snapshot.dcm.set_value_ns = 500'000;
  const auto report = RunRecorder(config).finish(snapshot);
  const auto wire = wire_time(config.cyclic[0].frames[0]);
  ASSERT_GT(wire, 19 * kMicrosecond);
  EXPECT_EQ(report.slaves[0].sync0_margin, 540'000 - 1'000 - wire);
  EXPECT_EQ(report.slaves[1].sync0_margin, 540'000 - 1'000) << "has no outputs to wait for";
}

}  // namespace
}  // namespace syncline
