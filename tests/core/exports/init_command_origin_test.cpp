// SPDX-License-Identifier: Apache-2.0
#include "exports/init_command_origin.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "compile/compile.h"
#include "config/project.h"
#include "exports/init_commands.h"
#include "tests/support/talkative_machine.h"

namespace syncline::exports {
namespace {

using enum InitCommandOrigin;

InitCommandRow row_of(const char* protocol, std::uint32_t address, std::uint8_t sub_index = 0) {
  InitCommandRow row;
  row.slave = 0;
  row.protocol = protocol;
  row.address = address;
  row.sub_index = sub_index;
  return row;
}

/// A drive with an ESI that brings its mode of operation.
Project drive() {
  Project project;
  auto& slave = project.slaves.emplace_back();
  StartupCommand mode;
  mode.index = 0x6060;
  mode.data = {8};
  slave.device.mailbox.emplace().coe.emplace().init_commands = {mode};
  slave.startup = {mode};
  return project;
}

TEST(InitCommandOrigin, OfRegistersIsThePartOfTheEsc) {
  const auto project = drive();
  const std::pair<std::uint32_t, InitCommandOrigin> known[] = {
      {0x0010, kAddresses},   {0x0120, kStateMachine}, {0x0130, kStateMachine}, {0x0300, kPorts},  {0x0420, kWatchdogs},
      {0x0502, kDeviceCheck}, {0x0600, kFmmus},        {0x0810, kSyncManagers}, {0x09A0, kClocks}, {0x0F00, kSettings}};
  for (const auto& [address, origin] : known) EXPECT_EQ(origin_of(row_of("ESC", address), project), origin) << address;
  auto of_all = row_of("ESC", 0x0120);
  of_all.slave = -1;
  EXPECT_EQ(origin_of(of_all, project), kStateMachine);
}

TEST(InitCommandOrigin, TellsTheEsisCommandsFromTheUsers) {
  auto project = drive();
  EXPECT_EQ(origin_of(row_of("CoE", 0x6060), project), kEsi);
  project.slaves[0].startup[0].data = {7};
  EXPECT_EQ(origin_of(row_of("CoE", 0x6060), project), kStartup) << "the user has changed it";
  EXPECT_EQ(origin_of(row_of("CoE", 0x6060, 1), project), kSettings) << "nobody's list has it";
}

TEST(InitCommandOrigin, OfPdosIsTheirAssignmentUnlessTheUserWroteThem) {
  auto project = drive();
  EXPECT_EQ(origin_of(row_of("CoE", 0x1C12), project), kPdoAssignment);
  EXPECT_EQ(origin_of(row_of("CoE", 0x1A01, 3), project), kPdoMapping);
  EXPECT_EQ(origin_of(row_of("CoE", 0x1C32, 2), project), kSettings) << "synchronisation, and no PDO";
  StartupCommand own;
  own.index = 0x1C12;
  project.slaves[0].startup.push_back(own);
  EXPECT_EQ(origin_of(row_of("CoE", 0x1C12), project), kStartup);
}

/// A whole machine: messages of the ESI, the user's own ones, and what the compiler adds.
TEST(InitCommandOrigin, OfAMachineSaysWhoseEachCommandIs) {
  using sample::set_own;
  auto project = sample::talkative_machine();
  set_own(project, "slave.1.aoe.startup.1", "SO data=aabb # own message");
  set_own(project, "slave.1.register.0", "PS write 0x09a8=0101 # own register");
  set_own(project, "master.register.0", "IP write 0x0101=01 # own broadcast");
  const auto config = compile(project).value().config;
  std::map<std::string, InitCommandOrigin> origins;
  for (const auto& row : init_commands(config)) origins[row.comment] = origin_of(row, project);
  EXPECT_EQ(origins["from the ESI"], kEsi);
  EXPECT_EQ(origins["own message"], kStartup);
  EXPECT_EQ(origins["own register"], kOwn);
  EXPECT_EQ(origins["own broadcast"], kOwn);
  EXPECT_EQ(origins["count slaves"], kStateMachine);
}

}  // namespace
}  // namespace syncline::exports
