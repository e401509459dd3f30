// SPDX-License-Identifier: Apache-2.0
#include "compile/coe_init_cmds.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compile/compile.h"
#include "config/command_text.h"
#include "tests/support/sample_devices.h"

namespace syncline {
namespace {

using testing::ElementsAre;

std::vector<std::string> downloads(const Project& project, EniDialect dialect = EniDialect::kEcEngineer) {
  std::vector<std::string> out;
  const auto compiled = compile(project, {dialect}).value();
  for (const auto& cmd : compiled.config.slaves.back().mailbox->coe_commands) {
    const auto& c = cmd.command;
    out.push_back(fmt::format("{:04x}:{} {}{}{}", c.index, c.sub_index, hex_text(c.data),
                              c.complete_access ? " all" : "", c.fixed ? " fixed" : ""));
  }
  return out;
}

TEST(CoeInitCmds, ClearMapAndAssignThenStartUp) {
  EXPECT_THAT(
      downloads(sample::small_machine()),
      ElementsAre("1c12:0 00 fixed", "1c13:0 00 fixed", "1601:0 00 fixed", "1601:1 2000ff60 fixed", "1601:0 01 fixed",
                  "1c12:1 0016 fixed", "1c12:0 01 fixed", "1c13:1 001a fixed", "1c13:0 01 fixed", "60c2:1 01"));
}

TEST(CoeInitCmds, WriteTheMappingThatTheUserMade) {
  Project project = sample::small_machine();
  auto& servo = project.slaves[3];
  servo.assigned_rx_pdos = {0x1600, 0x1601};
  servo.changed_pdos = {
      sample::pdo(0x1601, "User outputs", std::nullopt,
                  {{0x60B1, 0, 32, "Velocity offset", "DINT"}, {0x60B2, 0, 16, "Torque offset", "INT"}})};
  EXPECT_THAT(downloads(project),
              ElementsAre("1c12:0 00 fixed", "1c13:0 00 fixed", "1601:0 00 fixed", "1601:1 2000b160 fixed",
                          "1601:2 1000b260 fixed", "1601:0 02 fixed", "1c12:1 0016 fixed", "1c12:2 0116 fixed",
                          "1c12:0 02 fixed", "1c13:1 001a fixed", "1c13:0 01 fixed", "60c2:1 01"));
}

TEST(CoeInitCmds, ADirectionWithoutPdosIsOnlyCleared) {
  Project project = sample::small_machine();
  project.slaves[3].assigned_rx_pdos.clear();
  project.slaves[3].device.mailbox->coe->pdo_config = false;
  EXPECT_THAT(downloads(project),
              ElementsAre("1c12:0 00 fixed", "1c13:0 00 fixed", "1c13:1 001a fixed", "1c13:0 01 fixed", "60c2:1 01"));
}

TEST(CoeInitCmds, CompleteAccessWritesAnObjectAtOnce) {
  Project project = sample::small_machine();
  project.slaves[3].device.mailbox->coe->complete_access = true;
  EXPECT_THAT(downloads(project), ElementsAre("1c12:0 00 fixed", "1c13:0 00 fixed", "1601:0 01002000ff60 all fixed",
                                              "1c12:0 01000016 all fixed", "1c13:0 0100001a all fixed", "60c2:1 01"));
  EXPECT_THAT(downloads(project, EniDialect::kTwinCat),
              ElementsAre("1601:0 01002000ff60 all fixed", "1c12:0 01000016 all fixed", "1c13:0 0100001a all fixed",
                          "60c2:1 01"));
}

TEST(CoeInitCmds, ADeviceThatCannotBeToldKeepsItsPdos) {
  Project project = sample::small_machine();
  project.slaves[3].device.mailbox->coe->pdo_assign = project.slaves[3].device.mailbox->coe->pdo_config = false;
  EXPECT_THAT(downloads(project), ElementsAre("60c2:1 01"));
}

TEST(CoeInitCmds, TheInterpolationTimeOfTheEsiFollowsTheCycle) {
  Project project = sample::small_machine();
  project.slaves[3].device.mailbox->coe->pdo_assign = project.slaves[3].device.mailbox->coe->pdo_config = false;
  project.master.cycle_time = 4 * kMillisecond;
  EXPECT_THAT(downloads(project), ElementsAre("60c2:1 04"));
  project.master.cycle_time = 10 * kMillisecond;
  EXPECT_THAT(downloads(project), ElementsAre("60c2:1 0a"));
  project.master.cycle_time = 250'000;  // 25 * 10^-5 s
  EXPECT_THAT(downloads(project), ElementsAre("60c2:1 19", "60c2:2 fb"));
}

TEST(CoeInitCmds, AnExponentInTheEsiIsAdaptedInItsPlace) {
  Project project = sample::small_machine();
  auto& servo = project.slaves[3];
  servo.device.mailbox->coe->pdo_assign = servo.device.mailbox->coe->pdo_config = false;
  StartupCommand exponent = servo.startup[0];
  exponent.sub_index = 2;
  exponent.data = {0xFD};
  servo.device.mailbox->coe->init_commands.push_back(exponent);
  servo.startup.push_back(exponent);
  EXPECT_THAT(downloads(project), ElementsAre("60c2:1 01", "60c2:2 fd"));
  project.master.cycle_time = 125'000;
  EXPECT_THAT(downloads(project), ElementsAre("60c2:1 7d", "60c2:2 fa"));
}

TEST(CoeInitCmds, TheUsersOwnInterpolationTimeStays) {
  Project project = sample::small_machine();
  project.slaves[3].device.mailbox->coe->pdo_assign = project.slaves[3].device.mailbox->coe->pdo_config = false;
  project.slaves[3].startup[0].data = {7};
  EXPECT_THAT(downloads(project), ElementsAre("60c2:1 07"));
}

TEST(CoeInitCmds, TellTheSynchronisationTypeOfTheOpMode) {
  Project project = sample::small_machine();
  auto& servo = project.slaves[3];
  servo.device.mailbox->coe->pdo_assign = servo.device.mailbox->coe->pdo_config = false;
  servo.device.dc->op_modes[0].sync_managers = {{2, 2, {}}, {3, 0x22, {}}};
  EXPECT_THAT(downloads(project), ElementsAre("1c32:1 0200 fixed", "1c33:1 2200 fixed", "60c2:1 01"));
  // A device that sets the type itself refuses the write; its dictionary says so.
  servo.device.dictionary = {
      {0x1C33, "SM input parameter", {{1, "Synchronization type", "UINT", 16, true, false, {}}}}};
  EXPECT_THAT(downloads(project), ElementsAre("1c32:1 0200 fixed", "60c2:1 01"));
  servo.dc.op_mode = "Off";
  EXPECT_THAT(downloads(project), ElementsAre("60c2:1 01"));
}

TEST(CoeInitCmds, ADisabledStartUpCommandStaysInTheListAsDisabled) {
  Project project = sample::small_machine();
  project.slaves[3].startup[0].enabled = false;
  const auto config = compile(project).value().config;
  EXPECT_FALSE(config.slaves[3].mailbox->coe_commands.back().command.enabled);
}

TEST(InterpolationTime, IsExactOrNothing) {
  using compiler::interpolation_time;
  using compiler::InterpolationTime;
  EXPECT_EQ(interpolation_time(kMillisecond), (InterpolationTime{1, -3}));
  EXPECT_EQ(interpolation_time(500'000), (InterpolationTime{5, -4}));
  EXPECT_EQ(interpolation_time(62'500), std::nullopt);  // 625 * 10^-7 does not fit a byte
  EXPECT_EQ(interpolation_time(100 * kMillisecond), (InterpolationTime{100, -3}));
}

}  // namespace
}  // namespace syncline
