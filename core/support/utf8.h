// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace syncline {

/// True for valid UTF-8: no overlong forms, no surrogates, nothing beyond U+10FFFF.
[[nodiscard]] bool is_utf8(std::string_view text);

/// Without the mark that other programs put in front of UTF-8 (EF BB BF).
[[nodiscard]] constexpr std::string_view without_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

}  // namespace syncline
