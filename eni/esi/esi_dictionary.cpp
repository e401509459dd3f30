// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "eni/esi/esi_device.h"
#include "eni/xml/xml_text.h"
#include "findings/error_text.h"
#include "reasons/because.h"
#include "support/byte_order.h"

/// The ESI describes objects by data types that name further data types; what a configurator needs is a list of
/// sub-indices with their own type, size, access and default.
namespace syncline::eni {
namespace {

/// What Flags say about an entry; sub-items that are silent follow their object.
struct Flags {
  bool readable = true, writable = false;
  bool rx_mappable = false, tx_mappable = false;
  ObjectCategory category = ObjectCategory::kOptional;
  bool backup = false, setting = false;
  std::string read_restrictions{}, write_restrictions{};

  void apply(ObjectEntry& entry) const {
    entry.readable = readable;
    entry.writable = writable;
    entry.rx_mappable = rx_mappable;
    entry.tx_mappable = tx_mappable;
    entry.category = category;
    entry.backup = backup;
    entry.setting = setting;
    entry.read_restrictions = read_restrictions;
    entry.write_restrictions = write_restrictions;
  }
};

void read_access(const Node& node, Flags& flags) {
  const auto text = node.trimmed();
  if (text.empty()) return;
  flags.writable = text.find('w') != std::string::npos;
  flags.readable = !flags.writable || text.find('r') != std::string::npos;  // "const" is read like "ro"
  flags.read_restrictions = node.attribute("ReadRestrictions");
  flags.write_restrictions = node.attribute("WriteRestrictions");
}

bool has_letter(const std::string& text, char lower) {
  return text.find(lower) != std::string::npos || text.find(static_cast<char>(lower - 32)) != std::string::npos;
}

Flags read_flags(const Node& node, Flags flags = {}) {
  if (!node) return flags;
  read_access(node.child("Access"), flags);
  if (const Node mapping = node.child("PdoMapping")) {
    flags.rx_mappable = has_letter(mapping.text(), 'r');
    flags.tx_mappable = has_letter(mapping.text(), 't');
  }
  const auto category = node.child("Category").trimmed();
  if (category == "m" || category == "M") flags.category = ObjectCategory::kMandatory;
  if (category == "c" || category == "C") flags.category = ObjectCategory::kConditional;
  if (category == "o" || category == "O") flags.category = ObjectCategory::kOptional;
  if (const auto backup = node.child_number<int>("Backup")) flags.backup = *backup != 0;
  if (const auto setting = node.child_number<int>("Setting")) flags.setting = *setting != 0;
  return flags;
}

std::uint16_t bit_size(const Node& node) {
  const auto bits = node.child_number<std::int64_t>("BitSize").value_or(0);
  return static_cast<std::uint16_t>(std::clamp<std::int64_t>(bits, 0, 0xFFFF));
}

/// A value as data, text or number: DefaultData, DefaultString, DefaultValue; MinData ...
std::vector<std::uint8_t> read_value(const Node& info, const std::string& what, std::uint16_t bits) {
  if (const Node data = info.child((what + "Data").c_str())) return data.bytes();
  if (const Node text = info.child((what + "String").c_str())) {
    const auto value = text.text();
    return {value.begin(), value.end()};
  }
  const Node value = info.child((what + "Value").c_str());
  if (!value || value.trimmed().empty() || bits == 0 || bits > 64) return {};
  auto bytes = le_bytes(static_cast<std::uint64_t>(value.number<std::int64_t>()));
  bytes.resize((bits + 7U) / 8U);
  return bytes;
}

/// `info`: an Info element, or a SubItem, which may carry the same.
void read_values(const Node& info, ObjectEntry& entry) {
  const auto set = [&](const char* what, std::vector<std::uint8_t>& target) {
    if (auto value = read_value(info, what, entry.bit_length); !value.empty()) target = std::move(value);
  };
  set("Default", entry.default_data);
  set("Min", entry.min_data);
  set("Max", entry.max_data);
}

constexpr std::size_t kMostEntries = 1024;  // of one object; sub-indices are bytes, but some files repeat them
constexpr std::size_t kMostOfDictionary =
    500'000;  // data types multiply: few lines of a file can stand for many entries

class DictionaryReader {
 public:
  explicit DictionaryReader(const Node& dictionary) {
    for (const Node& type : dictionary.child("DataTypes").children("DataType")) {
      types_.emplace(type.child("Name").trimmed(), type);
    }
  }

  [[nodiscard]] ObjectDescription object(const Node& node) const {
    ObjectDescription object;
    const Node index = node.required("Index");
    object.index = index.number<std::uint16_t>();
    object.depend_on_slot = index.boolean("DependOnSlot").value_or(false);
    object.depend_on_slot_group = index.boolean("DependOnSlotGroup").value_or(false);
    object.overwritten_by_module = index.boolean("OverwrittenByModule").value_or(false);
    object.name = node.localized("Name").trimmed();
    const auto type_name = node.child("Type").trimmed();
    const Node type = find(type_name);
    const auto flags = read_flags(node.child("Flags"));
    if (type.child("SubItem")) {
      add_items(object, type, flags);
      if (object.entries.size() > kMostEntries)
        node.fail(ErrorCode::kXmlBadValue, because("it has too many sub-indices"));
      add_defaults(object, node.child("Info"));
    } else {
      object.entries.push_back(variable(node, object.name, type_name, flags));
    }
    return object;
  }

 private:
  [[nodiscard]] ObjectEntry variable(const Node& node, const std::string& name, const std::string& type_name,
                                     const Flags& flags) const {
    ObjectEntry entry{.sub_index = 0,
                      .name = name,
                      .data_type = type_name,
                      .bit_length = node.child("BitSize") ? bit_size(node) : bit_size(find(type_name)),
                      .default_data = {}};
    flags.apply(entry);
    read_values(node.child("Info"), entry);
    return entry;
  }

