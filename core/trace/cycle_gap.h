// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/types.h"

namespace syncline {

/// Values of two cycles that are no further apart (ns, like the cycle time) are joined by a line: a cycle may have
/// none.
constexpr Nanoseconds longest_cycle_gap(Nanoseconds cycle_time) { return cycle_time * 5 / 2; }

}  // namespace syncline
