// SPDX-License-Identifier: Apache-2.0
#include "sim/device/device_objects.h"

#include <algorithm>

#include "config/device_description.h"
#include "config/module_slots.h"
#include "config/sim_config.h"
#include "protocol/sdo_information.h"
#include "sim/device/sii_from_device.h"
#include "sim/objects/object_dictionary.h"

namespace syncline::sim {
namespace {

void add_identity(const SimSlaveConfig& config, ObjectDictionary& dictionary) {
  const auto& device = config.device;
  dictionary.add<std::uint32_t>(0x1000, 0, "Device type", device.profiles.empty() ? 0 : device.profiles[0].profile_no);
  constexpr std::uint16_t kVisibleString = 0x09;
  dictionary.add(0x1008, 0, "Device name", std::vector<std::uint8_t>(device.type.begin(), device.type.end()))
      .data_type = kVisibleString;
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
        auto& added =
            dictionary.add(entry.index, entry.sub_index, entry.name,
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

/// An object of which only the bytes of one complete access are known: one entry takes them all.
void add_whole_object(const StartupCommand& command, ObjectDictionary& dictionary) {
  constexpr std::size_t kHead = 2;  // sub-index 0 and its padding
  const std::size_t head = command.sub_index == 0 ? std::min(kHead, command.data.size()) : 0;
  if (dictionary.find(command.index, 0) != nullptr || dictionary.find(command.index, 1) != nullptr) return;
  dictionary.add(command.index, 0, "Number of entries", std::uint8_t{1}, true);
  dictionary.add(command.index, 1, command.comment, std::vector<std::uint8_t>(command.data.size() - head), true);
}

/// Objects of the lists of PDOs that PdoObjects makes out of the description.
bool is_pdo_object(const DeviceDescription& device, std::uint16_t index) {
  constexpr std::uint16_t kFirstAssign = 0x1C00, kLastAssign = 0x1C2F;
  if (index >= kFirstAssign && index <= kLastAssign) return true;
  const auto has = [&](const std::vector<Pdo>& pdos) {
    return std::ranges::find(pdos, index, &Pdo::index) != pdos.end();
  };
  return has(device.rx_pdos) || has(device.tx_pdos);
}

/// The dictionary of an ESI file calls many an object read-only that its own start-up commands write: the commands are
/// what the maker has tried.
void make_writable(const DeviceDescription& device, const StartupCommand& command, ObjectDictionary& dictionary) {
  const auto sub_indices =
      command.complete_access ? dictionary.sub_indices(command.index) : std::vector<std::uint8_t>{command.sub_index};
  for (const auto sub_index : sub_indices) {
    auto* entry = dictionary.find(command.index, sub_index);
    if (entry == nullptr) continue;
    entry->writable = true;
    constexpr std::uint16_t kMapped = coe::access::kRxPdo | coe::access::kTxPdo;
    const bool fixed_size = (entry->extra_access & kMapped) != 0 || is_pdo_object(device, command.index);
    if (command.complete_access || fixed_size || command.data.empty() || entry->value.size() == command.data.size())
      continue;
    entry->value.resize(command.data.size());
    entry->bit_length = 0;
  }
}

/// What the description wants to be written at state transitions must be there, also where it has no dictionary.
void add_commanded_objects(const DeviceDescription& device, ObjectDictionary& dictionary) {
  if (!device.mailbox || !device.mailbox->coe) return;
  for (const auto& command : device.mailbox->coe->init_commands) {
    make_writable(device, command, dictionary);
    if (command.complete_access) {
      add_whole_object(command, dictionary);
      continue;
    }
    if (dictionary.find(command.index, command.sub_index) != nullptr) continue;
    dictionary.add(command.index, command.sub_index, command.comment, std::vector<std::uint8_t>(command.data.size()),
                   true);
  }
}

/// The configured list of modules (ETG.5001.1, 0xF030), which a master downloads where the description says so.
void add_module_list(const DeviceDescription& device, ObjectDictionary& dictionary) {
  constexpr std::uint16_t kModuleIdentList = 0xF030;
  constexpr std::size_t kMost = 254;
  const bool wanted = device.slots && (device.slots->download_ident_list || device.download_module_list);
  if (!wanted || !dictionary.sub_indices(kModuleIdentList).empty()) return;
  const auto places = std::min(slot_places(device).size(), kMost);
  dictionary.set_object_name(kModuleIdentList, "Configured module ident list");
  dictionary.add<std::uint8_t>(kModuleIdentList, 0, "Number of entries", 0, true);
  for (std::size_t place = 0; place < places; ++place) {
    dictionary.add<std::uint32_t>(kModuleIdentList, static_cast<std::uint8_t>(place + 1), "Module ident", 0, true);
  }
}

/// The synchronisation type (0x1C32:01, 0x1C33:01) that an operation mode sets must be there to be set.
void add_sync_types(const DeviceDescription& device, ObjectDictionary& dictionary) {
  if (!device.dc || !device.mailbox || !device.mailbox->coe) return;
  constexpr std::uint16_t kFirst = 0x1C30;  // of SyncManager 0
  for (const auto& mode : device.dc->op_modes) {
    for (const auto& manager : mode.sync_managers) {
      const auto index = static_cast<std::uint16_t>(kFirst + manager.number);
      if (!manager.sync_type || manager.number > 31 || dictionary.find(index, 1) != nullptr) continue;
      dictionary.add<std::uint8_t>(index, 0, "Number of entries", 1);
      dictionary.add<std::uint16_t>(index, 1, "Synchronisation type", 0, true);
    }
  }
}

}  // namespace

void add_device_objects(const SimSlaveConfig& config, ObjectDictionary& dictionary) {
  add_identity(config, dictionary);
  add_mapped_objects(config.device, dictionary);
  add_described_objects(config.device, dictionary);
  add_commanded_objects(config.device, dictionary);
  add_module_list(config.device, dictionary);
  add_sync_types(config.device, dictionary);
}

}  // namespace syncline::sim
