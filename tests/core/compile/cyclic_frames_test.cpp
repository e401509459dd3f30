// SPDX-License-Identifier: Apache-2.0
#include "compile/cyclic_frames.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compile/compile.h"
#include "config/command_text.h"
#include "config/frame_time.h"
#include "tests/support/sample_devices.h"

namespace syncline {
namespace {

using testing::ElementsAre;

/// "PREOP,SAFEOP,OP BRD 0:0x0130 2 wkc 4 at 28" for each command of a frame.
std::vector<std::string> lines(const CyclicFrame& frame) {
  std::vector<std::string> out;
  for (const auto& cmd : frame.commands) {
    EXPECT_EQ(cmd.input_offset, cmd.output_offset);
    const std::string wkc = cmd.expected_wkc ? fmt::format(" wkc {}", *cmd.expected_wkc) : "";
    out.push_back(fmt::format("{} {} {}{} at {}", states_text(cmd.states), address_text(cmd), cmd.length(), wkc,
                              cmd.input_offset));
  }
  return out;
}

NetworkConfig compiled(const Project& project, EniDialect dialect = EniDialect::kEcEngineer) {
  return compile(project, {dialect}).value().config;
}

TEST(CyclicFrames, PutServiceDataBehindProcessDataInTheEcEngineerLayout) {
  Project project = sample::small_machine();
  project.master.dc.sync_window.enabled = true;
  const NetworkConfig config = compiled(project);
  ASSERT_EQ(config.cyclic.size(), 1U);
  ASSERT_EQ(config.cyclic[0].frames.size(), 1U);
  // Digital input, digital output, servo (6 bytes out, 8 in): 1 + 1 + 8 bytes; WKC 1 + 2 + 3.
  EXPECT_THAT(lines(config.cyclic[0].frames[0]),
              ElementsAre("PREOP,SAFEOP,OP BRD 0:0x0130 2 wkc 4 at 10", "PREOP,SAFEOP,OP NOP 0:0x0900 4 at 12",
                          "PREOP,SAFEOP,OP ARMW 65533:0x0910 4 at 16", "PREOP,SAFEOP,OP APWR 65533:0x0910 4 at 20",
                          "SAFEOP,OP LRW 0x10000000 10 wkc 6 at 0", "SAFEOP,OP BRD 0:0x092c 4 at 24"));
  EXPECT_EQ(config.image.input_bytes, 28U);
  EXPECT_EQ(config.image.output_bytes, 28U);
  EXPECT_EQ(config.image.command_data_offset, 0U);
  EXPECT_EQ(config.slaves[1].receive, (ImageRange{0, 2}));
  EXPECT_EQ(config.slaves[2].send, (ImageRange{8, 2}));
  EXPECT_EQ(config.slaves[3].send, (ImageRange{16, 48}));
  EXPECT_EQ(config.slaves[3].receive, (ImageRange{16, 64}));
}

TEST(CyclicFrames, SortByDirectionAndPackBitsInTheTwinCatLayout) {
  Project project = sample::small_machine();
  project.slaves.push_back(sample::slave(sample::digital_input(), 4));
  const NetworkConfig config = compiled(project, EniDialect::kTwinCat);
  ASSERT_EQ(config.cyclic[0].frames.size(), 1U);
  EXPECT_THAT(lines(config.cyclic[0].frames[0]),
              ElementsAre("PREOP,SAFEOP,OP NOP 0:0x0900 4 at 16", "PREOP,SAFEOP,OP ARMW 65533:0x0910 4 at 32",
                          "PREOP,SAFEOP,OP APWR 65533:0x0910 4 at 48", "SAFEOP,OP LRW 0x01000000 8 wkc 3 at 64",
                          "SAFEOP,OP LWR 0x01000800 1 wkc 1 at 84", "SAFEOP,OP LRD 0x01001000 1 wkc 2 at 97",
                          "PREOP,SAFEOP,OP BRD 0:0x0130 2 wkc 5 at 110"));
  EXPECT_EQ(config.image.command_data_offset, 10U);
  EXPECT_EQ(config.slaves[3].send, (ImageRange{74 * 8, 48}));
  EXPECT_EQ(config.slaves[1].receive, (ImageRange{107 * 8, 2}));
  EXPECT_EQ(config.slaves[4].receive, (ImageRange{107 * 8 + 2, 2}));
  EXPECT_EQ(config.image.input_bytes, 1536U);
}

TEST(CyclicFrames, MasterShiftNeedsNoCommandOfItsOwn) {
  Project project = sample::small_machine();
  project.master.dc.dcm.mode = DcmMode::kMasterShift;
  const auto commands = lines(compiled(project).cyclic[0].frames[0]);
  EXPECT_EQ(std::ranges::count_if(commands, [](const auto& l) { return l.find("APWR") != std::string::npos; }), 0);
  EXPECT_EQ(std::ranges::count_if(commands, [](const auto& l) { return l.find("ARMW") != std::string::npos; }), 1);
}

TEST(CyclicFrames, CarryNoDcCommandsWithoutADcSlave) {
  Project project = sample::project({sample::coupler(), sample::digital_input()});
  project.master.dc.sync_window.enabled = true;
  const NetworkConfig config = compiled(project);
  EXPECT_THAT(lines(config.cyclic[0].frames[0]),
              ElementsAre("PREOP,SAFEOP,OP BRD 0:0x0130 2 wkc 2 at 1", "SAFEOP,OP LRW 0x10000000 1 wkc 1 at 0"));
  EXPECT_FALSE(config.dc.enabled);
  EXPECT_EQ(config.reference_clock(), std::nullopt);
}

TEST(CyclicFrames, ReadMailboxStatesOfSlavesThatMapThem) {
  Project project = sample::project({sample::servo(), sample::servo()});
  for (auto& slave : project.slaves) slave.device.fmmus.push_back(FmmuUse::kMailboxState);
  const NetworkConfig config = compiled(project);
  EXPECT_EQ(config.master.mailbox_state_count, 2);
  EXPECT_EQ(lines(config.cyclic[0].frames[0])[4], "PREOP,SAFEOP,OP LRD 0x09000000 2 at 30");
  EXPECT_EQ(lines(compiled(project, EniDialect::kTwinCat).cyclic[0].frames[0])[3],
            "PREOP,SAFEOP,OP LRD 0x09000000 1 at 64");
}

TEST(CyclicFrames, ASlaveWithoutLrwGetsTwoCommandsOverTheSameAddresses) {
  Project project = sample::project({sample::servo()});
  project.slaves[0].device.use_lrd_lwr = true;
  const NetworkConfig config = compiled(project);
  const auto commands = lines(config.cyclic[0].frames[0]);
  EXPECT_EQ(commands[4], "SAFEOP,OP LWR 0x10000000 8 wkc 1 at 0");
  EXPECT_EQ(commands[5], "SAFEOP,OP LRD 0x10000000 8 wkc 1 at 0");
  EXPECT_EQ(config.slaves[0].receive, (ImageRange{0, 64}));
}

/// A servo whose inputs are `bytes` long.
DeviceDescription wide_device(std::uint16_t bytes) {
  DeviceDescription device = sample::servo();
  device.sync_managers[3].max_size = std::nullopt;
  device.tx_pdos[0].entries = {{0x3000, 1, static_cast<std::uint16_t>(bytes * 8), "Block", "ARRAY"}};
  return device;
}

TEST(CyclicFrames, AreSplitBeforeTheyExceedEthernet) {
  Project project = sample::project(std::vector<DeviceDescription>(10, wide_device(400)));
  for (const auto dialect : {EniDialect::kEcEngineer, EniDialect::kTwinCat}) {
    const NetworkConfig config = compiled(project, dialect);
    ASSERT_EQ(config.cyclic[0].frames.size(), 4U);
    std::uint32_t process_data = 0;
    for (const auto& frame : config.cyclic[0].frames) {
      std::uint32_t bytes = 0;
      for (const auto& cmd : frame.commands) {
        bytes += 12U + cmd.length();
        process_data += cmd.command == Command::kLrw ? cmd.length() : 0U;
      }
      EXPECT_LE(bytes, 1498U);
    }
    EXPECT_EQ(process_data, 4000U);
  }
}

TEST(CyclicFrames, OffsetsOfSplitFramesMatchTheVariables) {
  Project project = sample::project(std::vector<DeviceDescription>(10, wide_device(400)));
  for (const auto dialect : {EniDialect::kEcEngineer, EniDialect::kTwinCat}) {
    const NetworkConfig config = compiled(project, dialect);
    for (const auto& slave : config.slaves) {
      // The slave's data lie in the image where the command that carries its logical address puts them.
      const auto& fmmu = *std::ranges::find_if(slave.init_cmds, [](const InitCmd& cmd) {
        return cmd.ado == 0x0600 && cmd.transitions == std::vector{Transition::kPS};
      });
      const std::uint32_t logical =
          fmmu.data[0] | fmmu.data[1] << 8U | fmmu.data[2] << 16U | static_cast<std::uint32_t>(fmmu.data[3]) << 24U;
      bool found = false;
      for (const auto& frame : config.cyclic[0].frames) {
        for (const auto& cmd : frame.commands) {
          if (cmd.command == Command::kLrw && logical >= cmd.logical_address &&
              logical < cmd.logical_address + cmd.length()) {
            found = true;
            EXPECT_EQ(slave.send->bit_start,
                      (cmd.output_offset + config.image.command_data_offset + logical - cmd.logical_address) * 8);
          }
        }
      }
      EXPECT_TRUE(found);
    }
  }
}

TEST(WireTime, CountsWhatATapMeasures) {
  // 46 bytes of payload at least: 84 bytes with everything around it, 80 ns each.
  CyclicFrame frame;
  frame.commands.emplace_back();
  frame.commands[0].data_length = 2;
  EXPECT_EQ(wire_time(frame), 6'720);
  frame.commands[0].data_length = 1486;
  EXPECT_EQ(wire_time(frame), 123'040);
}

/// "LRW 0x10000000 8 wkc 3" of the process-data commands.
std::vector<std::string> process_data(const NetworkConfig& config) {
  std::vector<std::string> out;
  for (const auto& frame : config.cyclic[0].frames) {
    for (const auto& cmd : frame.commands) {
      if (is_logical(cmd.command))
        out.push_back(fmt::format("{} {} wkc {}", address_text(cmd), cmd.length(), *cmd.expected_wkc));
    }
  }
  return out;
}

TEST(CyclicFrames, WithoutOverlapInputsStandBehindOutputs) {
  Project project = sample::small_machine();
  project.master.overlap_process_data = false;
  const NetworkConfig config = compiled(project);
  // Outputs 1 + 6, inputs 1 + 8.
  EXPECT_THAT(process_data(config), ElementsAre("LRW 0x10000000 16 wkc 6"));
  EXPECT_EQ(config.slaves[2].send, (ImageRange{0, 2}));
  EXPECT_EQ(config.slaves[3].send, (ImageRange{8, 48}));
  EXPECT_EQ(config.slaves[1].receive, (ImageRange{56, 2}));
  EXPECT_EQ(config.slaves[3].receive, (ImageRange{64, 64}));
  EXPECT_THAT(process_data(compiled(project, EniDialect::kTwinCat)),
              ElementsAre("LWR 0x01000000 7 wkc 2", "LRD 0x01000800 9 wkc 2"));
}

TEST(CyclicFrames, OnlySlavesThatCannotDoLrwGetLwrAndLrd) {
  Project project = sample::small_machine();
  project.slaves.push_back(project.slaves.back());
  project.slaves.back().station_address = 1005;
  project.slaves[3].device.use_lrd_lwr = true;
  const NetworkConfig config = compiled(project);
  EXPECT_THAT(process_data(config),
              ElementsAre("LRW 0x10000000 10 wkc 6", "LWR 0x1000000a 8 wkc 1", "LRD 0x1000000a 8 wkc 1"));
  EXPECT_EQ(config.slaves[4].send, (ImageRange{16, 48}));
}

}  // namespace
}  // namespace syncline
