// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "compile/compile.h"
#include "compile/eoe_ip.h"
#include "protocol/registers.h"
#include "settings/settings_keys.h"
#include "tests/support/sample_devices.h"

namespace syncline {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Project machine() { return sample::project({sample::coupler(), sample::servo()}); }

const InitCmd* find_cmd(const SlaveConfig& slave, const std::string& comment) {
  const auto found = std::ranges::find_if(slave.init_cmds, [&](const InitCmd& c) { return c.comment == comment; });
  return found == slave.init_cmds.end() ? nullptr : &*found;
}

SlaveConfig servo_of(const Project& project) { return compile(project).value().config.slaves[1]; }

std::vector<std::string> keys_of(const Project& project) {
  std::vector<std::string> keys;
  const auto result = compile(project).value();
  for (const auto& finding : result.findings) keys.push_back(finding.place.key);
  return keys;
}

TEST(SlaveOptions, WatchdogsReplaceThoseOfTheEsi) {
  Project project = machine();
  project.slaves[1].watchdog = {.divider = 0x03E6, .pdi = 500, .process_data = 250, .outputs = false};
  const auto servo = servo_of(project);
  EXPECT_THAT(find_cmd(servo, "set watchdog divider")->data, ElementsAre(0xE6, 0x03));
  EXPECT_THAT(find_cmd(servo, "set PDI watchdog")->data, ElementsAre(0xF4, 0x01));
  EXPECT_THAT(find_cmd(servo, "set process data watchdog")->data, ElementsAre(250, 0));
  EXPECT_EQ(find_cmd(servo, "set SM 2 (outputs)")->data[4], 0x24);
  EXPECT_EQ(find_cmd(servo_of(machine()), "set SM 2 (outputs)")->data[4], 0x64);
}

TEST(SlaveOptions, PortsWithFastHotConnectAreWrittenWithTheLettersOfTheEni) {
  Project project = machine();
  project.slaves[1].device.physics = "KHKH";
  EXPECT_EQ(servo_of(project).physics, "KYKY");
}

TEST(SlaveOptions, AWatchdogShorterThanTheCycleIsFound) {
  Project project = machine();
  project.slaves[1].watchdog.process_data = 15;  // times 100 us
  EXPECT_THAT(keys_of(project), ElementsAre("slave.1.watchdog.process_data"));
  project.slaves[1].watchdog.outputs = false;
  EXPECT_THAT(keys_of(project), ElementsAre("slave.1.watchdog.outputs")) << "they stay when frames stop";
}

TEST(SlaveOptions, TimeoutsAndMailboxSizes) {
  Project project = machine();
  auto& timeouts = project.slaves[1].timeouts;
  timeouts.preop = 4000;
  timeouts.safeop_op = 7000;
  timeouts.mailbox_request = 150;
  timeouts.mailbox_response = 900;
  project.slaves[1].mailbox = {.out_size = 256, .in_size = 300, .state_bit = true, .poll_time_ms = 7};
  const auto servo = servo_of(project);
  EXPECT_EQ(servo.timeouts.preop, 4000U);
  EXPECT_EQ(find_cmd(servo, "wait for PREOP")->validate->timeout_ms, 5000U);  // of the way back, which stands first
  EXPECT_EQ(find_cmd(servo, "wait for OP")->validate->timeout_ms, 7000U);
  EXPECT_EQ(servo.mailbox->timeouts, (MailboxTimeouts{150, 900}));
  EXPECT_EQ(servo.mailbox->send.length, 256);
  EXPECT_EQ(servo.mailbox->receive.length, 300);
  EXPECT_EQ(servo.mailbox->poll_time_ms, 7U);
}

TEST(SlaveOptions, TheStateBitCanBeLeftOut) {
  Project project = machine();
  project.slaves[1].device.fmmus.push_back(FmmuUse::kMailboxState);
  EXPECT_EQ(servo_of(project).mailbox->status_bit_address, 0U);
  project.slaves[1].mailbox.state_bit = false;
  EXPECT_FALSE(servo_of(project).mailbox->status_bit_address);
  EXPECT_FALSE(compile(project).value().config.master.mailbox_state_count);
}

struct RevisionCase {
  RevisionCheck rule;
  std::vector<std::pair<std::size_t, ValidateType>> compared;  // bytes and how
};

TEST(SlaveOptions, RevisionRules) {
  using enum RevisionCheck;
  const RevisionCase cases[] = {
      {kNone, {}},
      {kEqual, {{4, ValidateType::kEqual}}},
      {kEqualOrGreater, {{4, ValidateType::kGreaterOrEqual}}},
      {kLowWordEqual, {{2, ValidateType::kEqual}}},
      {kLowWordEqualHighWordEqualOrGreater, {{2, ValidateType::kEqual}, {2, ValidateType::kGreaterOrEqual}}},
  };
  for (const auto& [rule, compared] : cases) {
    Project project = machine();
    project.slaves[1].check = {.vendor = false, .product = false, .revision = true, .revision_rule = rule};
    std::vector<std::pair<std::size_t, ValidateType>> found;
    const auto servo = servo_of(project);
    for (const auto& cmd : servo.init_cmds) {
      if (cmd.ado == reg::kSiiData) found.emplace_back(cmd.validate->data.size(), cmd.validate->type);
    }
    EXPECT_EQ(found, compared) << revision_check_name(rule);
  }
}

TEST(SlaveOptions, AliasAndDeviceIdAreCompared) {
  Project project = machine();
  project.slaves[1].alias = 7;
  project.slaves[1].check.alias = true;
  project.slaves[1].check.device_id = 0x1234;
  project.slaves[1].device.identification_ado = 0x0F18;
  auto servo = servo_of(project);
  EXPECT_THAT(find_cmd(servo, "check alias")->validate->data, ElementsAre(7, 0));
  EXPECT_EQ(find_cmd(servo, "check device ID")->ado, 0x0F18);
  EXPECT_EQ(servo.identification, (Identification{0x0F18, 0x1234}));
  project.slaves[1].device.identification_ado.reset();
  project.slaves[1].device.identification_reg134 = true;
  servo = servo_of(project);
  EXPECT_THAT(find_cmd(servo, "request device ID")->data, ElementsAre(0x21, 0));
  EXPECT_EQ(find_cmd(servo, "check device ID")->ado, reg::kAlStatusCode);
}

TEST(SlaveOptions, AnOptionalSlaveIsAGroupOfItsOwn) {
  Project project = sample::project({sample::coupler(), sample::servo(), sample::digital_input()});
  project.slaves[1].optional = true;
  EXPECT_THAT(keys_of(project), ElementsAre("slave.1.alias"));
  project.slaves[1].check.device_id = 5;
  project.slaves[1].device.identification_reg134 = true;
  const auto config = compile(project).value().config;
  ASSERT_TRUE(config.slaves[1].hot_connect);
  EXPECT_EQ(config.slaves[1].hot_connect->member_count, 1);
  EXPECT_EQ(config.slaves[1].hot_connect->group, project.slaves[1].name);
  EXPECT_EQ(config.slaves[1].hot_connect->identify_cmds.size(), 4U);
  EXPECT_FALSE(config.hot_connect_head(2));
  EXPECT_TRUE(config.slaves[1].previous);
}

TEST(SlaveOptions, OversamplingRepeatsTheEntries) {
  Project project = machine();
  auto& device = project.slaves[1].device;
  device.tx_pdos[0].os_index_increment = 1;
  device.tx_pdos[0].os_max = 4;
  device.dc->op_modes[0].sync_managers = {{3, std::nullopt, {}, {{0x1A00, 3}}, {}, {}}};
  EXPECT_EQ(servo_of(project).receive->bit_length, 3 * 64U);
  project.slaves[1].oversampling = {{0x1A00, 2}};
  project.slaves[1].variable_names = {{0x1A00, 2, "Axis 1 position"}};
  const auto config = compile(project).value().config;
  EXPECT_EQ(config.slaves[1].receive->bit_length, 2 * 64U);
  std::vector<std::string> names;
  for (const auto& variable : config.image.inputs) names.push_back(variable.name);
  EXPECT_THAT(names, ElementsAre(HasSubstr("Status word[0]"), "Axis 1 position[0]", HasSubstr("Status word[1]"),
                                 "Axis 1 position[1]"));
  EXPECT_EQ(config.image.inputs[3].bit_offset - config.image.inputs[1].bit_offset, 64U);
  project.slaves[1].oversampling[0].factor = 5;
  EXPECT_THAT(keys_of(project), testing::Contains("slave.1.pdo.oversampling.0x1a00"));
}

TEST(SlaveOptions, TimesOfSyncManagersFollowTheModeAndTheCycle) {
  Project project = machine();
  auto& mode = project.slaves[1].device.dc->op_modes[0];
  OpModeTime cycle, shift;
  cycle.factor = -2;
  shift.value_ns = 5000;
  mode.sync_managers = {{2, std::nullopt, {}, {}, cycle, shift}};
  StartupCommand adapted;
  adapted.index = 0x1C33;
  adapted.sub_index = 2;
  adapted.data = {0, 0, 0, 0};
  adapted.adapt_automatically = true;
  project.slaves[1].startup.push_back(adapted);
  std::map<std::pair<int, int>, std::vector<std::uint8_t>> written;
  const auto servo = servo_of(project);
  for (const auto& cmd : servo.mailbox->coe_commands)
    written[{cmd.command.index, cmd.command.sub_index}] = cmd.command.data;
  EXPECT_THAT((written[{0x1C32, 2}]), ElementsAre(0x20, 0xA1, 0x07, 0x00));  // 500 us
  EXPECT_THAT((written[{0x1C32, 3}]), ElementsAre(0x88, 0x13, 0x00, 0x00));
  EXPECT_THAT((written[{0x1C33, 2}]), ElementsAre(0x40, 0x42, 0x0F, 0x00));  // 1 ms
}

TEST(SlaveOptions, MoreObjectsThanTheDriveTakes) {
  Project project = machine();
  auto& device = project.slaves[1].device;
  device.identity.vendor_id = 0x539;
  device.type = "SGDV-E1";
  device.sync_managers[3].max_size = 128;
  device.tx_pdos[0].entries.assign(16, {0x6064, 0, 32, "Position", "DINT"});
  EXPECT_THAT(keys_of(project), ElementsAre());
  device.tx_pdos[0].entries.push_back({0x6041, 0, 16, "Status", "UINT"});
  EXPECT_THAT(keys_of(project), ElementsAre("slave.1.pdo.tx"));
}

TEST(SlaveOptions, MoreEntriesThanTheMappingObjectHasRoomFor) {
  Project project = machine();
  auto& device = project.slaves[1].device;
  Pdo changed = device.rx_pdos[1];
  changed.entries.push_back({0x60B1, 0, 16, "Velocity offset", "INT"});
  project.slaves[1].changed_pdos = {changed};
  device.dictionary = {
      {0x1601, "Mapping", {{0, "Count", "USINT", 8, true, false, {}}, {2, "Entry 2", "UDINT", 32, true, false, {}}}}};
  EXPECT_THAT(keys_of(project), ElementsAre());
  device.dictionary[0].entries.back().sub_index = 1;
  EXPECT_THAT(keys_of(project), ElementsAre("slave.1.pdo.map.0x1601"));
}

TEST(SlaveOptions, EntriesThatTheEsiFixesStay) {
  Project project = machine();
  auto& device = project.slaves[1].device;
  device.rx_pdos[1].entries[0].fixed = true;
  Pdo changed = device.rx_pdos[1];
  changed.entries[0].index = 0x60B1;
  project.slaves[1].changed_pdos = {changed};
  EXPECT_THAT(keys_of(project), ElementsAre("slave.1.pdo.map.0x1601"));
}

TEST(SlaveOptions, EoeSoeAndAoeAtStartUp) {
  Project project = machine();
  auto& mailbox = *project.slaves[1].device.mailbox;
  mailbox.eoe = mailbox.soe = mailbox.aoe = true;
  ASSERT_TRUE(set_setting(project, "slave.1.eoe.ip", "192.168.1.10"));
  ASSERT_TRUE(set_setting(project, "slave.1.eoe.mac", "02:00:00:00:00:01"));
  ASSERT_TRUE(set_setting(project, "slave.1.soe.0", "PS 1:P-1-0047=0a00 # limit"));
  ASSERT_TRUE(set_setting(project, "slave.1.aoe.net_id", "5.1.2.3.1.1"));
  const auto config = servo_of(project).mailbox.value();
  ASSERT_EQ(config.eoe_commands.size(), 1U);
  EXPECT_THAT(config.eoe_commands[0].data,
              // 62 bytes with each parameter in its place, as the tools write them.
              testing::ElementsAreArray([] {
                std::vector<std::uint8_t> bytes{0x02, 0, 0, 0, 0x03, 0, 0, 0, 2, 0, 0, 0, 0, 1, 10, 1, 168, 192};
                bytes.resize(62);
                return bytes;
              }()));
  EXPECT_EQ(decode_ip_parameters(config.eoe_commands[0].data, 1002), project.slaves[1].eoe);
  ASSERT_EQ(config.soe_commands.size(), 1U);
  EXPECT_EQ(config.soe_commands[0].idn, 0x902F);
  EXPECT_EQ(config.soe_commands[0].drive_no, 1);
  EXPECT_EQ(config.aoe_net_id, "5.1.2.3.1.1");
  ASSERT_TRUE(set_setting(project, "slave.1.eoe.enabled", "off"));
  EXPECT_TRUE(servo_of(project).mailbox->eoe_disabled);
  EXPECT_TRUE(servo_of(project).mailbox->eoe_commands.empty());
  EXPECT_FALSE(compile(project).value().config.master.eoe);
}

TEST(SlaveOptions, ValuesOutOfRangeAreRefusedWithTheirRange) {
  Project project = machine();
  project.slaves[1].device.mailbox->soe = true;
  const std::tuple<const char*, const char*, const char*> edits[] = {
      {"slave.1.watchdog.divider", "65536", "0..65535"},
      {"slave.1.timeout.preop_ms", "0", "1..600000"},
      {"slave.1.mailbox.out_size", "8", "24..1486"},
      {"slave.1.check.revision_rule", "LIKE", "LW_EQ"},
      {"slave.1.eoe.ip", "1.2.3", "192.168.1.10"},
      {"slave.1.eoe.ip", "1.2.3.256", "192.168.1.10"},
      {"slave.1.aoe.net_id", "5.1.2.3.1", "5.1.2.3.1.1"},
      {"slave.1.soe.0", "PS 8:S-0-0001=00", "0..7"},
      {"slave.1.soe.0", "PS 0:S-9-0001=00", "IDN"},
      {"slave.1.sync_unit.inputs", "Nobody", "none"},
      {"master.task.0", "Slow", "xMULTIPLE"},
      {"master.task.0", "Slow x0", "1..1000"},
      {"master.image.alignment", "3", "1, 2, 4, 8"},
  };
  for (const auto& [key, value, explanation] : edits) {
    const Project before = project;
    const auto status = set_setting(project, key, value);
    ASSERT_FALSE(status) << key;
    EXPECT_EQ(status.error().subject, key);
    EXPECT_THAT(status.error().detail.text(), HasSubstr(explanation));
    EXPECT_EQ(project, before);
  }
}

}  // namespace
}  // namespace syncline
