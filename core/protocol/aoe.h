// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "support/result.h"

/// ADS over EtherCAT (ETG.1020, 4): the AMS header before the data of a command.
namespace syncline::aoe {

inline constexpr std::uint16_t kReadState = 4, kWrite = 3, kRead = 2, kReadWrite = 9;
/// The device does not know this command.
inline constexpr std::uint32_t kServiceNotSupported = 0x0701;

struct Address {
  std::array<std::uint8_t, 6> net_id{};
  std::uint16_t port = 0;
  bool operator==(const Address&) const = default;
};

struct Header {
  static constexpr std::size_t kSize = 32;
  static constexpr std::uint16_t kResponse = 0x0001, kAdsCommand = 0x0004;
  Address target, source;
  std::uint16_t command = 0;
  std::uint16_t state_flags = kAdsCommand;
  std::uint32_t length = 0;  // of what follows, bytes
  std::uint32_t error_code = 0;
  std::uint32_t invoke_id = 0;
  bool operator==(const Header&) const = default;
  [[nodiscard]] bool is_response() const { return (state_flags & kResponse) != 0; }
};

[[nodiscard]] std::vector<std::uint8_t> encode(const Header& header);
/// The first 32 bytes behind the mailbox header. kMalformedData.
[[nodiscard]] Result<Header> decode(std::span<const std::uint8_t> data);

}  // namespace syncline::aoe
