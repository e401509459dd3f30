// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

namespace syncline {

/// Sum of what a device's counter counted while it was watched, from readings now and then. The first reading is the
/// beginning: what was counted before is somebody else's. A counter that jumps back has been cleared, or its device
/// restarted: it counted its new value since, and nobody knows what else, so the sum is then "at least". The same holds
/// for one that stands at its end stop, until who watches it clears it. A counter that wraps goes on.
class CounterTotal {
 public:
  enum class End : std::uint8_t { kSaturates, kWraps };

  /// `bits`: 1 to 32.
  constexpr CounterTotal(unsigned bits, End end) : most_(0xFFFF'FFFFU >> (32 - bits)), end_(end) {}

  /// Takes a reading; what it adds to the sum.
  constexpr std::uint32_t read(std::uint32_t value) {
    value = std::min(value, most_);
    const auto increase = known_ ? since_last(value) : 0;
    if (end_ == End::kSaturates && value == most_) at_least_ = true;
    known_ = true;
    last_ = value;
    total_ = total_ > UINT32_MAX - increase ? UINT32_MAX : total_ + increase;
    return increase;
  }
  /// It was set to 0 just now, by who watches it. What it counted since its last reading is not known.
  constexpr void cleared() {
    at_least_ = true;
    last_ = 0;
  }
  /// The next reading is a new beginning; the sum stays.
  constexpr void begin_anew() { known_ = false; }

  [[nodiscard]] constexpr bool known() const { return known_; }
  [[nodiscard]] constexpr std::uint32_t total() const { return total_; }
  [[nodiscard]] constexpr std::uint32_t last() const { return last_; }
  /// It counts no more, until somebody clears it.
  [[nodiscard]] constexpr bool at_end_stop() const { return end_ == End::kSaturates && known_ && last_ == most_; }
  /// There may have been more than total().
  [[nodiscard]] constexpr bool at_least() const { return at_least_; }

 private:
  constexpr std::uint32_t since_last(std::uint32_t value) {
    if (value >= last_) return value - last_;
    // From the last quarter to the first one: nothing that was cleared looks like that.
    const bool wrapped = end_ == End::kWraps && last_ > most_ - most_ / 4 && value < most_ / 4;
    if (wrapped) return value + (most_ - last_) + 1;
    at_least_ = true;
    return value;
  }

  std::uint32_t most_;
  End end_;
  bool known_ = false, at_least_ = false;
  std::uint32_t last_ = 0, total_ = 0;
};

}  // namespace syncline
