// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "channels/command.h"
#include "channels/master_channels.h"
#include "channels/snapshot.h"
#include "master/exchange/bus.h"
#include "master/mailbox/coe_client.h"
#include "master/master_service.h"
#include "master/startup/coe_download_work.h"
#include "master/startup/init_cmd_runner.h"
#include "tests/core/master/terminals_bed.h"
#include "tests/support/simulated_segment.h"

namespace syncline {
namespace {

InitCmd write(std::uint16_t position, std::uint16_t ado, std::uint16_t value) {
  InitCmd cmd;
  cmd.command = Command::kApwr;
  cmd.adp = Position{position}.auto_increment_address();
  cmd.ado = ado;
  cmd.data = le_bytes(value);
  cmd.expected_wkc = 1;
  return cmd;
}

class SlaveBatch : public test::TerminalsBed {
 protected:
  InitCmdWork work(std::vector<const InitCmd*> commands, std::string subject = "slave") {
    return InitCmdWork(std::move(commands), {std::move(subject), kMillisecond, std::nullopt, {}});
  }
};

TEST_F(SlaveBatch, SendsOneCommandOfEverySlaveInOneFrameAndKeepsEachSlavesOrder) {
  link.record = true;
  std::vector<InitCmd> commands;
  for (std::uint16_t slave = 0; slave < 3; ++slave) {
    commands.push_back(write(slave, reg::kStationAddress, static_cast<std::uint16_t>(1001 + slave)));
    commands.push_back(write(slave, 0x1F00, static_cast<std::uint16_t>(7 + slave)));
  }
  std::vector<InitCmdWork> works;
  for (std::size_t slave = 0; slave < 3; ++slave)
    works.push_back(work({&commands[2 * slave], &commands[2 * slave + 1]}));
  SlaveWork* const all[] = {&works[0], &works[1], &works[2]};
  ASSERT_TRUE(run_side_by_side(bus, all));
  ASSERT_EQ(link.sent.size(), 2U);
  for (std::uint16_t slave = 0; slave < 3; ++slave) {
    EXPECT_TRUE(works[slave].result());
    EXPECT_EQ(link.get<std::uint16_t>(slave, reg::kStationAddress), 1001 + slave);
    EXPECT_EQ(link.get<std::uint16_t>(slave, 0x1F00), 7 + slave);
  }
}

TEST_F(SlaveBatch, TriesAgainAsOftenAsTheCommandSays) {
  auto command = write(7, 0x1F00, 1);  // there is no such slave
  command.retries = 4;
  auto lonely = work({&command});
  SlaveWork* const all[] = {&lonely};
  ASSERT_TRUE(run_side_by_side(bus, all));
  EXPECT_EQ(link.frames_sent, 5U);
  ASSERT_FALSE(lonely.result());
  EXPECT_EQ(lonely.result().error().code, ErrorCode::kWorkingCounter);
  EXPECT_EQ(lonely.result().error().expected, 1);
}

TEST_F(SlaveBatch, OneSlavesFailureDoesNotHoldTheOthers) {
  auto wrong = write(7, 0x1F00, 1), never = write(0, 0x1F02, 5), right = write(1, 0x1F00, 2),
       next = write(1, 0x1F02, 3);
  auto failing = work({&wrong, &never}), good = work({&right, &next});
  SlaveWork* const all[] = {&failing, &good};
  ASSERT_TRUE(run_side_by_side(bus, all));
  EXPECT_FALSE(failing.result());
  EXPECT_TRUE(good.result());
  EXPECT_EQ(link.get<std::uint16_t>(0, 0x1F02), 0);  // what follows a failed command is not sent
  EXPECT_EQ(link.get<std::uint16_t>(1, 0x1F02), 3);
}

TEST_F(SlaveBatch, WaitsForValidationUntilItsTimeIsOver) {
  InitCmd check;
  check.command = Command::kAprd;
  check.adp = 0;
  check.ado = 0x1F00;
  check.data.resize(2);
  check.validate = InitCmdValidate{{5, 0}, {0x0F, 0}, 20};
  int frames = 0;
  link.on_frame = [&] {
    if (++frames == 10) link.set<std::uint16_t>(0, 0x1F00, 0x35);
  };
  auto patient = work({&check}), again = work({&check});
  SlaveWork* const first[] = {&patient};
  ASSERT_TRUE(run_side_by_side(bus, first));
  EXPECT_TRUE(patient.result());
  EXPECT_EQ(frames, 10);
  link.set<std::uint16_t>(0, 0x1F00, 0x04);
  SlaveWork* const second[] = {&again};
  const auto before = clock.now();
  ASSERT_TRUE(run_side_by_side(bus, second));
  ASSERT_FALSE(again.result());
  EXPECT_EQ(again.result().error().code, ErrorCode::kInitCmdValidation);
  EXPECT_GE(clock.now() - before, 20 * kMillisecond);
  EXPECT_LT(clock.now() - before, 30 * kMillisecond);
}

TEST_F(SlaveBatch, ASlaveFoundElsewhereIsAddressedThere) {
  const auto command = write(2, 0x1F00, 9);
  InitCmdWork moved({&command}, {"slave", 0, Position{1}.auto_increment_address(), {}});
  SlaveWork* const all[] = {&moved};
  ASSERT_TRUE(run_side_by_side(bus, all));
  EXPECT_EQ(link.get<std::uint16_t>(1, 0x1F00), 9);
  EXPECT_EQ(link.get<std::uint16_t>(2, 0x1F00), 0);
}

/// Each slave's commands of INIT to PREOP.
bool lead_to_preop(Bus& bus, const NetworkConfig& config) {
  std::vector<InitCmdWork> works;
  std::vector<SlaveWork*> all;
  works.reserve(config.slaves.size());
  for (const auto& slave : config.slaves) {
    std::vector<const InitCmd*> commands;
    for (const auto& cmd : slave.init_cmds) {
      if (has_transition(cmd, Transition::kIP)) commands.push_back(&cmd);
    }
    works.emplace_back(std::move(commands), InitCmdContext{slave.name, kMillisecond, std::nullopt, {}});
    all.push_back(&works.back());
  }
  return run_side_by_side(bus, all).has_value() &&
         std::ranges::all_of(works, [](const auto& work) { return work.result().has_value(); });
}

/// Two objects to three drives that stand in PREOP; what they have taken is read back.
TEST(SlaveBatchMailbox, DownloadsObjectsOfEveryLengthToManySlavesAtOnce) {
  VirtualClock clock;
  test::SimulatedNetwork network;
  auto device = test::servo();
  auto& text = device.dictionary.emplace_back();
  text.index = 0x2000;
  text.entries.resize(1);
  text.entries[0].writable = text.entries[0].readable = true;
  text.entries[0].bit_length = 300 * 8;
  for (int i = 0; i < 3; ++i) network.add(device, "servo-y");
  test::SimulatedSegment link(clock, network.sim);
  FrameExchange exchange(link, clock);
  Bus bus(exchange, clock);
  const auto config = network.compiled();
  ASSERT_TRUE(lead_to_preop(bus, config));

  std::vector<StartupCommand> commands(2);
  commands[0].index = 0x6060;
  commands[0].data = {8};
  commands[1].index = 0x2000;
  commands[1].data.resize(300);
  for (std::size_t i = 0; i < 300; ++i) commands[1].data[i] = static_cast<std::uint8_t>(i);
  std::vector<SlaveMailbox> mailboxes(3);
  std::vector<CoeDownloadWork> works;
  std::vector<SlaveWork*> all;
  works.reserve(3);
  for (std::size_t i = 0; i < 3; ++i) {
    mailboxes[i].port = mailbox_port(config.slaves[i]);
    works.emplace_back(mailboxes[i], std::vector<const StartupCommand*>{&commands[0], &commands[1]});
    all.push_back(&works.back());
  }
  ASSERT_TRUE(run_side_by_side(bus, all));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(works[i].result()) << i;
    MailboxClient mailbox(bus, mailboxes[i]);
    CoeClient client(mailbox);
    EXPECT_EQ(client.upload({0x6060, 0}).value(), commands[0].data);
    EXPECT_EQ(client.upload({0x2000, 0}).value(), commands[1].data);
  }
}

/// Virtual time until OP; nothing when OP was not reached.
std::optional<Nanoseconds> time_to_op(const test::SimulatedNetwork& network) {
  VirtualClock clock;
  auto link = network.link(clock);
  if (!link) return std::nullopt;
  MasterService service(std::move(link), clock);
  service.channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
  const auto start = clock.now();
  (void)service.step();
  Snapshot snapshot;
  (void)service.channels().snapshot.read(snapshot);
  if (snapshot.state != AlState::kOp) return std::nullopt;
  return clock.now() - start;
}

TEST(BringUp, OfManyDrivesTakesLittleLongerThanOfOne) {
  const auto network = [](std::size_t drives) {
    test::SimulatedNetwork result;
    for (std::size_t i = 0; i < drives; ++i) result.add(test::servo(), "servo-y");
    return result;
  };
  const auto one = time_to_op(network(1)), many = time_to_op(network(40));
  ASSERT_TRUE(one);
  ASSERT_TRUE(many);
  // Some 40 commands each: one after the other they took 170 ms more with every drive.
  EXPECT_LT(*many - *one, 500 * kMillisecond);
}

}  // namespace
}  // namespace syncline
