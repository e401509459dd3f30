// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace syncline {

/// SyncManager register image, 8 bytes at 0x0800 + 8 n (ETG.1000.4, table 58).
struct SyncManager {
  static constexpr std::size_t kSize = 8;
  static constexpr std::uint16_t kPlaceOfStatus = 5;  // in its registers; before it start, length, control
  static constexpr std::uint8_t kControlMailbox = 0x02;
  static constexpr std::uint8_t kControlEcatWrites = 0x04;
  static constexpr std::uint8_t kControlWatchdog = 0x40;
  static constexpr std::uint8_t kStatusMailboxFull = 0x08;
  static constexpr std::uint8_t kStatusBuffer = 0x30;  // buffered: the one written last; 3: none

  std::uint16_t start = 0;
  std::uint16_t length = 0;
  std::uint8_t control = 0;
  std::uint8_t status = 0;
  std::uint8_t activate = 0;
  std::uint8_t pdi_control = 0;

  bool operator==(const SyncManager&) const = default;
  [[nodiscard]] std::array<std::uint8_t, kSize> encode() const;
  [[nodiscard]] static SyncManager decode(std::span<const std::uint8_t, kSize> bytes);
  [[nodiscard]] bool is_mailbox() const { return (control & 0x03) == kControlMailbox; }
  [[nodiscard]] bool ecat_writes() const { return (control & 0x0C) == kControlEcatWrites; }
  [[nodiscard]] bool enabled() const { return (activate & 0x01) != 0; }
};

}  // namespace syncline
