// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sim/esc_memory.h"

namespace syncline::sim {

/// EEPROM behind registers 0x0500 to 0x050F (ESC data sheet II, 3.9): read, write, reload; the master must
/// own it, and writing needs the enable bit in the same frame.
class SiiInterface {
 public:
  SiiInterface(std::vector<std::uint8_t> content, EscMemory& memory);
  void control_written();
  [[nodiscard]] const std::vector<std::uint8_t>& content() const { return content_; }

 private:
  void read(std::uint32_t word);
  EscMemory& memory_;
  std::vector<std::uint8_t> content_;
};

}  // namespace syncline::sim
