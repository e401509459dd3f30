// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "config/external_clock.h"
#include "support/types.h"

namespace syncline {

/// How far the other network's clock is ahead, as long as the bridge device shows both times going on: one whose cable
/// to the other network is unplugged, or whose firmware stands still, shows the last ones. The cyclic thread.
class ExternalClockReader {
 public:
  explicit ExternalClockReader(const ExternalClockPlace& place) : place_(place) {}
  [[nodiscard]] std::size_t slave() const { return place_.slave; }
  /// Once a cycle; `now`: host clock. External less internal time.
  [[nodiscard]] std::optional<Nanoseconds> read(std::span<const std::uint8_t> inputs, Nanoseconds now);

 private:
  struct Stamp {
    std::uint64_t value = 0;
    Nanoseconds changed = 0;
    [[nodiscard]] bool goes_on(std::uint64_t shown, Nanoseconds now);
  };
  ExternalClockPlace place_;
  Stamp internal_, external_;
};

}  // namespace syncline
