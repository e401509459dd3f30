// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace syncline {

/// Datagram commands (ETG.1000.4, table 9). The numbers are those of the wire and of ENI `Cmd`.
enum class Command : std::uint8_t {
  kNop = 0,
  kAprd = 1,
  kApwr = 2,
  kAprw = 3,
  kFprd = 4,
  kFpwr = 5,
  kFprw = 6,
  kBrd = 7,
  kBwr = 8,
  kBrw = 9,
  kLrd = 10,
  kLwr = 11,
  kLrw = 12,
  kArmw = 13,
  kFrmw = 14,
};
inline constexpr std::uint8_t kLastCommand = 14;

[[nodiscard]] std::string_view command_name(Command command);  // "APRD"
[[nodiscard]] constexpr bool is_logical(Command c) {
  return c == Command::kLrd || c == Command::kLwr || c == Command::kLrw;
}
[[nodiscard]] constexpr bool is_auto_increment(Command c) {
  return c == Command::kAprd || c == Command::kApwr || c == Command::kAprw || c == Command::kArmw;
}
[[nodiscard]] constexpr bool is_fixed_address(Command c) {
  return c == Command::kFprd || c == Command::kFpwr || c == Command::kFprw || c == Command::kFrmw;
}
[[nodiscard]] constexpr bool is_broadcast(Command c) {
  return c == Command::kBrd || c == Command::kBwr || c == Command::kBrw;
}
/// True when the master's data reach a slave's memory.
[[nodiscard]] constexpr bool writes(Command c) {
  return c == Command::kApwr || c == Command::kAprw || c == Command::kFpwr || c == Command::kFprw ||
         c == Command::kBwr || c == Command::kBrw || c == Command::kLwr || c == Command::kLrw || c == Command::kArmw ||
         c == Command::kFrmw;
}

}  // namespace syncline
