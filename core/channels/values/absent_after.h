// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/types.h"

namespace syncline {

/// Slaves count as absent when nothing at all has come back for so long, longer than any burst of lost frames.
inline constexpr Nanoseconds kAbsentAfter = 100 * kMillisecond;

}  // namespace syncline
