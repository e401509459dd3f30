// SPDX-License-Identifier: Apache-2.0
#include "recover/recover_project.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config/sim_config.h"
#include "config/startup_messages.h"
#include "recover/simulated_network.h"
#include "tests/support/sample_devices.h"

namespace syncline {
namespace {

std::string describe_finding(const Finding& finding) { return describe(finding); }

using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> words(const RecoveredProject& recovered) {
  std::vector<std::string> out;
  for (const auto& difference : recovered.differences) out.push_back(describe(difference));
  return out;
}

Project machine() {
  Project project = sample::project(
      {sample::coupler(), sample::digital_input(), sample::digital_output(), sample::servo(), sample::servo()});
  auto& servo = project.slaves[4];
  servo.name = "Feeder";
  servo.alias = 77;
  servo.check.revision = servo.check.vendor = true;
  servo.dc.sync0.shift = 125'000;
  servo.startup.push_back(
      {.transitions = {Transition::kPS}, .index = 0x6060, .sub_index = 0, .data = {8}, .comment = {}});
  project.master.cycle_time = 2 * kMillisecond;
  project.master.dc.sync_window.enabled = true;
  return project;
}

/// As an ENI holds it: nothing but what the file says.
NetworkConfig compiled(const Project& project, EniDialect dialect) {
  return compile(project, {dialect}).value().config;
}

class RecoverProject : public testing::TestWithParam<EniDialect> {};

TEST_P(RecoverProject, CompilesToTheSameCommandsWithoutAnyEsi) {
  const auto config = compiled(machine(), GetParam());
  const auto recovered = recover_project(config);
  EXPECT_EQ(recovered.dialect, GetParam());
  EXPECT_THAT(words(recovered), IsEmpty());
  const auto& servo = recovered.project.slaves[4];
  EXPECT_EQ(servo.name, "Feeder");
  EXPECT_EQ(servo.alias, 77);
  EXPECT_TRUE(servo.check.revision);
  EXPECT_EQ(recovered.project.master.cycle_time, 2 * kMillisecond);
  EXPECT_TRUE(recovered.project.master.dc.sync_window.enabled);
  EXPECT_THAT(recovered.findings, testing::Contains(testing::ResultOf(describe_finding, HasSubstr("No ESI of"))));
}

TEST_P(RecoverProject, KnowsWhoseEoeIsSwitchedOff) {
  auto config = compiled(machine(), GetParam());
  EXPECT_TRUE(recover_project(config).project.slaves[3].eoe.enabled);
  config.slaves[3].mailbox->eoe_disabled = true;
  EXPECT_FALSE(recover_project(config).project.slaves[3].eoe.enabled);
  EXPECT_TRUE(recover_project(config).project.slaves[4].eoe.enabled);
}

TEST_P(RecoverProject, CompilesToTheSameCommandsWithTheEsi) {
  const auto project = machine();
  const auto config = compiled(project, GetParam());
  const auto recovered = recover_project(config, [&](const Identity& identity) -> const DeviceDescription* {
    for (const auto& slave : project.slaves) {
      if (slave.device.identity == identity) return &slave.device;
    }
    return nullptr;
  });
  EXPECT_THAT(words(recovered), IsEmpty());
  EXPECT_EQ(recovered.project.slaves[4].dc.op_mode, project.slaves[4].dc.op_mode);
  EXPECT_EQ(recovered.project.slaves[4].dc.sync0.shift, 125'000);
  EXPECT_EQ(recovered.project.slaves[3].device, project.slaves[3].device);
  EXPECT_EQ(recovered.project.slaves[4].assigned_tx_pdos, project.slaves[4].assigned_tx_pdos);
}

/// Messages and register commands that no setting stands for are the user's own again, whatever register they touch.
TEST_P(RecoverProject, KeepsMessagesAndRegisterCommands) {
  auto project = machine();
  auto& servo = project.slaves[4];
  for (const auto& protocol : kMessageProtocols) {
    (*servo.device.mailbox).*protocol.known = true;
    (servo.*protocol.startup).push_back({{Transition::kPS}, {1, 0, 0, 0}, 70, false, true, "own"});
  }
  RegisterCommand write, read;
  write.address = 0x0310;  // among the error counters, which a setting clears
  write.data = {1, 1};
  write.comment = "own";
  read.transitions = {Transition::kSO, Transition::kOS};
  read.read = true;
  read.address = 0x0F10;
  read.data = {0, 0};
  read.expected = {8, 0};
  read.mask = {0xF, 0};
  read.timeout_ms = 500;
  servo.register_commands = {write, read};
  project.master.register_commands = {write, read};
  project.master.register_commands[1].after_slaves = true;
  const auto recovered = recover_project(compiled(project, GetParam()));
  EXPECT_THAT(words(recovered), IsEmpty());
  EXPECT_THAT(recovered.findings,
              testing::Not(testing::Contains(testing::ResultOf(describe_finding, HasSubstr("cannot be kept")))));
  for (const auto& protocol : kMessageProtocols)
    EXPECT_EQ(recovered.project.slaves[4].*protocol.startup, servo.*protocol.startup) << protocol.name;
  EXPECT_EQ(recovered.project.slaves[4].register_commands, servo.register_commands);
  EXPECT_EQ(recovered.project.master.register_commands, project.master.register_commands);
  EXPECT_TRUE(recovered.project.slaves[3].register_commands.empty());
}

/// Another tool chooses other commands for the same settings: only what touches a register of its own is kept.
TEST(RecoverProject, TakesNoCommandOfASettingForTheUsersOwn) {
  auto config = compiled(machine(), EniDialect::kEcEngineer);
  auto& commands = config.slaves[4].init_cmds;
  const auto watchdog = std::ranges::find(commands, std::uint16_t{0x0420}, &InitCmd::ado);
  ASSERT_NE(watchdog, commands.end());
  watchdog->comment = "in another tool's words";
  auto latch = *watchdog;
  latch.ado = 0x0F20;
  latch.comment = "its own";
  commands.push_back(latch);
  const auto recovered = recover_project(config).project.slaves[4].register_commands;
  ASSERT_EQ(recovered.size(), 1U);
  EXPECT_EQ(recovered[0].address, 0x0F20);
  EXPECT_EQ(recovered[0].comment, "its own");
}

INSTANTIATE_TEST_SUITE_P(Dialects, RecoverProject, testing::Values(EniDialect::kEcEngineer, EniDialect::kTwinCat),
                         [](const auto& test) {
                           return test.param == EniDialect::kTwinCat ? "TwinCat" : "EcEngineer";
                         });

TEST(RecoverProject, SaysWhatItCannotKeep) {
  auto config = compiled(machine(), EniDialect::kEcEngineer);
  config.slaves[3].mailbox->voe_commands.push_back({{Transition::kPS}, {1}, 0, true, false, {}});
  config.cyclic[0].frames[0].commands[0].copy_infos.push_back({0, 8, 8});
  config.slaves[4].init_cmds.erase(config.slaves[4].init_cmds.begin() + 3);
  const auto recovered = recover_project(config);
  EXPECT_THAT(recovered.findings,
              testing::Contains(testing::ResultOf(describe_finding, HasSubstr("of VoE cannot be kept"))));
  EXPECT_THAT(recovered.findings, testing::Contains(testing::ResultOf(describe_finding, HasSubstr("slave-to-slave"))));
  EXPECT_THAT(words(recovered), testing::ElementsAre(HasSubstr("slave 4")));
}

TEST_P(RecoverProject, PutsSlavesIntoTheTasksOfTheEni) {
  auto project = machine();
  project.master.tasks = {{"slow", 4}};
  project.master.sync_units = {{"axis", "slow"}};
  project.slaves[3].output_unit = project.slaves[3].input_unit = "axis";
  const auto config = compiled(project, GetParam());
  ASSERT_EQ(config.cyclic.size(), 2U);
  const auto recovered = recover_project(config);
  EXPECT_THAT(words(recovered), IsEmpty());
  ASSERT_EQ(recovered.project.master.tasks.size(), 1U);
  EXPECT_EQ(recovered.project.master.tasks[0].multiple, 4U);
  EXPECT_EQ(recovered.project.slaves[3].input_unit, recovered.project.master.sync_units[0].name);
  EXPECT_EQ(recovered.project.slaves[4].input_unit, "");
}

TEST(RecoverProject, SaysWhichTaskDoesNotFit) {
  auto config = compiled(machine(), EniDialect::kEcEngineer);
  config.cyclic.push_back({3 * kMillisecond, {}, {}, {}, {}});
  EXPECT_THAT(
      recover_project(config).findings,
      testing::Contains(testing::ResultOf(describe_finding, HasSubstr("task 2, 3 ms, is no multiple of 2 ms"))));
}

TEST(RecoverProject, TakesNoEsiThatDoesNotFit) {
  const auto project = machine();
  const auto config = compiled(project, EniDialect::kEcEngineer);
  auto other = project.slaves[4].device;
  other.tx_pdos.clear();
  const auto recovered =
      recover_project(config, [&](const Identity& identity) { return identity == other.identity ? &other : nullptr; });
  EXPECT_THAT(words(recovered), IsEmpty());
  EXPECT_THAT(recovered.findings, testing::Contains(testing::ResultOf(describe_finding, HasSubstr("has no PDO 0x1A"))));
  EXPECT_FALSE(recovered.project.slaves[4].device.tx_pdos.empty());
}

TEST(SimulatedNetwork, HasTheWiringIdentitiesAndObjectsOfTheEni) {
  auto config = compiled(machine(), EniDialect::kEcEngineer);
  config.slaves[3].previous = PreviousPort{0, 3};
  config.slaves[4].previous = PreviousPort{0, 1};
  config.slaves[4].identity = {0x5C17, 0x7001, 0x10000, 0};
  const auto simulated = simulated_network(config);
  ASSERT_EQ(simulated.slaves.size(), 5U);
  EXPECT_EQ(simulated.slaves[4].alias, 77);
  EXPECT_EQ(simulated.slaves[4].device.identity, config.slaves[4].identity);
  EXPECT_EQ(simulated.slaves[1].parent, 0);
  // Two slaves at port B of the first cannot be: then it is a line.
  EXPECT_EQ(simulated.slaves[4].parent, 3);
  const auto& dictionary = simulated.slaves[4].device.dictionary;
  EXPECT_TRUE(std::ranges::any_of(dictionary, [](const ObjectDescription& object) { return object.index == 0x60C2; }));
  EXPECT_EQ(simulated.slaves[0].behaviour, "generic");
  EXPECT_EQ(simulated.slaves[4].behaviour, "servo-y");
}

}  // namespace
}  // namespace syncline
