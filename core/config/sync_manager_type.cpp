// SPDX-License-Identifier: Apache-2.0
#include "config/sync_manager_type.h"

#include <algorithm>
#include <array>

#include "protocol/sync_manager.h"

namespace syncline {
namespace {

constexpr std::array<std::string_view, 4> kWords{"MBoxOut", "MBoxIn", "Outputs", "Inputs"};  // type 1 and on

}  // namespace

std::string_view sync_manager_word(SyncManagerType type) {
  return type == SyncManagerType::kUnused ? std::string_view{} : kWords[static_cast<std::size_t>(type) - 1];
}

std::optional<SyncManagerType> sync_manager_type(std::string_view word) {
  const auto found = std::ranges::find(kWords, word);
  if (found == kWords.end()) return std::nullopt;
  return static_cast<SyncManagerType>(found - kWords.begin() + 1);
}

SyncManagerType sync_manager_type(const SyncManager& manager) {
  if (manager.is_mailbox()) return manager.ecat_writes() ? SyncManagerType::kMailboxOut : SyncManagerType::kMailboxIn;
  return manager.ecat_writes() ? SyncManagerType::kOutputs : SyncManagerType::kInputs;
}

}  // namespace syncline
