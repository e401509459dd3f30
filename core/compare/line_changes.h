// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace syncline {

enum class LineChangeKind : std::uint8_t { kAdded, kRemoved, kAltered };

struct LineChange {
  LineChangeKind kind = LineChangeKind::kAltered;
  std::size_t left = 0;   // the line, from 0; of an added one: the line before which it comes
  std::size_t right = 0;  // the same on the other side; of a removed one: the line before which it stood
  bool operator==(const LineChange&) const = default;
};

/// What lines of XML were added, removed or altered, in the order of both texts. Where a stretch differs on both sides,
/// lines with the same indentation and element are one that was altered. An added or removed stretch begins at the
/// outermost element that it can, so that whole elements come and go. See line_difference().
[[nodiscard]] std::vector<LineChange> line_changes(std::span<const std::string_view> left,
                                                   std::span<const std::string_view> right);

}  // namespace syncline
