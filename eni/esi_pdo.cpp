// SPDX-License-Identifier: Apache-2.0
#include "eni/esi_device.h"
#include "eni/xml_text.h"

namespace syncline::eni {
namespace {

PdoEntry read_entry(const Node& node) {
  PdoEntry entry;
  entry.index = node.required("Index").number<std::uint16_t>();
  entry.sub_index = node.child_number<std::uint8_t>("SubIndex").value_or(0);
  entry.bit_length = node.required("BitLen").number<std::uint16_t>();
  entry.name = node.localized("Name").trimmed();
  entry.data_type = node.child("DataType").trimmed();
  return entry;
}

}  // namespace

Pdo read_pdo(const Node& node) {
  Pdo pdo;
  pdo.index = node.required("Index").number<std::uint16_t>();
  pdo.name = node.localized("Name").trimmed();
  pdo.sync_manager = node.number<std::uint8_t>("Sm");
  pdo.fixed = node.boolean("Fixed").value_or(false);
  pdo.mandatory = node.boolean("Mandatory").value_or(false);
  for (const Node& exclude : node.children("Exclude")) pdo.exclude.push_back(exclude.number<std::uint16_t>());
  for (const Node& entry : node.children("Entry")) pdo.entries.push_back(read_entry(entry));
  return pdo;
}

}  // namespace syncline::eni
