// SPDX-License-Identifier: Apache-2.0
#include "channels/frame_ring.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

namespace syncline {
namespace {

constexpr std::size_t kAlignment = 8;

constexpr std::size_t aligned(std::size_t size) { return (size + kAlignment - 1) / kAlignment * kAlignment; }

}  // namespace

void FrameRing::open(WhenFull when_full, std::size_t bytes) {
  close();
  if (!memory_) {
    size_ = std::bit_ceil(std::max<std::size_t>(bytes, 4096));
    memory_ = std::make_unique<std::uint8_t[]>(size_);  // zeroed: its pages are there before the cycles run
  }
  when_full_.store(when_full, std::memory_order_relaxed);
  tail_.store(head_.load(std::memory_order_acquire), std::memory_order_release);
  if (++opened_ == 0) opened_ = 1;
  generation_.store(opened_, std::memory_order_release);
}

void FrameRing::close() { generation_.store(0, std::memory_order_release); }

std::uint64_t FrameRing::lost() const {
  const auto lost = lost_.load(std::memory_order_relaxed);
  return lost >> kGenerationShift == opened_ ? lost & ((std::uint64_t{1} << kGenerationShift) - 1) : 0;
}

/// What was lost for the one who had it open before is nobody's any more.
void FrameRing::begin_generation(std::uint16_t generation) {
  producing_ = generation;
  untold_ = 0;
  lost_.store(std::uint64_t{generation} << kGenerationShift, std::memory_order_relaxed);
}

bool FrameRing::has_room(std::size_t bytes) const {
  return head_.load(std::memory_order_relaxed) + bytes - tail_.load(std::memory_order_acquire) <= size_;
}

bool FrameRing::wait_for_room(std::size_t bytes, std::uint16_t generation) const {
  while (!has_room(bytes)) {
    if (generation_.load(std::memory_order_acquire) != generation) return false;
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
  return true;
}

void FrameRing::push(std::span<const std::uint8_t> frame, Nanoseconds time, FrameDirection direction) {
  const auto generation = generation_.load(std::memory_order_acquire);
  if (generation == 0) return;
  if (generation != producing_) begin_generation(generation);
  const auto needed = sizeof(Header) + aligned(frame.size());
  auto head = head_.load(std::memory_order_relaxed);
  const auto to_end = size_ - (head & (size_ - 1));
  const auto skipped = to_end < needed ? to_end : 0;
  if (!has_room(skipped + needed) &&
      (when_full_.load(std::memory_order_relaxed) == WhenFull::kLose || !wait_for_room(skipped + needed, generation))) {
    ++untold_;
    lost_.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  if (skipped > 0) std::memcpy(&memory_[head & (size_ - 1)], &kSkip, sizeof kSkip);
  head += skipped;
  const Header header{static_cast<std::uint32_t>(frame.size()), generation, direction, time, std::exchange(untold_, 0)};
  auto* const at = &memory_[head & (size_ - 1)];
  std::memcpy(at, &header, sizeof header);
  std::ranges::copy(frame, at + sizeof header);
  head_.store(head + needed, std::memory_order_release);
}

void FrameRing::read(const std::function<void(const RingFrame&)>& take) {
  const auto head = head_.load(std::memory_order_acquire);
  auto tail = tail_.load(std::memory_order_relaxed);
  while (tail != head) {
    const auto* const at = &memory_[tail & (size_ - 1)];
    Header header;
    std::memcpy(&header.size, at, sizeof header.size);
    if (header.size == kSkip) {
      tail += size_ - (tail & (size_ - 1));
      continue;
    }
    std::memcpy(&header, at, sizeof header);
    // Begun for the one who had it open before.
    if (header.generation == opened_)
      take({header.time, header.direction, header.lost_before, {at + sizeof header, header.size}});
    tail += sizeof header + aligned(header.size);
    tail_.store(tail, std::memory_order_release);
  }
}

}  // namespace syncline
