// SPDX-License-Identifier: Apache-2.0
#include "sim/device/device_objects.h"

#include <gtest/gtest.h>

#include "config/sim_config.h"
#include "protocol/sdo_information.h"
#include "sim/objects/object_dictionary.h"

namespace syncline::sim {
namespace {

StartupCommand command(std::uint16_t index, std::uint8_t sub_index, std::vector<std::uint8_t> data) {
  StartupCommand made;
  made.index = index;
  made.sub_index = sub_index;
  made.data = std::move(data);
  return made;
}

SimSlaveConfig with_coe() {
  SimSlaveConfig config;
  config.device.mailbox.emplace().coe.emplace();
  return config;
}

ObjectEntry entry(std::uint8_t sub_index, std::uint16_t bits, std::vector<std::uint8_t> value) {
  ObjectEntry made;
  made.sub_index = sub_index;
  made.bit_length = bits;
  made.default_data = std::move(value);
  made.readable = true;
  return made;
}

/// ETG.1000.6, 0x1C00: one sub-index for each SyncManager, 32 at most.
TEST(SimDeviceObjects, NameTheTypeOfEachSyncManager) {
  SimSlaveConfig config;
  config.device.sync_managers.resize(3);
  config.device.sync_managers[2].type = SyncManagerType::kOutputs;
  ObjectDictionary three;
  add_device_objects(config, three);
  EXPECT_EQ(three.get<std::uint8_t>(0x1C00, 0), 3);
  EXPECT_EQ(three.get<std::uint8_t>(0x1C00, 3), 3);
  EXPECT_EQ(three.find(0x1C00, 4), nullptr);
  config.device.sync_managers.resize(40);
  ObjectDictionary many;
  add_device_objects(config, many);
  EXPECT_EQ(many.get<std::uint8_t>(0x1C00, 0), 32);
  EXPECT_EQ(many.sub_indices(0x1C00).back(), 32);
}

/// ETG.1000.6, object access: bit 6 for RxPDOs, bit 7 for TxPDOs.
TEST(SimDeviceObjects, SayIntoWhichPdosTheyCanBeMapped) {
  auto config = with_coe();
  const auto pdo = [](std::uint16_t index) {
    Pdo made;
    made.index = 0x1600;
    made.entries.emplace_back();
    made.entries[0].index = index;
    made.entries[0].sub_index = 1;
    made.entries[0].bit_length = 16;
    made.entries[0].data_type = "UINT";
    return made;
  };
  config.device.rx_pdos = {pdo(0x7000)};
  config.device.tx_pdos = {pdo(0x6000)};
  ObjectDictionary dictionary;
  add_device_objects(config, dictionary);
  EXPECT_EQ(dictionary.find(0x7000, 1)->extra_access, coe::access::kRxPdo);
  EXPECT_EQ(dictionary.find(0x6000, 1)->extra_access, coe::access::kTxPdo);
  EXPECT_TRUE(dictionary.find(0x7000, 1)->writable);
  EXPECT_FALSE(dictionary.find(0x6000, 1)->writable);
}

TEST(SimObjectDictionary, AnObjectGoesWithAllThatIsUnderItAndNothingElse) {
  ObjectDictionary dictionary;
  for (const std::uint16_t index : {0x2000, 0x2001, 0x2002}) {
    for (const std::uint8_t sub_index : {0, 1, 0xFF}) dictionary.add<std::uint8_t>(index, sub_index, "", 7);
  }
  dictionary.remove_object(0x2001);
  for (const std::uint8_t sub_index : {0, 1, 0xFF}) {
    EXPECT_NE(dictionary.find(0x2000, sub_index), nullptr);
    EXPECT_EQ(dictionary.find(0x2001, sub_index), nullptr);
    EXPECT_NE(dictionary.find(0x2002, sub_index), nullptr);
  }
}

/// What start-up commands write is there and can be written, as long as they write it; the lists of PDOs have their
/// size, whatever a file writes to them.
TEST(SimDeviceObjects, AreAsLongAsTheStartUpCommandsOfTheEsiWriteThem) {
  auto config = with_coe();
  auto& device = config.device;
  device.dictionary.resize(3);
  for (std::uint16_t i = 0; i < 3; ++i) {
    device.dictionary[i].index = static_cast<std::uint16_t>(i == 0 ? 0x2000 : i == 1 ? 0x1C12 : 0x1600);
    device.dictionary[i].entries = {entry(0, 8, {1}), entry(1, 16, {1, 2})};
  }
  device.rx_pdos.resize(1);
  device.rx_pdos[0].index = 0x1600;
  for (const std::uint16_t index : {0x2000, 0x1C12, 0x1600, 0x1C2F, 0x1C30}) {
    device.mailbox->coe->init_commands.push_back(command(index, 1, {1, 2, 3, 4}));
  }
  ObjectDictionary dictionary;
  add_device_objects(config, dictionary);
  const auto size = [&](std::uint16_t index) { return dictionary.find(index, 1)->value.size(); };
  EXPECT_EQ(size(0x2000), 4U);
  EXPECT_EQ(size(0x1C12), 2U);
  EXPECT_EQ(size(0x1600), 2U);
  EXPECT_EQ(size(0x1C2F), 4U) << "made for the command";
  for (const std::uint16_t index : {0x2000, 0x1C12, 0x1600, 0x1C2F, 0x1C30}) {
    EXPECT_TRUE(dictionary.find(index, 1)->writable) << std::hex << index;
  }
  EXPECT_FALSE(dictionary.find(0x2000, 0)->writable);
}

}  // namespace
}  // namespace syncline::sim