  void add_items(ObjectDescription& object, const Node& type, const Flags& flags) const {
    bool has_array = false;
    for (const Node& item : type.children("SubItem")) {
      if (object.entries.size() > kMostEntries) return;  // the caller says so
      has_array = static_cast<bool>(find(item.child("Type").trimmed()).child("ArrayInfo")) || has_array;
      add_item(object, item, flags);
    }
    // Nearly every file has them in order; entries are large.
    if (!std::ranges::is_sorted(object.entries, {}, &ObjectEntry::sub_index))
      std::ranges::stable_sort(object.entries, {}, &ObjectEntry::sub_index);
    object.code = has_array && is_uniform_array(object) ? ObjectCode::kArray : ObjectCode::kRecord;
  }

  [[nodiscard]] Node find(const std::string& name) const {
    const auto found = types_.find(name);
    return found == types_.end() ? Node() : found->second;
  }

  void add_item(ObjectDescription& object, const Node& item, const Flags& of_object) const {
    const auto type_name = item.child("Type").trimmed();
    ObjectEntry entry{.sub_index = 0,
                      .name = item.localized("Name").trimmed(),
                      .data_type = type_name,
                      .bit_length = bit_size(item),
                      .default_data = {}};
    read_flags(item.child("Flags"), of_object).apply(entry);
    entry.bit_offset = static_cast<std::uint32_t>(
        std::clamp<std::int64_t>(item.child_number<std::int64_t>("BitOffs").value_or(0), 0, 0xFFFFFF));
    const Node type = find(type_name);
    const Node array = type.child("ArrayInfo");
    // An array that has a sub-index is the value of that one entry, e.g. the 16 bytes of a diagnosis message.
    entry.sub_index = item.child_number<std::uint8_t>("SubIdx").value_or(0);
    if (array && entry.sub_index == 0) {
      add_elements(object, type, array, std::move(entry));
      return;
    }
    // Without SubIdx: the number of entries, which every structure begins with.
    if (entry.bit_length == 0) entry.bit_length = bit_size(type);
    read_values(item, entry);
    object.entries.push_back(std::move(entry));
  }

  void add_elements(ObjectDescription& object, const Node& type, const Node& array, ObjectEntry entry) const {
    const auto first = std::clamp<std::int64_t>(array.child_number<std::int64_t>("LBound").value_or(1), 0, 256);
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
      entry.bit_offset += entry.bit_length;
    }
  }

  /// Info/SubItem follow the sub-indices in order; their names are more telling than those of an array's elements.
  static void add_defaults(ObjectDescription& object, const Node& info) {
    const auto items = info.children("SubItem");
    if (items.size() > object.entries.size()) return;
    for (std::size_t i = 0; i < items.size(); ++i) {
      auto& entry = object.entries[i];
      if (auto name = items[i].localized("Name").trimmed(); !name.empty()) entry.name = std::move(name);
      read_values(items[i].child("Info"), entry);
    }
  }

  std::map<std::string, Node> types_;
};

EnumDescription read_enum(const Node& type) {
  EnumDescription description{.name = type.child("Name").trimmed(),
                              .base_type = type.child("BaseType").trimmed(),
                              .bit_length = bit_size(type)};
  for (const Node& value : type.children("EnumInfo")) {
    description.values.push_back({value.required("Enum").number<std::int64_t>(), value.localized("Text").trimmed()});
  }
  return description;
}

/// Reads one piece; what cannot be read is left out with a warning.
template <class T, class Read>
void read_piece(const Node& node, ReasonRow<1> left_out, std::vector<T>& pieces, const Read& read) {
  Reading part = node.reading().of_part();
  auto piece = read(node.with(part));
  if (part.ok()) {
    pieces.push_back(std::move(piece));
  } else {
    node.reading().warn(part.error()->line, part.error()->subject, because(left_out, reason_of(*part.error())));
  }
}

}  // namespace

bool is_uniform_array(const ObjectDescription& object) {
  if (object.entries.size() < 2 || object.entries.front().sub_index != 0) return false;
  auto expected = object.entries[1];
  expected.default_data = expected.min_data = expected.max_data = {};
  for (std::size_t i = 1; i < object.entries.size(); ++i) {
    auto entry = object.entries[i];
    expected.sub_index = static_cast<std::uint8_t>(i);
    expected.name = entry.name;
    entry.default_data = entry.min_data = entry.max_data = {};
    if (i > 0xFF || entry != expected) return false;
    expected.bit_offset += expected.bit_length;
  }
  return true;
}

void read_dictionary(const Node& dictionary, ReadProfiles& profiles) {
  Reading of_types = dictionary.reading().of_part();
  const DictionaryReader reader(dictionary.with(of_types));
  for (const Node& type : dictionary.child("DataTypes").children("DataType")) {
    if (type.child("EnumInfo")) read_piece(type, "the data type is left out: {error}", profiles.enums, read_enum);
  }
  std::size_t entries = 0;
  for (const Node& node : dictionary.child("Objects").children("Object")) {
    if (entries > kMostOfDictionary) {
      node.warn(because("the dictionary has too many entries; the rest is left out"));
      break;
    }
    const auto before = profiles.dictionary.size();
    read_piece(node, "the object is left out: {error}", profiles.dictionary,
               [&reader](const Node& part) { return reader.object(part); });
    if (profiles.dictionary.size() > before) entries += profiles.dictionary.back().entries.size();
  }
  if (const auto& error = of_types.error()) of_types.warn(error->line, error->subject, reason_of(*error));
}

}  // namespace syncline::eni
