// SPDX-License-Identifier: Apache-2.0
#include "config/device_from_sii.h"

#include <fmt/format.h>

#include "config/dc_description.h"
#include "config/device_description.h"
#include "config/mailbox_description.h"
#include "protocol/coe_data_type.h"
#include "protocol/sii.h"
#include "protocol/sync_manager.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

Pdo pdo_of(const sii::Pdo& from) {
  Pdo pdo;
  pdo.index = from.index;
  pdo.name = from.name;
  if (from.sync_manager != 0xFF) pdo.sync_manager = from.sync_manager;
  for (const auto& entry : from.entries) {
    PdoEntry out{entry.index, entry.sub_index, entry.bit_length, entry.name, {}};
    if (entry.index != 0) out.data_type = coe::esi_type_name(entry.data_type, entry.bit_length);
    pdo.entries.push_back(std::move(out));
  }
  return pdo;
}

/// Old images, and some tools, leave the type 0 for SyncManagers that are in use: the control byte (0x0804) says mode
/// and direction all the same.
SyncManagerType type_of(const sii::SyncM& from) {
  constexpr std::uint8_t kEnable = 0x01, kLastType = 4;
  if (from.type != 0 || (from.enable & kEnable) == 0) {
    return from.type <= kLastType ? static_cast<SyncManagerType>(from.type) : SyncManagerType::kUnused;
  }
  return sync_manager_type(SyncManager{.control = from.control});
}

SyncManagerDescription sync_manager_of(const sii::SyncM& from) {
  SyncManagerDescription manager;
  manager.type = type_of(from);
  manager.start_address = from.start;
  manager.default_size = from.length;
  manager.control_byte = from.control;
  manager.enable = (from.enable & 0x01) != 0;
  manager.is_virtual = (from.enable & 0x04) != 0;
  manager.op_only = (from.enable & 0x08) != 0;
  return manager;
}

MailboxDescription mailbox_of(const sii::Image& image) {
  MailboxDescription mailbox;
  const auto has = [&](std::uint16_t protocol) { return (image.mailbox_protocols & protocol) != 0; };
  mailbox.aoe = has(sii::kProtocolAoe);
  mailbox.eoe = has(sii::kProtocolEoe);
  mailbox.foe = has(sii::kProtocolFoe);
  mailbox.soe = has(sii::kProtocolSoe);
  mailbox.voe = has(sii::kProtocolVoe);
  if (has(sii::kProtocolCoe)) {
    const std::uint8_t details = image.general ? image.general->coe_details : 0;
    CoeDescription coe;
    coe.sdo_info = (details & 0x02) != 0;
    coe.pdo_assign = (details & 0x04) != 0;
    coe.pdo_config = (details & 0x08) != 0;
    coe.pdo_upload = (details & 0x10) != 0;
    coe.complete_access = (details & 0x20) != 0;
    mailbox.coe = coe;
  }
  return mailbox;
}

/// The SII counts factors like ESI: 0 means none.
DcTime dc_time(std::uint32_t value, std::int16_t factor) {
  DcTime time;
  time.value_ns = static_cast<std::int32_t>(value);
  if (factor != 0) time.factor = factor;
  return time;
}

DcDescription dc_of(const sii::Image& image) {
  DcDescription dc;
  for (const auto& mode : image.dc_modes) {
    DcOpMode out;
    out.name = mode.name.empty() ? fmt::format("mode {}", dc.op_modes.size() + 1) : mode.name;
    out.description = mode.description;
    out.assign_activate = mode.assign_activate;
    out.cycle_time_sync0 = dc_time(mode.cycle_time_sync0, mode.cycle_factor_sync0);
    out.shift_time_sync0 = dc_time(mode.shift_time_sync0, 0);
    out.cycle_time_sync1 = dc_time(0, mode.cycle_factor_sync1);
    out.shift_time_sync1 = dc_time(mode.shift_time_sync1, 0);
    dc.op_modes.push_back(std::move(out));
  }
  return dc;
}

/// Physical ports, 4 bits each: 1 MII, 3 EBUS; ESI's letters.
std::string physics_of(std::uint16_t ports) {
  std::string text;
  for (unsigned port = 0; port < 4; ++port) {
    const unsigned kind = (ports >> (4 * port)) & 0x0FU;
    text += kind == 1 || kind == 4 ? 'Y' : kind == 3 ? 'K' : ' ';
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

std::vector<std::uint8_t> config_data_of(const sii::Image& image) {
  std::vector<std::uint8_t> bytes;
  ByteWriter(bytes)
      .u16(image.pdi_control)
      .u16(image.pdi_configuration)
      .u16(image.sync_impulse_length)
      .u16(image.pdi_configuration2)
      .zeros(6);  // the alias belongs to the installation, not to the device
  return bytes;
}

std::vector<std::uint8_t> boot_strap_of(const sii::MailboxArea& area) {
  if (area.receive_size == 0 || area.send_size == 0) return {};
  std::vector<std::uint8_t> bytes;
  ByteWriter(bytes).u16(area.receive_offset).u16(area.receive_size).u16(area.send_offset).u16(area.send_size);
  return bytes;
}

}  // namespace

DeviceDescription device_from_sii(const sii::Image& image) {
  DeviceDescription device;
  device.identity = {image.vendor_id, image.product_code, image.revision_no, 0};
  if (image.general) {
    device.group_type = image.general->group;
    device.type = image.general->order;
    device.name = image.general->name;
    device.physics = physics_of(image.general->physical_ports);
  }
  if (device.type.empty()) device.type = fmt::format("0x{:08X}", image.product_code);
  if (device.name.empty()) device.name = device.type;
  for (const auto use : image.fmmus) device.fmmus.push_back(use <= 3 ? static_cast<FmmuUse>(use) : FmmuUse::kUnused);
  for (const auto& manager : image.sync_managers) device.sync_managers.push_back(sync_manager_of(manager));
  for (const auto& pdo : image.rx_pdos) device.rx_pdos.push_back(pdo_of(pdo));
  for (const auto& pdo : image.tx_pdos) device.tx_pdos.push_back(pdo_of(pdo));
  if (image.mailbox_protocols != 0) device.mailbox = mailbox_of(image);
  if (!image.dc_modes.empty()) device.dc = dc_of(image);
  device.eeprom.byte_size = image.size_bytes;
  device.eeprom.config_data = config_data_of(image);
  device.eeprom.boot_strap = boot_strap_of(image.bootstrap_mailbox);
  device.source = "SII";
  return device;
}

}  // namespace syncline
