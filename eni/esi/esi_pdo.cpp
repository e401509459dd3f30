// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <limits>

#include "config/identity.h"
#include "eni/esi/esi_device.h"
#include "eni/xml/xml_text.h"
#include "protocol/coe_data_type.h"
#include "reasons/because.h"

namespace syncline::eni {
namespace {

/// How many channels a template is moved by; see PdoTemplates.
class Channel {
 public:
  explicit Channel(int number) : number_(number) {}

  template <std::integral T>
  [[nodiscard]] T number(const Node& node) const {
    const auto value = static_cast<std::int64_t>(node.number<T>()) + number_ * factor(node);
    if (value < 0 || value > static_cast<std::int64_t>(std::numeric_limits<T>::max())) {
      node.fail(ErrorCode::kXmlBadValue, because("{value} is out of range in channel {channel}", value, number_));
      return T{};
    }
    return static_cast<T>(value);
  }

  /// "Channel #1" counts on.
  [[nodiscard]] std::string name(const Node& node) const {
    auto text = node.trimmed();
    const auto mark = text.rfind('#');
    if (number_ == 0 || factor(node) == 0 || mark == std::string::npos) return text;
    const auto first = parse_number(std::string_view(text).substr(mark + 1));
    return first ? text.substr(0, mark + 1) + std::to_string(*first + number_ * factor(node)) : text;
  }

 private:
  [[nodiscard]] static std::int64_t factor(const Node& node) { return node.number<std::int16_t>("ChnFac").value_or(0); }
  int number_;
};

std::uint16_t read_bit_length(const Node& node, const std::string& data_type) {
  const Node length = node.child("BitLen");
  if (length) return length.number<std::uint16_t>();
  if (const auto* type = coe::find_data_type(data_type); type != nullptr && type->bits > 0) {
    node.warn(because("BitLen is missing; {bits} bits by the data type {type}", type->bits, data_type));
    return type->bits;
  }
  return node.required("BitLen").number<std::uint16_t>();
}

PdoEntry read_entry(const Node& node, const Channel& channel) {
  PdoEntry entry;
  const Node index = node.required("Index");
  entry.index = channel.number<std::uint16_t>(index);
  entry.depend_on_slot = index.boolean("DependOnSlot").value_or(false);
  entry.depend_on_slot_group = index.boolean("DependOnSlotGroup").value_or(false);
  entry.sub_index = channel.number<std::uint8_t>(node.child("SubIndex"));
  entry.name = node.localized("Name").trimmed();
  entry.data_type = node.child("DataType").trimmed();
  entry.bit_length = read_bit_length(node, entry.data_type);
  entry.fixed = node.boolean("Fixed").value_or(false);
  return entry;
}

void read_oversampling(const Node& node, Pdo& pdo) {
  pdo.os_factor = node.number<std::uint16_t>("OSFac");
  pdo.os_min = node.number<std::uint16_t>("OSMin");
  pdo.os_max = node.number<std::uint16_t>("OSMax");
  pdo.os_index_increment = node.number<std::uint16_t>("OSIndexInc");
}

/// What a PDO element says about its use, not about its content.
void read_use(const Node& node, Pdo& pdo) {
  pdo.sync_manager = node.number<std::uint8_t>("Sm");
  pdo.sync_unit = node.number<std::uint8_t>("Su");
  pdo.fixed = node.boolean("Fixed").value_or(false);
  pdo.mandatory = node.boolean("Mandatory").value_or(false);
  pdo.is_virtual = node.boolean("Virtual").value_or(false);
  pdo.overwritten_by_module = node.boolean("OverwrittenByModule").value_or(false);
  pdo.order = node.number<int>("PdoOrder");
  read_oversampling(node, pdo);
}

void read_content(const Node& node, const Channel& channel, Pdo& pdo) {
  const Node index = node.required("Index");
  pdo.index = channel.number<std::uint16_t>(index);
  pdo.depend_on_slot = index.boolean("DependOnSlot").value_or(false);
  pdo.depend_on_slot_group = index.boolean("DependOnSlotGroup").value_or(false);
  pdo.name = channel.name(node.localized("Name"));
  for (const Node& exclude : node.children("Exclude")) {
    pdo.exclude.push_back(channel.number<std::uint16_t>(exclude));
    if (exclude.boolean("DependOnSlot").value_or(false)) pdo.exclude_by_slot.push_back(pdo.exclude.back());
  }
  for (const Node& manager : node.children("ExcludedSm")) {
    pdo.excluded_sync_managers.push_back(manager.number<std::uint8_t>());
  }
  for (const Node& entry : node.children("Entry")) pdo.entries.push_back(read_entry(entry, channel));
}

}  // namespace

Pdo read_pdo(const Node& node, const PdoTemplates& templates) {
  Pdo pdo;
  read_use(node, pdo);
  const auto reference = node.attribute("Ref");
  if (reference.empty() || node.child("Index")) {
    read_content(node, Channel(0), pdo);
    return pdo;
  }
  const auto found = templates.find(reference);
  if (found == templates.end()) {
    node.fail(ErrorCode::kXmlBadValue, because("there is no Pdo with the RefName \"{name}\"", reference));
    return pdo;
  }
  read_content(found->second.with(node.reading()), Channel(node.number<std::uint8_t>("Chn").value_or(0)), pdo);
  return pdo;
}

PdoTemplates read_pdo_templates(const Node& descriptions) {
  PdoTemplates templates;
  for (const Node& pdo : descriptions.child("Pdos").children("Pdo")) templates.emplace(pdo.attribute("RefName"), pdo);
  return templates;
}

void check_pdo_indices(const Node& parent, const std::vector<Pdo>& rx_pdos, const std::vector<Pdo>& tx_pdos) {
  std::map<std::uint16_t, int> seen;
  const auto check = [&](const char* tag, const std::vector<Pdo>& pdos) {
    const auto nodes = parent.children(tag);
    for (std::size_t i = 0; i < pdos.size() && i < nodes.size(); ++i) {
      const auto [first, is_new] = seen.emplace(pdos[i].index, nodes[i].line());
      if (is_new) continue;
      nodes[i].fail(ErrorCode::kXmlBadValue, because("the PDO index 0x{index} is used twice; first in line {line}",
                                                     fmt::format("{:04x}", pdos[i].index), first->second));
    }
  };
  check("RxPdo", rx_pdos);
  check("TxPdo", tx_pdos);
}

}  // namespace syncline::eni
