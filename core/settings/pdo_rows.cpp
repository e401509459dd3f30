// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "config/module_slots.h"
#include "config/project.h"
#include "reasons/because.h"
#include "settings/number_text.h"
#include "settings/pdo_places.h"
#include "settings/setting.h"
#include "settings/setting_type.h"
#include "settings/tables.h"

namespace syncline::settings {
namespace {

using PdoIndices = std::vector<std::uint16_t>;

const Pdo* find(const std::vector<Pdo>& pdos, std::uint32_t index) {
  const auto found = std::ranges::find_if(pdos, [index](const Pdo& pdo) { return pdo.index == index; });
  return found == pdos.end() ? nullptr : &*found;
}

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const auto comma = text.find(',');
    parts.push_back(text.substr(0, comma));
    if (comma == std::string_view::npos) break;
    text.remove_prefix(comma + 1);
    if (text.empty()) parts.emplace_back();  // a comma at the end
  }
  return parts;
}

// ---- assignment: slave.N.pdo.rx, slave.N.pdo.tx

std::string index_list(const std::vector<Pdo>& pdos) {
  PdoIndices indices;
  for (const Pdo& pdo : pdos) indices.push_back(pdo.index);
  return indices.empty() ? "none" : format_value(settings::Indices{}, indices);
}

Status check_assignment(const std::vector<Pdo>& pdos, const PdoIndices& chosen) {
  for (const auto index : chosen) {
    const Pdo* pdo = find(pdos, index);
    if (pdo == nullptr) {
      return bad_value(because("the device has no PDO 0x{index} in this direction; it has {indices}",
                               fmt::format("{:04x}", index), index_list(pdos)));
    }
    if (std::ranges::count(chosen, index) > 1)
      return bad_value(because("0x{index} stands there twice", fmt::format("{:04x}", index)));
    for (const auto excluded : pdo->exclude) {
      if (excluded != index && std::ranges::find(chosen, excluded) != chosen.end()) {
        return bad_value(because("0x{index} and 0x{other} exclude each other", fmt::format("{:04x}", index),
                                 fmt::format("{:04x}", excluded)));
      }
    }
  }
  return {};
}

Setting assignment_row(const char* name, PdoDirection direction, PdoIndices SlaveSettings::*assigned) {
  const bool outputs = direction == PdoDirection::kRx;
  Setting row{.key = fmt::format("slave.N.pdo.{}", name),
              .type = Indices{},
              .words = {.label = outputs ? "Outputs (RxPDO)" : "Inputs (TxPDO)",
                        .help = fmt::format("{} in the order in which they lie in the process data.",
                                            outputs ? "RxPDOs (outputs)" : "TxPDOs (inputs)"),
                        .object = outputs ? "0x1C12" : "0x1C13",
                        .eni = outputs ? "ProcessData/RxPdo" : "ProcessData/TxPdo",
                        .preset = "those of the ESI"},
              .read = {},
              .write = {}};
  row.read = [assigned](const Project& project, const Place& place) -> Value {
    return project.slaves[place.slave].*assigned;
  };
  row.write = [direction, assigned](Project& project, const Place& place, const Value& value) -> Status {
    auto& slave = project.slaves[place.slave];
    const auto& chosen = std::get<PdoIndices>(value);
    if (chosen == slave.*assigned) return {};
    if (auto status = check_assignment(pdos_of(slave, direction), chosen); !status) return status;
    slave.*assigned = chosen;
    return {};
  };
  return row;
}

// ---- mapping: slave.N.pdo.map.0xIIII

bool same_object(const PdoEntry& a, const PdoEntry& b) {
  return a.index == b.index && a.sub_index == b.sub_index && a.bit_length == b.bit_length;
}

std::vector<PdoEntry> mapped_entries(const SlaveSettings& slave, std::uint32_t index) {
  const Pdo* changed = find(slave.changed_pdos, index);
  if (changed != nullptr) return changed->entries;
  const auto pdo = pdo_of(slave, index);
  return pdo ? pdo->entries : std::vector<PdoEntry>{};
}

std::string format_mapping(const std::vector<PdoEntry>& entries) {
  std::string text;
  for (const auto& e : entries) {
    text += fmt::format("{}0x{:04x}:{:02x}:{}", text.empty() ? "" : ",", e.index, e.sub_index, e.bit_length);
  }
  return text;
}

