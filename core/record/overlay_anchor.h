// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "support/types.h"

namespace syncline {

class RunRecord;
struct Trigger;

/// Which moments of two runs are laid over each other.
enum class OverlayAlignment : std::uint8_t {
  kBegin,    // their first cycles
  kArmed,    // when their figures were armed: in OP, and in sync where that is watched
  kTrigger,  // the first episode of the same trigger in each
};

/// That moment of a run (host clock); nothing where it has none. `trigger`: whose first episode it is.
[[nodiscard]] std::optional<Nanoseconds> overlay_anchor(const RunRecord& run, OverlayAlignment alignment,
                                                        const Trigger& trigger);

/// By how much the second run is laid later than begin on begin, so that the moments of both lie over each other;
/// nothing where one of them has none. Exact.
[[nodiscard]] std::optional<Nanoseconds> overlay_offset(const RunRecord& first, const RunRecord& second,
                                                        OverlayAlignment alignment, const Trigger& trigger);

}  // namespace syncline
