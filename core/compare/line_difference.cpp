// SPDX-License-Identifier: Apache-2.0
#include "compare/line_difference.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace syncline {
namespace {

using Lines = std::span<const std::uint32_t>;

/// Signed, because diagonals are.
struct LineBox {
  std::ptrdiff_t left, left_end, right, right_end;
};

/// A place through which a short path from the upper left to the lower right corner of a box leads.
struct LineCrossing {
  std::ptrdiff_t left, right;
};

class LineMatcher {
 public:
  LineMatcher(Lines left, Lines right)
      : left_(left),
        right_(right),
        left_alone_(left.size(), false),
        right_alone_(right.size(), false),
        origin_(static_cast<std::ptrdiff_t>(right.size()) + 1),
        forward_(left.size() + right.size() + 3),
        backward_(forward_.size()) {}

  void match();
  /// By line: nothing stands for it on the other side.
  [[nodiscard]] const std::vector<bool>& left_alone() const { return left_alone_; }
  [[nodiscard]] const std::vector<bool>& right_alone() const { return right_alone_; }

 private:
  [[nodiscard]] bool same(std::ptrdiff_t left, std::ptrdiff_t right) const {
    return left_[static_cast<std::size_t>(left)] == right_[static_cast<std::size_t>(right)];
  }
  /// Furthest left line on a diagonal (left - right) that so many edits reach, from the start and from the end.
  std::ptrdiff_t& forward(std::ptrdiff_t diagonal) { return forward_[static_cast<std::size_t>(origin_ + diagonal)]; }
  std::ptrdiff_t& backward(std::ptrdiff_t diagonal) { return backward_[static_cast<std::size_t>(origin_ + diagonal)]; }
  void trim(LineBox& box) const;
  LineCrossing crossing(const LineBox& box);
  std::ptrdiff_t go_forward(const LineBox& box, std::ptrdiff_t diagonal);
  std::ptrdiff_t go_backward(const LineBox& box, std::ptrdiff_t diagonal);

  /// Diagonals that have been reached, every second one.
  struct Reach {
    std::ptrdiff_t low, high;
    [[nodiscard]] bool has(std::ptrdiff_t diagonal) const { return low <= diagonal && diagonal <= high; }
  };
  /// One edit more; what is beyond the box gets `unreachable`.
  static void widen(Reach& reach, const LineBox& box, std::vector<std::ptrdiff_t>& furthest, std::ptrdiff_t origin,
                    std::ptrdiff_t unreachable);
  LineCrossing best_so_far(const LineBox& box, const Reach& ahead, const Reach& back);

  Lines left_, right_;
  std::vector<bool> left_alone_, right_alone_;
  std::ptrdiff_t origin_;
  std::vector<std::ptrdiff_t> forward_, backward_;
};

void LineMatcher::trim(LineBox& box) const {
  while (box.left < box.left_end && box.right < box.right_end && same(box.left, box.right)) ++box.left, ++box.right;
  while (box.left < box.left_end && box.right < box.right_end && same(box.left_end - 1, box.right_end - 1))
    --box.left_end, --box.right_end;
}

std::ptrdiff_t LineMatcher::go_forward(const LineBox& box, std::ptrdiff_t diagonal) {
  const auto below = forward(diagonal - 1), above = forward(diagonal + 1);
  auto left = below < above ? above : below + 1;
  for (auto right = left - diagonal; left < box.left_end && right < box.right_end && same(left, right); ++right) ++left;
  return forward(diagonal) = left;
}

std::ptrdiff_t LineMatcher::go_backward(const LineBox& box, std::ptrdiff_t diagonal) {
  const auto below = backward(diagonal - 1), above = backward(diagonal + 1);
  auto left = below < above ? below : above - 1;
  for (auto right = left - diagonal; box.left < left && box.right < right && same(left - 1, right - 1); --right) --left;
  return backward(diagonal) = left;
}

void LineMatcher::widen(Reach& reach, const LineBox& box, std::vector<std::ptrdiff_t>& furthest, std::ptrdiff_t origin,
                        std::ptrdiff_t unreachable) {
  const auto lowest = box.left - box.right_end, highest = box.left_end - box.right;
  const auto put = [&](std::ptrdiff_t diagonal) {
    furthest[static_cast<std::size_t>(origin + diagonal)] = unreachable;
  };
  if (reach.low > lowest) {
    put(--reach.low - 1);
  } else {
    ++reach.low;
  }
  if (reach.high < highest) {
    put(++reach.high + 1);
  } else {
    --reach.high;
  }
}

LineCrossing LineMatcher::crossing(const LineBox& box) {
  const auto start = box.left - box.right, end = box.left_end - box.right_end;
  const bool odd = ((start - end) & 1) != 0;
  Reach ahead{start, start}, back{end, end};
  forward(start) = box.left;
  backward(end) = box.left_end;
  for (std::size_t edits = 1; edits <= kMostEdits; ++edits) {
    widen(ahead, box, forward_, origin_, -1);
    for (auto diagonal = ahead.high; diagonal >= ahead.low; diagonal -= 2) {
      const auto left = go_forward(box, diagonal);
      if (odd && back.has(diagonal) && backward(diagonal) <= left) return {left, left - diagonal};
    }
    widen(back, box, backward_, origin_, std::numeric_limits<std::ptrdiff_t>::max());
    for (auto diagonal = back.high; diagonal >= back.low; diagonal -= 2) {
      const auto left = go_backward(box, diagonal);
      if (!odd && ahead.has(diagonal) && left <= forward(diagonal)) return {left, left - diagonal};
    }
  }
  return best_so_far(box, ahead, back);
}

/// Where the box is cut when it costs too much to go on: where one of the two ways has come furthest.
LineCrossing LineMatcher::best_so_far(const LineBox& box, const Reach& ahead, const Reach& back) {
  LineCrossing first{box.left, box.right}, last{box.left_end, box.right_end};
  for (auto diagonal = ahead.high; diagonal >= ahead.low; diagonal -= 2) {
    const auto left = std::min({forward(diagonal), box.left_end, box.right_end + diagonal});
    if (left + left - diagonal > first.left + first.right) first = {left, left - diagonal};
  }
  for (auto diagonal = back.high; diagonal >= back.low; diagonal -= 2) {
    const auto left = std::max({backward(diagonal), box.left, box.right + diagonal});
    if (left + left - diagonal < last.left + last.right) last = {left, left - diagonal};
  }
  const auto gone = first.left - box.left + first.right - box.right;
  const auto come = box.left_end - last.left + box.right_end - last.right;
  return gone >= come ? first : last;
}

void LineMatcher::match() {
  std::vector<LineBox> open{{0, static_cast<std::ptrdiff_t>(left_.size()), 0, std::ssize(right_)}};
  while (!open.empty()) {
    auto box = open.back();
    open.pop_back();
    trim(box);
    if (box.left == box.left_end || box.right == box.right_end) {
      std::fill(left_alone_.begin() + box.left, left_alone_.begin() + box.left_end, true);
      std::fill(right_alone_.begin() + box.right, right_alone_.begin() + box.right_end, true);
      continue;
    }
    const auto at = crossing(box);
    open.push_back({at.left, box.left_end, at.right, box.right_end});
    open.push_back({box.left, at.left, box.right, at.right});
  }
}

/// The lines that the other side has at all, with their places.
struct SharedLines {
  std::vector<std::uint32_t> tokens;
  std::vector<std::size_t> places;
};

SharedLines shared_lines(Lines lines, const std::vector<bool>& known, std::vector<bool>& alone) {
  SharedLines out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!known[lines[i]]) {
      alone[i] = true;
      continue;
    }
    out.tokens.push_back(lines[i]);
    out.places.push_back(i);
  }
  return out;
}

