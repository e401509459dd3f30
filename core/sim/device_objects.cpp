// SPDX-License-Identifier: Apache-2.0
#include "sim/device_objects.h"

#include <algorithm>

#include "protocol/sdo_information.h"
#include "sim/sii_from_device.h"

namespace syncline::sim {
namespace {

void add_identity(const SimSlaveConfig& config, ObjectDictionary& dictionary) {
  const auto& device = config.device;
  dictionary.add<std::uint32_t>(0x1000, 0, "Device type", device.profiles.empty() ? 0 : device.profiles[0].profile_no);
  constexpr std::uint16_t kVisibleString = 0x09;
  dictionary.add(0x1008, 0, "Device name", std::vector<std::uint8_t>(device.type.begin(), device.type.end())).data_type =
      kVisibleString;
  const auto managers = std::min<std::size_t>(device.sync_managers.size(), 32);
  dictionary.set_object_name(0x1C00, "Sync manager type");
  dictionary.add(0x1C00, 0, "Number of entries", static_cast<std::uint8_t>(managers));
  for (std::size_t i = 0; i < managers; ++i) {
    dictionary.add(0x1C00, static_cast<std::uint8_t>(i + 1), "Communication type",
                    static_cast<std::uint8_t>(device.sync_managers[i].type));
  }
  dictionary.add<std::uint8_t>(0x1018, 0, "Identity", 4);
  dictionary.add<std::uint32_t>(0x1018, 1, "Vendor ID", device.identity.vendor_id);
  dictionary.add<std::uint32_t>(0x1018, 2, "Product code", device.identity.product_code);
  dictionary.add<std::uint32_t>(0x1018, 3, "Revision", device.identity.revision_no);
  dictionary.add<std::uint32_t>(0x1018, 4, "Serial number", config.serial_no);
}

void add_mapped_objects(const DeviceDescription& device, ObjectDictionary& dictionary) {
  for (const auto direction : {PdoDirection::kRx, PdoDirection::kTx}) {
    for (const auto& pdo : device.pdos(direction)) {
      for (const auto& entry : pdo.entries) {
        if (entry.index == 0 || dictionary.find(entry.index, entry.sub_index) != nullptr) continue;
        auto& added = dictionary.add(entry.index, entry.sub_index, entry.name,
                                      std::vector<std::uint8_t>((entry.bit_length + 7U) / 8U), direction == PdoDirection::kRx);
        added.bit_length = entry.bit_length;
        added.data_type = data_type_code(entry.data_type);
        added.extra_access = direction == PdoDirection::kRx ? coe::access::kRxPdo : coe::access::kTxPdo;
      }
    }
  }
}

void add_described_objects(const DeviceDescription& device, ObjectDictionary& dictionary) {
  for (const auto& object : device.dictionary) {
    dictionary.set_object_name(object.index, object.name);
    for (const auto& entry : object.entries) {
      if (dictionary.find(object.index, entry.sub_index) != nullptr) continue;
      auto value = entry.default_data;
      value.resize(std::max<std::size_t>((entry.bit_length + 7U) / 8U, value.size()));
      auto& added = dictionary.add(object.index, entry.sub_index, entry.name, std::move(value), entry.writable);
      added.bit_length = entry.bit_length;
      added.data_type = data_type_code(entry.data_type);
      added.readable = entry.readable || !entry.writable;
    }
  }
}

/// What the description wants to be written at state transitions must be there, also where it has no dictionary.
void add_commanded_objects(const DeviceDescription& device, ObjectDictionary& dictionary) {
  if (!device.mailbox || !device.mailbox->coe) return;
  for (const auto& command : device.mailbox->coe->init_commands) {
    const bool pdo_object = command.index >= 0x1600 && command.index < 0x1C20;  // PdoObjects makes these
    if (pdo_object || command.complete_access) continue;
    if (dictionary.find(command.index, command.sub_index) != nullptr) continue;
    dictionary.add(command.index, command.sub_index, command.comment, std::vector<std::uint8_t>(command.data.size()), true);
  }
}

}  // namespace

void add_device_objects(const SimSlaveConfig& config, ObjectDictionary& dictionary) {
  add_identity(config, dictionary);
  add_mapped_objects(config.device, dictionary);
  add_described_objects(config.device, dictionary);
  add_commanded_objects(config.device, dictionary);
}

}  // namespace syncline::sim
