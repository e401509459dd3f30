// SPDX-License-Identifier: Apache-2.0
#include "protocol/sync_manager.h"

#include "support/byte_order.h"

namespace syncline {

std::array<std::uint8_t, SyncManager::kSize> SyncManager::encode() const {
  std::array<std::uint8_t, kSize> bytes{};
  const std::span<std::uint8_t> out(bytes);
  store_le(out, start);
  store_le(out.subspan(2), length);
  out[4] = control;
  out[5] = status;
  out[6] = activate;
  out[7] = pdi_control;
  return bytes;
}

SyncManager SyncManager::decode(std::span<const std::uint8_t, kSize> bytes) {
  ByteReader reader(bytes);
  SyncManager sm;
  sm.start = reader.u16();
  sm.length = reader.u16();
  sm.control = reader.u8();
  sm.status = reader.u8();
  sm.activate = reader.u8();
  sm.pdi_control = reader.u8();
  return sm;
}

}  // namespace syncline
