// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "support/types.h"

namespace syncline {

class SampleStore;

/// No frame came back, or no cycle is known.
struct Outage {
  Nanoseconds begin = 0, end = 0;  // the last frame before it and the first one after it, or the newest cycle
  bool operator==(const Outage&) const = default;
};

/// Those of [from, to) that are longer than SampleStore::longest_gap() allows between two cycles, by time. Short
/// stretches are looked at cycle by cycle; of long ones those are found that fill a column of `width` ns.
[[nodiscard]] std::vector<Outage> outages(const SampleStore& store, Nanoseconds from, Nanoseconds to,
                                          Nanoseconds width);

}  // namespace syncline
