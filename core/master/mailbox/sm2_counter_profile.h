// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace syncline {

struct Identity;

inline constexpr std::uint16_t kSyncManager2Parameter = 0x1C32;  // "Output SyncManager parameter"
inline constexpr std::uint16_t kSyncManager3Parameter = 0x1C33;  // "Input SyncManager parameter"

/// Sub-index of 0x1C32 that counts missed SM2 events. ETG.1020 has it at 0x0B; the older layout, still
/// in the field, has "cycle exceeded" there and the missed events at 0x0C.
inline constexpr std::uint8_t kSm2MissedSubIndex = 0x0B;
inline constexpr std::uint8_t kSm2MissedSubIndexOldLayout = 0x0C;

/// By the table of device families; nothing for everybody else.
[[nodiscard]] std::optional<std::uint8_t> known_sm2_missed_sub_index(const Identity& identity);
/// The same; the ETG place for everybody else.
[[nodiscard]] std::uint8_t sm2_missed_sub_index(const Identity& identity);

/// By the object's own words ("SM event missed counter"), which are better than any table. 0 when
/// neither name speaks of missed events.
[[nodiscard]] std::uint8_t sm2_missed_sub_index(std::string_view name_of_0b, std::string_view name_of_0c);

}  // namespace syncline
