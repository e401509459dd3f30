// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "eni/esi_writer.h"
#include "eni/xml_number.h"

namespace syncline::eni {
namespace {

std::string_view access_text(const ObjectEntry& entry) {
  return !entry.writable ? "ro" : entry.readable ? "rw" : "wo";
}

void write_access(XmlWriter& xml, const ObjectEntry& entry) {
  xml.open("Flags").element("Access", access_text(entry)).close();
}

void write_default(XmlWriter& xml, const ObjectEntry& entry) {
  if (!entry.default_data.empty()) xml.open("Info").element("DefaultData", hex_bytes(entry.default_data)).close();
}

/// A variable needs no data type of its own.
bool is_variable(const ObjectDescription& object) {
  return object.entries.size() == 1 && object.entries.front().sub_index == 0 &&
         object.entries.front().name == object.name;
}

void write_structure(XmlWriter& xml, const std::string& type_name, const ObjectDescription& object) {
  std::uint32_t offset = 0;
  xml.open("DataType").element("Name", type_name);
  for (const auto& entry : object.entries) offset += entry.bit_length;
  xml.element("BitSize", fmt::format("{}", offset));
  offset = 0;
  for (const auto& entry : object.entries) {
    xml.open("SubItem").element("SubIdx", fmt::format("{}", entry.sub_index)).element("Name", entry.name);
    xml.element("Type", entry.data_type).element("BitSize", fmt::format("{}", entry.bit_length));
    xml.element("BitOffs", fmt::format("{}", offset));
    write_access(xml, entry);
    xml.close();
    offset += entry.bit_length;
  }
  xml.close();
}

void write_object(XmlWriter& xml, const std::string& type_name, const ObjectDescription& object) {
  xml.open("Object").element("Index", hex_dec(object.index)).element("Name", object.name);
  if (is_variable(object)) {
    const ObjectEntry& entry = object.entries.front();
    xml.element("Type", entry.data_type).element("BitSize", fmt::format("{}", entry.bit_length));
    write_default(xml, entry);
    write_access(xml, entry);
  } else {
    xml.element("Type", type_name);
    if (std::ranges::any_of(object.entries, [](const ObjectEntry& e) { return !e.default_data.empty(); })) {
      xml.open("Info");
      for (const auto& entry : object.entries) {
        xml.open("SubItem").element("Name", entry.name);
        write_default(xml, entry);
        xml.close();
      }
      xml.close();
    }
  }
  xml.close();
}

std::vector<std::string> structure_names(const std::vector<ObjectDescription>& objects) {
  std::set<std::string> used;
  std::vector<std::string> names;
  for (const auto& object : objects) {
    const auto base = fmt::format("DT{:04X}", object.index);
    std::string name = base;
    for (int n = 2; !used.insert(name).second; ++n) name = fmt::format("{}_{}", base, n);
    names.push_back(std::move(name));
  }
  return names;
}

}  // namespace

void write_dictionary(XmlWriter& xml, const std::vector<ObjectDescription>& objects) {
  if (objects.empty()) return;
  const auto names = structure_names(objects);
  xml.open("Dictionary").open("DataTypes");
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (!is_variable(objects[i])) write_structure(xml, names[i], objects[i]);
  }
  xml.close().open("Objects");
  for (std::size_t i = 0; i < objects.size(); ++i) write_object(xml, names[i], objects[i]);
  xml.close().close();
}

}  // namespace syncline::eni
