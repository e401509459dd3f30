// SPDX-License-Identifier: Apache-2.0
#include "eni/text_encoding.h"

namespace syncline::eni {

std::size_t utf8_sequence_length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  std::size_t length = 0;
  if (lead < 0x80) {
    length = 1;
  } else if (lead >= 0xC2 && lead < 0xE0) {
    length = 2;
  } else if ((lead & 0xF0) == 0xE0) {
    length = 3;
  } else if (lead >= 0xF0 && lead < 0xF5) {
    length = 4;
  }
  if (length > text.size()) {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) {
      return 0;
    }
  }
  return length;
}

std::string to_utf8(std::string_view text) {
  bool is_utf8 = true;
  for (std::string_view rest = text; is_utf8 && !rest.empty();) {
    const std::size_t length = utf8_sequence_length(rest);
    is_utf8 = length > 0;
    rest.remove_prefix(length);
  }
  if (is_utf8) {
    return std::string(text);
  }
  std::string out;
  out.reserve(text.size() + text.size() / 8);
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      out += c;
    } else {
      out += static_cast<char>(0xC0 | byte >> 6);
      out += static_cast<char>(0x80 | (byte & 0x3F));
    }
  }
  return out;
}

}  // namespace syncline::eni
