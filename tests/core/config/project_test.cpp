// SPDX-License-Identifier: Apache-2.0
#include "config/project.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/sample_devices.h"

namespace syncline {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(DefaultSlave, TakesTheEsisSoeCommandsAsTheyAre) {
  MailboxDescription mailbox;
  mailbox.soe = true;
  mailbox.soe_options.init_commands.push_back(
      {.drive = 1, .idn = 2, .data = {0xE8, 0x03}, .fixed = true, .timeout_ms = 300});
  DeviceDescription device;
  device.mailbox = mailbox;
  const auto slave = default_slave(device, 0);
  EXPECT_EQ(slave.soe_startup, mailbox.soe_options.init_commands);
}

TEST(Project, DcmModesHaveNamesBothWays) {
  for (const auto mode : {DcmMode::kOff, DcmMode::kBusShift, DcmMode::kMasterShift}) {
    EXPECT_EQ(dcm_mode_from_name(dcm_mode_name(mode)), mode);
  }
  EXPECT_EQ(dcm_mode_name(DcmMode::kBusShift), "bus-shift");
  EXPECT_EQ(dcm_mode_from_name("shift"), std::nullopt);
}

TEST(Project, IdentityIsWrittenInHexadecimal) {
  EXPECT_EQ(to_string(Identity{0x2, 0x044C2C52, 0x00120000, 0}), "0x00000002:0x044c2c52:0x00120000");
}

Pdo pdo(std::uint16_t index, std::optional<std::uint8_t> manager, std::vector<std::uint16_t> exclude = {},
        bool mandatory = false) {
  auto made = sample::pdo(index, "", manager, {{0x6000, 1, 8, "", "USINT"}});
  made.exclude = std::move(exclude);
  made.mandatory = mandatory;
  return made;
}

TEST(Project, DefaultAssignmentIsWhatTheEsiAssigns) {
  DeviceDescription device;
  device.tx_pdos = {pdo(0x1A02, 3), pdo(0x1A00, std::nullopt), pdo(0x1A01, 3)};
  EXPECT_THAT(default_assignment(device, PdoDirection::kTx), ElementsAre(0x1A02, 0x1A01));
  EXPECT_THAT(default_assignment(device, PdoDirection::kRx), IsEmpty());
}

TEST(Project, DefaultAssignmentHonoursExclusionBothWays) {
  DeviceDescription device;
  device.tx_pdos = {pdo(0x1A00, 3, {0x1A01}), pdo(0x1A01, 3), pdo(0x1A02, 3, {0x1A00})};
  EXPECT_THAT(default_assignment(device, PdoDirection::kTx), ElementsAre(0x1A00));
}

TEST(Project, MandatoryPdoWinsAndNeedsNoSyncManager) {
  DeviceDescription device;
  device.rx_pdos = {pdo(0x1600, 2, {0x1601}), pdo(0x1601, std::nullopt, {}, true)};
  EXPECT_THAT(default_assignment(device, PdoDirection::kRx), ElementsAre(0x1601));
}

TEST(Project, DefaultSlaveFollowsTheDevice) {
  DeviceDescription device = sample::digital_output();
  device.type = "Elmo Drive ";
  device.dc.emplace().potential_reference_clock = true;
  device.dc->op_modes = {{"DcSync", "", 0x0300, {}, {}, {}, {}, {}}, {"FreeRun", "", 0, {}, {}, {}, {}, {}}};
  StartupCommand command;
  command.index = 0x6060;
  device.mailbox.emplace().coe.emplace().init_commands = {command};
  const auto slave = default_slave(device, 2);
  EXPECT_EQ(slave.name, "Slave_1003 [Elmo Drive ]");
  EXPECT_EQ(slave.station_address, 1003);
  EXPECT_EQ(slave.dc.op_mode, "DcSync");
  EXPECT_TRUE(slave.dc.potential_reference_clock);
  EXPECT_THAT(slave.startup, ElementsAre(command));
  EXPECT_EQ(slave.device, device);
  EXPECT_EQ(slave.previous, std::nullopt);
  EXPECT_EQ(default_slave(sample::digital_input(), 0).dc.op_mode, "");
}

TEST(Project, ModeWithUnknownPdosLeavesTheAssignmentAlone) {
  DeviceDescription device = sample::digital_input();
  device.dc.emplace().op_modes = {{"Oversampling", "", 0x0730, {}, {}, {}, {}, {{0, std::nullopt, {0x1A00, 0x1BFF}}}}};
  const auto slave = default_slave(device, 0);
  EXPECT_EQ(slave.dc.op_mode, "Oversampling");
  EXPECT_THAT(slave.assigned_tx_pdos, ElementsAre(0x1A00, 0x1A01));
}

}  // namespace
}  // namespace syncline
