// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace syncline {

/// kUnknown: was or should be watched, but the readings are too old to say anything.
enum class SyncState : std::uint8_t { kNotMonitored, kNotReady, kBusy, kInSync, kOutOfSync, kUnknown };
inline constexpr std::uint8_t kSyncStates = 6;

/// Somebody judges; otherwise the state says nothing about the machine.
[[nodiscard]] constexpr bool is_watched(SyncState state) { return state != SyncState::kNotMonitored; }

/// The name in JSON and in recordings: "in_sync".
[[nodiscard]] std::string_view sync_state_key(SyncState state);
/// In words: "in sync", "OUT OF SYNC".
[[nodiscard]] std::string_view sync_state_text(SyncState state);

}  // namespace syncline
