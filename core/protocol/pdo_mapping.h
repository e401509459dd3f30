// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline {

/// One object in a PDO's mapping (0x1600.., 0x1A00..; ETG.1000.6, 5.6.7.4.7): an entry's 32 bits in words.
struct PdoMapping {
  std::uint16_t index = 0;  // 0: padding
  std::uint8_t sub_index = 0;
  std::uint8_t bits = 0;

  [[nodiscard]] static constexpr PdoMapping of(std::uint32_t word) {
    return {static_cast<std::uint16_t>(word >> 16), static_cast<std::uint8_t>(word >> 8),
            static_cast<std::uint8_t>(word)};
  }
  [[nodiscard]] constexpr std::uint32_t word() const {
    return std::uint32_t{index} << 16 | std::uint32_t{sub_index} << 8 | bits;
  }
  bool operator==(const PdoMapping&) const = default;
};

}  // namespace syncline
