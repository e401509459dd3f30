// SPDX-License-Identifier: Apache-2.0
#include "sim/device/sii_from_device.h"

#include <algorithm>
#include <string_view>

#include "config/dc_description.h"
#include "config/device_description.h"
#include "config/sim_config.h"
#include "protocol/coe_data_type.h"
#include "protocol/sii.h"
#include "protocol/station_alias.h"
#include "support/byte_order.h"

namespace syncline::sim {
namespace {

std::uint16_t config_word(const std::vector<std::uint8_t>& data, std::size_t word) {
  return data.size() >= 2 * word + 2 ? load_le<std::uint16_t>(std::span(data).subspan(2 * word)) : std::uint16_t{0};
}

/// Index of the base data types (ETG.1000.6, table 64) by their ESI names.

sii::Pdo to_sii(const Pdo& pdo) {
  sii::Pdo out;
  out.index = pdo.index;
  out.sync_manager = pdo.sync_manager.value_or(0xFF);
  out.name = pdo.name;
  out.flags = static_cast<std::uint16_t>((pdo.mandatory ? 0x0001U : 0U) | (pdo.fixed ? 0x0010U : 0U));
  for (const auto& entry : pdo.entries) {
    out.entries.push_back({entry.index, entry.sub_index, entry.name, data_type_code(entry.data_type),
                           static_cast<std::uint8_t>(entry.bit_length), 0});
  }
  return out;
}

sii::DcMode to_sii(const DcOpMode& mode) {
  sii::DcMode out;
  out.cycle_time_sync0 = static_cast<std::uint32_t>(mode.cycle_time_sync0.value_ns);
  out.shift_time_sync0 = static_cast<std::uint32_t>(mode.shift_time_sync0.value_ns);
  out.shift_time_sync1 = static_cast<std::uint32_t>(mode.shift_time_sync1.value_ns);
  out.cycle_factor_sync0 = static_cast<std::int16_t>(mode.cycle_time_sync0.factor.value_or(0));
  out.cycle_factor_sync1 = static_cast<std::int16_t>(mode.cycle_time_sync1.factor.value_or(0));
  out.assign_activate = mode.assign_activate;
  out.name = mode.name;
  out.description = mode.description;
  return out;
}

void add_mailbox(sii::Image& image, const DeviceDescription& device) {
  if (!device.mailbox) return;
  const auto& mailbox = *device.mailbox;
  for (const auto& sm : device.sync_managers) {
    if (sm.type == SyncManagerType::kMailboxOut) {
      image.mailbox.receive_offset = sm.start_address;
      image.mailbox.receive_size = sm.default_size.value_or(0);
    } else if (sm.type == SyncManagerType::kMailboxIn) {
      image.mailbox.send_offset = sm.start_address;
      image.mailbox.send_size = sm.default_size.value_or(0);
    }
  }
  const auto& boot = device.eeprom.boot_strap;
  if (boot.size() >= 8)
    image.bootstrap_mailbox = {config_word(boot, 0), config_word(boot, 1), config_word(boot, 2), config_word(boot, 3)};
  image.mailbox_protocols =
      static_cast<std::uint16_t>((mailbox.aoe ? sii::kProtocolAoe : 0) | (mailbox.eoe ? sii::kProtocolEoe : 0) |
                                 (mailbox.coe ? sii::kProtocolCoe : 0) | (mailbox.foe ? sii::kProtocolFoe : 0) |
                                 (mailbox.soe ? sii::kProtocolSoe : 0) | (mailbox.voe ? sii::kProtocolVoe : 0));
  if (mailbox.coe) {
    const auto& coe = *mailbox.coe;
    image.general->coe_details = static_cast<std::uint8_t>(
        0x01 | (coe.sdo_info ? 0x02 : 0) | (coe.pdo_assign ? 0x04 : 0) | (coe.pdo_config ? 0x08 : 0) |
        (coe.pdo_upload ? 0x10 : 0) | (coe.complete_access ? 0x20 : 0));
  }
  image.general->foe_details = mailbox.foe ? 1 : 0;
  image.general->eoe_details = mailbox.eoe ? 1 : 0;
}

std::uint16_t physical_ports(std::string_view physics) {
  std::uint16_t ports = 0;
  for (std::size_t i = 0; i < physics.size() && i < 4; ++i) {
    const unsigned code = physics[i] == 'Y' || physics[i] == 'H' ? 1U : (physics[i] == 'K' ? 3U : 0U);
    ports = static_cast<std::uint16_t>(ports | code << (4 * i));
  }
  return ports;
}

}  // namespace

std::uint8_t data_type_code(std::string_view name) {
  const auto* type = coe::find_data_type(name);
  return type != nullptr ? static_cast<std::uint8_t>(type->code) : std::uint8_t{0};
}

sii::Image sii_from_device(const DeviceDescription& device, std::uint16_t alias, std::uint32_t serial_no) {
  sii::Image image;
  const auto& config = device.eeprom.config_data;
  image.pdi_control = config_word(config, 0);
  image.pdi_configuration = config_word(config, 1);
  image.sync_impulse_length = config_word(config, 2);
  image.pdi_configuration2 = config_word(config, 3);
  image.alias = alias;
  image.vendor_id = device.identity.vendor_id;
  image.product_code = device.identity.product_code;
  image.revision_no = device.identity.revision_no;
  image.serial_no = serial_no;
  image.size_bytes = std::max<std::uint32_t>(device.eeprom.byte_size, 128);
  image.general.emplace();
  image.general->group = device.group_type;
  image.general->order = device.type;
  image.general->name = device.name;
  image.general->physical_ports = physical_ports(device.physics);
  add_mailbox(image, device);
  for (const auto fmmu : device.fmmus) image.fmmus.push_back(static_cast<std::uint8_t>(fmmu));
  for (const auto& sm : device.sync_managers) {
    image.sync_managers.push_back(
        {sm.start_address, sm.default_size.value_or(0), sm.control_byte, 0,
         static_cast<std::uint8_t>((sm.enable ? 1 : 0) | (sm.is_virtual ? 4 : 0) | (sm.op_only ? 8 : 0)),
         static_cast<std::uint8_t>(sm.type)});
  }
  for (const auto& pdo : device.tx_pdos) image.tx_pdos.push_back(to_sii(pdo));
  for (const auto& pdo : device.rx_pdos) image.rx_pdos.push_back(to_sii(pdo));
  if (device.dc) {
    for (const auto& mode : device.dc->op_modes) image.dc_modes.push_back(to_sii(mode));
  }
  return image;
}

std::vector<std::uint8_t> factory_sii(const SimSlaveConfig& config) {
  if (config.sii_image.empty()) return sii::encode(sii_from_device(config.device, config.alias, config.serial_no));
  auto image = config.sii_image;
  if (image.size() > kSiiChecksumByte &&
      config.alias != load_le<std::uint16_t>(std::span(image).subspan(kSiiAliasByte))) {
    const bool checked = sii::checksum(std::span(image).first(kSiiChecksumByte)) == image[kSiiChecksumByte];
    store_le<std::uint16_t>(std::span(image).subspan(kSiiAliasByte, 2), config.alias);
    if (checked) image[kSiiChecksumByte] = sii::checksum(std::span(image).first(kSiiChecksumByte));
  }
  return image;
}

}  // namespace syncline::sim
