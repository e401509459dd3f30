// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <string_view>

/// Reasons whose words are looked up while compiling: one that is no row of its table, and a placeholder without
/// something that stands in it, do not compile.
namespace syncline {

/// The words with what is given in their placeholders, in their order.
[[nodiscard]] std::string fill_reason(std::string_view words, std::span<const std::string> given);

/// A row of the table that has a placeholder for each of `Given`. Function templates take it as
/// std::type_identity_t<ReasonRow<kTable, Given...>>, so that a literal becomes one.
template <const auto& kTable, class... Given>
class ReasonRow {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): as with format strings.
  consteval ReasonRow(const char* words) {
    const std::string_view whole(words);
    std::size_t row = 0;
    while (row < std::size(kTable) && kTable[row] != whole) ++row;
    if (row == std::size(kTable)) throw "no row of the table has these words";
    words_ = kTable[row];
    std::size_t places = 0;
    for (const char c : words_) places += c == '{' ? 1U : 0U;
    if (places != sizeof...(Given)) throw "a placeholder for each thing that is given, and no other";
  }
  [[nodiscard]] std::string_view words() const { return words_; }
  /// In English, figures as fmt writes them.
  [[nodiscard]] std::string text(const Given&... given) const {
    return fill_reason(words_, std::array<std::string, sizeof...(Given)>{fmt::format("{}", given)...});
  }

 private:
  std::string_view words_;
};

}  // namespace syncline
