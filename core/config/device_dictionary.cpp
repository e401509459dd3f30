// SPDX-License-Identifier: Apache-2.0
#include "config/device_dictionary.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "config/device_description.h"

namespace syncline {
namespace {

const ObjectEntry* find_entry(const DeviceDictionary& dictionary, std::uint16_t index, std::uint8_t sub_index) {
  const auto object = std::ranges::find(dictionary.objects, index, &ObjectDescription::index);
  if (object == dictionary.objects.end()) return nullptr;
  const auto entry = std::ranges::find(object->entries, sub_index, &ObjectEntry::sub_index);
  return entry == object->entries.end() ? nullptr : &*entry;
}

std::string entry_name(const DeviceDictionary& dictionary, const PdoEntry& entry, const ObjectEntry* described) {
  if (described != nullptr && !described->name.empty()) return described->name;
  const auto object = std::ranges::find(dictionary.objects, entry.index, &ObjectDescription::index);
  if (object != dictionary.objects.end() && !object->name.empty()) return object->name;
  return fmt::format("0x{:04x}:{:02x}", entry.index, entry.sub_index);
}

Pdo pdo_of(const DictionaryPdo& from, const DeviceDictionary& dictionary) {
  Pdo pdo;
  pdo.index = from.index;
  pdo.name = from.name.empty() ? fmt::format("PDO 0x{:04x}", from.index) : from.name;
  pdo.fixed = !from.writable;
  for (const auto word : from.mapped) {
    PdoEntry entry;
    const auto mapped = PdoMapping::of(word);
    entry.index = mapped.index;
    entry.sub_index = mapped.sub_index;
    entry.bit_length = mapped.bits;
    if (entry.index != 0) {
      const auto* described = find_entry(dictionary, entry.index, entry.sub_index);
      entry.name = entry_name(dictionary, entry, described);
      if (described != nullptr) entry.data_type = described->data_type;
      if (entry.data_type.empty())
        entry.data_type = entry.bit_length == 1 ? "BOOL" : fmt::format("BIT{}", entry.bit_length);
    }
    pdo.entries.push_back(std::move(entry));
  }
  return pdo;
}

std::optional<std::uint8_t> manager_of(const DeviceDescription& device, SyncManagerType type) {
  const auto found = std::ranges::find(device.sync_managers, type, &SyncManagerDescription::type);
  if (found == device.sync_managers.end()) return std::nullopt;
  return static_cast<std::uint8_t>(found - device.sync_managers.begin());
}

/// The assigned ones first and in the order of their assignment, which is that of the process data.
void replace(std::vector<Pdo>& pdos, const std::vector<DictionaryPdo>& from, const std::vector<std::uint16_t>& assigned,
             std::optional<std::uint8_t> manager, const DeviceDictionary& dictionary) {
  if (from.empty()) return;
  std::vector<Pdo> known;
  for (const auto& pdo : from) known.push_back(pdo_of(pdo, dictionary));
  const auto rank = [&](const Pdo& pdo) { return std::ranges::find(assigned, pdo.index) - assigned.begin(); };
  std::ranges::stable_sort(known, {}, rank);
  for (auto& pdo : known) {
    if (std::ranges::find(assigned, pdo.index) != assigned.end()) pdo.sync_manager = manager;
  }
  pdos = std::move(known);
}

}  // namespace

void complete_from_dictionary(DeviceDescription& device, const DeviceDictionary& dictionary) {
  if (!dictionary.objects.empty()) device.dictionary = dictionary.objects;
  replace(device.rx_pdos, dictionary.rx_pdos, dictionary.assigned_rx, manager_of(device, SyncManagerType::kOutputs),
          dictionary);
  replace(device.tx_pdos, dictionary.tx_pdos, dictionary.assigned_tx, manager_of(device, SyncManagerType::kInputs),
          dictionary);
}

}  // namespace syncline
