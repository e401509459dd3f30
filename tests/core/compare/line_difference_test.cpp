// SPDX-License-Identifier: Apache-2.0
#include "compare/line_difference.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <random>
#include <string>

#include "compare/line_changes.h"

namespace syncline {
namespace {

using Tokens = std::vector<std::uint32_t>;

std::size_t lines_in(const std::vector<LineHunk>& hunks) {
  std::size_t lines = 0;
  for (const auto& hunk : hunks) lines += hunk.left_count + hunk.right_count;
  return lines;
}

/// `left` with its stretches replaced; empty when the hunks are out of order or out of the texts.
Tokens patched(const Tokens& left, const Tokens& right, const std::vector<LineHunk>& hunks) {
  Tokens out;
  std::size_t at = 0;
  for (const auto& hunk : hunks) {
    if (hunk.left < at || hunk.left + hunk.left_count > left.size()) return {};
    if (hunk.right + hunk.right_count > right.size() || hunk.left_count + hunk.right_count == 0) return {};
    out.insert(out.end(), left.begin() + static_cast<std::ptrdiff_t>(at),
               left.begin() + static_cast<std::ptrdiff_t>(hunk.left));
    if (out.size() != hunk.right) return {};
    out.insert(out.end(), right.begin() + static_cast<std::ptrdiff_t>(hunk.right),
               right.begin() + static_cast<std::ptrdiff_t>(hunk.right + hunk.right_count));
    at = hunk.left + hunk.left_count;
  }
  out.insert(out.end(), left.begin() + static_cast<std::ptrdiff_t>(at), left.end());
  return out;
}

/// Lines that come and go in the shortest difference, by the table of all common parts.
std::size_t shortest(const Tokens& left, const Tokens& right) {
  std::vector<std::vector<std::size_t>> common(left.size() + 1, std::vector<std::size_t>(right.size() + 1));
  for (std::size_t i = 1; i <= left.size(); ++i) {
    for (std::size_t j = 1; j <= right.size(); ++j) {
      common[i][j] =
          left[i - 1] == right[j - 1] ? common[i - 1][j - 1] + 1 : std::max(common[i - 1][j], common[i][j - 1]);
    }
  }
  return left.size() + right.size() - 2 * common.back().back();
}

rc::Gen<Tokens> short_text() { return rc::gen::container<Tokens>(rc::gen::inRange<std::uint32_t>(0, 4)); }

TEST(LineDifference, MakesTheOtherTextOfTheOne) {
  EXPECT_TRUE(rc::check("patched", [] {
    const auto left = *short_text(), right = *short_text();
    RC_ASSERT(patched(left, right, line_difference(left, right)) == right);
  }));
}

TEST(LineDifference, IsTheShortest) {
  EXPECT_TRUE(rc::check("shortest", [] {
    const auto left = *short_text(), right = *short_text();
    RC_ASSERT(lines_in(line_difference(left, right)) == shortest(left, right));
  }));
}

TEST(LineDifference, OfEqualTextsIsNone) {
  const Tokens text{1, 2, 3};
  EXPECT_TRUE(line_difference(text, text).empty());
  EXPECT_TRUE(line_difference(Tokens{}, Tokens{}).empty());
  EXPECT_EQ(line_difference(Tokens{}, text), (std::vector<LineHunk>{{0, 0, 0, 3}}));
  EXPECT_EQ(line_difference(text, Tokens{}), (std::vector<LineHunk>{{0, 3, 0, 0}}));
}

/// The worst there is: the same hundred thousand lines, in another order.
TEST(LineDifference, OfHugeTextsEnds) {
  std::mt19937 random(1);  // NOLINT: the same in each run
  Tokens left(100'000);
  for (auto& token : left) token = static_cast<std::uint32_t>(random() % 300);
  auto right = left;
  std::shuffle(right.begin(), right.end(), random);
  auto hunks = line_difference(left, right);
  EXPECT_EQ(patched(left, right, hunks), right);
  right = left;
  for (std::size_t i = 0; i < right.size(); i += 20) right[i] = 1'000 + static_cast<std::uint32_t>(i);
  hunks = line_difference(left, right);
  EXPECT_EQ(patched(left, right, hunks), right);
  EXPECT_LE(hunks.size(), 5'100U) << "nearly the shortest";
}

using Words = std::vector<std::string_view>;

TEST(LineChanges, PairWhatIsTheSameElement) {
  const Words left{"<A>", "  <Cmd>", "    <Data>00</Data>", "    <Retries>3</Retries>", "  </Cmd>", "</A>"};
  const Words right{"<A>", "  <Cmd>", "    <Data>01</Data>", "    <Cnt>2</Cnt>", "  </Cmd>", "</A>"};
  EXPECT_EQ(line_changes(left, right),
            (std::vector<LineChange>{
                {LineChangeKind::kAltered, 2, 2}, {LineChangeKind::kRemoved, 3, 3}, {LineChangeKind::kAdded, 4, 3}}));
}

TEST(LineChanges, BeginWhereAnElementOpens) {
  const Words left{"<A>", "  <Cmd>", "    <Data>00</Data>", "  </Cmd>", "</A>"};
  const Words right{"<A>",      "  <Cmd>", "    <Data>00</Data>", "  </Cmd>", "  <Cmd>", "    <Data>01</Data>",
                    "  </Cmd>", "</A>"};
  const auto added = line_changes(left, right);
  ASSERT_EQ(added.size(), 3U);
  EXPECT_EQ(added[0], (LineChange{LineChangeKind::kAdded, 4, 4}));
  const auto removed = line_changes(right, left);
  ASSERT_EQ(removed.size(), 3U);
  EXPECT_EQ(removed[0], (LineChange{LineChangeKind::kRemoved, 4, 4}));
}

/// The other text follows from the one and the changes.
std::vector<std::string_view> changed(const Words& left, const Words& right, const std::vector<LineChange>& changes) {
  Words out;
  std::size_t at = 0;
  for (const auto& change : changes) {
    while (at < change.left) out.push_back(left[at++]);
    if (change.kind != LineChangeKind::kRemoved) out.push_back(right[change.right]);
    if (change.kind != LineChangeKind::kAdded) ++at;
  }
  while (at < left.size()) out.push_back(left[at++]);
  return out;
}

TEST(LineChanges, SayAllThatDiffers) {
  static constexpr std::string_view kLines[] = {"<A>", "</A>", "  <B>1</B>", "  <B>2</B>", "  <C x='1'>", "text"};
  EXPECT_TRUE(rc::check("all", [] {
    const auto text = [] {
      Words words;
      for (const auto line : *short_text()) words.push_back(kLines[line]);
      for (const auto line : *short_text()) words.push_back(kLines[line + 2]);
      return words;
    };
    const auto left = text(), right = text();
    RC_ASSERT(changed(left, right, line_changes(left, right)) == right);
  }));
}

}  // namespace
}  // namespace syncline
