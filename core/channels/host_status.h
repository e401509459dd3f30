// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/types.h"

namespace syncline {

/// How this host wakes up, on the real clock.
struct HostStatus {
  Nanoseconds spin = 0;       // end of each wait that is spent asking the clock, now
  Nanoseconds spin_mean = 0;  // what a cycle has spent so in the mean
  Nanoseconds wake_p50 = 0,
              wake_p99 = 0;  // how late sleeping alone wakes up, of the latest some hundred cycles; 0 not known
  bool operator==(const HostStatus&) const = default;
};

}  // namespace syncline
