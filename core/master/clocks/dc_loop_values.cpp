// SPDX-License-Identifier: Apache-2.0
#include "master/clocks/dc_loop_values.h"

#include "config/network_config.h"
#include "dc/clock_registers.h"
#include "protocol/registers.h"
#include "protocol/speed_counter.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

/// Averages 2^6 differences: what the host writes jitters with its send times, with tails of tens of microseconds; what
/// slaves are written does not. One that returns has to be learned quickly.
constexpr std::uint8_t kHostFilterDepth = 6, kReturningFilterDepth = 5;
/// The reset value, 12, learns a quartz in some ten thousand messages only; below 10 the controller of bus shift
/// swings.
constexpr std::uint8_t kReturningSpeedCounterDepth = 10;
/// Of clocks that follow a clock: each message counts, and a quartz is learned within some hundred of them.
constexpr std::uint8_t kFilterDepthDifference = 0, kFilterDepthSpeedCounter = 8;

}  // namespace

bool DcLoopWrite::optional() const {
  return address == reg::kFilterDepthDifference || address == reg::kFilterDepthSpeedCounter;
}

std::uint8_t difference_depth(const NetworkConfig& config, bool leads) {
  return leads ? kHostFilterDepth : config.dc.loop.filter_depth_difference.value_or(kFilterDepthDifference);
}

std::vector<DcLoopWrite> dc_loop_values(const NetworkConfig& config, DcLoopRole role) {
  std::vector<DcLoopWrite> writes;
  if (config.dc.dcm.standard_loop_values) return writes;
  const auto& loop = config.dc.loop;
  if (role != DcLoopRole::kFollower) {
    const bool returning = role == DcLoopRole::kReturning;
    const auto depth = returning ? kReturningFilterDepth : kHostFilterDepth;
    if (returning || steers_reference_clock(config.dc.dcm.mode))
      writes.push_back({reg::kFilterDepthDifference, {depth}});
    if (returning) writes.push_back({reg::kFilterDepthSpeedCounter, {kReturningSpeedCounterDepth}});
    writes.push_back({reg::kSpeedCounterStart, le_bytes(kSpeedCounterDefault)});
    return writes;
  }
  writes.push_back({reg::kFilterDepthDifference, {difference_depth(config, false)}});
  writes.push_back(
      {reg::kFilterDepthSpeedCounter, {loop.filter_depth_speed_counter.value_or(kFilterDepthSpeedCounter)}});
  const auto start = loop.speed_counter_start.value_or(dc::speed_counter_start(config.cycle_time()));
  writes.push_back({reg::kSpeedCounterStart, le_bytes(start)});
  return writes;
}

}  // namespace syncline
