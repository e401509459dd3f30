// SPDX-License-Identifier: Apache-2.0
#include "config/device_from_sii.h"

#include <gtest/gtest.h>

#include "protocol/sii.h"

namespace syncline {
namespace {

sii::Image drive() {
  sii::Image image;
  image.vendor_id = 0x5C17;
  image.product_code = 7;
  image.revision_no = 0x10000;
  image.serial_no = 42;
  image.mailbox_protocols = sii::kProtocolCoe;
  image.general = sii::General{};
  image.general->name = "a drive";
  image.general->order = "DRV";
  image.general->coe_details = 0x25;
  image.general->physical_ports = 0x0011;
  image.fmmus = {1, 2, 3};
  image.sync_managers = {{0x1000, 128, 0x26, 0, 1, 1}, {0x1080, 128, 0x22, 0, 1, 2}, {0x1100, 6, 0x64, 0, 9, 3}};
  sii::Pdo pdo;
  pdo.index = 0x1600;
  pdo.sync_manager = 2;
  pdo.name = "outputs";
  pdo.entries.push_back({0x6040, 0, "Controlword", 6, 16, 0});
  image.rx_pdos.push_back(pdo);
  sii::DcMode mode;
  mode.name = "DC";
  mode.assign_activate = 0x0300;
  mode.cycle_factor_sync0 = 1;
  image.dc_modes.push_back(mode);
  return image;
}

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

TEST(DeviceFromSii, SyncManagersSayWhetherTheyAreVirtual) {
  auto image = drive();
  image.sync_managers[2].enable = 0x05;
  EXPECT_TRUE(device_from_sii(image).sync_managers[2].is_virtual);
}

}  // namespace
}  // namespace syncline
