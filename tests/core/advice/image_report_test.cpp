// SPDX-License-Identifier: Apache-2.0
#include "advice/image_report.h"

#include <gtest/gtest.h>

#include "compile/cyclic_frames.h"
#include "config/frame_time.h"
#include "tests/support/sample_devices.h"

namespace syncline {
namespace {

ImageReport report(const Project& project) { return image_report(project, compile(project).value().config); }

TEST(ImageReport, FramesAndBandwidth) {
  const Project project = sample::project({sample::servo(), sample::servo()});
  const auto result = report(project);
  ASSERT_EQ(result.frames.size(), 1U);
  const auto config = compile(project).value().config;
  const auto& frame = config.cyclic[0].frames[0];
  EXPECT_EQ(result.frames[0].datagrams, frame.commands.size());
  EXPECT_EQ(result.frames[0].process_data_bytes, 16U);
  EXPECT_EQ(result.wire_time, wire_time(frame));
  // Preamble, frame and gap: what the wire time is made of.
  EXPECT_EQ(result.frames[0].wire_time, (result.frames[0].bytes + 20) * 80);
  EXPECT_DOUBLE_EQ(result.bandwidth, static_cast<double>(result.wire_time) / 1e6);
  EXPECT_EQ(result.output_bytes, 12U);
  EXPECT_EQ(result.input_bytes, 16U);
}

TEST(ImageReport, TheLastFrameIsBackWhenItHasPassedAllSlaves) {
  const auto result = report(sample::project({sample::servo(), sample::servo(), sample::servo()}));
  EXPECT_EQ(result.travel_time, 3 * kMicrosecond);
  EXPECT_EQ(result.busiest_cycle, result.busiest_wire_time + 3 * kMicrosecond);
}

TEST(ImageReport, ASlowTaskCountsByItsShare) {
  Project project = sample::project({sample::servo(), sample::servo()});
  project.master.tasks = {{"Slow", 4}};
  project.master.sync_units = {{"Late", "Slow"}};
  project.slaves[1].output_unit = project.slaves[1].input_unit = "Late";
  const auto result = report(project);
  EXPECT_DOUBLE_EQ(result.frames_per_cycle, 1.25);
  EXPECT_EQ(result.busiest_wire_time, result.frames[0].wire_time + result.frames[1].wire_time);
  EXPECT_EQ(result.wire_time, result.frames[0].wire_time + result.frames[1].wire_time / 4);
  EXPECT_EQ(result.slaves[0].slave, 0U);
  EXPECT_EQ(result.slaves[1].wire_time, result.slaves[0].wire_time / 4);
}

TEST(ImageReport, TheCostliestSlaveComesFirst) {
  const auto result = report(sample::project({sample::digital_input(), sample::servo()}));
  EXPECT_EQ(result.slaves[0].slave, 1U);
  EXPECT_EQ(result.slaves[0].bytes, 8U);  // 6 out and 8 in share addresses
  EXPECT_EQ(result.slaves[0].wire_time, 640);
}

/// What is said to be saved is what compiling without the object saves.
TEST(ImageReport, MovingAnObjectSavesWhatIsSaid) {
  for (const bool overlap : {true, false}) {
    Project project =
        sample::project({sample::servo(), sample::servo(), sample::servo(), sample::servo(), sample::servo()});
    project.master.overlap_process_data = overlap;
    for (auto& slave : project.slaves) {
      slave.assigned_rx_pdos = {0x1600, 0x1601};
      // 15 bytes out and 8 in: without the 8 bytes of one object the inputs are the longer ones.
      slave.device.rx_pdos[1].entries = {{0x60FF, 0, 8, "Velocity", "SINT"}, {0x2000, 0, 64, "Time", "ULINT"}};
    }
    const auto before = report(project);
    ASSERT_EQ(before.movable.size(), 10U);
    EXPECT_EQ(before.movable[0].index, 0x2000);
    EXPECT_EQ(before.movable[0].saved_bytes, overlap ? 7U : 8U);
    for (const auto& object : before.movable) {
      Project moved = project;
      Pdo pdo = moved.slaves[object.slave].device.rx_pdos[1];
      std::erase_if(pdo.entries, [&](const PdoEntry& e) { return e.index == object.index; });
      moved.slaves[object.slave].changed_pdos = {pdo};
      EXPECT_EQ(before.wire_time - report(moved).wire_time, object.saved_wire_time) << object.index << " " << overlap;
    }
  }
}

}  // namespace
}  // namespace syncline
