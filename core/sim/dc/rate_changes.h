// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "support/types.h"

namespace syncline {
struct RateChange;
struct SimConfig;
}  // namespace syncline

namespace syncline::sim {

/// How the scenario's faults change the rate of a slave's quartz against true time, when the segment is switched on at
/// `start`. True time is the host's clock: an error of that is the opposite one of every slave.
[[nodiscard]] std::vector<RateChange> rate_changes(const SimConfig& config, std::size_t slave, Nanoseconds start);

}  // namespace syncline::sim
