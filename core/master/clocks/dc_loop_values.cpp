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
/// In front of the clock that leads, which shakes a follower of each message by microseconds. One less where the
/// messages of an average are far apart, and one where the clock that leads moves with the host's jitter: it has to be
/// followed, too.
constexpr std::uint8_t kInFrontFilterDepth = 6;
constexpr Nanoseconds kLongCycle = 4 * kMillisecond;
/// The reset value, 12, learns a quartz in some ten thousand messages only; below 10 the controller of bus shift
/// swings.
constexpr std::uint8_t kReturningSpeedCounterDepth = 10;
/// Of clocks that follow a clock: each message counts, and a quartz is learned within some hundred of them.
constexpr std::uint8_t kFilterDepthDifference = 0, kFilterDepthSpeedCounter = 8;

std::uint8_t in_front_depth(const NetworkConfig& config) {
  const int less =
      (config.cycle_time() > kLongCycle ? 1 : 0) + (config.dc.dcm.mode == DcmMode::kMasterRefClock ? 1 : 0);
  return static_cast<std::uint8_t>(kInFrontFilterDepth - less);
}

}  // namespace

bool DcLoopWrite::optional() const {
  return address == reg::kFilterDepthDifference || address == reg::kFilterDepthSpeedCounter;
}

std::uint8_t difference_depth(const NetworkConfig& config, DcLoopRole role) {
  const auto& wanted = config.dc.loop.filter_depth_difference;
  switch (role) {
    case DcLoopRole::kFollower:
      return wanted.value_or(kFilterDepthDifference);
    case DcLoopRole::kInFront:
      return wanted.value_or(in_front_depth(config));
    case DcLoopRole::kLeader:
      return kHostFilterDepth;
    case DcLoopRole::kReturning:
      break;
  }
  return kReturningFilterDepth;
}

std::vector<DcLoopWrite> dc_loop_values(const NetworkConfig& config, DcLoopRole role) {
  std::vector<DcLoopWrite> writes;
  if (config.dc.dcm.standard_loop_values) return writes;
  const auto& loop = config.dc.loop;
  const auto depth = difference_depth(config, role);
  if (role == DcLoopRole::kLeader || role == DcLoopRole::kReturning) {
    const bool returning = role == DcLoopRole::kReturning;
    if (returning || steers_reference_clock(config.dc.dcm.mode))
      writes.push_back({reg::kFilterDepthDifference, {depth}});
    if (returning) writes.push_back({reg::kFilterDepthSpeedCounter, {kReturningSpeedCounterDepth}});
    writes.push_back({reg::kSpeedCounterStart, le_bytes(kSpeedCounterDefault)});
    return writes;
  }
  writes.push_back({reg::kFilterDepthDifference, {depth}});
  writes.push_back(
      {reg::kFilterDepthSpeedCounter, {loop.filter_depth_speed_counter.value_or(kFilterDepthSpeedCounter)}});
  const auto start = loop.speed_counter_start.value_or(dc::speed_counter_start(config.cycle_time()));
  writes.push_back({reg::kSpeedCounterStart, le_bytes(start)});
  return writes;
}

}  // namespace syncline
