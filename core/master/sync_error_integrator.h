// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline {

/// What a slave's internal error counter (0x10F1: 3 more for each missed SM event, 1 less for each good one, never below 0)
/// may have reached, from the counter of missed events that is read now and then. The order of events between two
/// readings is not known; the value is the one with the misses last, the highest that it can be now.
class SyncErrorIntegrator {
 public:
  static constexpr std::uint32_t kMiss = 3;

  /// `missed`: the slave's counter, which may begin anew; `cycle`: number of its SYNC0 cycle.
  void read(std::uint32_t missed, std::uint64_t cycle) {
    const std::uint64_t cycles = known_ && cycle > cycle_ ? cycle - cycle_ : 0;
    const std::uint64_t misses = known_ && missed > missed_ ? missed - missed_ : 0;
    if (known_ && missed < missed_) value_ = 0;  // it has left OP meanwhile
    const std::uint64_t good = cycles > misses ? cycles - misses : 0;
    value_ = (value_ > good ? value_ - good : 0) + kMiss * misses;
    missed_ = missed;
    cycle_ = cycle;
    known_ = true;
  }
  void reset() { *this = {}; }
  [[nodiscard]] std::uint32_t value() const { return value_ > 0xFFFF ? 0xFFFF : static_cast<std::uint32_t>(value_); }

 private:
  bool known_ = false;
  std::uint32_t missed_ = 0;
  std::uint64_t cycle_ = 0, value_ = 0;
};

}  // namespace syncline
