// SPDX-License-Identifier: Apache-2.0
#include "settings/settings_keys.h"
#include "config/startup_messages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "settings/settings_doc.h"
#include "support/random_project.h"
#include "tests/support/modular_device.h"
#include "tests/support/sample_devices.h"
#include "tests/support/source_dir.h"

namespace syncline {
namespace {

using ::testing::HasSubstr;

Project random_project(std::uint32_t seed) { return test::RandomProject(seed).project(); }

TEST(SettingsKeys, SettingWhatIsReadChangesNothing) {
  EXPECT_TRUE(rc::check([](std::uint32_t seed) {
    const Project before = random_project(seed);
    Project project = before;
    for (const auto& setting : list_settings(before)) {
      const auto read = get_setting(before, setting.key);
      RC_ASSERT(read.has_value());
      RC_ASSERT(*read == setting.value);
      const auto status = set_setting(project, setting.key, *read);
      if (!status) RC_FAIL(setting.key + "=" + *read + ": " + status.error().detail.text());
      RC_ASSERT(project == before);
    }
  }));
}

/// Were a field without a key, the copy would keep its default there.
TEST(SettingsKeys, TheKeysCarryEveryFieldOfAProject) {
  EXPECT_TRUE(rc::check([](std::uint32_t seed) {
    const Project original = random_project(seed);
    Project copy;
    copy.views = original.views;  // what the monitor draws is no setting
    for (const auto& slave : original.slaves) {
      copy.slaves.push_back(default_slave(slave.device, static_cast<std::uint16_t>(copy.slaves.size())));
      copy.slaves.back().startup.clear();
      copy.slaves.back().soe_startup.clear();
      for (const auto& protocol : kMessageProtocols) (copy.slaves.back().*protocol.startup).clear();
    }
    for (const auto& setting : list_settings(original)) {
      const auto status = set_setting(copy, setting.key, setting.value);
      if (!status) RC_FAIL(setting.key + "=" + setting.value + ": " + status.error().detail.text());
    }
    RC_ASSERT(copy == original);
  }));
}

TEST(SettingsKeys, EveryListedKeyIsDescribedOnce) {
  std::set<std::string> described;
  for (const auto& description : setting_descriptions()) {
    EXPECT_TRUE(described.insert(description.key).second) << description.key;
    EXPECT_FALSE(description.type.empty() || description.range.empty() || description.meaning.empty())
        << description.key;
  }
  for (const auto& setting : list_settings(random_project(7))) {
    auto key = std::regex_replace(setting.key, std::regex("^slave\\.[0-9]+"), "slave.N");
    key = std::regex_replace(key, std::regex("\\.0x[0-9a-f]+"), ".0xIIII");
    key = std::regex_replace(key, std::regex("(startup|register|task|sync_unit|soe|module|output_pin|IIII)\\.[0-9]+"),
                             "$1.K");
    EXPECT_TRUE(described.contains(key)) << setting.key;
  }
}

TEST(SettingsKeys, TheDocumentationListsThemAsTheyAre) {
  const auto path = std::filesystem::path(test::source_dir()) / "docs/project-keys.md";
  std::ostringstream content;
  content << std::ifstream(path).rdbuf();
  auto text = content.str();
  const auto from = text.find("| key |"), behind = text.find("\n\n", from);
  ASSERT_NE(from, std::string::npos);
  const auto table = settings::settings_table_text();
  if (std::getenv("SYNCLINE_WRITE_GOLDEN") != nullptr) {
    text.replace(from, behind + 1 - from, table);
    std::ofstream(path) << text;
  }
  EXPECT_THAT(text, HasSubstr(table)) << "SYNCLINE_WRITE_GOLDEN=1 test_settings writes it";
}

Project servo_project() {
  Project project;
  DeviceDescription device = sample::digital_output();
  device.type = "Servo";
  device.mailbox.emplace().coe.emplace().pdo_config = true;
  device.mailbox->eoe = true;
  device.rx_pdos = {sample::pdo(0x1600, "A", 2, {{0x6040, 0, 16, "Control word", "UINT"}}),
                    sample::pdo(0x1601, "B", std::nullopt, {{0x607A, 0, 32, "Target", "DINT"}}),
                    sample::pdo(0x1602, "C", std::nullopt, {{0x6060, 0, 8, "Mode", "SINT"}})};
  device.rx_pdos[1].exclude = {0x1600};
  device.rx_pdos[1].fixed = false;
  DcOpMode sync{"DCSYNC0", "", 0x0300, {}, {}, {}, {}, {{2, std::nullopt, {0x1601, 0x1602}}}};
  device.dc.emplace().op_modes = {{"FREE", "", 0, {}, {}, {}, {}, {}}, sync};
  project.slaves = {default_slave(device, 0), default_slave(device, 1)};
  return project;
}

struct BadEdit {
  const char* key;
  const char* value;
  ErrorCode code;
  const char* explanation;
};

TEST(SettingsKeys, BadEditsSayWhyAndChangeNothing) {
  constexpr auto kKey = ErrorCode::kUnknownKey, kValue = ErrorCode::kBadValue;
  const BadEdit edits[] = {
      {"", "1", kKey, ""},
      {"master", "1", kKey, ""},
      {"master.name.", "1", kKey, ""},
      {"master.nothing", "1", kKey, ""},
      {"slave.2.name", "x", kKey, "project: 2"},
      {"slave.-1.name", "x", kKey, ""},
      {"slave.N.name", "x", kKey, ""},
      {"slave.0.startup.1", "PS 0x6060:00=08", kKey, "item"},
      {"slave.0.pdo.map.0x1999", "", kKey, "item"},
      {"master.name", "", kValue, "empty"},
      {"master.name", "a\nb", kValue, "printable"},
      {"master.name", "\xFF", kValue, "UTF-8"},
      {"master.cycle_time_us", "31.2", kValue, "31.25..100000"},
      {"master.cycle_time_us", "1000.0001", kValue, "three decimals"},
      {"master.cycle_time_us", "1e3", kValue, "microseconds"},
      {"master.dc.mode", "sideways", kValue, "bus-shift"},
      {"master.dc.reference_clock", "2", kValue, "no slave at position 2"},
      {"master.dc.sync_window", "perhaps", kValue, "on nor off"},
      {"master.dc.sync_window_exponent", "31", kValue, "1..30"},
      {"master.source_mac", "01:02:03:04:05", kValue, "address"},
      {"slave.0.station_address", "65536", kValue, "1..65535"},
      {"slave.0.station_address", "12x", kValue, "whole number"},
      {"slave.0.dc.op_mode", "DC", kValue, "off, FREE, DCSYNC0"},
      {"slave.0.dc.sync0.factor", "0", kValue, "factor 0"},
      {"slave.1.previous", "1:B", kValue, "another slave"},
      {"slave.1.previous", "0:E", kValue, "POSITION:PORT"},
      {"slave.0.pdo.rx", "0x1600,0x1700", kValue, "no PDO 0x1700"},
      {"slave.0.pdo.rx", "0x1602,0x1602", kValue, "twice"},
      {"slave.0.pdo.rx", "0x1600,0x1601", kValue, "exclude each other"},
      {"slave.0.pdo.rx", "0x1600,", kValue, "no PDO index"},
      {"slave.0.pdo.map.0x1600", "0x6040:00:8", kValue, "fixed"},
      {"slave.0.pdo.map.0x1601", "0x607a:00:0", kValue, "INDEX:SUB:BITS"},
      {"slave.0.startup.0", "PS", kValue, "INDEX:SUB=DATA"},
      {"slave.0.startup.0", "XX 0x6060:00=08", kValue, "transition"},
      {"slave.0.startup.0", "PS 0x6060:00=8", kValue, "hexadecimal"},
      {"slave.0.startup.0", "PS 0x6060:00=08 soon", kValue, "timeout=MS"},
      {"slave.0.foe.startup.0", "PS data=02", kValue, "no FoE mailbox"},
      {"slave.0.voe.startup.0", "PS data=0200", kValue, "no VoE mailbox"},
      {"slave.0.aoe.startup.1", "PS data=02", kKey, "item"},
      {"slave.0.eoe.startup.0", "PS 0200", kValue, "data=HEX"},
      {"slave.0.eoe.startup.0", "PS data=020", kValue, "hexadecimal"},
      {"slave.0.eoe.startup.0", "PS data=0200 soon", kValue, "fixed, off, timeout=MS"},
      {"slave.0.eoe.startup.0", "PX data=0200", kValue, "transition"},
      {"slave.0.register.0", "PS poke 0x0120=01", kValue, "neither write nor read"},
      {"slave.0.register.0", "PS write 0x0120", kValue, "REGISTER=DATA"},
      {"slave.0.register.0", "PS write 0x0120=", kValue, "REGISTER=DATA"},
      {"slave.0.register.0", "PS write 0xffff=0102", kValue, "REGISTER=DATA"},
      {"slave.0.register.0", "PS read 0x0130=0102", kValue, "REGISTER*BYTES"},
      {"slave.0.register.0", "PS read 0x0130*0", kValue, "REGISTER*BYTES"},
      {"slave.0.register.0", "PS read 0x0130*1487", kValue, "REGISTER*BYTES"},
      {"slave.0.register.0", "PS read 0x0130*2 expect=01", kValue, "as many bytes as it reads"},
      {"slave.0.register.0", "PS read 0x0130*2 mask=0100", kValue, "only a read expects"},
      {"slave.0.register.0", "PS write 0x0130=01 expect=01", kValue, "only a read expects"},
      {"slave.0.register.0", "PS read 0x0130*2 within=-1", kValue, "within=MS"},
      {"slave.0.register.0", "PS write 0x0130=01 after", kValue, "only commands of the master"},
      {"master.register.0", "PS write 0x0130=01 before", kValue, "after"},
  };
  const Project before = servo_project();
  for (const auto& edit : edits) {
    Project project = before;
    const auto status = set_setting(project, edit.key, edit.value);
    ASSERT_FALSE(status) << edit.key << "=" << edit.value;
    EXPECT_EQ(status.error().code, edit.code) << edit.key << "=" << edit.value;
    EXPECT_EQ(status.error().subject, edit.key);
    EXPECT_THAT(status.error().detail.text(), HasSubstr(edit.explanation)) << edit.key << "=" << edit.value;
    EXPECT_EQ(project, before) << edit.key;
  }
}

TEST(SettingsKeys, MicrosecondsAreExact) {
  Project project;
  ASSERT_TRUE(set_setting(project, "master.cycle_time_us", "31.25"));
  EXPECT_EQ(project.master.cycle_time, 31'250);
  EXPECT_EQ(get_setting(project, "master.cycle_time_us"), "31.25");
  project = servo_project();
  ASSERT_TRUE(set_setting(project, "slave.0.dc.sync0.shift_us", "-0.05"));
  EXPECT_EQ(project.slaves[0].dc.sync0.shift, -50);
  EXPECT_EQ(get_setting(project, "slave.0.dc.sync0.shift_us"), "-0.05");
  ASSERT_TRUE(set_setting(project, "slave.0.dc.sync0.shift_us", "auto"));
  EXPECT_EQ(project.slaves[0].dc.sync0.shift, std::nullopt);
}

TEST(SettingsKeys, OperationModeBringsItsPdos) {
  Project project = servo_project();
  EXPECT_EQ(get_setting(project, "slave.0.dc.op_mode"), "FREE");
  EXPECT_EQ(get_setting(project, "slave.0.pdo.rx"), "0x1600");
  ASSERT_TRUE(set_setting(project, "slave.0.dc.op_mode", "DCSYNC0"));
  EXPECT_EQ(get_setting(project, "slave.0.pdo.rx"), "0x1601,0x1602");
  ASSERT_TRUE(set_setting(project, "slave.0.pdo.rx", "0x1602"));
  ASSERT_TRUE(set_setting(project, "slave.0.dc.op_mode", "off"));
  EXPECT_EQ(project.slaves[0].dc.op_mode, "");
  EXPECT_EQ(get_setting(project, "slave.0.pdo.rx"), "0x1602") << "no mode, no wish";
}

TEST(SettingsKeys, ChangedMappingTakesNamesFromTheDeviceAndGoesWhenItIsTheDevicesOwn) {
  Project project = servo_project();
  ASSERT_TRUE(set_setting(project, "slave.0.pdo.map.0x1601", "0x607a:00:32,0x6060:00:8,0x0000:00:8"));
  ASSERT_EQ(project.slaves[0].changed_pdos.size(), 1U);
  const auto& entries = project.slaves[0].changed_pdos[0].entries;
  EXPECT_EQ(entries[0], (PdoEntry{0x607A, 0, 32, "Target", "DINT"}));
  EXPECT_EQ(entries[1], (PdoEntry{0x6060, 0, 8, "Mode", "SINT"}));
  EXPECT_EQ(entries[2], (PdoEntry{0, 0, 8, "", ""}));
  EXPECT_TRUE(project.slaves[1].changed_pdos.empty());
  ASSERT_TRUE(set_setting(project, "slave.0.pdo.map.0x1601", "0x607a:00:32"));
  EXPECT_TRUE(project.slaves[0].changed_pdos.empty());
}

TEST(SettingsKeys, StartupListGrowsChangesAndShrinks) {
  Project project = servo_project();
  ASSERT_TRUE(set_setting(project, "slave.0.startup.0", "PS,SO 0x6060:00=08 off timeout=500 # CSP # mode"));
  ASSERT_TRUE(set_setting(project, "slave.0.startup.1", "PS 0x1c12:00=0100001600 complete fixed"));
  const auto& startup = project.slaves[0].startup;
  ASSERT_EQ(startup.size(), 2U);
  EXPECT_EQ(startup[0], (StartupCommand{.transitions = {Transition::kPS, Transition::kSO},
                                        .index = 0x6060,
                                        .sub_index = 0,
                                        .data = {8},
                                        .enabled = false,
                                        .timeout_ms = 500,
                                        .comment = "CSP # mode"}));
  EXPECT_EQ(get_setting(project, "slave.0.startup.1"), "PS 0x1c12:00=0100001600 complete fixed");
  ASSERT_TRUE(set_setting(project, "slave.0.startup.0", ""));
  ASSERT_EQ(startup.size(), 1U);
  EXPECT_EQ(startup[0].index, 0x1C12);
}

TEST(SettingsKeys, AKeyPlugsAModule) {
  Project project;
  project.slaves = {default_slave(sample::gateway(), 0)};
  ASSERT_TRUE(set_setting(project, "slave.0.module.3", "0x200"));
  EXPECT_EQ(get_setting(project, "slave.0.module.3"), "0x00000200");
  EXPECT_EQ(get_setting(project, "slave.0.pdo.map.0x1621"), "0x8000:01:8");
  EXPECT_EQ(set_setting(project, "slave.0.module.4", "none").error().code, ErrorCode::kUnknownKey);
  EXPECT_THAT(set_setting(project, "slave.0.module.3", "x").error().detail.text(), HasSubstr("neither none nor"));
}

}  // namespace
}  // namespace syncline
