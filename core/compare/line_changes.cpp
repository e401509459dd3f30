// SPDX-License-Identifier: Apache-2.0
#include "compare/line_changes.h"

#include <algorithm>

#include "compare/line_difference.h"

namespace syncline {
namespace {

using TextLines = std::span<const std::string_view>;

/// Indentation and element: "    <Data>".
std::string_view key_of_line(std::string_view line) {
  const auto end = line.find_first_of(" >", std::min(line.find('<'), line.size()));
  return line.substr(0, end);
}

std::vector<std::string_view> keys_of_lines(TextLines lines) {
  std::vector<std::string_view> keys;
  keys.reserve(lines.size());
  for (const auto line : lines) keys.push_back(key_of_line(line));
  return keys;
}

std::size_t indentation(std::string_view line) { return std::min(line.find_first_not_of(" \t"), line.size()); }

/// How many lines up a stretch [begin, begin + count) can begin instead, with the same lines left over.
std::size_t best_shift(TextLines lines, std::size_t begin, std::size_t count, std::size_t room) {
  std::size_t best = 0, least = indentation(lines[begin]);
  for (std::size_t up = 1; up <= room && lines[begin - up] == lines[begin - up + count]; ++up) {
    const auto indented = indentation(lines[begin - up]);
    const bool closes = lines[begin - up].substr(indented).starts_with("</");
    const bool closed = lines[begin - best].substr(indentation(lines[begin - best])).starts_with("</");
    if (indented > least || (closes && !closed) || (indented == least && closes == closed)) continue;
    best = up;
    least = indented;
  }
  return best;
}

/// An added or removed stretch goes up to where an element opens.
void shift(LineHunk& hunk, TextLines left, TextLines right, std::size_t room) {
  if (hunk.left_count != 0 && hunk.right_count != 0) return;
  const auto up = hunk.left_count == 0 ? best_shift(right, hunk.right, hunk.right_count, room)
                                       : best_shift(left, hunk.left, hunk.left_count, room);
  hunk.left -= up;
  hunk.right -= up;
}

void add_hunk(const LineHunk& hunk, TextLines left, TextLines right, std::vector<LineChange>& out) {
  const auto ours = left.subspan(hunk.left, hunk.left_count), theirs = right.subspan(hunk.right, hunk.right_count);
  const auto our_keys = keys_of_lines(ours), their_keys = keys_of_lines(theirs);
  std::size_t l = 0, r = 0;
  const auto pair_until = [&](std::size_t end) {
    for (; l < end; ++l, ++r) {
      if (ours[l] != theirs[r]) out.push_back({LineChangeKind::kAltered, hunk.left + l, hunk.right + r});
    }
  };
  for (const auto& alone : line_difference(TextLines(our_keys), TextLines(their_keys))) {
    pair_until(alone.left);
    for (; l < alone.left + alone.left_count; ++l)
      out.push_back({LineChangeKind::kRemoved, hunk.left + l, hunk.right + r});
    for (; r < alone.right + alone.right_count; ++r)
      out.push_back({LineChangeKind::kAdded, hunk.left + l, hunk.right + r});
  }
  pair_until(ours.size());
}

}  // namespace

std::vector<LineChange> line_changes(TextLines left, TextLines right) {
  std::vector<LineChange> out;
  std::size_t left_end = 0;
  for (auto hunk : line_difference(left, right)) {
    shift(hunk, left, right, hunk.left - left_end);
    left_end = hunk.left + hunk.left_count;
    add_hunk(hunk, left, right, out);
  }
  return out;
}

}  // namespace syncline
