// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "master/exchange/frame_exchange.h"

namespace syncline {

/// The short burst of a running bus: frames behind those of the cycle that hand the leading clock's time to all others,
/// so that a clock which was just set learns its quartz in a fraction of a second. A frame of its own for each: an ESC
/// compares once a frame. Allocates nothing.
class ClockFeed {
 public:
  /// `cycle`: the frames fill a sixteenth of it at most.
  explicit ClockFeed(Nanoseconds cycle);
  ClockFeed(const ClockFeed&) = delete;
  ClockFeed& operator=(const ClockFeed&) = delete;

  /// From the next cycle on, with the time of the clock that has this station address.
  void start(std::uint16_t station);
  void stop() { on_ = false; }
  /// With those of the cycle itself.
  [[nodiscard]] std::size_t messages_per_cycle() const { return count_ + 1; }
  /// The frames of this cycle; none while it is off.
  [[nodiscard]] std::span<PendingFrame> prepare();
  /// What the leading clock will show when the frame that is being sent passes; slaves in front of it are written that.
  void stamp(Nanoseconds reference_time);

 private:
  static constexpr std::size_t kMostFrames = 8;
  struct Slot {
    std::array<std::uint8_t, 4> time{};
    Datagram datagram;
  };
  std::array<Slot, kMostFrames> slots_;
  std::array<PendingFrame, kMostFrames> frames_;
  std::size_t count_;
  std::uint32_t address_ = 0;
  bool on_ = false;
};

}  // namespace syncline
