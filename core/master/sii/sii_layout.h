// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "protocol/sii.h"
#include "support/types.h"

/// What the EEPROM's reader, writer and kinds share: control and status 0x0502 (ESC data sheet, section II), and the
/// fixed part of the image (ETG.2010, table 2).
namespace syncline {

inline constexpr std::uint16_t kSiiReadCommand = 0x0100;
inline constexpr std::uint16_t kSiiReadsEightBytes = 0x0040;
inline constexpr std::uint16_t kSiiCommandError = 0x2000;
inline constexpr std::uint16_t kSiiWriteEnableError = 0x4000;
inline constexpr std::uint16_t kSiiBusy = 0x8000;
inline constexpr std::size_t kSiiStatusBytes = 6;  // 0x0502 control and status, 0x0504 address
/// A slave whose PDI emulates its EEPROM may need so long.
inline constexpr Nanoseconds kSiiBusyLimit = 300 * kMillisecond;

inline constexpr std::size_t kSiiHeaderBytes = 2 * sii::kCategoriesWord;
inline constexpr std::size_t kSiiPiece = 8;                 // bytes that one command reads at most
inline constexpr std::uint32_t kSiiConfigurationWords = 8;  // the last one holds the checksum

}  // namespace syncline
