// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sim/registers/esc_memory.h"

namespace syncline::sim {

/// Write protection of an ESC (registers 0x0020, 0x0021, 0x0030, 0x0031; ESC data sheet I, 13.2): where it is on, a
/// frame must write the enable register before anything else, and only that frame may go on.
class WriteProtection {
 public:
  explicit WriteProtection(EscMemory& memory) : memory_(memory) {}

  void implement_registers() {
    memory_.implement(kRegisterEnable, 2, EscMemory::kReadWrite);
    memory_.implement(kMemoryEnable, 2, EscMemory::kReadWrite);
  }
  /// A new frame: what the one before had enabled is over.
  void start_of_frame() {
    if (registers_enabled_) memory_.set<std::uint8_t>(kRegisterEnable, 0);
    if (memory_enabled_) memory_.set<std::uint8_t>(kMemoryEnable, 0);
    registers_enabled_ = memory_enabled_ = false;
  }
  /// The passing frame writes from `address` on. False: the write is not executed.
  bool allows(std::uint32_t address, std::size_t length) {
    const auto covers = [&](std::uint16_t reg) { return address <= reg && reg < address + length; };
    if (covers(kMemoryEnable)) memory_enabled_ = true;
    if (covers(kRegisterEnable)) registers_enabled_ = true;
    if (on(kMemoryProtection) && !memory_enabled_) return false;
    const bool protects = address < kProtectedEnd && !covers(kMemoryEnable);
    return !protects || !on(kRegisterProtection) || registers_enabled_;
  }
  /// The frame before has enabled something that is protected otherwise.
  [[nodiscard]] bool lifted() const { return registers_enabled_ || memory_enabled_; }
  /// Something is protected.
  [[nodiscard]] bool any() const { return on(kMemoryProtection) || on(kRegisterProtection); }

 private:
  static constexpr std::uint16_t kRegisterEnable = 0x0020, kRegisterProtection = 0x0021, kMemoryEnable = 0x0030,
                                 kMemoryProtection = 0x0031;
  static constexpr std::uint32_t kProtectedEnd = 0x0F10;  // of the registers; the user RAM behind stays open
  [[nodiscard]] bool on(std::uint16_t reg) const { return (memory_.u8(reg) & 0x01) != 0; }

  EscMemory& memory_;
  bool registers_enabled_ = false, memory_enabled_ = false;
};

}  // namespace syncline::sim
