// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compile/compile.h"
#include "config/command_text.h"
#include "tests/support/sample_devices.h"

namespace syncline {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Not;

/// "APWR 65535:0x0120 1100" for each command of a transition.
std::vector<std::string> lines_of(const SlaveConfig& slave, Transition transition) {
  std::vector<std::string> out;
  for (const InitCmd& cmd : slave.init_cmds) {
    if (std::ranges::find(cmd.transitions, transition) != cmd.transitions.end()) {
      out.push_back(address_text(cmd) + " " + hex_text(payload(cmd)));
    }
  }
  return out;
}

SlaveConfig compiled(const Project& project, std::size_t position, EniDialect dialect = EniDialect::kEcEngineer) {
  return compile(project, {dialect}).value().config.slaves.at(position);
}

const InitCmd& command(const SlaveConfig& slave, Transition transition, Command code, std::uint16_t ado) {
  for (const InitCmd& cmd : slave.init_cmds) {
    if (cmd.command == code && cmd.ado == ado &&
        std::ranges::find(cmd.transitions, transition) != cmd.transitions.end()) {
      return cmd;
    }
  }
  throw std::out_of_range("no such command");
}

constexpr const char* kZeros16 = "00000000000000000000000000000000";

TEST(SlaveInitCmds, BringAServoFromInitToOperational) {
  const SlaveConfig servo = compiled(sample::small_machine(), 3);
  EXPECT_THAT(lines_of(servo, Transition::kIP),
              ElementsAre("APWR 65533:0x0120 1100", "APRD 65533:0x0130 0000", "APWR 65533:0x0500 00",
                          "APWR 65533:0x0502 000108000000", "APRD 65533:0x0508 00000000",
                          "APWR 65533:0x0502 00010a000000", "APRD 65533:0x0508 00000000", "APWR 65533:0x0010 ec03",
                          "FPWR 1004:0x0400 c209", "FPWR 1004:0x0420 e803", std::string("FPWR 1004:0x0800 ") + kZeros16,
                          "FPWR 1004:0x0800 0010800026000100", "FPWR 1004:0x0808 8010800022000100",
                          "FPWR 1004:0x0980 0000", std::string("FPWR 1004:0x0810 ") + kZeros16, "FPWR 1004:0x0500 01",
                          "FPWR 1004:0x0120 1200", "FPRD 1004:0x0130 000000000000", "APWR 65533:0x0500 00"));
  EXPECT_THAT(lines_of(servo, Transition::kPS),
              ElementsAre("FPWR 1004:0x09a0 40420f0000000000", "FPWR 1004:0x0990 0000000000000000",
                          "FPWR 1004:0x0980 0003", "FPWR 1004:0x09a8 0000", "FPWR 1004:0x0810 0011060064000100",
                          "FPWR 1004:0x0818 8011080020000100", "FPWR 1004:0x0600 02000010060000070011000201000000",
                          "FPWR 1004:0x0610 02000010080000078011000101000000", "FPWR 1004:0x0120 0400",
                          "FPRD 1004:0x0130 000000000000"));
  EXPECT_THAT(lines_of(servo, Transition::kSO), ElementsAre("FPWR 1004:0x0120 0800", "FPRD 1004:0x0130 000000000000"));
}

TEST(SlaveInitCmds, TakeAServoBack) {
  const SlaveConfig servo = compiled(sample::small_machine(), 3);
  EXPECT_THAT(lines_of(servo, Transition::kOP),
              ElementsAre("FPWR 1004:0x0120 1200", std::string("FPWR 1004:0x0810 ") + kZeros16,
                          std::string("FPWR 1004:0x0600 ") + kZeros16, std::string("FPWR 1004:0x0610 ") + kZeros16,
                          "FPWR 1004:0x0980 0000", "FPRD 1004:0x0130 000000000000"));
  EXPECT_THAT(lines_of(servo, Transition::kOI),
              ElementsAre("APWR 65533:0x0120 1100", "APWR 65533:0x0980 0000", "APRD 65533:0x0130 0000",
                          std::string("FPWR 1004:0x0800 ") + kZeros16, std::string("FPWR 1004:0x0810 ") + kZeros16,
                          std::string("FPWR 1004:0x0600 ") + kZeros16, std::string("FPWR 1004:0x0610 ") + kZeros16));
  EXPECT_THAT(lines_of(servo, Transition::kOS), ElementsAre("FPWR 1004:0x0120 0400", "FPRD 1004:0x0130 000000000000"));
}

TEST(SlaveInitCmds, UseTheBootstrapMailboxOnTheWayToBoot) {
  const SlaveConfig servo = compiled(sample::small_machine(), 3);
  EXPECT_THAT(lines_of(servo, Transition::kIB), Contains("FPWR 1004:0x0800 0010000226000100"));
  EXPECT_THAT(lines_of(servo, Transition::kIB), Contains("FPWR 1004:0x0120 1300"));

  Project project = sample::small_machine();
  project.slaves[3].device.eeprom.boot_strap.clear();
  EXPECT_THAT(lines_of(compiled(project, 3), Transition::kIB), Contains("FPWR 1004:0x0800 0010800026000100"));
}

TEST(SlaveInitCmds, DoNotAcknowledgeErrorsOfAnEmulatedDevice) {
  const Project project = sample::small_machine();
  EXPECT_THAT(lines_of(compiled(project, 1), Transition::kIP), Contains("FPWR 1002:0x0120 0200"));
  EXPECT_THAT(lines_of(compiled(project, 3), Transition::kIP), Contains("FPWR 1004:0x0120 1200"));
  EXPECT_THAT(lines_of(compiled(project, 1), Transition::kSO), Contains("FPWR 1002:0x0120 0800"));
}

TEST(SlaveInitCmds, OpenAnOpOnlySyncManagerOnTheWayToOp) {
  const SlaveConfig output = compiled(sample::small_machine(), 2);
  EXPECT_THAT(lines_of(output, Transition::kSO), Contains("FPWR 1003:0x0800 000f010044000100"));
  EXPECT_THAT(lines_of(output, Transition::kPS), Not(Contains("FPWR 1003:0x0800 000f010044000100")));
  EXPECT_THAT(lines_of(output, Transition::kOS), ElementsAre("FPWR 1003:0x0800 0000000000000000",
                                                             "FPWR 1003:0x0120 0400", "FPRD 1003:0x0130 000000000000"));
}

TEST(SlaveInitCmds, MapBitsOfADigitalTerminal) {
  const SlaveConfig input = compiled(sample::small_machine(), 1);
  EXPECT_THAT(lines_of(input, Transition::kPS), Contains("FPWR 1002:0x0600 00000010010000010010000101000000"));
  const SlaveConfig output = compiled(sample::small_machine(), 2);
  EXPECT_THAT(lines_of(output, Transition::kPS), Contains("FPWR 1003:0x0600 0100001001000001000f000201000000"));
}

TEST(SlaveInitCmds, ACouplerHasStateAndIdentityCommandsOnly) {
  for (const InitCmd& cmd : compiled(sample::small_machine(), 0).init_cmds) {
    EXPECT_TRUE(cmd.ado < 0x0600) << cmd.comment;
  }
}

TEST(SlaveInitCmds, LeaveDcAloneWhereItIsOff) {
  Project project = sample::small_machine();
  project.slaves[3].dc.op_mode = "Off";
  for (const InitCmd& cmd : compiled(project, 3).init_cmds) {
    EXPECT_LT(cmd.ado, 0x0900) << cmd.comment;
  }
  project.slaves[3].dc.op_mode = "DC Sync";
  project.master.dc.enabled = false;
  for (const InitCmd& cmd : compiled(project, 3).init_cmds) {
    EXPECT_LT(cmd.ado, 0x0900) << cmd.comment;
  }
}

TEST(SlaveInitCmds, KeepAwayFromTheLatchThatBelongsToThePdi) {
  Project project = sample::small_machine();
  project.slaves[3].device.dc->op_modes[0].assign_activate = 0x0330;
  const auto start = lines_of(compiled(project, 3), Transition::kPS);
  EXPECT_THAT(start, Contains("FPWR 1004:0x0980 3003"));
  EXPECT_THAT(start, Not(Contains("FPWR 1004:0x09a8 0000")));
}

TEST(SlaveInitCmds, WriteShiftAndBothCycleTimes) {
  Project project = sample::small_machine();
  project.slaves[3].device.dc->op_modes[0].assign_activate = 0x0700;
  project.slaves[3].dc.sync0.shift = -1000;
  project.slaves[3].dc.sync1.shift = 0x1234;
  const auto start = lines_of(compiled(project, 3), Transition::kPS);
  EXPECT_THAT(start, Contains("FPWR 1004:0x09a0 40420f0034120000"));
  EXPECT_THAT(start, Contains("FPWR 1004:0x0990 18fcffffffffffff"));
}

TEST(SlaveInitCmds, TakeTimeoutsFromTheDevice) {
  Project project = sample::small_machine();
  project.slaves[3].device.timeouts = {111, 222, 333, 444};
  const SlaveConfig servo = compiled(project, 3);
  EXPECT_EQ(command(servo, Transition::kIP, Command::kFprd, 0x0130).validate->timeout_ms, 111);
  EXPECT_EQ(command(servo, Transition::kPS, Command::kFprd, 0x0130).validate->timeout_ms, 222);
  EXPECT_EQ(command(servo, Transition::kSO, Command::kFprd, 0x0130).validate->timeout_ms, 222);
  EXPECT_EQ(command(servo, Transition::kPI, Command::kAprd, 0x0130).validate->timeout_ms, 333);
  EXPECT_EQ(command(servo, Transition::kOS, Command::kFprd, 0x0130).validate->timeout_ms, 444);
  EXPECT_EQ(command(servo, Transition::kBI, Command::kAprd, 0x0130).validate->timeout_ms, 10'000);
  EXPECT_EQ(command(servo, Transition::kPS, Command::kFpwr, 0x0120).timeout_ms, 222);
}

TEST(SlaveInitCmds, CheckTheIdentityAsTheUserWants) {
  Project project = sample::small_machine();
  auto& slave = project.slaves[3];
  slave.check = {.vendor = false, .product = true, .revision = true, .serial = true};
  slave.device.identity.serial_no = 0x01020304;
  std::vector<std::string> expected;
  for (const InitCmd& cmd : compiled(project, 3).init_cmds) {
    if (cmd.ado == 0x0508) expected.push_back(hex_text(cmd.validate->data));
  }
  EXPECT_THAT(expected, ElementsAre("02040000", "02000100", "04030201"));
  slave.device.check_revision = RevisionCheck::kLowWordEqual;
  EXPECT_THAT(lines_of(compiled(project, 3), Transition::kIP), Contains("APRD 65533:0x0508 0000"));
}

TEST(SlaveInitCmds, MapTheMailboxStateFromPreop) {
  Project project = sample::project({sample::servo(), sample::servo()});
  for (auto& slave : project.slaves) slave.device.fmmus.push_back(FmmuUse::kMailboxState);
  const SlaveConfig second = compiled(project, 1);
  EXPECT_THAT(lines_of(second, Transition::kIP), Contains("FPWR 1002:0x0620 00000009010001010d08000101000000"));
  EXPECT_THAT(lines_of(second, Transition::kPI), Contains(std::string("FPWR 1002:0x0620 ") + kZeros16));
  EXPECT_EQ(second.mailbox->status_bit_address, 1);
  EXPECT_EQ(second.mailbox->poll_time_ms, std::nullopt);
}

TEST(SlaveInitCmds, TheTwinCatDialectWritesNoTimeoutsForRequests) {
  for (const InitCmd& cmd : compiled(sample::small_machine(), 3, EniDialect::kTwinCat).init_cmds) {
    EXPECT_EQ(cmd.timeout_ms, std::nullopt) << cmd.comment;
  }
}

TEST(SlaveInitCmds, OnlyRequestsOfEveryCycleTakeACycleOfTheirOwn) {
  // Commands that only prepare the next one may share its frame.
  const SlaveConfig servo = compiled(sample::small_machine(), 3);
  EXPECT_FALSE(command(servo, Transition::kIP, Command::kApwr, 0x0502).requires_cycle);
  EXPECT_TRUE(command(servo, Transition::kIP, Command::kAprd, 0x0508).requires_cycle);
  EXPECT_TRUE(command(servo, Transition::kPS, Command::kFpwr, 0x0120).requires_cycle);
  EXPECT_EQ(command(servo, Transition::kSP, Command::kFpwr, 0x0120).retries, 300);
  EXPECT_EQ(command(servo, Transition::kPS, Command::kFpwr, 0x0120).expected_wkc, 1);
}

}  // namespace
}  // namespace syncline
