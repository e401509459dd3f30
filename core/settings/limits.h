// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "support/types.h"

/// Limits that more than one setting or more than one room of the program knows: each stands here and nowhere else.
namespace syncline::limits {

/// Of the bus cycle of our master.
inline constexpr Nanoseconds kShortestCycle = 31'250, kLongestCycle = 100 * kMillisecond;
/// Of the cycle of a task in anybody's ENI.
inline constexpr Nanoseconds kLongestTaskCycle = 10 * kSecond;
/// What 32 bits of nanoseconds hold: 0x09A0, 0x09A4, 0x1C32, 0x1C33, 0xF800:04.
inline constexpr Nanoseconds kLargestTime32 = 0xFFFF'FFFF;
/// What the ENI holds of the times of a slave's SYNC signals (xs:int of DC/CycleTime0, CycleTime1 and ShiftTime).
inline constexpr Nanoseconds kLargestSyncTime = 0x7FFF'FFFF;
inline constexpr std::int64_t kLargestWord = 0xFFFF;
inline constexpr std::int64_t kLongestTimeoutMs = 600'000;
/// Of a settle time of the slaves or of the master.
inline constexpr std::int64_t kLongestSettleMs = 60'000;
/// Of a task, in bus cycles; of a Sync Unit Cycle, up and down; of samples in a cycle.
inline constexpr std::int64_t kLargestMultiple = 1000;
/// Exponents of the filters 0x0934 and 0x0935.
inline constexpr std::int64_t kLargestFilterDepth = 15;
inline constexpr std::int64_t kWholePercent = 100;
/// Of texts, in bytes.
inline constexpr std::int64_t kNameBytes = 255, kHostNameBytes = 32;

}  // namespace syncline::limits
