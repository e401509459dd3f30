// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "sim/registers/esc_memory.h"

namespace syncline::sim {

/// Latch units of an ESC: the system time of edges at its inputs LATCH0 and LATCH1 (registers 0x09A8 to 0x09CF; ESC
/// data sheet I, 9.2.4). Knows no clock: the DC unit says what time it is.
class LatchUnit {
 public:
  static constexpr unsigned kInputs = 2;
  /// `wide`: times of 64 bit, otherwise of 32.
  LatchUnit(EscMemory& memory, bool wide) : memory_(memory), wide_(wide) {}

  void implement_registers();
  /// The level at input `number`; an edge in single event mode counts only once its predecessor has been read.
  /// True when a time was taken.
  bool input(unsigned number, bool level, std::uint64_t system_time);
  /// Somebody is about to read registers: the first byte of a time freezes the others.
  void before_read(std::uint16_t address, std::size_t length);
  /// A master read them in a frame: the times that it has seen are acknowledged, as far as the unit is its own.
  void acknowledge(std::uint16_t address, std::size_t length);
  /// Event flags of the units that the master controls; what the ECAT event request shows.
  [[nodiscard]] bool master_event() const;
  /// Of those that the PDI controls.
  [[nodiscard]] bool pdi_event() const;
  /// 0x0980: whose the unit is.
  [[nodiscard]] bool controlled_by_pdi(unsigned number) const;

 private:
  static constexpr unsigned kEdges = 2;  // positive, negative
  [[nodiscard]] bool event(unsigned number) const;
  void write_status(unsigned number);

  EscMemory& memory_;
  bool wide_;
  std::array<bool, kInputs> level_{};
  std::array<std::array<bool, kEdges>, kInputs> event_{};
  std::array<std::array<std::uint64_t, kEdges>, kInputs> time_{};
};

}  // namespace syncline::sim
