// SPDX-License-Identifier: Apache-2.0
#include "sim/dc/latch_unit.h"

#include "protocol/registers.h"

namespace syncline::sim {
namespace {

constexpr unsigned kPinBit = 2;    // of the status; bits 0 and 1: events of both edges
constexpr unsigned kOwnerBit = 4;  // of 0x0980: latch 0; the next one: latch 1

/// Bytes from the first time register to behind the last.
constexpr std::uint16_t kTimesBegin = reg::kLatch0PositiveEdge, kTimesEnd = reg::kLatch1NegativeEdge + 8;

constexpr std::uint16_t time_register(unsigned number, unsigned edge) {
  return static_cast<std::uint16_t>(kTimesBegin + 16 * number + 8 * edge);
}

bool covers(std::uint16_t address, std::size_t length, std::uint16_t byte) {
  return address <= byte && byte < address + length;
}

}  // namespace

void LatchUnit::implement_registers() {
  memory_.implement(reg::kLatch0Control, 2, EscMemory::kReadWrite);
  memory_.implement(reg::kLatch0Status, 2, EscMemory::kRead);
  for (unsigned number = 0; number < kInputs; ++number) {
    for (unsigned edge = 0; edge < kEdges; ++edge)
      memory_.implement(time_register(number, edge), wide_ ? 8 : 4, EscMemory::kRead);
  }
}

bool LatchUnit::controlled_by_pdi(unsigned number) const {
  return (memory_.u8(reg::kCyclicUnitControl) >> (kOwnerBit + number) & 1U) != 0;
}

bool LatchUnit::event(unsigned number) const { return event_[number][0] || event_[number][1]; }

bool LatchUnit::master_event() const {
  return (event(0) && !controlled_by_pdi(0)) || (event(1) && !controlled_by_pdi(1));
}

bool LatchUnit::pdi_event() const { return (event(0) && controlled_by_pdi(0)) || (event(1) && controlled_by_pdi(1)); }

void LatchUnit::write_status(unsigned number) {
  const unsigned status =
      (event_[number][0] ? 1U : 0U) | (event_[number][1] ? 2U : 0U) | (level_[number] ? 1U << kPinBit : 0U);
  memory_.set<std::uint8_t>(static_cast<std::uint16_t>(reg::kLatch0Status + number), static_cast<std::uint8_t>(status));
}

bool LatchUnit::input(unsigned number, bool level, std::uint64_t system_time) {
  if (number >= kInputs || level == level_[number]) return false;
  level_[number] = level;
  const unsigned edge = level ? 0 : 1;
  const auto control = memory_.u8(static_cast<std::uint16_t>(reg::kLatch0Control + number));
  const bool single = (control >> edge & 1U) != 0;
  const bool taken = !single || !event_[number][edge];
  if (taken) {
    event_[number][edge] = true;
    time_[number][edge] = system_time;
  }
  write_status(number);
  return taken;
}

void LatchUnit::before_read(std::uint16_t address, std::size_t length) {
  if (address >= kTimesEnd || address + length <= kTimesBegin) return;
  for (unsigned number = 0; number < kInputs; ++number) {
    for (unsigned edge = 0; edge < kEdges; ++edge) {
      const auto place = time_register(number, edge);
      if (covers(address, length, place))
        memory_.set<std::uint64_t>(place, wide_ ? time_[number][edge] : time_[number][edge] & 0xFFFF'FFFFU);
    }
  }
}

void LatchUnit::acknowledge(std::uint16_t address, std::size_t length) {
  if (address >= kTimesEnd || address + length <= kTimesBegin) return;
  for (unsigned number = 0; number < kInputs; ++number) {
    if (controlled_by_pdi(number)) continue;
    for (unsigned edge = 0; edge < kEdges; ++edge) {
      if (covers(address, length, time_register(number, edge))) event_[number][edge] = false;
    }
    write_status(number);
  }
}

}  // namespace syncline::sim
