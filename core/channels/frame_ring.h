// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "support/types.h"

namespace syncline {

enum class FrameDirection : std::uint8_t { kReceived = 1, kSent = 2 };  // as pcapng's epb_flags, bits 1:0

/// A frame on the wire, as the ring lends it.
struct RingFrame {
  Nanoseconds time = 0;  // host clock: when it was handed to the wire, or came
  FrameDirection direction = FrameDirection::kSent;
  std::uint64_t lost_before = 0;        // frames that did not fit, since the one before
  std::span<const std::uint8_t> bytes;  // Ethernet frame without FCS
};

/// Raw frames on request, from the thread that sends and receives to one other. Closed, as it is made, it takes nothing
/// and has no memory. The producer neither waits, allocates nor locks: what does not fit is left out and counted,
/// unless whoever opened it has it wait, which only virtual time can afford.
class FrameRing {
 public:
  enum class WhenFull : std::uint8_t { kLose, kWait };
  static constexpr std::size_t kUsualBytes = std::size_t{8} << 20;  // 10 s of 1,000 cycles of two frames of 350 bytes

  /// Producer: the thread that sends and receives.
  void push(std::span<const std::uint8_t> frame, Nanoseconds time, FrameDirection direction);
  /// Any thread.
  [[nodiscard]] bool is_open() const { return generation_.load(std::memory_order_relaxed) != 0; }

  /// Consumer. Frames from now on, what came before is dropped; `bytes` (at least 4096, rounded up to a power of two)
  /// counts when it is opened first, the memory stays.
  void open(WhenFull when_full = WhenFull::kLose, std::size_t bytes = kUsualBytes);
  /// The producer stops, at the latest after the frame that it has begun; what is in it can still be read.
  void close();
  /// Frames lost since it was opened.
  [[nodiscard]] std::uint64_t lost() const;
  /// Oldest first, until it is empty. The frame is valid during the call.
  void read(const std::function<void(const RingFrame&)>& take);

 private:
  struct Header {
    std::uint32_t size = 0;  // of the frame; kSkip: go on at the ring's begin
    std::uint16_t generation = 0;
    FrameDirection direction = FrameDirection::kSent;
    Nanoseconds time = 0;
    std::uint64_t lost_before = 0;
  };
  static constexpr std::uint32_t kSkip = UINT32_MAX;
  static constexpr unsigned kGenerationShift = 48;  // above the count of lost frames

  [[nodiscard]] bool has_room(std::size_t bytes) const;
  bool wait_for_room(std::size_t bytes, std::uint16_t generation) const;
  void begin_generation(std::uint16_t generation);

  std::unique_ptr<std::uint8_t[]> memory_;
  std::size_t size_ = 0;  // a power of two
  std::atomic<WhenFull> when_full_{WhenFull::kLose};
  std::uint16_t opened_ = 0;  // the consumer's: how often, never 0 once it was
  std::atomic<std::uint16_t> generation_{0};
  std::atomic<std::size_t> head_{0}, tail_{0};  // bytes since the begin of all
  std::atomic<std::uint64_t> lost_{0};          // with the generation in its uppermost bits; written by the producer
  std::uint16_t producing_ = 0;                 // the producer's
  std::uint64_t untold_ = 0;                    // the producer's: lost, and no frame came after them
};

}  // namespace syncline
