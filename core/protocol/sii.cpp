// SPDX-License-Identifier: Apache-2.0
// What the encoder and the decoder share; see sii_encode.cpp and sii_decode.cpp.
#include "protocol/sii.h"

#include "support/byte_order.h"

namespace syncline::sii {

std::size_t told_size(std::span<const std::uint8_t> bytes) {
  return (load_le<std::uint16_t>(bytes.subspan(std::size_t{2} * kSizeWord)) + std::size_t{1}) * kSizeStep;
}

std::size_t image_size(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kUsual = 2048;
  const auto size = told_size(bytes);
  return size < std::size_t{2} * kCategoriesWord || size > kLongestImage ? kUsual : size;
}

std::uint8_t checksum(std::span<const std::uint8_t> first_14_bytes) {
  unsigned crc = 0xFF;
  for (const auto byte : first_14_bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 0x80U) != 0 ? ((crc << 1) ^ 0x07U) & 0xFFU : crc << 1;
  }
  return static_cast<std::uint8_t>(crc);
}

}  // namespace syncline::sii
