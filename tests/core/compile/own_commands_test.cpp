// SPDX-License-Identifier: Apache-2.0
// Start-up messages and register commands of the user's own: from a key of the settings to the configuration, in their
// place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "compile/compile.h"
#include "config/project.h"
#include "config/startup_messages.h"
#include "config/startup_origin.h"
#include "tests/support/talkative_machine.h"

namespace syncline {
namespace {

using sample::set_own;
using sample::talkative_machine;
using sample::talkative_servo;
using testing::ElementsAre;
using testing::IsEmpty;

const MailboxConfig& own_mailbox_of(const CompileResult& result) { return *result.config.slaves[1].mailbox; }

TEST(OwnCommands, MessagesOfTheEsiComeFirstAndCanBeTakenOut) {
  auto project = talkative_machine();
  set_own(project, "slave.1.aoe.startup.1", "SO data=aabb fixed timeout=70 # own");
  set_own(project, "slave.1.foe.startup.0", "PS data=0200 off");
  const auto compiled = compile(project).value();
  const auto& aoe = own_mailbox_of(compiled).aoe_commands;
  ASSERT_EQ(aoe.size(), 2U);
  EXPECT_TRUE(is_from_esi(aoe[0], project.slaves[1].device, MailboxType::kAoe));
  EXPECT_THAT(aoe[1].data, ElementsAre(0xAA, 0xBB));
  EXPECT_THAT(aoe[1].transitions, ElementsAre(Transition::kSO));
  EXPECT_TRUE(aoe[1].fixed);
  EXPECT_EQ(aoe[1].timeout_ms, 70U);
  EXPECT_EQ(aoe[1].comment, "own");
  ASSERT_EQ(own_mailbox_of(compiled).foe_commands.size(), 1U);
  EXPECT_FALSE(own_mailbox_of(compiled).foe_commands[0].enabled);
  set_own(project, "slave.1.aoe.startup.0", "");
  EXPECT_EQ(own_mailbox_of(compile(project).value()).aoe_commands.size(), 1U);
}

/// The address that the user gives replaces the ESI's; a message that the user wrote stays, whatever it sets.
TEST(OwnCommands, AnAddressReplacesTheOneOfTheEsiOnly) {
  auto project = talkative_machine();
  const auto& eoe = [&] { return own_mailbox_of(compile(project).value()).eoe_commands; };
  EXPECT_EQ(eoe().at(0).data, (std::vector<std::uint8_t>{2, 0, 0, 0, 2, 0, 0, 0, 10, 0, 0, 1}));
  set_own(project, "slave.1.eoe.ip", "192.168.1.10");
  ASSERT_EQ(eoe().size(), 1U);
  EXPECT_EQ(eoe()[0].comment, "set IP parameter");
  set_own(project, "slave.1.eoe.startup.0", "IP data=0200000002000000 # mine");
  ASSERT_EQ(eoe().size(), 2U);
  EXPECT_EQ(eoe()[0].comment, "mine");
}

std::vector<std::string> own_at_transition(const std::vector<InitCmd>& commands, Transition transition) {
  std::vector<std::string> comments;
  for (const auto& command : commands) {
    if (std::ranges::find(command.transitions, transition) != command.transitions.end())
      comments.push_back(command.ado == 0x0120 ? "state" : command.comment);
  }
  return comments;
}

TEST(OwnCommands, RegistersAreWrittenBeforeTheStateIsAskedFor) {
  auto project = talkative_machine();
  set_own(project, "slave.1.register.0", "PS,SO write 0x09a8=0101 # latch");
  set_own(project, "slave.1.register.1", "PS read 0x0f10*2 expect=0800 mask=0f00 within=500 # inputs");
  set_own(project, "slave.1.register.2", "PS write 0x0f10=00 off # not sent");
  const auto config = compile(project).value().config;
  const auto& commands = config.slaves[1].init_cmds;
  for (const auto transition : {Transition::kPS, Transition::kSO}) {
    const auto order = own_at_transition(commands, transition);
    const auto own = std::ranges::find(order, "latch"), state = std::ranges::find(order, "state");
    ASSERT_NE(own, order.end());
    EXPECT_LT(own, state);
    EXPECT_EQ(std::ranges::count(order, "not sent"), 0);
  }
  const auto latch = std::ranges::find(commands, "latch", &InitCmd::comment);
  EXPECT_EQ(latch->command, Command::kFpwr);
  EXPECT_EQ(latch->adp, project.slaves[1].station_address);
  EXPECT_EQ(latch->ado, 0x09A8);
  EXPECT_THAT(latch->data, ElementsAre(1, 1));
  EXPECT_EQ(latch->expected_wkc, 1);
  const auto inputs = std::ranges::find(commands, "inputs", &InitCmd::comment);
  EXPECT_EQ(inputs->command, Command::kFprd);
  EXPECT_THAT(inputs->data, ElementsAre(0, 0));
  ASSERT_TRUE(inputs->validate);
  EXPECT_THAT(inputs->validate->data, ElementsAre(8, 0));
  EXPECT_THAT(inputs->validate->mask, ElementsAre(0x0F, 0));
  EXPECT_EQ(inputs->validate->timeout_ms, 500U);
}

TEST(OwnCommands, TheMastersGoToAllBeforeTheSlavesOrBehindThem) {
  auto project = talkative_machine();
  const auto without = compile(project).value().config.master.init_cmds;
  set_own(project, "master.register.0", "IP write 0x0101=01 # forward");
  set_own(project, "master.register.1", "SO read 0x0130*2 after # states");
  const auto all = compile(project).value().config.master.init_cmds;
  ASSERT_EQ(all.size(), without.size() + 2);
  EXPECT_TRUE(std::equal(without.begin(), without.end(), all.begin()));
  EXPECT_EQ(all[without.size()].command, Command::kBwr);
  EXPECT_TRUE(all[without.size()].before_slave);
  EXPECT_EQ(all.back().command, Command::kBrd);
  EXPECT_FALSE(all.back().before_slave);
}

std::vector<std::string> too_long(const Project& project) {
  std::vector<std::string> out;
  const auto compiled = compile(project).value();
  for (const auto& finding : compiled.findings) {
    if (finding.code == "startup-message-too-long") out.push_back(finding.place.key);
  }
  return out;
}

TEST(OwnCommands, AMessageThatDoesNotFitIsFound) {
  auto project = talkative_machine();
  project.slaves[1].mailbox.out_size = 24;
  const std::string whole = "PS data=" + std::string(2 * 18, '0');
  set_own(project, "slave.1.voe.startup.0", whole.c_str());
  EXPECT_THAT(too_long(project), IsEmpty()) << "24 bytes, 6 of them header";
  set_own(project, "slave.1.voe.startup.0", (whole + "00").c_str());
  EXPECT_THAT(too_long(project), ElementsAre("slave.1.voe.startup.0"));
  set_own(project, "slave.1.voe.startup.0", (whole + "00 off").c_str());
  EXPECT_THAT(too_long(project), IsEmpty());
}

}  // namespace
}  // namespace syncline
