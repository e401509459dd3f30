// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace syncline {

struct NetworkConfig;

/// What is written to the time control loop of a clock (ESC data sheet I, 9.1.4), in this order: the write of the speed
/// counter start comes last, it resets the filters and makes the depths effective.
struct DcLoopWrite {
  std::uint16_t address = 0;  // 0x0930, 0x0934, 0x0935
  std::vector<std::uint8_t> bytes;
  [[nodiscard]] bool optional() const;  // older ESCs have no filter depths
};

enum class DcLoopRole : std::uint8_t {
  kFollower,   // is told another clock's time in every frame: each message counts
  kInFront,    // of the clock that leads: is told what the master believes, with the noise of its send stamps
  kLeader,     // leads, and where the mode steers it is told the host's time, with the host's jitter
  kReturning,  // is to lead, and follows its substitute until it has learned its quartz; in front of it, it is told
               // what the host believes
};
/// Exponent of the average over time differences (0x0934) of a clock in this role.
[[nodiscard]] std::uint8_t difference_depth(const NetworkConfig& config, DcLoopRole role);
/// Nothing when the configuration leaves the loop as the init commands wrote it (standard_loop_values).
[[nodiscard]] std::vector<DcLoopWrite> dc_loop_values(const NetworkConfig& config, DcLoopRole role);

}  // namespace syncline
