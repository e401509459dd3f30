// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dc/propagation_delay.h"
#include "master/clocks/clock_segment.h"

namespace syncline {

class Bus;
class SlaveAddress;

/// The registers of one slave's clock as they are.
struct ClockReading {
  DcCapability capability = DcCapability::kNone;
  std::uint64_t system_time = 0;                                             // 0x0910, ns
  std::uint64_t offset = 0;                                                  // 0x0920
  std::uint32_t delay_ns = 0;                                                // 0x0928
  std::int64_t difference_ns = 0;                                            // 0x092C, positive: ahead
  std::uint16_t speed_counter_start = 0;                                     // 0x0930
  std::int16_t speed_counter_diff = 0;                                       // 0x0932
  std::uint8_t filter_depth_difference = 0, filter_depth_speed_counter = 0;  // 0x0934, 0x0935
  std::uint16_t assign_activate = 0;                                         // 0x0980
  bool start_pending = false;                                                // 0x0984: the first SYNC0 is still to come
  std::uint64_t next_sync0 = 0;                                              // 0x0990
  std::uint32_t sync0_cycle_ns = 0, sync1_cycle_ns = 0;                      // 0x09A0, 0x09A4

  [[nodiscard]] bool has_system_time() const { return syncline::has_system_time(capability); }
  /// By how much the control loop slows the clock.
  [[nodiscard]] double correction_ppm() const;
  /// SYNC0 was started with a time that has passed: it will not come.
  [[nodiscard]] bool start_missed() const;
};
/// Reads only. Frame order; kNoResponse names a slave that does not answer.
[[nodiscard]] Result<std::vector<ClockReading>> survey_clocks(Bus& bus, std::span<const SlaveAddress> slaves);

/// What the slaves latched, and the delays that follow.
struct DelaySurvey {
  ClockSegment segment;  // nodes with the receive times
  dc::DelayResult result;
  std::size_t rounds = 0;  // 0: the times are those of the last latch by anybody
};
/// Takes `rounds` latches (BWR 0x0900: nothing else is changed); 0 reads what is there and changes nothing.
[[nodiscard]] Result<DelaySurvey> survey_delays(Bus& bus, std::span<const SlaveAddress> slaves, std::size_t rounds,
                                                const dc::DelayOptions& options);

}  // namespace syncline
