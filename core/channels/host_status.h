// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "channels/processor_holder.h"
#include "support/types.h"

namespace syncline {

/// How this host wakes up, on the real clock.
struct HostStatus {
  Nanoseconds spin = 0;       // end of each wait that is spent asking the clock, now
  Nanoseconds spin_mean = 0;  // what a cycle has spent so in the mean
  Nanoseconds wake_p50 = 0,
              wake_p99 = 0;  // how late sleeping alone wakes up, of the latest some hundred cycles; 0 not known
  Nanoseconds held = 0;      // by how much the cyclic thread came too late where cycles were left out, all together
  std::optional<Nanoseconds> held_by_others;  // of it, while it was ready and other threads had its processor
  ProcessorHolder holder;                     // who keeps a processor longest, looked for after cycles were left out
  bool operator==(const HostStatus&) const = default;
};

}  // namespace syncline
