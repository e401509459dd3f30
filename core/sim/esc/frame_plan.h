// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "protocol/registers.h"
#include "sim/registers/esc_ranges.h"

namespace syncline::sim {

/// What a frame of every cycle does to one ESC, found out once: a frame with the same commands, addresses and lengths
/// does the same again, as long as nobody writes to the ESC's registers or changes its SyncManagers. Following the plan
/// leaves what executing the datagrams leaves, byte for byte; tests/core/sim/frame_plan_test.cpp holds both against
/// each other.
struct FramePlan {
  static constexpr std::size_t kPlaces = 32;         // frames that are remembered: a cycle of 1,000 drives has 15
  static constexpr std::size_t kMostDatagrams = 16;  // of such a frame
  static constexpr std::size_t kMostSteps = 12;      // what does more is executed
  static constexpr std::uint8_t kTellsDlStatus = 0x01, kTellsAlStatus = 0x02;  // detail of kOrRegister
  static constexpr unsigned kMemoryBit = 4;                                    // detail of kGiveBit
  static constexpr std::uint8_t kNarrowTime = 4, kWideTime = 8;                // bytes, of time_size
  using Counters = std::array<std::uint16_t, kMostDatagrams>;

  /// In the order in which they are done: the usual ones, first, go by their number, without a look at each. None sees
  /// what another one does; where their order matters all the same (depends_on_order()) there is no plan.
  enum class Do : std::uint8_t {
    kTakeOutputs,   // into the whole buffer of a SyncManager
    kGiveInputs,    // from one
    kOrWord,        // the bits of a register of 16 bit are added to those of the datagram
    kOrRegister,    // the same with any other
    kGiveRegister,  // bytes into process data
    kGiveBit,       // one bit of them
  };
  struct Step {
    Do what = Do::kTakeOutputs;
    std::uint8_t detail = 0;   // SyncManager; bits in the frame's byte (0..7) and, from bit 4 on, in the memory; events
    std::uint16_t offset = 0;  // in the frame
    std::uint16_t address = 0;  // in the ESC
    std::uint16_t length = 0;
  };

  std::uint64_t shape = 0;                       // PassingFrame::Shape::id
  std::uint32_t generation = 0;                  // of the ESC's settings, from 1 on
  bool executed = true;                          // no plan: somebody must look at it each time
  bool restarts_watchdog = false;                // by the outputs that it takes
  std::uint8_t kind = 0;                         // PassingFrame::kind_of()
  std::uint8_t time_size = 0;                    // bytes of the system time that is received; 0: none
  std::uint16_t time_offset = 0;                 // where it is in the frame
  std::uint16_t difference_offset = 0;           // where 0x092C is added to the frame; 0: nowhere
  std::uint8_t count = 0;                        // of the steps
  std::uint8_t takes = 0, gives = 0, words = 0;  // the first ones, of the kinds that come first
  std::uint8_t told = 0;                         // events that the master is told of by it
  std::uint32_t written = 0;                     // bit per SyncManager: its whole buffer
  std::uint32_t read = 0;                        // the same
  std::array<Step, kMostSteps> steps{};
  Counters wkc{};  // what the working counters grow by

  /// No time is received, and no SyncManager has a part in it: what SYNC0 has done before does not matter.
  [[nodiscard]] bool is_passive() const { return time_size == 0 && (written | read) == 0; }

  /// Steps of different kinds give the same byte of the frame, of which the last of the FMMUs wins; or the master is
  /// told of events and reads the request of events, too.
  [[nodiscard]] bool depends_on_order() const {
    const auto reads_request = [](const Step& step) {
      return step.what > Do::kGiveInputs && overlaps(step.address, step.length, reg::kEcatEventRequest, 2);
    };
    const auto* const end = steps.data() + count;
    if (told != 0 && std::find_if(steps.data(), end, reads_request) != end) return true;
    const auto gives_byte = [](const Step& step) {
      return step.what == Do::kGiveInputs || step.what == Do::kGiveRegister || step.what == Do::kGiveBit;
    };
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const auto &a = steps[i], &b = steps[j];
        if (a.what != b.what && gives_byte(a) && gives_byte(b) && overlaps(a.offset, a.length, b.offset, b.length))
          return true;
      }
    }
    return false;
  }
  /// Behind those that are done before it. False: there is no room for it.
  bool add(const Step& step) {
    if (count == kMostSteps) return false;
    auto place = count++;
    for (; place > 0 && steps[place - 1U].what > step.what; --place) steps[place] = steps[place - 1U];
    steps[place] = step;
    if (step.what == Do::kTakeOutputs) ++takes;
    if (step.what == Do::kGiveInputs) ++gives;
    if (step.what == Do::kOrWord) ++words;
    if (step.what == Do::kOrWord || step.what == Do::kOrRegister) told |= step.detail;
    return true;
  }
};

}  // namespace syncline::sim
