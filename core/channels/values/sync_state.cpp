// SPDX-License-Identifier: Apache-2.0
#include "channels/values/sync_state.h"

#include <array>

namespace syncline {
namespace {

struct Words {
  std::string_view key, text;
};
constexpr std::array<Words, kSyncStates> kWords{{{"not_monitored", "not monitored"},
                                                 {"not_ready", "not ready"},
                                                 {"settling", "getting in sync"},
                                                 {"in_sync", "in sync"},
                                                 {"out_of_sync", "OUT OF SYNC"},
                                                 {"unknown", "unknown, no recent readings"}}};

const Words& words_of(SyncState state) {
  const auto index = static_cast<std::size_t>(state);
  return index < kWords.size() ? kWords[index] : kWords.back();
}

}  // namespace

std::string_view sync_state_key(SyncState state) { return words_of(state).key; }
std::string_view sync_state_text(SyncState state) { return words_of(state).text; }

}  // namespace syncline
