// SPDX-License-Identifier: Apache-2.0
// What the encoder and the decoder share; see sii_encode.cpp and sii_decode.cpp.
#include "protocol/sii.h"

namespace syncline::sii {

std::uint8_t checksum(std::span<const std::uint8_t> first_14_bytes) {
  unsigned crc = 0xFF;
  for (const auto byte : first_14_bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 0x80U) != 0 ? ((crc << 1) ^ 0x07U) & 0xFFU : crc << 1;
  }
  return static_cast<std::uint8_t>(crc);
}

}  // namespace syncline::sii
