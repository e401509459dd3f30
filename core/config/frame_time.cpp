// SPDX-License-Identifier: Apache-2.0
#include "config/frame_time.h"

#include "protocol/frame.h"

namespace syncline {

Nanoseconds wire_time(const CyclicFrame& frame) {
  std::size_t bytes = kFrameOverhead;
  for (const auto& cmd : frame.commands) bytes += kDatagramHeaderSize + cmd.length() + kWkcSize;
  return wire_time_ns(bytes);
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
