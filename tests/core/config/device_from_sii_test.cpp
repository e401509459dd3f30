// SPDX-License-Identifier: Apache-2.0
#include "config/device_from_sii.h"

#include <gtest/gtest.h>

#include "config/device_description.h"
#include "protocol/sii.h"
#include "tests/support/sample_image.h"

namespace syncline {
namespace {

sii::Image drive() { return sample::drive_image(7); }

TEST(DeviceFromSii, KeepsWhatAnEsiWouldSay) {
  const auto device = device_from_sii(drive());
  EXPECT_EQ(device.identity, (Identity{0x5C17, 7, 0x10000, 0}));
  EXPECT_EQ(device.type, "DRV");
  EXPECT_EQ(device.name, "a drive");
  EXPECT_EQ(device.physics, "YY");
  ASSERT_TRUE(device.mailbox && device.mailbox->coe);
  EXPECT_TRUE(device.mailbox->coe->pdo_assign);
  EXPECT_TRUE(device.mailbox->coe->complete_access);
  EXPECT_FALSE(device.mailbox->coe->pdo_config);
  ASSERT_EQ(device.sync_managers.size(), 3U);
  EXPECT_EQ(device.sync_managers[2].type, SyncManagerType::kOutputs);
  EXPECT_TRUE(device.sync_managers[2].op_only);
  EXPECT_FALSE(device.sync_managers[2].is_virtual);
  ASSERT_EQ(device.rx_pdos.size(), 1U);
  EXPECT_EQ(device.rx_pdos[0].entries[0].data_type, "UINT");
  EXPECT_EQ(device.rx_pdos[0].sync_manager, 2);
  ASSERT_TRUE(device.dc);
  EXPECT_EQ(device.dc->op_modes[0].cycle_time_sync0.factor, 1);
  EXPECT_EQ(device.source, "SII");
}

/// ETG.2010, table 7: one bit each.
TEST(DeviceFromSii, EachDetailOfCoeIsABitOfItsOwn) {
  const auto bits = [](std::uint8_t details) {
    auto image = drive();
    image.general->coe_details = details;
    const auto coe = device_from_sii(image).mailbox.value().coe.value();
    return std::vector<bool>{coe.sdo_info, coe.pdo_assign, coe.pdo_config, coe.pdo_upload, coe.complete_access};
  };
  for (unsigned bit = 1; bit <= 5; ++bit) {
    std::vector<bool> one(5, false), others(5, true);
    one[bit - 1] = true;
    others[bit - 1] = false;
    EXPECT_EQ(bits(static_cast<std::uint8_t>(1U << bit)), one) << bit;
    EXPECT_EQ(bits(static_cast<std::uint8_t>(0xFF & ~(1U << bit))), others) << bit;
  }
}

TEST(DeviceFromSii, EachMailboxProtocolIsABitOfItsOwn) {
  const auto protocols = [](std::uint16_t bits) {
    auto image = drive();
    image.mailbox_protocols = bits;
    const auto mailbox = *device_from_sii(image).mailbox;
    return std::vector<bool>{mailbox.aoe, mailbox.eoe, mailbox.coe.has_value(), mailbox.foe, mailbox.soe, mailbox.voe};
  };
  for (unsigned bit = 0; bit < 6; ++bit) {
    std::vector<bool> one(6, false);
    one[bit] = true;
    EXPECT_EQ(protocols(static_cast<std::uint16_t>(1U << bit)), one) << bit;
  }
  auto without = drive();
  without.mailbox_protocols = 0;
  EXPECT_FALSE(device_from_sii(without).mailbox);
}

/// Four bits for each port (ETG.2010, table 7): 0 unused, 1 MII, 3 E-bus, 4 fast hot connect.
TEST(DeviceFromSii, PortsHaveTheLettersOfAnEsi) {
  const auto physics = [](std::uint16_t ports) {
    auto image = drive();
    image.general->physical_ports = ports;
    return device_from_sii(image).physics;
  };
  EXPECT_EQ(physics(0x0000), "");
  EXPECT_EQ(physics(0x0033), "KK");
  EXPECT_EQ(physics(0x4301), "Y KY");
  EXPECT_EQ(physics(0x0031), "YK");
  EXPECT_EQ(physics(0x0012), " Y") << "2 is reserved";
}

TEST(DeviceFromSii, ModesOfTheClocksKeepTimesAndFactors) {
  auto image = drive();
  image.dc_modes[0].shift_time_sync0 = 30'000;
  image.dc_modes[0].shift_time_sync1 = 40'000;
  image.dc_modes[0].cycle_factor_sync1 = -2;
  sii::DcMode free;
  free.cycle_time_sync0 = 500'000;
  free.assign_activate = 0x0700;
  free.description = "free";
  image.dc_modes.push_back(free);
  const auto dc = device_from_sii(image).dc.value();
  ASSERT_EQ(dc.op_modes.size(), 2U);
  EXPECT_EQ(dc.op_modes[0].name, "DC");
  EXPECT_EQ(dc.op_modes[0].cycle_time_sync0, (DcTime{.value_ns = 0, .factor = 1}));
  EXPECT_EQ(dc.op_modes[0].cycle_time_sync1, (DcTime{.value_ns = 0, .factor = -2}));
  EXPECT_EQ(dc.op_modes[0].shift_time_sync0, (DcTime{.value_ns = 30'000, .factor = {}}));
  EXPECT_EQ(dc.op_modes[0].shift_time_sync1, (DcTime{.value_ns = 40'000, .factor = {}}));
  EXPECT_EQ(dc.op_modes[1].name, "mode 2");
  EXPECT_EQ(dc.op_modes[1].description, "free");
  EXPECT_EQ(dc.op_modes[1].assign_activate, 0x0700);
  EXPECT_EQ(dc.op_modes[1].cycle_time_sync0, (DcTime{.value_ns = 500'000, .factor = {}}));
}

/// The first words as an ESI's ConfigData gives them, without the alias, which belongs to the installation.
TEST(DeviceFromSii, TheConfigurationAndTheBootMailboxAreThoseOfTheEeprom) {
  auto image = drive();
  image.pdi_control = 0x0805;
  image.pdi_configuration = 0x1122;
  image.sync_impulse_length = 10;
  image.pdi_configuration2 = 0x3344;
  image.alias = 77;
  using Bytes = std::vector<std::uint8_t>;
  const auto plain = device_from_sii(image).eeprom;
  EXPECT_EQ(plain.config_data, (Bytes{0x05, 0x08, 0x22, 0x11, 10, 0, 0x44, 0x33, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(plain.byte_size, 2048U);
  EXPECT_EQ(plain.boot_strap, Bytes{});
  image.bootstrap_mailbox = {0x1000, 0x80, 0x1080, 0};
  EXPECT_EQ(device_from_sii(image).eeprom.boot_strap, Bytes{}) << "one half is none";
  image.bootstrap_mailbox = {0x1000, 0, 0x1080, 0x40};
  EXPECT_EQ(device_from_sii(image).eeprom.boot_strap, Bytes{});
  image.bootstrap_mailbox.receive_size = 1;
  EXPECT_EQ(device_from_sii(image).eeprom.boot_strap, (Bytes{0, 0x10, 1, 0, 0x80, 0x10, 0x40, 0}));
}

TEST(DeviceFromSii, SyncManagersKeepTheirBits) {
  auto image = drive();
  const auto manager = [&](std::uint8_t enable) {
    image.sync_managers[2].enable = enable;
    const auto made = device_from_sii(image).sync_managers[2];
    return std::vector<bool>{made.enable, made.is_virtual, made.op_only};
  };
  EXPECT_EQ(manager(0x01), (std::vector<bool>{true, false, false}));
  EXPECT_EQ(manager(0x04), (std::vector<bool>{false, true, false}));
  EXPECT_EQ(manager(0x08), (std::vector<bool>{false, false, true}));
}

TEST(DeviceFromSii, SyncManagersSayWhetherTheyAreVirtual) {
  auto image = drive();
  image.sync_managers[2].enable = 0x05;
  EXPECT_TRUE(device_from_sii(image).sync_managers[2].is_virtual);
}

}  // namespace
}  // namespace syncline
