// SPDX-License-Identifier: Apache-2.0
#include "config/device_from_sii.h"

#include <gtest/gtest.h>

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

TEST(DeviceFromSii, SyncManagersSayWhetherTheyAreVirtual) {
  auto image = drive();
  image.sync_managers[2].enable = 0x05;
  EXPECT_TRUE(device_from_sii(image).sync_managers[2].is_virtual);
}

}  // namespace
}  // namespace syncline
