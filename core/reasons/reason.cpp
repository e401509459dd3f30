// SPDX-License-Identifier: Apache-2.0
#include "reasons/reason.h"

#include <fmt/format.h>

#include <cstring>
#include <utility>

#include "reasons/because.h"
#include "reasons/brief_reason.h"
#include "reasons/placeholder.h"
#include "reasons/reason_words.h"

namespace syncline {
namespace {

std::string number_text(const BriefNumber& number) {
  return number.digits == 0 ? fmt::format("{}", number.value) : fmt::format("{:0{}X}", number.value, number.digits);
}

}  // namespace

Reason Reason::of_system(int number) { return phrase(std::strerror(number)); }

std::string_view Reason::words() const {
  if (row_ < std::size(words::kReasons)) return words::kReasons[row_];
  return phrase_ ? std::string_view(text_) : std::string_view();
}

std::string Reason::text() const {
  if (given_.empty() && row_ >= std::size(words::kReasons)) return text_;
  auto words = this->words();
  std::string text;
  for (const Reason& one : given_) {
    const auto place = next_place(words);
    auto said = one.text();
    const bool is_one = said == "1";
    text.append(words.substr(0, place.open)).append(place.in(words).filled(std::move(said), is_one));
    words.remove_prefix(place.end);
  }
  return text.append(words);
}

std::optional<Reason> reason_of_words(std::string_view words, std::vector<Reason> given) {
  for (std::size_t row = 0; row < std::size(words::kReasons); ++row) {
    if (words::kReasons[row] == words && places_of_reason(words) == given.size())
      return Reason::of_row(static_cast<std::uint16_t>(row), std::move(given));
  }
  return given.empty() ? std::optional(Reason::phrase(words)) : std::nullopt;
}

Reason BriefReason::in_full() const {
  if (row >= std::size(words::kReasons)) return {};
  const bool worded = takes_word(words::kReasons[row]);
  const auto figures = places_of_reason(words::kReasons[row]) - (worded ? 1U : 0U);
  std::vector<Reason> given;
  for (std::size_t i = 0; i < figures; ++i) given.push_back(Reason::verbatim(number_text(numbers[i])));
  if (worded) given.push_back(Reason::phrase(word));
  return Reason::of_row(row, std::move(given));
}

}  // namespace syncline
