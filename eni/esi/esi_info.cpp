// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "config/device_description.h"
#include "eni/esi/esi_device.h"
#include "eni/xml/xml_text.h"
#include "support/byte_order.h"

namespace syncline::eni {
namespace {

void read_timeouts(const Node& timeout, StateTimeouts& t) {
  t.preop = timeout.child_number<std::uint32_t>("PreopTimeout").value_or(t.preop);
  t.safeop_op = timeout.child_number<std::uint32_t>("SafeopOpTimeout").value_or(t.safeop_op);
  t.back_to_init = timeout.child_number<std::uint32_t>("BackToInitTimeout").value_or(t.back_to_init);
  t.back_to_safeop = timeout.child_number<std::uint32_t>("BackToSafeopTimeout").value_or(t.back_to_safeop);
}

StartBehavior read_behavior(const Node& node) {
  return {.to_init = node.boolean("StartToInit").value_or(false),
          .to_preop = node.boolean("StartToPreop").value_or(false),
          .to_safeop = node.boolean("StartToSafeop").value_or(false),
          .to_safeop_no_sync = node.boolean("StartToSafeopNoSync").value_or(false)};
}

PortDescription read_port(const Node& node) {
  return {.type = node.child("Type").trimmed(),
          .connector = node.child("Connector").trimmed(),
          .label = node.child("Label").trimmed(),
          .rx_delay = node.child_number<std::int32_t>("RxDelay"),
          .tx_delay = node.child_number<std::int32_t>("TxDelay")};
}

/// The whole image instead of its parts.
void read_whole_eeprom(const Node& data, EepromDescription& eeprom) {
  constexpr std::size_t kConfigBytes = 14, kBootStrapStart = 0x14 * 2, kBootStrapBytes = 8;
  eeprom.image = data.bytes();
  const auto part = [&image = eeprom.image](std::size_t from, std::size_t count) {
    const auto begin = std::min(from, image.size()), end = std::min(from + count, image.size());
    return std::vector<std::uint8_t>(image.begin() + static_cast<std::ptrdiff_t>(begin),
                                     image.begin() + static_cast<std::ptrdiff_t>(end));
  };
  eeprom.byte_size = static_cast<std::uint32_t>(eeprom.image.size());
  eeprom.config_data = part(0, kConfigBytes);
  eeprom.boot_strap = part(kBootStrapStart, kBootStrapBytes);
}

EepromCategory read_category(const Node& node) {
  EepromCategory category;
  category.number = node.required("CatNo").number<std::uint16_t>();
  if (const Node text = node.child("DataString")) {
    const auto value = text.text();
    category.data.assign(value.begin(), value.end());
  } else if (const auto number = node.child_number<std::uint16_t>("DataUINT")) {
    const auto bytes = le_bytes(*number);
    category.data.assign(bytes.begin(), bytes.end());
  } else if (const auto wide = node.child_number<std::uint32_t>("DataUDINT")) {
    const auto bytes = le_bytes(*wide);
    category.data.assign(bytes.begin(), bytes.end());
  } else {
    category.data = node.child("Data").bytes();
  }
  return category;
}

}  // namespace

void read_info(const Node& node, DeviceDescription& device) {
  const Node info = node.child("Info");
  const Node machine = info.child("StateMachine");
  read_timeouts(machine.child("Timeout"), device.timeouts);
  device.behavior = read_behavior(machine.child("Behavior"));
  device.ebus_current_ma = info.child("Electrical").child_number<std::int32_t>("EBusCurrent");
  if (const Node flag = info.child("IdentificationReg134")) device.identification_reg134 = flag.boolean();
  device.identification_ado = info.child_number<std::uint16_t>("IdentificationAdo");
  const Node controller = info.child("EtherCATController");
  device.dpram_size = controller.child_number<std::uint32_t>("DpramSize");
  device.sync_manager_count = controller.child_number<std::uint8_t>("SmCount");
  device.fmmu_count = controller.child_number<std::uint8_t>("FmmuCount");
  for (const Node& port : info.children("Port")) device.ports.push_back(read_port(port));
}

EepromDescription read_eeprom(const Node& node) {
  EepromDescription eeprom;
  if (const Node data = node.child("Data")) {
    read_whole_eeprom(data, eeprom);
    return eeprom;
  }
  eeprom.byte_size = node.child_number<std::uint32_t>("ByteSize").value_or(eeprom.byte_size);
  eeprom.config_data = node.child("ConfigData").bytes();
  eeprom.boot_strap = node.child("BootStrap").bytes();
  eeprom.assign_to_pdi = node.boolean("AssignToPdi").value_or(false);
  for (const Node& category : node.children("Category")) eeprom.categories.push_back(read_category(category));
  return eeprom;
}

}  // namespace syncline::eni
