// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "reasons/placeholder.h"

namespace syncline {

/// Whether the number in the placeholder that begins at `open` names something ("station address {address}",
/// "SM{manager}", "Line {line}") instead of saying how many there are: it has its word before it, or one of these for
/// its own name. One that chooses its words ("{count:# slave|# slaves}") counts.
[[nodiscard]] constexpr bool names_something(std::string_view sentence, std::size_t open) {
  constexpr std::array<std::string_view, 8> kNames{"address", "alias",   "fmmu",      "id",
                                                   "line",    "manager", "sub_index", "task"};
  constexpr std::array<std::string_view, 19> kWords{
      "FMMU", "ID",    "Line", "PhysAddr", "Place",    "SM",  "SyncManager", "address", "alias",  "bit",
      "bits", "block", "line", "place",    "position", "row", "slave",       "task",    "version"};
  const Placeholder placeholder(sentence.substr(open + 1, sentence.find('}', open) - open - 1));
  if (!placeholder.one.empty()) return false;
  if (std::ranges::find(kNames, placeholder.name) != kNames.end()) return true;
  auto before = sentence.substr(0, open);
  if (before.ends_with(' ')) before.remove_suffix(1);
  return std::ranges::any_of(kWords, [before](std::string_view word) {
    if (!before.ends_with(word)) return false;
    const auto rest = before.substr(0, before.size() - word.size());
    return rest.empty() || std::string_view(" \"(;,").find(rest.back()) != std::string_view::npos;
  });
}

}  // namespace syncline
