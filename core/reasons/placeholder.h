// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace syncline {

/// What stands between the braces of a placeholder: {name} is the figure, {name:# frame was|# frames were} the words
/// that it chooses as a count, with the figure in the place of "#".
struct Placeholder {
  std::string_view name;
  std::string_view one{}, other{};  // of counts: 1, and all others; empty: the figure itself
  constexpr explicit Placeholder(std::string_view inside) : name(inside.substr(0, inside.find(':'))) {
    if (name.size() == inside.size()) return;
    const auto words = inside.substr(name.size() + 1);
    one = words.substr(0, words.find('|'));
    other = one.size() == words.size() ? one : words.substr(one.size() + 1);
  }
  [[nodiscard]] std::string_view words_for(bool is_one) const { return is_one ? one : other; }
  /// The figure's text, or the words that it chooses with it.
  [[nodiscard]] std::string filled(std::string text, bool is_one) const {
    if (one.empty()) return text;
    std::string words(words_for(is_one));
    for (auto at = words.find('#'); at != std::string::npos; at = words.find('#', at + text.size()))
      words.replace(at, 1, text);
    return words;
  }
};

/// Where the next placeholder of a row stands; text.size() twice where there is none. From '{' to behind '}'.
struct ReasonPlace {
  std::size_t open = 0, end = 0;
  [[nodiscard]] Placeholder in(std::string_view text) const {
    return Placeholder(end > open ? text.substr(open + 1, end - open - 2) : std::string_view{});
  }
};
[[nodiscard]] constexpr ReasonPlace next_place(std::string_view text) {
  const auto open = text.find('{'), close = text.find('}', open);
  if (open == std::string_view::npos || close == std::string_view::npos) return {text.size(), text.size()};
  return {open, close + 1};
}

}  // namespace syncline
