// SPDX-License-Identifier: Apache-2.0
#include "findings/reasons.h"

#include <algorithm>
#include <iterator>

#include "findings/reason_row.h"
#include "findings/reason_words.h"

namespace syncline {
namespace {

bool is_word(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Length of what a placeholder takes from the begin of a text, when `next` stands behind it: up to where that comes
/// first, to the end where nothing does, and a number or a word in front of another placeholder.
std::size_t length_of(std::string_view text, std::string_view next, bool last) {
  if (!next.empty()) return last && text.ends_with(next) ? text.size() - next.size() : text.find(next);
  if (last) return text.size();
  return static_cast<std::size_t>(std::ranges::find_if_not(text, is_word) - text.begin());
}

std::optional<Reason> match(std::string_view words, std::string_view text) {
  Reason reason{words};
  auto open = words.find('{');
  if (!text.starts_with(words.substr(0, open))) return std::nullopt;
  if (open == std::string_view::npos) return text == words ? std::optional(reason) : std::nullopt;
  text.remove_prefix(open);
  while (open != std::string_view::npos) {
    const auto close = words.find('}', open);
    const auto after = words.find('{', close);
    const auto next = words.substr(close + 1, after == std::string_view::npos ? after : after - close - 1);
    const auto length = length_of(text, next, after == std::string_view::npos);
    if (length == std::string_view::npos || !text.substr(length).starts_with(next)) return std::nullopt;
    reason.given.emplace_back(words.substr(open + 1, close - open - 1), text.substr(0, length));
    text.remove_prefix(length + next.size());
    open = after;
  }
  return text.empty() ? std::optional(reason) : std::nullopt;
}

/// Letters of ours; the row with most of them is the one that was meant.
std::size_t own_size(const Reason& reason) {
  std::size_t size = reason.words.size();
  for (const auto& [name, text] : reason.given) size -= name.size() + 2;
  return size;
}

}  // namespace

std::string fill_reason(std::string_view words, std::span<const std::string> given) {
  std::string text;
  for (const auto& one : given) {
    const auto open = words.find('{');
    text.append(words.substr(0, open)).append(one);
    words.remove_prefix(words.find('}', open) + 1);
  }
  return text.append(words);
}

std::optional<Reason> find_reason(std::string_view text) {
  std::optional<Reason> best;
  for (const auto words : words::kReasons) {
    auto found = match(words, text);
    if (found && (!best || own_size(*found) > own_size(*best))) best = std::move(found);
  }
  return best;
}

}  // namespace syncline
