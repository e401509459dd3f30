// SPDX-License-Identifier: Apache-2.0
#include "master/startup/startup_messages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "channels/command.h"
#include "channels/events/service_events.h"
#include "channels/master_channels.h"
#include "channels/snapshot.h"
#include "config/slave_settings.h"
#include "findings/error_text.h"
#include "master/master_service.h"
#include "protocol/aoe.h"
#include "protocol/eoe.h"
#include "protocol/soe.h"
#include "support/clock.h"
#include "support/simulated_network.h"

namespace syncline {
namespace {

using testing::HasSubstr;

/// A servo that knows every mailbox protocol, led to OP with messages of the test's choice.
class StartupMessagesOnBus : public testing::Test {
 protected:
  StartupMessagesOnBus() {
    auto device = test::servo();
    device.mailbox->aoe = device.mailbox->eoe = device.mailbox->soe = device.mailbox->voe = true;
    network.add(device);
    config = network.compiled();
  }
  MailboxConfig& mailbox() { return *config.slaves[0].mailbox; }
  static SoeInitCmd soe(std::uint8_t op_code, std::uint16_t idn, std::vector<std::uint8_t> data = {}) {
    SoeInitCmd command;
    command.transitions = {Transition::kPS};
    command.op_code = op_code;
    command.idn = idn;
    command.data = std::move(data);
    return command;
  }
  static MailboxInitCmd message(std::vector<std::uint8_t> data) {
    MailboxInitCmd command;
    command.transitions = {Transition::kPS};
    command.data = std::move(data);
    return command;
  }
  static std::vector<std::uint8_t> eoe_header(eoe::Kind kind) {
    eoe::Header header;
    header.kind = kind;
    header.last_fragment = true;
    return eoe::encode(header);
  }
  AlState run() {
    auto link = network.link(clock);
    MasterService service(std::move(link), clock);
    service.channels().commands.push(GoOnlineCommand{config, AlState::kOp});
    (void)service.step();
    for (const auto& event : service.channels().events.drain()) {
      if (const auto* failure = event.as<events::Failure>()) errors += describe(failure->error) + "\n";
    }
    Snapshot snapshot;
    (void)service.channels().snapshot.read(snapshot);
    return snapshot.state;
  }

