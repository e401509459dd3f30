// SPDX-License-Identifier: Apache-2.0
#include "exports/markup_text.h"

#include "support/utf8.h"

namespace syncline::exports {

std::string markup_text(std::string_view text) {
  const bool valid = is_utf8(text);
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += byte < 0x20 ? ' ' : byte >= 0x80 && !valid ? '?' : c;
    }
  }
  return out;
}

}  // namespace syncline::exports
