// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "protocol/sii.h"

namespace syncline::sample {

/// The EEPROM of a CoE drive with DC: mailbox, outputs, one RxPDO, one operation mode.
[[nodiscard]] inline sii::Image drive_image(std::uint32_t product) {
  sii::Image image;
  image.vendor_id = 0x5C17;
  image.product_code = product;
  image.revision_no = 0x10000;
  image.serial_no = 42;
  image.mailbox_protocols = sii::kProtocolCoe;
  image.general = sii::General{};
  image.general->name = "a drive";
  image.general->order = "DRV";
  image.general->coe_details = 0x25;
  image.general->physical_ports = 0x0011;
  image.fmmus = {1, 2, 3};
  image.sync_managers = {{0x1000, 128, 0x26, 0, 1, 1}, {0x1080, 128, 0x22, 0, 1, 2}, {0x1100, 6, 0x64, 0, 9, 3}};
  sii::Pdo pdo;
  pdo.index = 0x1600;
  pdo.sync_manager = 2;
  pdo.name = "outputs";
  pdo.entries.push_back({0x6040, 0, "Controlword", 6, 16, 0});
  image.rx_pdos.push_back(pdo);
  sii::DcMode mode;
  mode.name = "DC";
  mode.assign_activate = 0x0300;
  mode.cycle_factor_sync0 = 1;
  image.dc_modes.push_back(mode);
  return image;
}

}  // namespace syncline::sample
