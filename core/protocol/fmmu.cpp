// SPDX-License-Identifier: Apache-2.0
#include "protocol/fmmu.h"

#include "support/byte_order.h"

namespace syncline {

std::array<std::uint8_t, Fmmu::kSize> Fmmu::encode() const {
  std::array<std::uint8_t, kSize> bytes{};
  const std::span<std::uint8_t> out(bytes);
  store_le(out, logical_start);
  store_le(out.subspan(4), length);
  out[6] = logical_start_bit & 0x07;
  out[7] = logical_stop_bit & 0x07;
  store_le(out.subspan(8), physical_start);
  out[10] = physical_start_bit & 0x07;
  out[11] = static_cast<std::uint8_t>((read ? 0x01 : 0) | (write ? 0x02 : 0));
  out[12] = active ? 0x01 : 0;
  return bytes;
}

Fmmu Fmmu::decode(std::span<const std::uint8_t, kSize> bytes) {
  ByteReader reader(bytes);
  Fmmu fmmu;
  fmmu.logical_start = reader.u32();
  fmmu.length = reader.u16();
  fmmu.logical_start_bit = reader.u8() & 0x07;
  fmmu.logical_stop_bit = reader.u8() & 0x07;
  fmmu.physical_start = reader.u16();
  fmmu.physical_start_bit = reader.u8() & 0x07;
  const auto type = reader.u8();
  fmmu.read = (type & 0x01) != 0;
  fmmu.write = (type & 0x02) != 0;
  fmmu.active = (reader.u8() & 0x01) != 0;
  return fmmu;
}

}  // namespace syncline
