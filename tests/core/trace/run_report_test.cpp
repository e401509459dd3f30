// SPDX-License-Identifier: Apache-2.0
#include "trace/run_report.h"

#include <gtest/gtest.h>

#include "channels/cycle_sample.h"
#include "channels/event.h"
#include "config/cyclic_frame.h"
#include "config/frame_time.h"
#include "config/network_config.h"
#include "config/process_image.h"
#include "protocol/al_state.h"
#include "protocol/command.h"

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

/// All are read in one cycle where somebody may have left the sync window; a sample tells of one of them.
TEST(RunReportTest, ASlavesReadingIsTheNewestThatTheSnapshotHas) {
  NetworkConfig config;
  config.slaves.resize(2);
  RunRecorder recorder(config);
  CycleSample sample;
  sample.send_time = kSecond;
  sample.slaves_sync = SyncState::kInSync;
  sample.slave_position = 1;
  sample.slave_deviation_ns = -12;
  sample.flags = CycleSample::kSlaveFollows;
  recorder.add(std::span(&sample, 1));
  Snapshot snapshot;
  snapshot.slaves.resize(2);
  auto& status = snapshot.slaves[1];
  status.present = status.follows = status.deviation_valid = true;
  status.deviation_time = kSecond + kMillisecond;
  status.deviation_ns = 70;
  recorder.add(snapshot);
  EXPECT_EQ(recorder.finish(snapshot).slaves[1].deviation_ns, 70);
  EXPECT_EQ(recorder.finish(snapshot).slaves[1].deviation_time, kSecond + kMillisecond);
  EXPECT_EQ(recorder.finish(snapshot).slaves[1].deviation_max_ns, 70);
  // Between two snapshots the first slave was worse: the event says so.
  recorder.add(Event{kSecond, 0, events::SlavesOutOfSync{400, 1}});
  EXPECT_EQ(recorder.finish(snapshot).slaves[0].deviation_max_ns, 400);
  EXPECT_EQ(recorder.finish(snapshot).deviation_max_ns, 400);
  status.follows = false;
  EXPECT_FALSE(recorder.finish(snapshot).slaves[1].deviation_ns) << "it leads by now";
}

TEST(RunReportTest, LatenessIsThatOfControlledClocksAndProcessDataInAnyState) {
  CycleSample sample;
  const auto counted = [&](AlState state, std::uint16_t flags) {
    RunRecorder recorder{NetworkConfig{}};
    sample.master_state = static_cast<std::uint8_t>(state);
    sample.flags = flags;
    recorder.add(std::span(&sample, 1));
    return recorder.finish(Snapshot{}).lateness_histogram.count();
  };
  EXPECT_EQ(counted(AlState::kInit, 0), 0U);
  EXPECT_EQ(counted(AlState::kPreop, 0), 0U);
  EXPECT_EQ(counted(AlState::kPreop, CycleSample::kDcmActive), 1U);
  EXPECT_EQ(counted(AlState::kSafeop, 0), 1U);
  EXPECT_EQ(counted(AlState::kOp, 0), 1U);
}

/// Also what a slave's counter said before it went; of a slave without one nothing is reported.
TEST(RunReportTest, MissedEventsAreReportedWhereACounterIsOrWasRead) {
  NetworkConfig config;
  config.slaves.resize(3);
  Snapshot snapshot;
  snapshot.slaves.resize(3);
  snapshot.slaves[0].sm2_missed.valid = snapshot.slaves[1].sm2_missed.known = true;
  const auto report = RunRecorder(config).finish(snapshot);
  EXPECT_TRUE(report.slaves[0].sm2_missed);
  EXPECT_TRUE(report.slaves[1].sm2_missed);
  EXPECT_FALSE(report.slaves[2].sm2_missed);
}

}  // namespace
}  // namespace syncline
