// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "protocol/registers.h"
#include "sim/registers/esc_memory.h"

namespace syncline::sim {

/// AL control, AL status and AL status code of an ESC (registers 0x0120, 0x0130, 0x0134; ESC data sheet I, chapter 10):
/// the master asks for a state here, and the device says which one it has. What it means is the device's matter.
class AlRegisters {
 public:
  explicit AlRegisters(EscMemory& memory) : memory_(memory) {}

  void implement_registers() {
    memory_.implement(reg::kAlControl, 2, EscMemory::kReadWrite);
    memory_.implement(reg::kAlStatus, 2, EscMemory::kRead);
    memory_.implement(reg::kAlStatusCode, 2, EscMemory::kRead);
    memory_.set<std::uint16_t>(reg::kAlControl, kInit);
    memory_.set<std::uint16_t>(reg::kAlStatus, kInit);
  }
  /// What the master has written last.
  [[nodiscard]] std::uint16_t control() const { return memory_.u16(reg::kAlControl); }
  [[nodiscard]] std::uint16_t status() const { return memory_.u16(reg::kAlStatus); }
  void set_status(std::uint16_t status) { memory_.set<std::uint16_t>(reg::kAlStatus, status); }
  /// Why, or the answer to the request for the identification.
  void set_code(std::uint16_t code) { memory_.set<std::uint16_t>(reg::kAlStatusCode, code); }

 private:
  static constexpr std::uint16_t kInit = 0x0001;

  EscMemory& memory_;
};

}  // namespace syncline::sim
