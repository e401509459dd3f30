// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "trace/signals.h"

namespace syncline {

struct Snapshot;

/// The count of a slave may have been higher than it says: its counter has stood at its end stop, or was cleared
/// between two readings, by the newest snapshot. False where that tells nothing of it.
[[nodiscard]] bool counted_at_least(const Snapshot& snapshot, Signal signal, std::size_t slave);

}  // namespace syncline
