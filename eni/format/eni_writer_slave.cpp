// SPDX-License-Identifier: Apache-2.0
#include "config/slave_config.h"
#include "eni/format/eni_element.h"
#include "eni/format/eni_text.h"
#include "eni/format/eni_writer.h"

namespace syncline::eni {
namespace {

/// The schema knows no word for one that is not used.
std::string_view type_name(SyncManagerType type) {
  const auto word = sync_manager_word(type);
  return word.empty() ? sync_manager_word(SyncManagerType::kOutputs) : word;
}

void write_range(EniText& out, std::string_view element, const ImageRange& range) {
  std::vector<std::string> names;
  for (int number = 0; number < kMaxSyncManagers; ++number) {
    if ((range.sync_managers >> number & 1) != 0) {
      names.push_back("Sm" + EniText::decimal(number));
    }
  }
  std::vector<EniText::Attribute> attributes;
  for (const std::string& name : names) {
    attributes.push_back({name, out.flag(true)});
  }
  out.open(element, attributes);
  out.number("BitStart", range.bit_start);
  out.number("BitLength", range.bit_length);
  out.close();
}

void write_ranges(EniText& out, std::string_view element, const std::optional<ImageRange>& whole,
                  const std::vector<ImageRange>& parts) {
  if (parts.empty() && whole) {
    write_range(out, element, *whole);
  }
  for (const ImageRange& part : parts) {
    write_range(out, element, part);
  }
}

void write_optional(EniText& out, std::string_view element, const std::optional<std::uint16_t>& value) {
  if (value) {
    out.number(element, *value);
  }
}

void write_sync_manager(EniText& out, const ConfiguredSyncManager& manager) {
  const SyncManagerDescription& description = manager.description;
  out.open("Sm" + EniText::decimal(manager.number));
  out.text("Type", type_name(description.type));
  write_optional(out, "MinSize", description.min_size);
  write_optional(out, "MaxSize", description.max_size);
  write_optional(out, "DefaultSize", description.default_size);
  out.number("StartAddress", description.start_address);
  out.number("ControlByte", description.control_byte);
  out.boolean("Enable", description.enable);
  if (description.is_virtual) {
    out.boolean("Virtual", true);
  }
  if (manager.watchdog) {
    out.number("Watchdog", *manager.watchdog);
  }
  for (const std::uint16_t pdo : manager.pdos) {
    out.number("Pdo", pdo);
  }
  out.close();
}

void write_entry(EniText& out, const PdoEntry& entry) {
  out.open("Entry", {{"Fixed", out.flag(entry.fixed)}});
  out.hex_number("Index", entry.index);
  if (entry.index != 0) {
    out.number("SubIndex", entry.sub_index);
  }
  out.number("BitLen", entry.bit_length);
  if (entry.index != 0 || !entry.name.empty()) {
    out.text("Name", entry.name);
  }
  if (!entry.comment.empty()) {
    out.text("Comment", entry.comment);
  }
  if (!entry.data_type.empty()) {
    out.open("DataType", {{"DScale", entry.scale}, {"SwapData", entry.swap == 0 ? "" : EniText::decimal(entry.swap)}});
    out.content(entry.data_type);
    out.close();
  }
  out.close();
}

template <class T>
std::string optional_text(const std::optional<T>& value) {
  return value ? EniText::decimal(*value) : std::string();
}

void write_pdo(EniText& out, const ConfiguredPdo& configured) {
  const Pdo& pdo = configured.pdo;
  out.open(configured.direction == PdoDirection::kTx ? "TxPdo" : "RxPdo",
           {{"Fixed", out.flag(pdo.fixed)},
            {"Mandatory", out.flag(pdo.mandatory)},
            {"Virtual", out.flag(pdo.is_virtual)},
            {"Sm", optional_text(pdo.sync_manager)},
            {"Su", optional_text(pdo.sync_unit)},
            {"PdoOrder", optional_text(pdo.order)},
            {"OSFac", optional_text(pdo.os_factor)},
            {"OSMin", optional_text(pdo.os_min)},
            {"OSMax", optional_text(pdo.os_max)},
            {"OSIndexInc", optional_text(pdo.os_index_increment)},
            {"OverwrittenByModule", out.flag(pdo.overwritten_by_module)}});
  out.hex_number("Index", pdo.index);
  out.text("Name", pdo.name);
  for (const std::uint16_t excluded : pdo.exclude) {
    out.hex_number("Exclude", excluded);
  }
  for (const PdoEntry& entry : pdo.entries) {
    write_entry(out, entry);
  }
  out.close();
}

}  // namespace

void write_process_data(EniText& out, const SlaveConfig& slave) {
  if (!slave.send && !slave.receive && slave.sync_managers.empty() && slave.pdos.empty()) {
    return;
  }
  out.open("ProcessData");
  write_ranges(out, "Send", slave.send, slave.send_parts);
  write_ranges(out, "Recv", slave.receive, slave.receive_parts);
  for (const auto& manager : slave.sync_managers) {
    write_sync_manager(out, manager);
  }
  for (const auto& pdo : slave.pdos) {
    write_pdo(out, pdo);
  }
  out.close();
}

}  // namespace syncline::eni
