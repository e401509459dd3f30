// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "support/result.h"

namespace syncline {

struct NetworkConfig;

/// A variable of the process image as somebody watches it, in every cycle. Has all that is needed to read its bits
/// without the configuration that it is of.
struct WatchedVariable {
  std::string name;                            // as the configuration names it
  std::string data_type;                       // the same: "DINT"
  bool output = false;                         // of the outputs; else of the inputs
  std::uint32_t bit_offset = 0, bit_size = 0;  // in that part of the image, as Variable::bit_offset
  int slave = -1;                              // position of the slave whose it is; -1: of none
  bool operator==(const WatchedVariable&) const = default;
};

/// Wider ones are no numbers.
inline constexpr std::uint32_t kMostWatchedBits = 64;

/// All variables of a configuration that can be watched (1 to 64 bits), inputs first, as they stand there.
[[nodiscard]] std::vector<WatchedVariable> watchable_variables(const NetworkConfig& config);

/// The one that `text` names: its name; or one of a slave, "3.Position actual value" or "Servo.Position actual value",
/// by the slave's position or name and the last part of its own, whatever the case of letters. kBadValue: none, or
/// several, which the error names.
[[nodiscard]] Result<WatchedVariable> find_watchable(const NetworkConfig& config, std::string_view text);

/// Numbers as the variable's type has them: a type of another length than its bits, and one of the device's own, is
/// unsigned.
using WatchedNumber = std::variant<std::int64_t, std::uint64_t, float, double>;
/// `bits`: those of the variable, the lowest in bit 0.
[[nodiscard]] WatchedNumber watched_number(const WatchedVariable& variable, std::uint64_t bits);
/// The same, to be drawn. Whole numbers beyond 2^53 are rounded.
[[nodiscard]] double watched_value(const WatchedVariable& variable, std::uint64_t bits);

}  // namespace syncline
