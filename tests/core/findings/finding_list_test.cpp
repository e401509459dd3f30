// SPDX-License-Identifier: Apache-2.0
#include "findings/finding_list.h"

#include <gtest/gtest.h>

#include "findings/eni_structure_words.h"
#include "findings/sentence.h"

namespace syncline {
namespace {

Finding missing() {
  return make_finding<words::kEniStructure>("ENI-XML-02", Place(), fig::text<"parent">("Cmd"),
                                            fig::text<"element">("Adp"));
}
Finding another_root() {
  return make_finding<words::kEniStructure>("ENI-XML-09", Place(), fig::text<"element">("Root"));
}

TEST(FindingList, WhatItHasRoomForIsKeptAndNothingSaidOfARest) {
  FindingList list;
  for (std::size_t i = 0; i < FindingList::kMostOfRule; ++i) list.add(missing());
  EXPECT_EQ(list.kept().size(), FindingList::kMostOfRule);
  EXPECT_EQ(list.left_out().all(), 0U);
  EXPECT_EQ(list.rest(), std::nullopt);
}

TEST(FindingList, MoreOfARuleAreCountedAndSaidInOneSentence) {
  FindingList list;
  for (std::size_t i = 0; i < FindingList::kMostOfRule; ++i) list.add(missing());
  EXPECT_FALSE(list.has_room("ENI-XML-02"));
  list.add(missing());
  list.leave_out(*find_finding_words("ENI-XML-02"), 1'000'000);
  EXPECT_TRUE(list.has_room("ENI-XML-09"));
  list.add(another_root());
  EXPECT_EQ(list.kept().size(), FindingList::kMostOfRule + 1);
  EXPECT_EQ(list.left_out()[Severity::kError], 1'000'001U);
  const auto rest = list.rest();
  ASSERT_TRUE(rest);
  EXPECT_EQ(rest->code, FindingList::kRest);
  EXPECT_EQ(rest->severity, Severity::kError) << "the worst of those that are not listed";
  EXPECT_EQ(facts_text(*rest), "1000001 findings more are not listed");
}

TEST(FindingList, BeyondTheMostInAllTheFirstOfARuleIsKept) {
  FindingList list;
  for (std::size_t rule = 0; rule < all_finding_words().size(); ++rule) {
    for (std::size_t i = 0; i < FindingList::kMostOfRule; ++i) {
      list.add(Finding{.code = all_finding_words()[rule].code, .severity = Severity::kNote});
    }
  }
  EXPECT_EQ(list.kept().size(), FindingList::kMostInAll + all_finding_words().size() - 10);
  EXPECT_EQ(list.kept().back().code, all_finding_words().back().code);
  EXPECT_EQ(list.rest()->severity, Severity::kNote);
}

TEST(FindingList, WhatIsOursIsKeptAsAWhole) {
  auto list = FindingList::unbounded();
  for (std::size_t i = 0; i < 2 * FindingList::kMostInAll; ++i) list.add(missing());
  EXPECT_EQ(list.take_kept().size(), 2 * FindingList::kMostInAll);
  EXPECT_EQ(list.rest(), std::nullopt);
}

}  // namespace
}  // namespace syncline
