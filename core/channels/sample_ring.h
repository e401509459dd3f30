// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "channels/cycle_sample.h"

namespace syncline {

/// Single producer, single consumer, power-of-two ring that never blocks the producer: a full ring
/// drops the new sample and counts it.
class SampleRing {
 public:
  explicit SampleRing(std::size_t capacity = 1U << 16);
  bool push(const CycleSample& sample);                                            // producer only
  std::size_t pop(std::vector<CycleSample>& out, std::size_t at_most = SIZE_MAX);  // consumer only; appends
  [[nodiscard]] bool is_half_full() const;                                         // producer only
  [[nodiscard]] std::uint64_t overruns() const { return overruns_.load(std::memory_order_relaxed); }

 private:
  std::vector<CycleSample> slots_;
  std::size_t mask_;
  std::atomic<std::size_t> head_{0}, tail_{0};
  std::atomic<std::uint64_t> overruns_{0};
};

}  // namespace syncline
