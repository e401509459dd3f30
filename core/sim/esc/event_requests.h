// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "protocol/registers.h"
#include "sim/registers/esc_memory.h"

namespace syncline::sim {

/// Event requests of an ESC (registers 0x0200 to 0x0223; ESC data sheet I, chapter 11): what the master is told of in
/// the frames that pass, as far as its mask lets it, and what waits for the PDI. Their bits are in esc_events.h.
class EventRequests {
 public:
  explicit EventRequests(EscMemory& memory) : memory_(memory) {}

  void implement_registers() {
    memory_.implement(reg::kEcatEventMask, 2, EscMemory::kReadWrite);
    memory_.implement(reg::kAlEventMask, 4, EscMemory::kRead);
    memory_.implement(reg::kEcatEventRequest, 2, EscMemory::kRead);
    memory_.implement(reg::kAlEventRequest, 4, EscMemory::kRead);
  }

  /// Of the master. True: that is another request than before.
  [[nodiscard]] bool raise(std::uint16_t event) { return set(static_cast<std::uint16_t>(requested() | event)); }
  [[nodiscard]] bool clear(std::uint16_t event) { return set(static_cast<std::uint16_t>(requested() & ~event)); }
  [[nodiscard]] std::uint16_t requested() const { return memory_.u16(reg::kEcatEventRequest); }
  /// Those that a frame carries.
  [[nodiscard]] std::uint16_t told() const {
    return static_cast<std::uint16_t>(requested() & memory_.u16(reg::kEcatEventMask));
  }
  [[nodiscard]] bool none_is_told() const { return memory_.u16(reg::kEcatEventMask) == 0; }

  /// Of the PDI.
  void raise_al(std::uint32_t event) { memory_.set<std::uint32_t>(reg::kAlEventRequest, al_requested() | event); }
  void acknowledge_al(std::uint32_t events) {
    const auto request = al_requested();
    if ((request & events) != 0) memory_.set<std::uint32_t>(reg::kAlEventRequest, request & ~events);
  }
  [[nodiscard]] std::uint32_t al_requested() const { return memory_.u32(reg::kAlEventRequest); }

 private:
  bool set(std::uint16_t request) {
    if (request == requested()) return false;
    memory_.set<std::uint16_t>(reg::kEcatEventRequest, request);
    return true;
  }

  EscMemory& memory_;
};

}  // namespace syncline::sim
