// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "protocol/registers.h"
#include "protocol/station_alias.h"
#include "sim/esc/passing_frame.h"
#include "sim/registers/esc_memory.h"

namespace syncline::sim {

/// What an ESC is called by in frames for single slaves: its station address (register 0x0010) and, where the master
/// has switched that on (0x0100, bit 24), its alias (0x0012; ESC data sheet I, 5.1).
class StationAddresses {
 public:
  /// As PassingFrame::is_for() takes them; an alias that is off is kNoStation.
  struct Pair {
    std::uint32_t station = 0, alias = 0;
  };

  explicit StationAddresses(EscMemory& memory) : memory_(memory) {}

  void implement_registers() {
    memory_.implement(reg::kStationAddress, 2, EscMemory::kReadWrite);
    memory_.implement(reg::kStationAlias, 2, EscMemory::kRead);
  }
  [[nodiscard]] bool has(std::uint16_t address) const {
    return address == memory_.u16(reg::kStationAddress) || (alias_on() && address == memory_.u16(reg::kStationAlias));
  }
  /// Both, of the settings of this generation: they are read again when that is another one.
  [[nodiscard]] const Pair& of(std::uint32_t generation) {
    if (generation_ != generation) note(generation);
    return noted_;
  }

 private:
  [[nodiscard]] bool alias_on() const { return listens_to_alias(memory_.u8(reg::kDlControlAlias)); }
  [[gnu::noinline]] void note(std::uint32_t generation) {
    generation_ = generation;
    noted_ = {memory_.u16(reg::kStationAddress),
              alias_on() ? memory_.u16(reg::kStationAlias) : PassingFrame::kNoStation};
  }

  EscMemory& memory_;
  std::uint32_t generation_ = 0;
  Pair noted_;
};

}  // namespace syncline::sim
