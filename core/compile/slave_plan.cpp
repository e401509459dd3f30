// SPDX-License-Identifier: Apache-2.0
#include "compile/slave_plan.h"

#include <algorithm>

#include "protocol/sync_manager.h"

namespace syncline::compiler {

SyncManager ProcessDataChannel::image() const {
  return {.start = description.start_address,
          .length = byte_length(),
          .control = description.control_byte,
          .status = 0,
          .activate = static_cast<std::uint8_t>(bit_length > 0 ? 1 : 0),
          .pdi_control = 0};
}

std::uint32_t SlavePlan::image_bits(PdoDirection direction) const {
  std::uint32_t bits = 0;
  for (const auto& channel : channels) {
    if (channel.is_output() == (direction == PdoDirection::kRx)) {
      bits += bit_oriented ? channel.bit_length : channel.byte_length() * 8U;
    }
  }
  return bits;
}

const Pdo* SlavePlan::find_pdo(std::uint16_t index) const {
  const auto found = std::ranges::find_if(pdos, [index](const ConfiguredPdo& p) { return p.pdo.index == index; });
  return found == pdos.end() ? nullptr : &found->pdo;
}

}  // namespace syncline::compiler
