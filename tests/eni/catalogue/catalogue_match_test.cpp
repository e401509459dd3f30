// SPDX-License-Identifier: Apache-2.0
#include "eni/catalogue/catalogue_match.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eni/catalogue/revision_rule.h"

namespace syncline::eni {
namespace {

using ::testing::HasSubstr;

std::vector<CatalogueEntry> revisions(std::initializer_list<std::pair<std::uint32_t, const char*>> given) {
  std::vector<CatalogueEntry> entries;
  for (const auto& [revision, rule] : given) {
    CatalogueEntry entry;
    entry.id = static_cast<std::int64_t>(entries.size()) + 1;
    entry.identity = {2, 3, revision, 0};
    entry.revision_rule = rule;
    entry.file = "a.xml";
    entries.push_back(entry);
  }
  return entries;
}

struct Found {
  MatchKind kind;
  std::uint32_t revision;
  bool operator==(const Found&) const = default;
};
Found find(const std::vector<CatalogueEntry>& entries, std::uint32_t revision) {
  const auto match = best_match(entries, {2, 3, revision, 0});
  return match ? Found{match->kind, match->entry.identity.revision_no} : Found{MatchKind::kExact, 0};
}

TEST(CatalogueMatch, TakesTheExactRevisionWhateverTheRulesOfOthers) {
  const auto entries = revisions({{0x10, "EQ_OR_G"}, {0x20, ""}, {0x30, "NONE"}});
  EXPECT_EQ(find(entries, 0x20), (Found{MatchKind::kExact, 0x20}));
  EXPECT_EQ(find(entries, 0), (Found{MatchKind::kExact, 0x30}));
  EXPECT_FALSE(best_match({}, {2, 3, 1, 0}));
}

TEST(CatalogueMatch, FollowsTheVendorsRule) {
  EXPECT_EQ(find(revisions({{0x10, "EQ_OR_G"}, {0x20, "EQ_OR_G"}, {0x30, ""}}), 0x25), (Found{MatchKind::kRule, 0x20}));
  EXPECT_EQ(find(revisions({{0x10, "EQ_OR_G"}, {0x20, "EQ"}}), 0x25), (Found{MatchKind::kRule, 0x10}));
  EXPECT_EQ(find(revisions({{0x110020, "LW_EQ"}, {0x120021, "LW_EQ"}}), 0x130020), (Found{MatchKind::kRule, 0x110020}));
  EXPECT_EQ(find(revisions({{0x140020, "LW_EQ"}}), 0x130020), (Found{MatchKind::kRule, 0x140020}));
  EXPECT_EQ(find(revisions({{0x140020, "LW_EQ_HW_EQ_OR_G"}}), 0x130020), (Found{MatchKind::kNewest, 0x140020}));
  EXPECT_EQ(find(revisions({{0x120020, "LW_EQ_HW_EQ_OR_G"}}), 0x130020), (Found{MatchKind::kRule, 0x120020}));
  EXPECT_EQ(find(revisions({{0x130020, "HW_EQ"}}), 0x130010), (Found{MatchKind::kRule, 0x130020}));
  EXPECT_EQ(find(revisions({{0x130020, "HW_EQ_LW_EQ_OR_G"}}), 0x130010), (Found{MatchKind::kNewest, 0x130020}));
  EXPECT_EQ(find(revisions({{0x130020, "HW_EQ_LW_EQ_OR_G"}}), 0x130030), (Found{MatchKind::kRule, 0x130020}));
  EXPECT_EQ(find(revisions({{0x20, "NONE"}}), 0x10), (Found{MatchKind::kRule, 0x20}));
  EXPECT_EQ(find(revisions({{0x10, "HOPE"}}), 0x20), (Found{MatchKind::kOlder, 0x10}));
}

TEST(CatalogueMatch, ElseTheNearestOlderThenTheNewest) {
  const auto entries = revisions({{0x10, ""}, {0x20, ""}, {0x30, "EQ"}});
  EXPECT_EQ(find(entries, 0x2F), (Found{MatchKind::kOlder, 0x20}));
  EXPECT_EQ(find(entries, 0x08), (Found{MatchKind::kNewest, 0x30}));
}

TEST(CatalogueMatch, SaysWhy) {
  const auto words = [](const auto& entries, std::uint32_t revision) {
    return best_match(entries, {2, 3, revision, 0})->words;
  };
  const auto ruled = revisions({{0x10, "EQ_OR_G"}});
  EXPECT_EQ(words(ruled, 0x10), "revision 0x00000010, exactly");
  EXPECT_EQ(words(ruled, 0x20),
            "no ESI file has revision 0x00000020; the vendor's rule EQ_OR_G of revision 0x00000010 accepts "
            "it (this revision or a newer one)");
  const auto strict = revisions({{0x10, "EQ"}});
  EXPECT_THAT(words(strict, 0x20), HasSubstr("no rule of the vendor accepts it; the nearest older one is 0x00000010"));
  EXPECT_THAT(words(strict, 0x08), HasSubstr("or an older one; the newest one is 0x00000010"));
}

TEST(CatalogueMatch, TheFirstFileWinsAndTheOthersAreNamed) {
  auto entries = revisions({{0x10, ""}, {0x10, ""}});
  entries[1].file = "/somewhere/b.xml";
  entries[1].line = 7;
  entries[1].content = 1;
  const auto match = best_match(entries, {2, 3, 0x10, 0});
  EXPECT_EQ(match->entry.file, "a.xml");
  EXPECT_THAT(match->words, HasSubstr("b.xml line 7"));
}

TEST(RevisionRule, EachKnownOneHasWords) {
  for (const char* rule : {"NONE", "EQ", "EQ_OR_G", "LW_EQ", "LW_EQ_HW_EQ_OR_G", "HW_EQ", "HW_EQ_LW_EQ_OR_G"}) {
    EXPECT_FALSE(revision_rule_words(rule).empty()) << rule;
    EXPECT_TRUE(revision_fits(rule, 0x120034, 0x120034)) << rule;
  }
  EXPECT_EQ(revision_rule_words("LW"), "");
  EXPECT_FALSE(revision_fits("LW", 1, 1));
  EXPECT_FALSE(revision_fits("", 1, 1));
}

}  // namespace
}  // namespace syncline::eni
