// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "eni/esi_device.h"
#include "eni/xml_text.h"
#include "protocol/error_text.h"
#include "support/byte_order.h"

/// The ESI describes objects by data types that name further data types; what a configurator needs is a list of
/// sub-indices with their own type, size, access and default.
namespace syncline::eni {
namespace {

struct Access {
  bool readable = true;
  bool writable = false;
};

std::optional<Access> read_access(const Node& flags) {
  const auto text = flags.child("Access").trimmed();
  if (text.empty()) return std::nullopt;
  const bool writable = text.find('w') != std::string::npos;
  return Access{!writable || text.find('r') != std::string::npos, writable};  // "const" is read like "ro"
}

std::uint16_t bit_size(const Node& node) {
  const auto bits = node.child_number<std::int64_t>("BitSize").value_or(0);
  return static_cast<std::uint16_t>(std::clamp<std::int64_t>(bits, 0, 0xFFFF));
}

std::vector<std::uint8_t> default_data(const Node& info, std::uint16_t bits) {
  if (const Node data = info.child("DefaultData")) return data.bytes();
  if (const Node text = info.child("DefaultString")) {
    const auto value = text.text();
    return {value.begin(), value.end()};
  }
  if (const Node value = info.child("DefaultValue"); value && bits > 0 && bits <= 64) {
    auto bytes = le_bytes(static_cast<std::uint64_t>(value.number<std::int64_t>()));
    bytes.resize((bits + 7U) / 8U);
    return bytes;
  }
  return {};
}

class DictionaryReader {
 public:
  explicit DictionaryReader(const Node& dictionary) {
    for (const Node& type : dictionary.child("DataTypes").children("DataType")) {
      types_.emplace(type.child("Name").trimmed(), type);
    }
  }

  [[nodiscard]] ObjectDescription object(const Node& node) const {
    ObjectDescription object;
    object.index = node.required("Index").number<std::uint16_t>();
    object.name = node.localized("Name").trimmed();
    const auto type_name = node.child("Type").trimmed();
    const Node type = find(type_name);
    const auto access = read_access(node.child("Flags")).value_or(Access{});
    if (type.child("SubItem")) {
      for (const Node& item : type.children("SubItem")) add_item(object, item, access);
      add_defaults(object, node.child("Info"));
    } else {
      object.entries.push_back({.sub_index = 0,
                                .name = object.name,
                                .data_type = type_name,
                                .bit_length = node.child("BitSize") ? bit_size(node) : bit_size(type),
                                .readable = access.readable,
                                .writable = access.writable,
                                .default_data = {}});
      object.entries.front().default_data = default_data(node.child("Info"), object.entries.front().bit_length);
    }
    std::ranges::stable_sort(object.entries, {}, &ObjectEntry::sub_index);
    return object;
  }

 private:
  [[nodiscard]] Node find(const std::string& name) const {
    const auto found = types_.find(name);
    return found == types_.end() ? Node() : found->second;
  }

  void add_item(ObjectDescription& object, const Node& item, const Access& of_object) const {
    const auto access = read_access(item.child("Flags")).value_or(of_object);
    const auto type_name = item.child("Type").trimmed();
    ObjectEntry entry{.sub_index = 0,
                      .name = item.localized("Name").trimmed(),
                      .data_type = type_name,
                      .bit_length = bit_size(item),
                      .readable = access.readable,
                      .writable = access.writable,
                      .default_data = {}};
    const Node type = find(type_name);
    const Node array = type.child("ArrayInfo");
    if (array) {
      add_elements(object, type, array, std::move(entry));
      return;
    }
    // Sub-item without SubIdx: the number of entries, which every structure begins with.
    entry.sub_index = item.child_number<std::uint8_t>("SubIdx").value_or(0);
    if (entry.bit_length == 0) entry.bit_length = bit_size(type);
    object.entries.push_back(std::move(entry));
  }

  void add_elements(ObjectDescription& object, const Node& type, const Node& array, ObjectEntry entry) const {
    const auto first = std::max<std::int64_t>(array.child_number<std::int64_t>("LBound").value_or(1), 0);
    const auto count = std::clamp<std::int64_t>(array.child_number<std::int64_t>("Elements").value_or(0), 0, 255);
    const auto base_name = type.child("BaseType").trimmed();
    const auto base_bits = bit_size(find(base_name));
    const auto total = entry.bit_length != 0 ? entry.bit_length : bit_size(type);
    const auto name = entry.name;
    entry.data_type = base_name;
    entry.bit_length = base_bits != 0 || count == 0 ? base_bits : static_cast<std::uint16_t>(total / count);
    for (std::int64_t i = first; i < first + count && i <= 0xFF; ++i) {
      entry.sub_index = static_cast<std::uint8_t>(i);
      entry.name = name.empty() || name == "Elements" ? fmt::format("SubIndex {:03}", i) : name;
      object.entries.push_back(entry);
    }
  }

  /// Info/SubItem follow the sub-indices in order; their names are more telling than those of an array's elements.
  static void add_defaults(ObjectDescription& object, const Node& info) {
    const auto items = info.children("SubItem");
    if (items.size() > object.entries.size()) return;
    for (std::size_t i = 0; i < items.size(); ++i) {
      auto& entry = object.entries[i];
      if (auto name = items[i].localized("Name").trimmed(); !name.empty()) entry.name = std::move(name);
      entry.default_data = default_data(items[i].child("Info"), entry.bit_length);
    }
  }

  std::map<std::string, Node> types_;
};

}  // namespace

std::vector<ObjectDescription> read_dictionary(const Node& profile, FileWarnings& warnings) {
  std::vector<ObjectDescription> objects;
  const Node dictionary = profile.child("Dictionary");
  if (!dictionary) return objects;
  Reading reading(profile.reading().file());
  const DictionaryReader reader(dictionary.with(reading));
  for (const Node& node : dictionary.child("Objects").children("Object")) {
    Reading of_object(reading.file());
    auto object = reader.object(node.with(of_object));
    if (of_object.ok()) {
      objects.push_back(std::move(object));
    } else {
      const Error& error = *of_object.error();
      warnings.push_back({error.file, error.line, error.subject, "the object is left out: " + describe(error)});
    }
  }
  return objects;
}

}  // namespace syncline::eni