void put_back(const std::vector<bool>& alone, const SharedLines& shared, std::vector<bool>& out) {
  for (std::size_t i = 0; i < alone.size(); ++i) {
    if (alone[i]) out[shared.places[i]] = true;
  }
}

std::vector<LineHunk> hunks_of(const std::vector<bool>& left_alone, const std::vector<bool>& right_alone) {
  std::vector<LineHunk> hunks;
  const auto end_of = [](const std::vector<bool>& alone, std::size_t from) {
    while (from < alone.size() && alone[from]) ++from;
    return from;
  };
  for (std::size_t left = 0, right = 0; left < left_alone.size() || right < right_alone.size(); ++left, ++right) {
    const auto left_end = end_of(left_alone, left), right_end = end_of(right_alone, right);
    if (left_end != left || right_end != right) hunks.push_back({left, left_end - left, right, right_end - right});
    left = left_end;
    right = right_end;
  }
  return hunks;
}

std::vector<bool> known_tokens(Lines lines, std::uint32_t highest) {
  std::vector<bool> known(std::size_t{highest} + 1);
  for (const auto token : lines) known[token] = true;
  return known;
}

}  // namespace

/// Lines that one side alone has can be in no common part: without them the rest is shorter by far, and as right.
std::vector<LineHunk> line_difference(Lines left, Lines right) {
  std::uint32_t highest = 0;
  for (const auto lines : {left, right}) {
    for (const auto token : lines) highest = std::max(highest, token);
  }
  std::vector<bool> left_alone(left.size()), right_alone(right.size());
  const auto ours = shared_lines(left, known_tokens(right, highest), left_alone);
  const auto theirs = shared_lines(right, known_tokens(left, highest), right_alone);
  LineMatcher matcher(ours.tokens, theirs.tokens);
  matcher.match();
  put_back(matcher.left_alone(), ours, left_alone);
  put_back(matcher.right_alone(), theirs, right_alone);
  return hunks_of(left_alone, right_alone);
}

std::vector<LineHunk> line_difference(std::span<const std::string_view> left, std::span<const std::string_view> right) {
  std::unordered_map<std::string_view, std::uint32_t> numbers;
  numbers.reserve(left.size() + right.size());
  const auto tokens_of = [&numbers](std::span<const std::string_view> lines) {
    std::vector<std::uint32_t> tokens;
    tokens.reserve(lines.size());
    for (const auto line : lines)
      tokens.push_back(numbers.emplace(line, static_cast<std::uint32_t>(numbers.size())).first->second);
    return tokens;
  };
  const auto ours = tokens_of(left), theirs = tokens_of(right);
  return line_difference(Lines(ours), Lines(theirs));
}

}  // namespace syncline
