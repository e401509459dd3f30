// SPDX-License-Identifier: Apache-2.0
#include "config/device_dictionary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config/device_description.h"

namespace syncline {
namespace {

using testing::ElementsAre;

DeviceDescription from_eeprom() {
  DeviceDescription device;
  device.sync_managers.resize(4);
  device.sync_managers[0].type = SyncManagerType::kMailboxOut;
  device.sync_managers[1].type = SyncManagerType::kMailboxIn;
  device.sync_managers[2].type = SyncManagerType::kOutputs;
  device.sync_managers[3].type = SyncManagerType::kInputs;
  Pdo old;
  old.index = 0x1600;
  old.name = "of the EEPROM";
  device.rx_pdos = {old};
  device.tx_pdos = {old};
  return device;
}

ObjectEntry entry(std::uint8_t sub_index, std::string name, std::string type, std::uint16_t bits) {
  ObjectEntry out;
  out.sub_index = sub_index;
  out.name = std::move(name);
  out.data_type = std::move(type);
  out.bit_length = bits;
  return out;
}

ObjectDescription object(std::uint16_t index, std::string name, std::vector<ObjectEntry> entries) {
  ObjectDescription out;
  out.index = index;
  out.name = std::move(name);
  out.entries = std::move(entries);
  return out;
}

TEST(DeviceDictionary, PdosComeFromTheMappingInTheOrderOfTheAssignment) {
  auto device = from_eeprom();
  DeviceDictionary dictionary;
  dictionary.objects = {object(0x6040, "Controlword", {entry(0, "", "UINT", 16)}),
                        object(0x2000, "Thing", {entry(0, "Count", "USINT", 8), entry(1, "First", "BOOL", 1)})};
  dictionary.rx_pdos = {{0x1600, "Fixed", {0x60400010}, false},
                        {0x1601, "", {0x20000101, 0x00000007, 0x30000208}, true}};
  dictionary.assigned_rx = {0x1601, 0x1600};
  complete_from_dictionary(device, dictionary);
  ASSERT_EQ(device.rx_pdos.size(), 2U);
  const auto& first = device.rx_pdos[0];
  EXPECT_EQ(first.index, 0x1601);
  EXPECT_EQ(first.name, "PDO 0x1601");
  EXPECT_FALSE(first.fixed);
  EXPECT_EQ(first.sync_manager, 2);
  ASSERT_EQ(first.entries.size(), 3U);
  EXPECT_EQ(first.entries[0].name, "First");
  EXPECT_EQ(first.entries[0].data_type, "BOOL");
  EXPECT_EQ(first.entries[1].index, 0) << "padding";
  EXPECT_EQ(first.entries[1].bit_length, 7);
  EXPECT_EQ(first.entries[2].name, "0x3000:02") << "the device does not describe it";
  EXPECT_EQ(first.entries[2].data_type, "BIT8");
  EXPECT_TRUE(device.rx_pdos[1].fixed);
  EXPECT_EQ(device.rx_pdos[1].entries[0].name, "Controlword");
  EXPECT_EQ(device.dictionary.size(), 2U);
  ASSERT_EQ(device.tx_pdos.size(), 1U);
  EXPECT_EQ(device.tx_pdos[0].name, "of the EEPROM") << "the dictionary has none of this direction";
}

TEST(DeviceDictionary, WhatIsNotAssignedHasNoSyncManager) {
  auto device = from_eeprom();
  DeviceDictionary dictionary;
  dictionary.tx_pdos = {{0x1A00, "Used", {0x60410010}, false}, {0x1A01, "Spare", {0x60640020}, false}};
  dictionary.assigned_tx = {0x1A00};
  complete_from_dictionary(device, dictionary);
  ASSERT_EQ(device.tx_pdos.size(), 2U);
  EXPECT_EQ(device.tx_pdos[0].sync_manager, 3);
  EXPECT_FALSE(device.tx_pdos[1].sync_manager);
}

}  // namespace
}  // namespace syncline
