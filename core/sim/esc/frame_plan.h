// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace syncline::sim {

/// What a frame of every cycle does to one ESC, found out once: a frame with the same commands, addresses and lengths
/// does the same again, as long as nobody writes to the ESC's registers or changes its SyncManagers. Following the plan
/// leaves what executing the datagrams leaves, byte for byte; tests/core/sim/frame_plan_test.cpp holds both against
/// each other.
struct FramePlan {
  static constexpr std::size_t kPlaces = 8;          // frames that are remembered
  static constexpr std::size_t kMostDatagrams = 16;  // of such a frame
  static constexpr std::size_t kMostSteps = 12;      // what does more is executed
  using Counters = std::array<std::uint16_t, kMostDatagrams>;

  enum class Do : std::uint8_t {
    kOrRegister,    // its bits are added to those of the datagram
    kOrWord,        // the same with one of 16 bit, the usual one
    kOrDifference,  // those of 0x092C
    kTakeOutputs,   // into the whole buffer of a SyncManager
    kGiveInputs,    // from one
    kGiveRegister,  // bytes into process data
    kGiveBit,       // one bit of them
  };
  struct Step {
    Do what = Do::kOrRegister;
    std::uint8_t detail = 0;   // SyncManager; bits in the frame's byte (0..7) and, from bit 4 on, in the memory; events
    std::uint16_t offset = 0;  // in the frame
    std::uint16_t address = 0;  // in the ESC
    std::uint16_t length = 0;
  };

  std::uint64_t shape = 0;         // PassingFrame::Shape::id
  std::uint32_t generation = 0;    // of the ESC's settings, from 1 on
  bool executed = true;            // no plan: somebody must look at it each time
  bool restarts_watchdog = false;  // by the outputs that it takes
  std::uint8_t time_size = 0;      // bytes of the system time that is received; 0: none
  std::uint16_t time_offset = 0;   // where it is in the frame
  std::uint8_t count = 0;          // of the steps
  std::uint32_t written = 0;       // bit per SyncManager: its whole buffer
  std::uint32_t read = 0;          // the same
  Counters wkc{};                  // what the working counters grow by
  std::array<Step, kMostSteps> steps{};

  /// No time is received, and no SyncManager has a part in it: what SYNC0 has done before does not matter.
  [[nodiscard]] bool is_passive() const { return time_size == 0 && (written | read) == 0; }

  /// False: there is no room for it.
  bool add(const Step& step) {
    if (count == kMostSteps) return false;
    steps[count++] = step;
    return true;
  }
};

}  // namespace syncline::sim
