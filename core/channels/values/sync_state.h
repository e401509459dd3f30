// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline {

/// kUnknown: was or should be watched, but the readings are too old to say anything.
enum class SyncState : std::uint8_t { kNotMonitored, kNotReady, kBusy, kInSync, kOutOfSync, kUnknown };

}  // namespace syncline
