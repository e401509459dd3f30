// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compile/compile.h"
#include "settings/settings_table.h"
#include "tests/support/sample_devices.h"

namespace syncline {
namespace {

using testing::HasSubstr;

std::vector<CyclicCmd> process_data(const CyclicTask& task) {
  std::vector<CyclicCmd> commands;
  for (const auto& frame : task.frames) {
    for (const auto& cmd : frame.commands) {
      if (is_logical(cmd.command)) commands.push_back(cmd);
    }
  }
  return commands;
}

/// A servo in the base task, terminals in a task four times slower.
Project two_tasks() {
  Project project = sample::project({sample::servo(), sample::digital_input(), sample::digital_output()});
  project.master.tasks = {{"Slow", 4}};
  project.master.sync_units = {{"Terminals", "Slow"}};
  for (std::size_t i : {1, 2}) project.slaves[i].output_unit = project.slaves[i].input_unit = "Terminals";
  return project;
}

class Tasks : public testing::TestWithParam<EniDialect> {};

TEST_P(Tasks, SlowerSlavesAreInFramesOfTheirOwnTask) {
  const auto result = compile(two_tasks(), {GetParam()}).value();
  const NetworkConfig& config = result.config;
  ASSERT_EQ(config.cyclic.size(), 2U);
  EXPECT_EQ(config.cyclic[0].cycle_time, kMillisecond);
  EXPECT_EQ(config.cyclic[1].cycle_time, 4 * kMillisecond);
  EXPECT_EQ(config.cyclic[1].comment, "Slow");
  unsigned base = 0, slow = 0;
  for (const auto& cmd : process_data(config.cyclic[0])) base += *cmd.expected_wkc;
  for (const auto& cmd : process_data(config.cyclic[1])) slow += *cmd.expected_wkc;
  EXPECT_EQ(base, 3U);                                               // the servo reads and writes in one LRW
  EXPECT_EQ(slow, GetParam() == EniDialect::kEcEngineer ? 3U : 2U);  // LRW counts a writer twice, LWR and LRD once
  for (const auto& frame : config.cyclic[1].frames) {
    for (const auto& cmd : frame.commands) EXPECT_TRUE(is_logical(cmd.command));
  }
}

TEST_P(Tasks, EveryDatumLiesInADatagramOfItsSlavesTask) {
  const auto config = compile(two_tasks(), {GetParam()}).value().config;
  const auto carried = [&](std::size_t task, const ImageRange& range, bool output) {
    for (const auto& cmd : process_data(config.cyclic[task])) {
      const auto begin = ((output ? cmd.output_offset : cmd.input_offset) + config.image.command_data_offset) * 8;
      if (range.bit_start >= begin && range.bit_start + range.bit_length <= begin + cmd.length() * 8U) return true;
    }
    return false;
  };
  EXPECT_TRUE(carried(0, *config.slaves[0].send, true));
  EXPECT_TRUE(carried(0, *config.slaves[0].receive, false));
  EXPECT_TRUE(carried(1, *config.slaves[1].receive, false));
  EXPECT_TRUE(carried(1, *config.slaves[2].send, true));
}

TEST_P(Tasks, TheSyncUnitCycleOfASlaveIsThatOfItsTask) {
  Project project = two_tasks();
  project.slaves[0].output_unit = project.slaves[0].input_unit = "Terminals";
  EXPECT_EQ(compile(project, {GetParam()}).value().config.slaves[0].dc->cycle_time0, 4 * kMillisecond);
  project.slaves[0].input_unit.clear();  // now its inputs come faster than its outputs
  EXPECT_EQ(compile(project, {GetParam()}).value().config.slaves[0].dc->cycle_time0, kMillisecond);
}

/// A field that is left to the operation mode shows what is written.
TEST_P(Tasks, TheCycleThatASettingStandsForIsThatOfTheTask) {
  Project project = two_tasks();
  const auto stands_for = [&project](const char* key) {
    settings::Place place;
    place.slave = 0;
    return settings::effective_value(settings::row(key), project, place);
  };
  const settings::Value base{kMillisecond}, slow{4 * kMillisecond};
  EXPECT_EQ(stands_for("slave.N.dc.sync0.cycle_us"), base);
  project.slaves[0].output_unit = project.slaves[0].input_unit = "Terminals";
  EXPECT_EQ(stands_for("slave.N.dc.sync0.cycle_us"), slow);
  project.slaves[0].device.dc->op_modes.front().shift_time_sync0.factor = 1;
  const auto shift = compile(project, {GetParam()}).value().config.slaves[0].dc->shift_time;
  EXPECT_EQ(stands_for("slave.N.dc.sync0.shift_us"), settings::Value{shift});
  EXPECT_EQ(shift, 4 * kMillisecond);
  project.slaves[0].assigned_tx_pdos.clear();
  project.slaves[0].output_unit.clear();
  EXPECT_EQ(stands_for("slave.N.dc.sync0.cycle_us"), base) << "its inputs' unit says nothing without inputs";
}

INSTANTIATE_TEST_SUITE_P(Dialects, Tasks, testing::Values(EniDialect::kEcEngineer, EniDialect::kTwinCat));

TEST(Tasks, ASyncUnitOfTheBaseTaskHasADatagramOfItsOwn) {
  Project project = two_tasks();
  project.master.sync_units[0].task.clear();
  const auto config = compile(project).value().config;
  ASSERT_EQ(config.cyclic.size(), 1U);
  const auto commands = process_data(config.cyclic[0]);
  ASSERT_EQ(commands.size(), 2U);
  EXPECT_EQ(commands[0].expected_wkc, 3U);
  EXPECT_EQ(commands[1].expected_wkc, 3U);
}

TEST(Tasks, WhatDoesNotExistIsSaid) {
  Project project = two_tasks();
  project.master.sync_units[0].task = "Fast";
  project.slaves[0].input_unit = "Nobody";
  const auto findings = compile(project).value().findings;
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].place.key, "master.sync_unit.0");
  EXPECT_THAT(describe(findings[0]), HasSubstr("\"Fast\""));
  EXPECT_EQ(findings[1].place.key, "slave.0.sync_unit.inputs");
}

TEST(ProcessImageOptions, LogicalStartAlignmentAndPacking) {
  Project project = sample::project({sample::digital_output(), sample::digital_output(), sample::servo()});
  project.master.image = {.logical_start = 0x0002'0000, .alignment = 4, .bit_packing = false};
  const auto config = compile(project).value().config;
  EXPECT_EQ(process_data(config.cyclic[0]).front().logical_address, 0x0002'0000U);
  for (const auto& slave : config.slaves) EXPECT_EQ(slave.send->bit_start % 32, 0U);
  EXPECT_EQ(config.slaves[0].send->bit_length, 8U);
  project.master.image.bit_packing = true;
  EXPECT_EQ(compile(project).value().config.slaves[0].send->bit_length, 2U);
}

}  // namespace
}  // namespace syncline
