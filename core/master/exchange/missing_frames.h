// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "protocol/command.h"
#include "support/types.h"

namespace syncline {

struct DatagramHeader;

/// Frames that were not back at their deadline, by the index of their datagrams: missing until they come late after
/// all, or are known to be lost. On the wire no frame overtakes another, so the return of one that was sent later
/// proves the loss at once; when nothing comes back, patience decides. What comes even then is still recognised, for
/// as long as its index rests. Allocates nothing.
class MissingFrames {
 public:
  /// What is remembered of a frame: enough to know it again.
  struct Frame {
    std::uint64_t sequence = 0;  // of sending
    Nanoseconds send_time = 0, deadline = 0;
    Command command = Command::kNop;  // of its first datagram
    std::uint32_t address = 0;
    std::size_t length = 0;  // data of the first datagram
    bool cyclic = false;     // it carried process data; all that do so in one cycle have the same deadline
  };
  /// What has been found out since the last take().
  struct News {
    std::uint32_t lost = 0;
    Nanoseconds first_lost = 0;  // when the first of them was sent
    std::uint32_t late = 0;
    std::uint32_t late_after_lost = 0;  // of the late ones: they had been news as lost before
    Nanoseconds late_by = 0;            // largest time between deadline and return
    std::uint32_t late_cycles = 0;      // cycles whose process data came late; each is news once
  };

  void miss(std::uint8_t index, const Frame& frame);
  /// A frame that was sent as number `sequence` came back.
  void returned(std::uint64_t sequence);
  /// True when the first datagram that came back is that of a missing frame.
  bool take_late(const DatagramHeader& header, Nanoseconds arrival);
  /// The index is used for another frame.
  void forget(std::uint8_t index);
  /// Frames that have been missing for the longest patience are lost.
  void expire(Nanoseconds now);
  /// All that are missing are lost: nobody will look for them any more.
  void give_up();
  /// What was on its way belongs to what nobody waits for any more: neither lost nor late.
  void forget_all();
  News take_news();

 private:
  enum class State : std::uint8_t { kNone, kMissing, kLost };
  struct Slot {
    State state = State::kNone;
    Frame frame;
  };
  void lose(Slot& slot);

  std::array<Slot, 256> slots_{};
  std::size_t missing_ = 0;
  Nanoseconds late_cycle_ = 0;  // deadline of the latest that was news as late
  News news_;
};

}  // namespace syncline
