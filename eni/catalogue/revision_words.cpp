// SPDX-License-Identifier: Apache-2.0
#include "eni/catalogue/revision_words.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "config/identity.h"

namespace syncline::eni {
namespace {

constexpr std::size_t kWholeDigits = 8;
constexpr std::uint32_t kLargestPrinted = 0xFFFF;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; }

std::string lower_case(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), lower);
  return result;
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < text.size();) {
    const auto end = std::min(text.find_first_of(" \t", at), text.size());
    if (end > at) words.emplace_back(text.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

std::optional<std::uint32_t> digits(std::string_view text, int base) {
  std::uint32_t value = 0;
  const auto* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value, base);
  return error == std::errc{} && stopped == end && !text.empty() ? std::optional(value) : std::nullopt;
}

bool is_hexadecimal(std::string_view text) { return text.starts_with("#x") || text.starts_with("0x"); }

std::optional<std::uint32_t> whole_number(const std::string& word) {
  const auto text = lower_case(word);
  if (!is_hexadecimal(text) || text.size() != 2 + kWholeDigits) return std::nullopt;
  return digits(std::string_view(text).substr(2), 16);
}

/// One end of a range: as it is, or what is printed on the device.
struct End {
  std::uint32_t number = 0;
  bool printed = false;
};

std::optional<End> end_of(std::string_view text) {
  if (is_hexadecimal(text)) {
    const auto number = digits(text.substr(2), 16);
    return number ? std::optional(End{*number}) : std::nullopt;
  }
  const auto number = digits(text, 10);
  return number ? std::optional(End{*number, *number <= kLargestPrinted}) : std::nullopt;
}

std::uint32_t first_of(End end) { return end.printed ? end.number << 16 : end.number; }
std::uint32_t last_of(End end) { return end.printed ? end.number << 16 | 0xFFFF : end.number; }

/// "18", "16-18", "16-", "-18".
std::optional<RevisionWords::Range> range_of(std::string_view text) {
  const auto dash = text.find('-');
  if (dash == std::string_view::npos) {
    const auto only = end_of(text);
    return only ? std::optional(RevisionWords::Range{first_of(*only), last_of(*only)}) : std::nullopt;
  }
  const auto before = text.substr(0, dash), behind = text.substr(dash + 1);
  auto from = end_of(before), to = end_of(behind);
  if ((!from && !before.empty()) || (!to && !behind.empty()) || (!from && !to)) return std::nullopt;
  if (from && to && first_of(*to) < first_of(*from)) std::swap(from, to);
  RevisionWords::Range range;
  if (from) range.first = first_of(*from);
  if (to) range.last = last_of(*to);
  return range;
}

bool says_revision(std::string_view word) {
  return word == "rev" || word == "rev." || word == "revision" || word == "rev:" || word == "revision:";
}

}  // namespace

bool RevisionWords::fit(const Identity& identity) const {
  const auto is = [&](std::uint32_t number) {
    return number == identity.revision_no || number == identity.product_code;
  };
  if (!std::ranges::all_of(numbers, is)) return false;
  if (!revisions) return true;
  const auto revision = identity.revision_no;
  if (revision >= revisions->first && revision <= revisions->last) return true;
  // Some vendors count from 1 in the low word.
  const bool low = revision <= kLargestPrinted && revisions->first > kLargestPrinted;
  return low && revision >= revisions->first >> 16 && revision <= revisions->last >> 16;
}

bool RevisionWords::name_revision(const Identity& identity) const {
  const auto is = [&](std::uint32_t number) {
    return number == identity.revision_no && number != identity.product_code;
  };
  return revisions.has_value() || std::ranges::any_of(numbers, is);
}

RevisionWords revision_words(std::string_view text) {
  RevisionWords found;
  const auto words = words_of(text);
  const auto keep = [&](const std::string& word) { found.words.append(found.words.empty() ? "" : " ").append(word); };
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto word = lower_case(words[i]);
    const bool more = i + 1 < words.size();
    if (const auto range = says_revision(word) && more ? range_of(lower_case(words[i + 1])) : std::nullopt) {
      found.revisions = range;
      ++i;
    } else if (const auto number = whole_number(word)) {
      found.numbers.push_back(*number);
    } else {
      keep(words[i]);
    }
  }
  return found;
}

}  // namespace syncline::eni
