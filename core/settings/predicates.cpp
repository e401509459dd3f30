// SPDX-License-Identifier: Apache-2.0
#include "settings/predicates.h"

#include <algorithm>
#include <utility>

#include "settings/limits.h"

namespace syncline::settings {
namespace {

bool is_multiple(Nanoseconds value, Nanoseconds of, Nanoseconds rounding) {
  const auto rest = value % of;
  return value >= of - rounding && std::min(rest, of - rest) < rounding;
}

}  // namespace

Range set_values(Nanoseconds cycle) { return {1, cycle - 1}; }

bool keeps_step(Nanoseconds sync_period, Nanoseconds cycle, Nanoseconds rounding) {
  if (sync_period <= 0 || cycle <= 0) return false;
  return is_multiple(sync_period, cycle, rounding) || is_multiple(cycle, sync_period, rounding);
}

bool is_position(std::size_t slaves, std::int64_t position) { return position >= 0 && std::cmp_less(position, slaves); }

bool is_bus_cycle(Nanoseconds cycle) { return cycle >= limits::kShortestCycle && cycle <= limits::kLongestCycle; }

}  // namespace syncline::settings
