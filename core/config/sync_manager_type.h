// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace syncline {

struct SyncManager;

/// What a SyncManager is for, by the numbers of the SII's category SyncM (ETG.2010).
enum class SyncManagerType : std::uint8_t { kUnused = 0, kMailboxOut = 1, kMailboxIn = 2, kOutputs = 3, kInputs = 4 };

/// The word of ESI (ETG.2000, Sm) and ENI (ETG.2100, Sm/Type); "" for one that is not used.
[[nodiscard]] std::string_view sync_manager_word(SyncManagerType type);
[[nodiscard]] std::optional<SyncManagerType> sync_manager_type(std::string_view word);
/// By mode and direction of its control byte (0x0804), where nobody says what it is for.
[[nodiscard]] SyncManagerType sync_manager_type(const SyncManager& manager);

}  // namespace syncline
