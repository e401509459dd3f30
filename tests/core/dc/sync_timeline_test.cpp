// SPDX-License-Identifier: Apache-2.0
#include "dc/sync_timeline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config/frame_time.h"
#include "config/network_config.h"

namespace syncline::dc {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using Span = SyncTimeline::Span;

/// 1 ms, SYNC0 in each cycle, 400 us behind the frame.
SlaveTiming usual() {
  SlaveTiming timing;
  timing.bus_cycle = timing.sync0.period = kMillisecond;
  timing.set_value = 400 * kMicrosecond;
  timing.delay = 2 * kMicrosecond;
  timing.wire = 10 * kMicrosecond;
  return timing;
}

/// A slave with SYNC0 and SYNC1 in a cycle of 1 ms.
NetworkConfig one_drive() {
  NetworkConfig config;
  CyclicTask task;
  task.cycle_time = kMillisecond;
  CyclicCmd outputs;
  outputs.command = Command::kLrw;
  outputs.data_length = 100;
  task.frames.emplace_back().commands = {outputs};
  config.cyclic = {task};
  config.dc.dcm.set_value = 300'000;
  auto& slave = config.slaves.emplace_back();
  slave.send = ImageRange{0, 16};
  auto& dc = slave.dc.emplace();
  dc.assign_activate = 0x0700;
  dc.cycle_time0 = 500'000;
  dc.cycle_time1 = 20'000;
  dc.shift_time = 70'000;
  return config;
}

TEST(SlaveTiming, IsThatOfItsConfiguration) {
  auto config = one_drive();
  const auto timing = slave_timing(config, 0);
  ASSERT_TRUE(timing);
  EXPECT_EQ(timing->bus_cycle, kMillisecond);
  EXPECT_EQ(timing->set_value, 300'000);
  EXPECT_EQ(timing->wire, outputs_wire_time(config, 0));
  EXPECT_GT(timing->wire, 0);
  EXPECT_EQ(timing->sync0.first, 70'000);
  EXPECT_EQ(timing->sync0.period, 500'000);
  EXPECT_EQ(timing->sync1, 20'000);
  EXPECT_EQ(timing->delay, 0);
  EXPECT_FALSE(timing->compute);
  config.slaves[0].dc->assign_activate = 0x0300;
  EXPECT_FALSE(slave_timing(config, 0)->sync1);
  config.dc.dcm.set_value.reset();
  EXPECT_EQ(slave_timing(config, 0)->set_value, 666'666);
}

TEST(SlaveTiming, IsNoneWithoutSync0) {
  const auto config = one_drive();
  EXPECT_FALSE(slave_timing(config, 1));
  const auto without = [&](auto&& change) {
    auto changed = config;
    change(changed);
    return !slave_timing(changed, 0);
  };
  EXPECT_TRUE(without([](auto& c) { c.slaves[0].dc.reset(); }));
  EXPECT_TRUE(without([](auto& c) { c.slaves[0].dc->assign_activate = 0; }));
  EXPECT_TRUE(without([](auto& c) { c.slaves[0].dc->assign_activate = 0x0100; }));
  EXPECT_TRUE(without([](auto& c) { c.slaves[0].dc->cycle_time0 = 0; }));
  EXPECT_FALSE(without([](auto& c) { c.slaves[0].dc->cycle_time0 = 1; }));
}

TEST(SyncTimeline, HasOutputsBehindTheReferenceClockAndTheirSync0) {
  auto timing = usual();
  timing.compute = 150 * kMicrosecond;
  const auto line = sync_timeline(timing);
  EXPECT_EQ(line.length, kMillisecond);
  EXPECT_THAT(line.outputs, ElementsAre(Span{2'000, 12'000}));
  EXPECT_THAT(line.compute, ElementsAre(Span{12'000, 162'000}));
  EXPECT_THAT(line.sync0, ElementsAre(400'000));
  EXPECT_THAT(line.sync1, IsEmpty());
  EXPECT_EQ(line.margin, 388'000);
}

/// A shift beyond the cycle comes back from the left, a negative one from the right.
TEST(SyncTimeline, ShiftsAreWithinThePeriod) {
  auto timing = usual();
  timing.sync0.first = 700 * kMicrosecond;
  EXPECT_THAT(sync_timeline(timing).sync0, ElementsAre(100'000));
  timing.sync0.first = -500 * kMicrosecond;
  EXPECT_THAT(sync_timeline(timing).sync0, ElementsAre(900'000));
}

TEST(SyncTimeline, TheWorstOfAllFramesInALongerPeriodCounts) {
  auto timing = usual();
  timing.sync0.period = 2 * kMillisecond;
  const auto line = sync_timeline(timing);
  EXPECT_EQ(line.length, 2 * kMillisecond);
  EXPECT_THAT(line.outputs, SizeIs(2));
  EXPECT_EQ(line.margin, 388'000);
}

/// Frames take the times of latched edges along as they pass the slave, also where it has no outputs.
TEST(SyncTimeline, LatchedTimesAreReadByEachFrame) {
  auto timing = usual();
  timing.wire = 0;
  timing.sync0.period = 2 * kMillisecond;
  EXPECT_THAT(sync_timeline(timing).latch_reads, IsEmpty());
  timing.latch = SlaveTiming::Latch{.single = true};
  EXPECT_THAT(sync_timeline(timing).latch_reads, IsEmpty()) << "nobody reads them";
  timing.latch->in_frames = true;
  EXPECT_THAT(sync_timeline(timing).latch_reads, ElementsAre(2'000, 1'002'000));
}

TEST(SyncTimeline, KnowsTheLatchUnitOfAConfiguration) {
  NetworkConfig config;
  auto& frames = config.cyclic.emplace_back();
  frames.cycle_time = kMillisecond;
  auto& slave = config.slaves.emplace_back();
  slave.station_address = 1001;
  slave.dc = SlaveDcConfig{.cycle_time0 = kMillisecond, .assign_activate = 0x0300};
  const auto latch = [&] { return slave_timing(config, 0).value().latch; };
  InitCmd control;
  control.command = Command::kFpwr;
  control.ado = 0x09A8;
  control.data = {0, 0};
  slave.init_cmds = {control};
  EXPECT_EQ(latch(), std::nullopt) << "as it comes out of reset";
  slave.init_cmds[0].data = {3, 0};
  ASSERT_TRUE(latch());
  EXPECT_TRUE(latch()->single);
  EXPECT_FALSE(latch()->by_device || latch()->in_frames);
  slave.init_cmds.clear();
  slave.dc->assign_activate |= 0x0030;
  ASSERT_TRUE(latch());
  EXPECT_TRUE(latch()->by_device);
  CyclicCmd read;
  read.command = Command::kFprd;
  read.adp = slave.station_address;
  read.ado = 0x09B0;
  frames.frames.emplace_back().commands = {read};
  EXPECT_TRUE(latch()->in_frames);
  slave.dc->assign_activate = 0x0300;
  frames.frames.clear();
  ConfiguredSyncManager registers;
  registers.description.start_address = 0x09AE;
  registers.pdos = {0x1A00};
  slave.sync_managers = {registers};
  ASSERT_TRUE(latch()) << "mapped into the process image";
  EXPECT_TRUE(latch()->in_frames);
}

TEST(SyncTimeline, OversamplingHasManySync0InACycle) {
  auto timing = usual();
  timing.sync0.period = 100 * kMicrosecond;
  timing.sync1 = 900 * kMicrosecond;
  const auto line = sync_timeline(timing);
  EXPECT_THAT(line.sync0, SizeIs(10));
  EXPECT_EQ(line.sync0.front(), 0);
  EXPECT_THAT(line.sync1, ElementsAre(300'000)) << "900 us behind one of each ten";
  EXPECT_EQ(line.margin, 88'000);
}

/// 0x09A4 equal to 0x09A0.
TEST(SyncTimeline, ASync1AsFarAsSync0ComesHalfAsOften) {
  auto timing = usual();
  timing.sync1 = kMillisecond;
  const auto line = sync_timeline(timing);
  EXPECT_EQ(line.length, 2 * kMillisecond);
  EXPECT_THAT(line.sync1, ElementsAre(1'400'000));
}

TEST(SyncTimeline, WithoutOutputsThereIsNothingThatCouldBeLate) {
  auto timing = usual();
  timing.wire = 0;
  const auto line = sync_timeline(timing);
  EXPECT_THAT(line.outputs, IsEmpty());
  EXPECT_FALSE(line.margin);
}

TEST(SyncTimeline, GivesNoMoreThanCanBeDrawn) {
  auto timing = usual();
  timing.sync0.period = 1;
  EXPECT_THAT(sync_timeline(timing).sync0, SizeIs(kMostEdges));
}

}  // namespace
}  // namespace syncline::dc
