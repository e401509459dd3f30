// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "reasons/because.h"
#include "reasons/reason.h"

namespace syncline {

/// A figure of a reason that allocates nothing; `digits` hexadecimal ones, or decimal.
struct BriefNumber {
  std::int64_t value = 0;
  std::uint8_t digits = 0;
};
template <class Number>
requires std::is_integral_v<Number>
[[nodiscard]] constexpr BriefNumber brief_number(Number value) { return {static_cast<std::int64_t>(value)}; }
[[nodiscard]] constexpr BriefNumber brief_number(BriefNumber value) { return value; }
[[nodiscard]] constexpr BriefNumber hex_number(std::int64_t value, std::uint8_t digits) { return {value, digits}; }

/// True for a row whose last placeholder is {which}, {reason} or {state}: it says BriefReason::word.
[[nodiscard]] constexpr bool takes_word(std::string_view words) {
  const auto last = words.substr(std::min(words.rfind('{'), words.size()));
  return last.starts_with("{which}") || last.starts_with("{reason}") || last.starts_with("{state}");
}

/// A row with as many placeholders, and one for a word behind them where it takes one.
template <std::size_t kPlaces>
class BriefRow {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): as with format strings.
  consteval BriefRow(const char* words) : row_(row_of_reason(words)) {
    const std::string_view whole(words);
    if (places_of_reason(whole) != kPlaces + (takes_word(whole) ? 1U : 0U))
      throw "a placeholder for each number that is given, and no other";
  }
  [[nodiscard]] constexpr std::uint16_t number() const { return row_; }

 private:
  std::uint16_t row_;
};

/// A reason found where nothing may be allocated: a row and its figures. Copied without allocating.
struct BriefReason {
  std::uint16_t row = Reason::kNoRow;
  std::array<BriefNumber, 2> numbers{};
  std::string_view word{};  // for the program's life, and known to the translations; see takes_word()

  /// With as many of the numbers as the row has placeholders, and the word in one behind them.
  [[nodiscard]] Reason in_full() const;
};

/// brief("packet {number} where {expected} was to come", got, wanted)
template <class... Numbers>
requires(sizeof...(Numbers) <= 2) [[nodiscard]] constexpr BriefReason
    brief(std::type_identity_t<BriefRow<sizeof...(Numbers)>> row, Numbers... numbers) {
  return {.row = row.number(), .numbers = {brief_number(numbers)...}};
}

}  // namespace syncline
