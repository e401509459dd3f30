// SPDX-License-Identifier: Apache-2.0
#include "sim/registers/esc_memory.h"

#include <algorithm>

namespace syncline::sim {

EscMemory::EscMemory(std::uint32_t ram_bytes)
    : memory_(std::make_unique<Bytes>()), bytes_(memory_->bytes), ram_end_(std::min(kRegisterEnd + ram_bytes, kSize)) {}

void EscMemory::implement(std::uint16_t address, std::uint16_t length, std::uint8_t rights) {
  std::fill_n(rights_.begin() + address, length, rights);
}

}  // namespace syncline::sim
