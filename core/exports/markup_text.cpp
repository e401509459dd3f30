// SPDX-License-Identifier: Apache-2.0
#include "exports/markup_text.h"

#include "support/markup.h"
#include "support/utf8.h"

namespace syncline::exports {

std::string markup_text(std::string_view text) {
  const bool valid = is_utf8(text);
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (const auto entity = markup_entity(c); !entity.empty()) {
      out += entity;
    } else {
      out += byte < 0x20 ? ' ' : byte >= 0x80 && !valid ? '?' : c;
    }
  }
  return out;
}

}  // namespace syncline::exports
