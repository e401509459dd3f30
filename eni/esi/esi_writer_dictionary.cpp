// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "config/object_description.h"
#include "eni/esi/esi_attributes.h"
#include "eni/esi/esi_writer.h"

namespace syncline::eni {
namespace {

std::string_view access_text(const ObjectEntry& entry) { return !entry.writable ? "ro" : entry.readable ? "rw" : "wo"; }

std::string_view category_text(ObjectCategory category) {
  switch (category) {
    case ObjectCategory::kOptional:
      return "";
    case ObjectCategory::kMandatory:
      return "m";
    case ObjectCategory::kConditional:
      return "c";
  }
  return "";
}

std::string_view mapping_text(const ObjectEntry& entry) {
  if (entry.rx_mappable) return entry.tx_mappable ? "TR" : "R";
  return entry.tx_mappable ? "T" : "";
}

void write_flags(XmlWriter& xml, const ObjectEntry& entry) {
  xml.open("Flags").open("Access");
  text_attribute(xml, "ReadRestrictions", entry.read_restrictions);
  text_attribute(xml, "WriteRestrictions", entry.write_restrictions);
  xml.text(access_text(entry)).close();
  text_element(xml, "Category", category_text(entry.category));
  text_element(xml, "PdoMapping", mapping_text(entry));
  if (entry.backup) xml.element("Backup", "1");
  if (entry.setting) xml.element("Setting", "1");
  xml.close();
}

bool has_values(const ObjectEntry& entry) {
  return !entry.default_data.empty() || !entry.min_data.empty() || !entry.max_data.empty();
}

void write_values(XmlWriter& xml, const ObjectEntry& entry) {
  if (!has_values(entry)) return;
  xml.open("Info");
  text_element(xml, "MinData", hex_bytes(entry.min_data));
  text_element(xml, "MaxData", hex_bytes(entry.max_data));
  text_element(xml, "DefaultData", hex_bytes(entry.default_data));
  xml.close();
}

bool is_variable(const ObjectDescription& object) {
  return object.code == ObjectCode::kVariable && object.entries.size() == 1 && object.entries.front().sub_index == 0 &&
         object.entries.front().name == object.name && object.entries.front().bit_offset == 0;
}

std::uint32_t end_of(const ObjectDescription& object) {
  std::uint32_t end = 0;
  for (const auto& entry : object.entries) end = std::max(end, entry.bit_offset + entry.bit_length);
  return end;
}

void write_item(XmlWriter& xml, const ObjectEntry& entry, const std::string& type, std::uint32_t bits) {
  xml.open("SubItem");
  if (entry.sub_index != 0) xml.element("SubIdx", decimal(entry.sub_index));
  xml.element("Name", entry.name)
      .element("Type", type)
      .element("BitSize", decimal(bits))
      .element("BitOffs", decimal(entry.bit_offset));
  write_flags(xml, entry);
  xml.close();
}

void write_structure(XmlWriter& xml, const std::string& type_name, const ObjectDescription& object) {
  xml.open("DataType").element("Name", type_name).element("BitSize", decimal(end_of(object)));
  for (const auto& entry : object.entries) write_item(xml, entry, entry.data_type, entry.bit_length);
  xml.close();
}

/// An array is a data type of its own inside of a structure that begins with the number of elements.
void write_array(XmlWriter& xml, const std::string& type_name, const ObjectDescription& object) {
  const auto& first = object.entries[1];
  const auto count = static_cast<std::uint32_t>(object.entries.size() - 1);
  const auto bits = count * first.bit_length;
  xml.open("DataType").element("Name", type_name + "ARR").element("BaseType", first.data_type);
  xml.element("BitSize", decimal(bits));
  xml.open("ArrayInfo").element("LBound", "1").element("Elements", decimal(count)).close().close();
  xml.open("DataType").element("Name", type_name).element("BitSize", decimal(end_of(object)));
  write_item(xml, object.entries.front(), object.entries.front().data_type, object.entries.front().bit_length);
  auto elements = first;
  elements.name = "Elements";
  elements.sub_index = 0;  // stands for all of them
  write_item(xml, elements, type_name + "ARR", bits);
  xml.close();
}

void write_values_of_items(XmlWriter& xml, const ObjectDescription& object) {
  const bool is_array = object.code == ObjectCode::kArray;  // whose elements have names only here
  if (!is_array && std::ranges::none_of(object.entries, has_values)) return;
  xml.open("Info");
  for (const auto& entry : object.entries) {
    xml.open("SubItem").element("Name", entry.name);
    write_values(xml, entry);
    xml.close();
  }
  xml.close();
}

void write_object(XmlWriter& xml, const std::string& type_name, const ObjectDescription& object) {
  xml.open("Object");
  xml.open("Index");
  flag(xml, "DependOnSlot", object.depend_on_slot);
  flag(xml, "DependOnSlotGroup", object.depend_on_slot_group);
  flag(xml, "OverwrittenByModule", object.overwritten_by_module);
  xml.text(hex_dec(object.index)).close();
  xml.element("Name", object.name);
  if (is_variable(object)) {
    const ObjectEntry& entry = object.entries.front();
    xml.element("Type", entry.data_type).element("BitSize", decimal(entry.bit_length));
    write_values(xml, entry);
    write_flags(xml, entry);
  } else {
    xml.element("Type", type_name).element("BitSize", decimal(end_of(object)));
    write_values_of_items(xml, object);
  }
  xml.close();
}

void write_enum(XmlWriter& xml, const EnumDescription& type) {
  xml.open("DataType").element("Name", type.name);
  text_element(xml, "BaseType", type.base_type);
  xml.element("BitSize", decimal(type.bit_length));
  for (const EnumValue& value : type.values) {
    xml.open("EnumInfo").element("Text", value.text).element("Enum", decimal(value.value)).close();
  }
  xml.close();
}

std::vector<std::string> structure_names(const std::vector<ObjectDescription>& objects,
                                         const std::vector<EnumDescription>& enums) {
  std::set<std::string> used;
  for (const auto& type : enums) used.insert(type.name);
  std::vector<std::string> names;
  for (const auto& object : objects) {
    const auto base = fmt::format("DT{:04X}", object.index);
    std::string name = base;
    for (int n = 2; !used.insert(name).second || used.contains(name + "ARR"); ++n) name = fmt::format("{}_{}", base, n);
    names.push_back(std::move(name));
  }
  return names;
}

}  // namespace

void write_dictionary(XmlWriter& xml, const std::vector<ObjectDescription>& objects,
                      const std::vector<EnumDescription>& enums) {
  if (objects.empty() && enums.empty()) return;
  const auto names = structure_names(objects, enums);
  xml.open("Dictionary").open("DataTypes");
  for (const EnumDescription& type : enums) write_enum(xml, type);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (is_variable(objects[i])) continue;
    const bool is_array = objects[i].code == ObjectCode::kArray && objects[i].entries.size() > 1;
    is_array ? write_array(xml, names[i], objects[i]) : write_structure(xml, names[i], objects[i]);
  }
  xml.close().open("Objects");
  for (std::size_t i = 0; i < objects.size(); ++i) write_object(xml, names[i], objects[i]);
  xml.close().close();
}

}  // namespace syncline::eni
