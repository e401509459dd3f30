// SPDX-License-Identifier: Apache-2.0
#include "sim/device/sii_from_device.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config/device_description.h"
#include "protocol/sii.h"

/// What a vendor's tool writes into an EEPROM (ETG.2010, tables 7, 8 and 12).
namespace syncline::sim {
namespace {

TEST(SiiFromDevice, SyncManagersSayWhetherTheyAreEnabledVirtualOrForOpAlone) {
  DeviceDescription device;
  for (const unsigned bits : {0U, 1U, 4U, 8U, 13U}) {
    auto& sm = device.sync_managers.emplace_back();
    sm.start_address = 0x1000;
    sm.enable = (bits & 1) != 0;
    sm.is_virtual = (bits & 4) != 0;
    sm.op_only = (bits & 8) != 0;
  }
  std::vector<unsigned> enables;
  for (const auto& sm : sii_from_device(device, 0, 0).sync_managers) enables.push_back(sm.enable);
  EXPECT_THAT(enables, testing::ElementsAre(0, 1, 4, 8, 13));
}

TEST(SiiFromDevice, EachProtocolHasItsDetails) {
  DeviceDescription device;
  auto& mailbox = device.mailbox.emplace();
  const auto general = [&] { return *sii_from_device(device, 0, 0).general; };
  EXPECT_EQ(general().coe_details, 0);
  EXPECT_EQ(general().foe_details, 0);
  EXPECT_EQ(general().eoe_details, 0);
  mailbox.foe = true;
  EXPECT_EQ(general().foe_details, 1);
  EXPECT_EQ(general().eoe_details, 0);
  mailbox.foe = false;
  mailbox.eoe = true;
  EXPECT_EQ(general().foe_details, 0);
  EXPECT_EQ(general().eoe_details, 1);
  auto& coe = mailbox.coe.emplace();
  EXPECT_EQ(general().coe_details, 0x01);
  coe.pdo_assign = coe.complete_access = true;
  EXPECT_EQ(general().coe_details, 0x25);
}

}  // namespace
}  // namespace syncline::sim
