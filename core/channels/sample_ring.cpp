// SPDX-License-Identifier: Apache-2.0
#include "channels/sample_ring.h"

#include <bit>

namespace syncline {

SampleRing::SampleRing(std::size_t capacity)
    : slots_(std::bit_ceil(capacity < 2 ? std::size_t{2} : capacity)), mask_(slots_.size() - 1) {}

bool SampleRing::push(const CycleSample& sample) {
  const auto head = head_.load(std::memory_order_relaxed);
  if (head - tail_.load(std::memory_order_acquire) == slots_.size()) {
    overruns_.fetch_add(1, std::memory_order_relaxed);
    return false;
  }
  slots_[head & mask_] = sample;
  head_.store(head + 1, std::memory_order_release);
  return true;
}

bool SampleRing::is_half_full() const {
  return head_.load(std::memory_order_relaxed) - tail_.load(std::memory_order_acquire) >= slots_.size() / 2;
}

std::size_t SampleRing::pop(std::vector<CycleSample>& out, std::size_t at_most) {
  const auto tail = tail_.load(std::memory_order_relaxed);
  const auto available = head_.load(std::memory_order_acquire) - tail;
  const auto count = available < at_most ? available : at_most;
  out.reserve(out.size() + count);
  for (std::size_t i = 0; i < count; ++i) out.push_back(slots_[(tail + i) & mask_]);
  tail_.store(tail + count, std::memory_order_release);
  return count;
}

}  // namespace syncline
