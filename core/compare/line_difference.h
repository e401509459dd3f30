// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace syncline {

/// Lines [left, left + left_count) of one text stand where [right, right + right_count) do in the other.
struct LineHunk {
  std::size_t left = 0, left_count = 0;
  std::size_t right = 0, right_count = 0;
  bool operator==(const LineHunk&) const = default;
};

/// Edits of one stretch, from both of its ends together, up to which the shortest difference is looked for.
inline constexpr std::size_t kMostEdits = 512;

/// The stretches in which two texts differ, ascending, with at least one common line between two of them (Myers, "An
/// O(ND) Difference Algorithm and Its Variations", 1986, with linear space). No other has fewer lines as long as
/// kMostEdits is enough for what remains when lines that only one text has are put aside; beyond that it is right, but
/// may be longer. At most some (N + M) x kMostEdits steps.
[[nodiscard]] std::vector<LineHunk> line_difference(std::span<const std::uint32_t> left,
                                                    std::span<const std::uint32_t> right);
[[nodiscard]] std::vector<LineHunk> line_difference(std::span<const std::string_view> left,
                                                    std::span<const std::string_view> right);

}  // namespace syncline
