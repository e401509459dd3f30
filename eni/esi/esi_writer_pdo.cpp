// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "config/pdo_description.h"
#include "eni/esi/esi_attributes.h"
#include "eni/esi/esi_writer.h"

namespace syncline::eni {
namespace {

void write_use(XmlWriter& xml, const Pdo& pdo) {
  flag(xml, "Fixed", pdo.fixed);
  flag(xml, "Mandatory", pdo.mandatory);
  flag(xml, "Virtual", pdo.is_virtual);
  optional_attribute(xml, "Sm", pdo.sync_manager);
  optional_attribute(xml, "Su", pdo.sync_unit);
  optional_attribute(xml, "PdoOrder", pdo.order);
  optional_attribute(xml, "OSFac", pdo.os_factor);
  optional_attribute(xml, "OSMin", pdo.os_min);
  optional_attribute(xml, "OSMax", pdo.os_max);
  optional_attribute(xml, "OSIndexInc", pdo.os_index_increment);
  flag(xml, "OverwrittenByModule", pdo.overwritten_by_module);
}

void write_entry(XmlWriter& xml, const PdoEntry& entry) {
  xml.open("Entry");
  flag(xml, "Fixed", entry.fixed);
  index_element(xml, "Index", entry.index, entry.depend_on_slot, entry.depend_on_slot_group);
  if (entry.index != 0 || entry.sub_index != 0) xml.element("SubIndex", decimal(entry.sub_index));
  xml.element("BitLen", decimal(entry.bit_length));
  text_element(xml, "Name", entry.name);
  text_element(xml, "DataType", entry.data_type);
  xml.close();
}

}  // namespace

void write_pdo(XmlWriter& xml, std::string_view tag, const Pdo& pdo) {
  xml.open(tag);
  write_use(xml, pdo);
  index_element(xml, "Index", pdo.index, pdo.depend_on_slot, pdo.depend_on_slot_group);
  xml.element("Name", pdo.name);
  for (const auto index : pdo.exclude) {
    index_element(xml, "Exclude", index, std::ranges::count(pdo.exclude_by_slot, index) > 0, false);
  }
  for (const PdoEntry& entry : pdo.entries) write_entry(xml, entry);
  for (const auto manager : pdo.excluded_sync_managers) xml.element("ExcludedSm", decimal(manager));
  xml.close();
}

}  // namespace syncline::eni
