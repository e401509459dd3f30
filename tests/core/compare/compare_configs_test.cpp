// SPDX-License-Identifier: Apache-2.0
#include "compare/compare_configs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "compare/compare_run_time.h"
#include "compare/network_compare.h"
#include "compile/compile.h"
#include "support/random_project.h"
#include "tests/support/sample_devices.h"

namespace syncline {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Group = DifferenceGroup;

/// Coupler, input, output, two drives.
Project machine() {
  Project project = sample::project(
      {sample::coupler(), sample::digital_input(), sample::digital_output(), sample::servo(), sample::servo()});
  project.master.dc.dcm.mode = DcmMode::kBusShift;
  return project;
}

NetworkConfig config(const Project& project) { return compile(project)->config; }

std::vector<std::string> words(const std::vector<ConfigDifference>& differences) {
  std::vector<std::string> out;
  for (const auto& difference : differences) out.push_back(describe(difference));
  return out;
}

struct Edit {
  Group group;
  std::string words;  // part of the one line that names it
  std::function<void(Project&)> apply;
};

std::vector<Edit> edits() {
  return {
      {Group::kClocks, "slave 3 (Slave_1004 [SV402]): SYNC0 cycle 1 ms -> 2 ms",
       [](Project& p) { p.slaves[3].dc.sync0.cycle_factor = 2; }},
      {Group::kClocks, "SYNC0 shift 0 ns -> 30 us", [](Project& p) { p.slaves[3].dc.sync0.shift = 30'000; }},
      {Group::kClocks, "slave 4 (Slave_1005 [SV402]): distributed clocks yes -> no",
       [](Project& p) { p.slaves[4].dc.op_mode = ""; }},
      {Group::kClocks, "reference clock yes -> no", [](Project& p) { p.master.dc.reference_clock = 4; }},
      {Group::kClocks, "network: bus shift (APWR 0x0910) only in the first",
       [](Project& p) { p.master.dc.dcm.mode = DcmMode::kMasterShift; }},
      {Group::kClocks, "sync window (BRD 0x092C) only in the",
       [](Project& p) { p.master.dc.sync_window.enabled = !p.master.dc.sync_window.enabled; }},
      {Group::kClocks, "drift compensation (ARMW 0x0910) 4 bytes",
       [](Project& p) { p.master.dc.show_64bit_system_time = true; }},
      {Group::kCyclic, "network: cycle time 1 ms -> 2 ms", [](Project& p) { p.master.cycle_time = 2 * kMillisecond; }},
      {Group::kCyclic, "LRW", [](Project& p) { p.master.overlap_process_data = false; }},
      {Group::kProcessData, "slave 3 (Slave_1004 [SV402]): SM2 PDOs 0x1600 -> 0x1600 0x1601",
       [](Project& p) {
         p.slaves[3].assigned_rx_pdos = {0x1600, 0x1601};
       }},
      {Group::kProcessData, "PDO 0x1601 0x60ff:00/32 -> 0x60ff:00/16",
       [](Project& p) {
         p.slaves[3].assigned_rx_pdos = {0x1600, 0x1601};
         Pdo pdo = p.slaves[3].device.rx_pdos[1];
         pdo.entries[0].bit_length = 16;
         p.slaves[3].changed_pdos = {pdo};
       }},
      {Group::kStartup, "start-up command 0x60C2:01 (PS) only in the first",
       [](Project& p) { p.slaves[3].startup.clear(); }},
      {Group::kStartup, "start-up command 0x2000:01 (PS) only in the second: 07",
       [](Project& p) {
         StartupCommand command;
         command.index = 0x2000;
         command.sub_index = 1;
         command.data = {7};
         p.slaves[3].startup.push_back(command);
       }},
      {Group::kSlaves, "slave 1 (Slave_1002 [SI1002]): removed",
       [](Project& p) {
         p.slaves.erase(p.slaves.begin() + 1);
         p.slaves[1].previous = PreviousPort{0, 1};
         p.slaves[2].previous = PreviousPort{1, 1};
         p.slaves[3].previous = PreviousPort{2, 1};
       }},
      {Group::kSlaves, "slave 5 (Slave_1006 [SV402]): added",
       [](Project& p) { p.slaves.push_back(sample::slave(sample::servo(), 5)); }},
      {Group::kSlaves, "revision 0x00010002 -> 0x00010003",
       [](Project& p) { p.slaves[3].device.identity.revision_no = 0x10003; }},
      {Group::kSlaves, "device 0x000005ec:0x00000402 -> 0x000005ec:0x00000403",
       [](Project& p) { p.slaves[3].device.identity.product_code = 0x403; }},
      {Group::kSlaves, "station address 1005 -> 2000", [](Project& p) { p.slaves[4].station_address = 2000; }},
      {Group::kWiring, "hangs on port B of slave 3 (Slave_1004 [SV402]) -> port C of slave 0 (Slave_1001 [SC1100])",
       [](Project& p) {
         p.slaves[4].previous = PreviousPort{0, 2};
       }},
      {Group::kWiring, "alias 0 -> 7", [](Project& p) { p.slaves[4].alias = 7; }},
      {Group::kMailbox, "mailbox for requests 128 bytes at 0x1000 -> 100 bytes at 0x1000",
       [](Project& p) { p.slaves[3].device.sync_managers[0].default_size = 100; }},
      {Group::kMailbox, "mailbox protocols CoE FoE -> CoE",
       [](Project& p) { p.slaves[3].device.mailbox->foe = false; }},
      {Group::kCommands, "time-out to PREOP 3000 ms -> 4000 ms",
       [](Project& p) { p.slaves[3].device.timeouts.preop = 4000; }},
      {Group::kCommands, "0x0420", [](Project& p) { p.slaves[3].device.reg_0420 = 2000; }},
      {Group::kCommands, "init command", [](Project& p) { p.slaves[3].check.revision = true; }},
      {Group::kMaster, "source address", [](Project& p) { p.master.source_mac[5] = 1; }},
  };
}

TEST(CompareConfigs, NothingDiffersFromItself) {
  const NetworkConfig same = config(machine());
  EXPECT_THAT(words(compare_configs(same, same)), IsEmpty());
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const auto compiled = compile(test::RandomProject(seed).project());
    if (!compiled) continue;
    EXPECT_THAT(words(compare_configs(compiled->config, compiled->config)), IsEmpty()) << seed;
  }
}

TEST(CompareConfigs, EachSettingIsNamedInItsGroupAndBothWays) {
  const NetworkConfig before = config(machine());
  for (const Edit& edit : edits()) {
    Project edited = machine();
    edit.apply(edited);
    const NetworkConfig after = config(edited);
    const auto differences = compare_configs(before, after);
    EXPECT_THAT(words(differences), Contains(HasSubstr(edit.words))) << edit.words;
    for (const auto& difference : differences) {
      if (describe(difference).find(edit.words) == std::string::npos) continue;
      EXPECT_EQ(difference.group, edit.group) << edit.words;
    }
    EXPECT_FALSE(compare_configs(after, before).empty()) << edit.words;
  }
}

TEST(CompareConfigs, WhatFollowsFromASettingIsNotToldAgain) {
  Project edited = machine();
  edited.slaves[3].dc.sync0.shift = 30'000;
  EXPECT_THAT(words(compare_configs(config(machine()), config(edited))),
              ElementsAre("slave 3 (Slave_1004 [SV402]): SYNC0 shift 0 ns -> 30 us"));
  edited = machine();
  edited.slaves[3].device.timeouts.preop = 4000;
  EXPECT_THAT(words(compare_configs(config(machine()), config(edited))),
              ElementsAre("slave 3 (Slave_1004 [SV402]): time-out to PREOP 3000 ms -> 4000 ms"));
}

TEST(CompareConfigs, WhatNoEniCarriesIsComparedBetweenProjects) {
  Project edited = machine();
  edited.master.dc.dcm.in_sync_limit = 12'345;
  edited.master.recovery.automatic = false;
  edited.master.dc.sync_window.enabled = !edited.master.dc.sync_window.enabled;  // stands in the commands
  EXPECT_THAT(words(compare_run_time(machine(), machine())), IsEmpty());
  const auto found = words(compare_run_time(machine(), edited));
  EXPECT_EQ(found.size(), 2U);
  EXPECT_THAT(found, Contains(AllOf(HasSubstr("master.dc.in_sync_limit_ns"), HasSubstr("-> 12345"))));
  EXPECT_THAT(found, Contains(HasSubstr("master.recovery.automatic")));
}

TEST(CompareConfigs, SpellingDoesNotCount) {
  const NetworkConfig before = config(machine());
  NetworkConfig after = before;
  after.master.name = "other";
  for (auto& slave : after.slaves) {
    for (auto& cmd : slave.init_cmds) cmd.comment = "other";
    for (auto& pdo : slave.pdos) pdo.pdo.name = "other";
    slave.physics = "KK";
  }
  for (auto& variable : after.image.inputs) variable.name += "?";
  for (auto& cmd : after.cyclic[0].frames[0].commands) cmd.comment = "other";
  EXPECT_THAT(words(compare_configs(before, after)), IsEmpty());
}

/// Its variables carry its name; one that has another name by itself is found by no application.
TEST(CompareConfigs, ASlaveOfAnotherNameTakesItsVariablesAlong) {
  const Project before = machine();
  Project after = before;
  after.slaves[3].name = "Axis";
  const auto renamed = config(after);
  EXPECT_THAT(words(compare_configs(config(before), renamed)), IsEmpty());
  auto odd = renamed;
  odd.image.inputs[0].name += "?";
  EXPECT_THAT(words(compare_configs(config(before), odd)), ElementsAre(HasSubstr("name of the variable")));
}

TEST(CompareConfigs, OneMoreSlaveInFrontIsOneDifferenceOfTheSlaves) {
  Project before = machine();
  for (auto& slave : before.slaves) slave.name = "unit " + std::to_string(slave.station_address);
  Project after = before;
  after.slaves.insert(after.slaves.begin() + 1, sample::slave(sample::digital_input(), 1));
  after.slaves[1].name = "new";
  for (std::size_t i = 1; i < after.slaves.size(); ++i) {
    after.slaves[i].station_address = static_cast<std::uint16_t>(1001 + i);
    after.slaves[i].previous = PreviousPort{static_cast<std::uint16_t>(i - 1), 1};
  }
  int slaves = 0;
  for (const auto& difference : compare_configs(config(before), config(after))) {
    // The frames grow with it, and the old second slave hangs on the new one.
    const bool follows =
        difference.group == Group::kCyclic || difference.group == Group::kImage || difference.group == Group::kWiring;
    if (!follows) {
      ++slaves;
      EXPECT_EQ(describe(difference), "slave 1 (new): added only in the second: 0x000005ec:0x00001002:0x00010000");
    }
  }
  EXPECT_EQ(slaves, 1);
}

TEST(CompareConfigs, AMovedSlaveIsFoundAgain) {
  Project before = machine();
  Project after = before;
  std::rotate(after.slaves.begin() + 1, after.slaves.begin() + 2, after.slaves.end());  // the input goes to the end
  for (std::size_t i = 1; i < after.slaves.size(); ++i) {
    after.slaves[i].previous = PreviousPort{static_cast<std::uint16_t>(i - 1), 1};
  }
  const auto found = words(compare_configs(config(before), config(after)));
  EXPECT_THAT(found, Contains("slave 1, now 4 (Slave_1002 [SI1002]): place 1 -> 4"));
  EXPECT_THAT(found, testing::Not(Contains(AllOf(HasSubstr("added")))));
  EXPECT_THAT(found, testing::Not(Contains(AllOf(HasSubstr("removed")))));
}

TEST(CompareNetworks, LongListsOfNothingInCommonEnd) {
  NetworkConfig left, right;
  left.slaves.resize(1);
  right.slaves.resize(1);
  for (std::uint16_t i = 0; i < 20'000; ++i) {
    InitCmd cmd;
    cmd.command = Command::kFpwr;
    cmd.ado = i;
    left.slaves[0].init_cmds.push_back(cmd);
    cmd.ado = static_cast<std::uint16_t>(40'000 + i);
    right.slaves[0].init_cmds.push_back(cmd);
  }
  EXPECT_EQ(compare_networks(left, right).size(), 40'000U);
}

}  // namespace
}  // namespace syncline
