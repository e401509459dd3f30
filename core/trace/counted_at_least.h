// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "trace/signals.h"

namespace syncline {

class SampleStore;
struct SlaveStatus;

/// Which of a slave's counts may be higher than they say, because its counter has stood at its end stop or was cleared
/// between two readings: a bit a counter. 0: all are exact. It is what Signal::kCountsAtLeast shows, in runs and in
/// recordings; older recordings do not tell it.
[[nodiscard]] std::uint32_t counts_at_least(const SlaveStatus& slave);
/// The counts that such bits are about; of a port, whose counters share a bit, the first one.
[[nodiscard]] std::vector<Signal> counts_in(std::uint32_t bits);

/// The count of a slave may have been higher than it says at `time` (host clock). False where nothing tells it.
[[nodiscard]] bool counted_at_least(const SampleStore& store, Signal signal, std::size_t slave, Nanoseconds time);

}  // namespace syncline
