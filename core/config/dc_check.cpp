// SPDX-License-Identifier: Apache-2.0
#include "config/dc_check.h"

#include <fmt/format.h>

#include <cstdint>

namespace syncline {
namespace {

struct Range {
  const char* key;
  std::int64_t value, low, high;
  const char* unit;
};

Status check(const Range& range) {
  if (range.value >= range.low && range.value <= range.high) return {};
  return fail(ErrorCode::kBadValue, range.key,
              fmt::format("{}{} is outside {} to {}", range.value, range.unit, range.low, range.high));
}

}  // namespace

Status check_dc(const NetworkConfig& config) {
  const auto& dc = config.dc;
  if (!dc.enabled) return {};
  const Range ranges[] = {
      {"master.dc.delay_rounds", dc.delay_rounds, 1, 100, ""},
      {"master.dc.delay_difference_ns", dc.delay_difference.value_or(0), 0, 1000, " ns"},
      {"master.dc.burst_total", dc.burst_total, 0, 1'000'000, " frames"},
      {"master.dc.burst_bulk", dc.burst_bulk, 1, 1000, " frames"},
      {"master.dc.sync_window_exponent", dc.sync_window.exponent, 1, 30, ""},
      {"master.dc.sync_window_settle_ms", dc.sync_window.settle_time_ms, 0, 60'000, " ms"},
      {"master.dc.start_time_safety_us", dc.start_time_safety / kMicrosecond, 0, 10'000'000, " us"},
      {"master.dc.start_time_grid_us", dc.start_time_grid / kMicrosecond, 0, 1'000'000, " us"},
      {"master.dc.loop.speed_counter_start", dc.loop.speed_counter_start.value_or(0x1000), 0x0080, 0x3FFF, ""},
      {"master.dc.loop.filter_depth_difference", dc.loop.filter_depth_difference.value_or(0), 0, 15, ""},
      {"master.dc.loop.filter_depth_speed_counter", dc.loop.filter_depth_speed_counter.value_or(0), 0, 15, ""},
  };
  for (const auto& range : ranges) {
    if (auto status = check(range); !status) return status;
  }
  if (dc.reference_clock && *dc.reference_clock >= config.slaves.size()) {
    return fail(ErrorCode::kBadValue, "master.dc.reference_clock",
                fmt::format("there is no slave at position {}, the last one is at {}", *dc.reference_clock,
                            static_cast<std::int64_t>(config.slaves.size()) - 1));
  }
  return {};
}

}  // namespace syncline
