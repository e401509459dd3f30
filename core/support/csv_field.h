// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace syncline {

/// A field of a line of comma-separated values (RFC 4180): in quotes where it holds what would end or divide it.
[[nodiscard]] inline std::string csv_field(std::string_view text) {
  const auto plain = [](char c) { return c != ',' && c != '"' && static_cast<unsigned char>(c) >= ' '; };
  if (std::ranges::all_of(text, plain)) return std::string(text);
  std::string field = "\"";
  for (const char c : text) {
    if (c == '"') field += '"';
    field += c;
  }
  return field + '"';
}

}  // namespace syncline
