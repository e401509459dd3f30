// SPDX-License-Identifier: Apache-2.0
#include "config/frame_time.h"

#include <algorithm>

namespace syncline {

Nanoseconds wire_time(const CyclicFrame& frame) {
  constexpr std::uint32_t kDatagramOverhead = 12;
  constexpr std::uint32_t kMinimumPayload = 46;
  constexpr std::uint32_t kAroundPayload = 8 + 14 + 4 + 12;  // preamble, Ethernet header, FCS, gap
  constexpr Nanoseconds kByteTime = 80;
  std::uint32_t payload = 2;
  for (const auto& cmd : frame.commands) payload += kDatagramOverhead + cmd.length();
  return (std::max(payload, kMinimumPayload) + kAroundPayload) * kByteTime;
}

CycleNeed cycle_need(const NetworkConfig& config, bool all_tasks) {
  CycleNeed need;
  for (const auto& task : config.cyclic) {
    for (const auto& frame : task.frames) need.wire += wire_time(frame);
    if (!all_tasks) break;
  }
  if (need.wire > 0) need.travel = static_cast<Nanoseconds>(config.slaves.size()) * kTravelPerSlave;
  return need;
}

}  // namespace syncline
