// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "record/run_limits.h"
#include "trace/sample_store.h"

namespace syncline::bench {

/// A signal that is drawn, of the bus or of a slave.
struct ShownSignal {
  Signal signal = Signal::kCycle;
  int slave = -1;  // -1: the bus
  bool operator==(const ShownSignal&) const = default;
};

/// What the plots of a run that is in order until `from` (host clock) show out of order since then: deviations and
/// errors beyond their limit, counts that rise, slaves that are not in OP or of which nothing is known.
[[nodiscard]] std::vector<ShownSignal> shown_out_of_order(const SampleStore& store, const RunLimits& limits,
                                                          Nanoseconds from);
/// Whether a count or a state of a slave that was known at `from` is not known for a while, or to the end, since then;
/// where it was not known then any more, whether it still is not at `until`.
[[nodiscard]] bool has_gap(const SampleStore& store, Signal signal, std::size_t slave, Nanoseconds from,
                           Nanoseconds until);
/// "deviation_ns of slave 2".
[[nodiscard]] std::string text_of(const ShownSignal& shown);

}  // namespace syncline::bench
