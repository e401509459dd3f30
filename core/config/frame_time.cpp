// SPDX-License-Identifier: Apache-2.0
#include "config/frame_time.h"

#include <algorithm>

#include "config/command_data.h"
#include "config/cyclic_frame.h"
#include "config/network_config.h"
#include "protocol/frame.h"

namespace syncline {

std::size_t frame_bytes(const CyclicFrame& frame) {
  std::size_t bytes = kFrameOverhead;
  for (const auto& cmd : frame.commands) bytes += kDatagramOverhead + cmd.length();
  return bytes;
}

std::size_t bytes_sent(const CyclicFrame& frame) {
  return std::max(frame_bytes(frame), kMinEthernetFrame) + kFrameCheckSequence;
}

Nanoseconds wire_time(const CyclicFrame& frame) { return wire_time_ns(frame_bytes(frame)); }

Nanoseconds outputs_wire_time(const NetworkConfig& config, std::size_t slave) {
  const auto task = outputs_task(config, slave);
  if (!task) return 0;
  Nanoseconds passed = 0, complete = 0;
  for (std::size_t i = 0; i <= *task; ++i) {
    for (const auto& frame : config.cyclic[i].frames) {
      passed += wire_time(frame);
      const bool carries = std::ranges::any_of(frame.commands, [&](const CyclicCmd& command) {
        return writes_outputs(command, config.slaves[slave].send, config.image);
      });
      if (carries) complete = passed;
    }
  }
  return complete;
}

Nanoseconds travel_time(const NetworkConfig& config) {
  Nanoseconds sum = 0;
  for (const auto& slave : config.slaves) sum += travel_through(slave.physics);
  return sum;
}

CycleNeed cycle_need(const NetworkConfig& config, bool all_tasks) {
  CycleNeed need;
  for (const auto& task : config.cyclic) {
    for (const auto& frame : task.frames) need.wire += wire_time(frame);
    if (!all_tasks) break;
  }
  if (need.wire > 0) need.travel = travel_time(config);
  return need;
}

}  // namespace syncline
