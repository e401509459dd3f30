// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "reasons/reason.h"
#include "reasons/reason_words.h"

/// Reasons whose words are looked up while compiling: one that is no row of the table, and a placeholder without
/// something that stands in it, do not compile.
namespace syncline {

[[nodiscard]] consteval std::uint16_t row_of_reason(std::string_view words) {
  for (std::size_t row = 0; row < std::size(words::kReasons); ++row) {
    if (words::kReasons[row] == words) return static_cast<std::uint16_t>(row);
  }
  throw "no row of the table of reasons has these words";
}

[[nodiscard]] constexpr std::size_t places_of_reason(std::string_view words) {
  std::size_t places = 0;
  for (const char c : words) places += c == '{' ? 1U : 0U;
  return places;
}

/// A row that has as many placeholders. A literal becomes one.
template <std::size_t kPlaces>
class ReasonRow {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): as with format strings.
  consteval ReasonRow(const char* words) : row_(row_of_reason(words)) {
    if (places_of_reason(words) != kPlaces) throw "a placeholder for each thing that is given, and no other";
  }
  [[nodiscard]] std::uint16_t number() const { return row_; }

 private:
  std::uint16_t row_;
};

/// What stands in a placeholder: a reason as it is, all else as fmt writes it.
template <class Given>
[[nodiscard]] Reason given_reason(Given&& given) {
  if constexpr (std::same_as<std::remove_cvref_t<Given>, Reason>) {
    return std::forward<Given>(given);
  } else {
    return Reason::verbatim(fmt::format("{}", std::forward<Given>(given)));
  }
}

/// because("\"{text}\" is none of {words}", text, names)
template <class... Given>
[[nodiscard]] Reason because(std::type_identity_t<ReasonRow<sizeof...(Given)>> row, Given&&... given) {
  std::vector<Reason> all;
  all.reserve(sizeof...(given));
  (all.push_back(given_reason(std::forward<Given>(given))), ...);
  return Reason::of_row(row.number(), std::move(all));
}

/// Words that stand in another row's placeholder, where no Reason can be made: they are a row of their own.
[[nodiscard]] consteval std::string_view reason_words(const char* words) {
  return words::kReasons[row_of_reason(words)];
}

}  // namespace syncline
