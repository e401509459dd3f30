// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "protocol/registers.h"
#include "sim/registers/esc_memory.h"

namespace syncline::sim {

/// Software reset of an ESC (register 0x0040; ESC data sheet II): R, E and S in three frames one behind the other.
class ResetSequence {
 public:
  explicit ResetSequence(EscMemory& memory) : memory_(memory) {}

  void implement_registers() { memory_.implement(reg::kEscReset, 1, EscMemory::kReadWrite); }
  /// A part of it has come: the next frame counts, whatever it is.
  [[nodiscard]] bool begun() const { return step_ != 0; }
  [[nodiscard]] bool complete() const { return step_ == kSequence.size(); }
  /// End of a frame that has `written` the register, or not. The register shows how many letters have come.
  void end_of_frame(bool written) {
    const auto value = memory_.u8(reg::kEscReset);
    if (!written || complete() || value != kSequence[step_]) {
      step_ = written && value == kSequence[0] ? 1 : 0;
    } else {
      ++step_;
    }
    memory_.set<std::uint8_t>(reg::kEscReset, static_cast<std::uint8_t>(step_));
  }

 private:
  static constexpr std::array<std::uint8_t, 3> kSequence{'R', 'E', 'S'};

  EscMemory& memory_;
  std::size_t step_ = 0;
};

}  // namespace syncline::sim
