// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

/// The configured station alias (register 0x0012): a second station address, which a slave takes from its EEPROM.
namespace syncline {

/// Where it stands in the EEPROM, in bytes, and the checksum over what comes before that one (ETG.1000.6, table 16).
inline constexpr std::size_t kSiiAliasByte = 8, kSiiChecksumByte = 14;

/// Whether a slave listens to it beside its station address; `dl_control_alias`: byte 0x0103.
[[nodiscard]] constexpr bool listens_to_alias(std::uint8_t dl_control_alias) { return (dl_control_alias & 0x01) != 0; }

}  // namespace syncline
