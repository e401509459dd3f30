// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace syncline {

/// How a character that XML and HTML mean something by is written in their texts and in attributes between double
/// quotes; empty for all others.
[[nodiscard]] constexpr std::string_view markup_entity(char character) {
  switch (character) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    default:
      return {};
  }
}

}  // namespace syncline