  test::SimulatedNetwork network;
  NetworkConfig config;
  VirtualClock clock;
  std::string errors;
};

TEST_F(StartupMessagesOnBus, WriteIdnsThatTheDriveThenHas) {
  mailbox().soe_commands = {soe(3, 32, {11, 0}), soe(1, 32)};
  EXPECT_EQ(run(), AlState::kOp) << errors;
}

TEST_F(StartupMessagesOnBus, TellWhatTheDriveRefuses) {
  mailbox().soe_commands = {soe(1, 32)};  // nobody has written it
  EXPECT_NE(run(), AlState::kOp);
  EXPECT_THAT(errors, HasSubstr("SoE start-up message 1"));
  EXPECT_THAT(errors, HasSubstr("SoE error 0x1001"));
}

TEST_F(StartupMessagesOnBus, SetTheAddressOfEoEAndWriteByAoE) {
  auto set_ip = eoe_header(eoe::Kind::kSetIpRequest);
  set_ip.insert(set_ip.end(), {0x02, 0, 0, 0, 192, 168, 0, 7});
  mailbox().eoe_commands = {message(set_ip)};
  aoe::Header write;
  write.command = aoe::kWrite;
  write.length = 14;
  auto ads = aoe::encode(write);
  ads.insert(ads.end(), {1, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 0xAA, 0xBB});
  mailbox().aoe_commands = {message(ads)};
  mailbox().voe_commands = {message({1, 2, 3})};
  EXPECT_EQ(run(), AlState::kOp) << errors;
}

/// Register commands of the project go out in their transition, and what they expect is held against the slave.
TEST_F(StartupMessagesOnBus, OwnRegisterCommandsAreSentAndJudged) {
  RegisterCommand write, read;
  write.address = read.address = 0x0200;  // event mask, which nobody else writes at this transition
  write.data = {0x34, 0x12};
  read.read = true;
  read.data = {0, 0};
  read.expected = {0x34, 0x02};
  read.mask = {0xFF, 0x0F};
  network.project.slaves[0].register_commands = {write, read};
  network.project.master.register_commands = {write};
  config = network.compiled();
  EXPECT_EQ(run(), AlState::kOp) << errors;
  network.project.slaves[0].register_commands[1].expected = {0x35, 0x02};
  network.project.slaves[0].register_commands[1].timeout_ms = 20;
  config = network.compiled();
  EXPECT_NE(run(), AlState::kOp);
  EXPECT_FALSE(errors.empty());
}

/// As they stand in a project: the drive takes what the ENI carries, and refuses what it cannot.
TEST_F(StartupMessagesOnBus, MessagesOfTheProjectAreSent) {
  auto set_ip = message(eoe_header(eoe::Kind::kSetIpRequest));
  set_ip.data.insert(set_ip.data.end(), {0x02, 0, 0, 0, 192, 168, 0, 7});
  network.project.slaves[0].eoe_startup = {set_ip};
  network.project.slaves[0].voe_startup = {message({1, 2, 3})};
  config = network.compiled();
  EXPECT_EQ(run(), AlState::kOp) << errors;
  // The project's description knows a protocol that the drive on the bus does not.
  network.project.slaves[0].device.mailbox->foe = true;
  network.project.slaves[0].foe_startup = {message({1, 0, 0, 0, 0, 0, 'n'})};
  config = network.compiled();
  EXPECT_NE(run(), AlState::kOp);
  EXPECT_THAT(errors, HasSubstr("FoE start-up message 1"));
}

TEST_F(StartupMessagesOnBus, NameTheProtocolThatADeviceLacks) {
  network.sim.slaves[0].device.mailbox->eoe = false;
  mailbox().eoe_commands = {message(eoe_header(eoe::Kind::kSetIpRequest))};
  mailbox().eoe_commands[0].comment = "set IP parameter";
  EXPECT_NE(run(), AlState::kOp);
  EXPECT_THAT(errors, HasSubstr("EoE start-up message 1 (set IP parameter)"));
}

TEST_F(StartupMessagesOnBus, AreNotSentWhenTheyAreDisabled) {
  network.sim.slaves[0].device.mailbox->eoe = false;
  mailbox().eoe_commands = {message(eoe_header(eoe::Kind::kSetIpRequest))};
  mailbox().eoe_commands[0].enabled = false;
  EXPECT_EQ(run(), AlState::kOp) << errors;
  mailbox().eoe_commands[0].enabled = true;
  mailbox().eoe_disabled = true;
  EXPECT_EQ(run(), AlState::kOp) << errors;
}

TEST(StartupMessages, ComeInTheOrderOfTheEniAtTheirTransition) {
  MailboxConfig mailbox;
  MailboxInitCmd command;
  command.transitions = {Transition::kPS};
  command.timeout_ms = 70;
  mailbox.aoe_commands = mailbox.eoe_commands = mailbox.foe_commands = mailbox.voe_commands = {command};
  SoeInitCmd idn;
  idn.transitions = {Transition::kPS, Transition::kSO};
  idn.drive_no = 2;
  idn.idn = 0x1234;
  idn.data = {9};
  mailbox.soe_commands = {idn};
  const auto messages = startup_messages(mailbox, Transition::kPS);
  ASSERT_EQ(messages.size(), 5U);
  const MailboxType order[] = {MailboxType::kAoe, MailboxType::kEoe, MailboxType::kSoe, MailboxType::kFoe,
                               MailboxType::kVoe};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(messages[i].type, order[i]);
    EXPECT_EQ(messages[i].answered, order[i] != MailboxType::kVoe);
    EXPECT_EQ(messages[i].timeout_ms, order[i] == MailboxType::kSoe ? 0U : 70U);
  }
  EXPECT_THAT(messages[2].data, testing::ElementsAre(0x43, 0x40, 0x34, 0x12, 9));
  EXPECT_EQ(startup_messages(mailbox, Transition::kSO).size(), 1U);
  EXPECT_TRUE(startup_messages(mailbox, Transition::kIP).empty());
}

TEST(StartupMessages, IpParametersWithoutAHeaderGetOne) {
  MailboxConfig mailbox;
  MailboxInitCmd command;
  command.transitions = {Transition::kIP};
  command.data = {0x06, 0, 0, 0, 192, 168, 0, 7, 255, 255, 255, 0};  // address and mask
  mailbox.eoe_commands = {command};
  const auto completed = startup_messages(mailbox, Transition::kIP)[0].data;
  ASSERT_EQ(completed.size(), 16U);
  EXPECT_EQ(eoe::decode(completed)->kind, eoe::Kind::kSetIpRequest);
  EXPECT_TRUE(std::equal(command.data.begin(), command.data.end(), completed.begin() + 4));
  mailbox.eoe_commands[0].data = completed;
  EXPECT_EQ(startup_messages(mailbox, Transition::kIP)[0].data, completed) << "it has one";
  mailbox.eoe_commands[0].data.resize(7);
  EXPECT_EQ(startup_messages(mailbox, Transition::kIP)[0].data.size(), 7U) << "something else";
}

TEST(StartupMessages, AnswersAreToldFromRequestsAndRefusalsFromConsent) {
  eoe::Header eoe;
  EXPECT_FALSE(judge_startup_answer(MailboxType::kEoe, eoe::encode(eoe)).is_answer) << "a frame";
  eoe.kind = eoe::Kind::kSetIpResponse;
  EXPECT_FALSE(judge_startup_answer(MailboxType::kEoe, eoe::encode(eoe)).refusal);
  eoe.result = eoe::kNoIpSupport;
  EXPECT_EQ(judge_startup_answer(MailboxType::kEoe, eoe::encode(eoe)).refusal.value_or(Reason()).text(),
            "EoE result 0x0201");
  soe::Header notification;
  notification.op_code = soe::OpCode::kNotification;
  EXPECT_FALSE(judge_startup_answer(MailboxType::kSoe, soe::encode(notification)).is_answer);
  aoe::Header ads;
  EXPECT_FALSE(judge_startup_answer(MailboxType::kAoe, aoe::encode(ads)).is_answer) << "a request";
  ads.state_flags |= aoe::Header::kResponse;
  EXPECT_FALSE(judge_startup_answer(MailboxType::kAoe, aoe::encode(ads)).refusal);
  auto own_result = aoe::encode(ads);
  own_result.insert(own_result.end(), {0x03, 0x07, 0, 0});
  EXPECT_EQ(judge_startup_answer(MailboxType::kAoe, own_result).refusal.value_or(Reason()).text(), "AoE error 0x703");
  for (const auto type : {MailboxType::kAoe, MailboxType::kEoe, MailboxType::kSoe, MailboxType::kFoe}) {
    EXPECT_TRUE(judge_startup_answer(type, {}).refusal) << mailbox_type_name(type);
  }
}

}  // namespace
}  // namespace syncline