/// "0x6040:00:16": index, sub-index (hexadecimal), bits.
Result<PdoEntry> parse_entry(std::string_view text) {
  const auto first = text.find(':');
  const auto second = first == std::string_view::npos ? first : text.find(':', first + 1);
  if (second != std::string_view::npos) {
    const auto index = parse_integer(text.substr(0, first));
    const auto sub = parse_integer("0x" + std::string(text.substr(first + 1, second - first - 1)));
    const auto bits = parse_integer(text.substr(second + 1));
    const bool fits = index && sub && bits && *index >= 0 && *index <= 0xFFFF && *sub >= 0 && *sub <= 0xFF;
    if (fits && *bits >= 1 && *bits <= 255) {  // the mapping object has a byte for the length
      PdoEntry entry;
      entry.index = static_cast<std::uint16_t>(*index);
      entry.sub_index = static_cast<std::uint8_t>(*sub);
      entry.bit_length = static_cast<std::uint16_t>(*bits);
      return entry;
    }
  }
  return bad_value(because("\"{text}\" is no entry INDEX:SUB:BITS like 0x6040:00:16", text));
}

/// Name and type as the device's description knows the object.
void describe_entry(const SlaveSettings& slave, const std::vector<PdoEntry>& current, PdoEntry& entry) {
  const auto take = [&entry](const std::vector<PdoEntry>& entries) {
    const auto known = std::ranges::find_if(entries, [&](const PdoEntry& e) { return same_object(e, entry); });
    if (known == entries.end()) return false;
    entry = *known;
    return true;
  };
  if (take(current) || entry.index == 0) return;
  for (const auto direction : {PdoDirection::kRx, PdoDirection::kTx}) {
    for (const Pdo& pdo : pdos_of(slave, direction)) {
      if (take(pdo.entries)) return;
    }
  }
  for (const auto& object : slave.device.dictionary) {
    if (object.index != entry.index) continue;
    for (const auto& known : object.entries) {
      if (known.sub_index != entry.sub_index || known.bit_length != entry.bit_length) continue;
      entry.name = known.name;
      entry.data_type = known.data_type;
      return;
    }
  }
}

Result<std::vector<PdoEntry>> parse_mapping(std::string_view text, const SlaveSettings& slave,
                                            const std::vector<PdoEntry>& current) {
  std::vector<PdoEntry> entries;
  for (const auto part : split(text)) {
    auto entry = parse_entry(part);
    if (!entry) return tl::unexpected(entry.error());
    describe_entry(slave, current, *entry);
    entries.push_back(std::move(*entry));
  }
  return entries;
}

void store_mapping(SlaveSettings& slave, const Pdo& of_device, std::vector<PdoEntry> entries) {
  std::erase_if(slave.changed_pdos, [&](const Pdo& pdo) { return pdo.index == of_device.index; });
  if (entries == of_device.entries) return;
  Pdo changed = of_device;
  changed.entries = std::move(entries);
  const auto place = std::ranges::upper_bound(slave.changed_pdos, changed.index, {}, &Pdo::index);
  slave.changed_pdos.insert(place, std::move(changed));
}

Status set_mapping(SlaveSettings& slave, std::uint32_t index, std::string_view text) {
  const auto of_device = pdo_of(slave, index);
  if (!of_device) return bad_value(because("the device has no such PDO"));
  const auto current = mapped_entries(slave, index);
  if (text == format_mapping(current)) return {};
  if (of_device->fixed) return bad_value(because("the ESI says that the mapping of this PDO is fixed"));
  if (!slave.device.mailbox || !slave.device.mailbox->coe || !slave.device.mailbox->coe->pdo_config) {
    return bad_value(because("the device does not take another mapping (CoE PdoConfig in its ESI)"));
  }
  auto entries = parse_mapping(text, slave, current);
  if (!entries) return tl::unexpected(entries.error());
  if (std::ranges::equal(*entries, current, same_object)) return {};
  store_mapping(slave, *of_device, std::move(*entries));
  return {};
}

Setting mapping_row() {
  Setting row{.key = "slave.N.pdo.map.0xIIII",
              .type = Record{"list of entries", "INDEX:SUB:BITS with commas; INDEX 0 is padding"},
              .words = {.label = "Mapping",
                        .help = "What PDO 0xIIII carries. Only PDOs that are not fixed can be changed.",
                        .object = "0xIIII",
                        .eni = "ProcessData/RxPdo/Entry, ProcessData/TxPdo/Entry"},
              .read = {},
              .write = {}};
  row.read = [](const Project& project, const Place& place) -> Value {
    return format_mapping(mapped_entries(project.slaves[place.slave], place.item));
  };
  row.write = [](Project& project, const Place& place, const Value& value) {
    return set_mapping(project.slaves[place.slave], place.item, std::get<std::string>(value));
  };
  row.items = [](const Project& project, std::size_t slave) { return pdo_places(project.slaves[slave], slave); };
  return row;
}

}  // namespace

std::vector<Setting> pdo_rows() {
  return {assignment_row("rx", PdoDirection::kRx, &SlaveSettings::assigned_rx_pdos),
          assignment_row("tx", PdoDirection::kTx, &SlaveSettings::assigned_tx_pdos), mapping_row()};
}

}  // namespace syncline::settings
