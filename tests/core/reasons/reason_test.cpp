// SPDX-License-Identifier: Apache-2.0
#include "reasons/reason.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "reasons/because.h"
#include "reasons/brief_reason.h"
#include "reasons/reason_words.h"
#include "tests/support/source_dir.h"

namespace syncline {
namespace {

TEST(Reasons, ARowSaysWhatIsGivenInItsOrder) {
  const auto reason = because("this port of slave {slave} has slave {other} already", 3, "{4}");
  EXPECT_EQ(reason.text(), "this port of slave 3 has slave {4} already");
  EXPECT_EQ(reason.words(), "this port of slave {slave} has slave {other} already");
  EXPECT_EQ(because("is more than there and back over {length} m together", 0.5).text(),
            "is more than there and back over 0.5 m together");
  EXPECT_EQ(because("needs a slave").text(), "needs a slave");
  EXPECT_NE(because("needs a slave"), because("it has no mailbox"));
  EXPECT_EQ(reason, because("this port of slave {slave} has slave {other} already", "3", "{4}"));
}

TEST(Reasons, OneStandsInAnothersPlace) {
  const auto reason = because("Device {device}: {reason}", "EL9999", because("\"{text}\" is no number", "1k"));
  EXPECT_EQ(reason.text(), "Device EL9999: \"1k\" is no number");
  ASSERT_EQ(reason.given().size(), 2U);
  EXPECT_EQ(reason.given()[1].words(), "\"{text}\" is no number");
}

TEST(Reasons, TheTextsOfOthersHaveNoWords) {
  EXPECT_TRUE(Reason().empty());
  EXPECT_EQ(Reason().text(), "");
  const auto theirs = Reason::verbatim(std::string("needs a slave"));
  EXPECT_FALSE(theirs.empty());
  EXPECT_EQ(theirs.text(), "needs a slave");
  EXPECT_EQ(theirs.words(), "");
  EXPECT_NE(theirs, because("needs a slave"));
  EXPECT_EQ(Reason::of_system(ENOSPC).words(), std::strerror(ENOSPC));
  static_assert(!std::is_constructible_v<Reason, std::string> && !std::is_constructible_v<Reason, const char*>,
                "a sentence becomes a reason by because() alone");
}

TEST(Reasons, WhatAllocatesNothingSaysTheSameInFull) {
  static_assert(std::is_trivially_copyable_v<BriefReason>);
  EXPECT_EQ(BriefReason().in_full(), Reason());
  EXPECT_EQ(brief("it has no mailbox").in_full(), because("it has no mailbox"));
  EXPECT_EQ(brief("packet {number} where {expected} was to come", 7U, std::int64_t{8}).in_full(),
            because("packet {number} where {expected} was to come", 7, 8));
  auto busy = brief("the EEPROM stays busy at word 0x{word}{which}", hex_number(0x1F, 4));
  EXPECT_EQ(busy.in_full().text(), "the EEPROM stays busy at word 0x001F");
  busy.word = reason_words("; the old content was put back");
  EXPECT_EQ(busy.in_full().text(), "the EEPROM stays busy at word 0x001F; the old content was put back");
  EXPECT_EQ(busy.in_full().given()[1].words(), "; the old content was put back");
}

TEST(Reasons, OneIsFoundAgainByItsWords) {
  const auto reason = because("{value} is outside {range}", "7 us", "0..5 us");
  EXPECT_EQ(reason_of_words(reason.words(), {reason.given().begin(), reason.given().end()}), reason);
  EXPECT_EQ(reason_of_words("{value} is outside {range}", {Reason::phrase("one alone")}), std::nullopt);
  EXPECT_EQ(reason_of_words("no row of {today}", {Reason::phrase("one")}), std::nullopt);
  EXPECT_EQ(reason_of_words("no row of today", {}), Reason::phrase("no row of today"));
}

/// The literals of a source, those behind each other joined.
void collect_literals(std::string_view source, std::set<std::string>& all) {
  std::string literal;
  bool inside = false, joined = false;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const char c = source[i];
    if (inside && c == '\\') {
      literal += source[++i];
    } else if (c == '"' && (inside || i == 0 || source[i - 1] != '\'')) {
      inside = !inside;
      joined = !inside;
    } else if (inside) {
      literal += c;
    } else if (joined && std::strchr(" \n", c) == nullptr) {
      all.insert(literal);
      literal.clear();
      joined = false;
    }
    if (!inside && c == '/' && source.substr(i, 2) == "//") i = std::min(source.find('\n', i), source.size());
  }
}

/// The compiler sees sentences without a row; rows without a sentence it does not.
TEST(Reasons, EachRowIsSaidSomewhere) {
  std::set<std::string> all;
  for (const auto* folder : {"core", "eni", "app", "ui"}) {
    const auto root = std::filesystem::path(test::source_dir()) / folder;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
      const auto path = entry.path();
      if (path.extension() != ".cpp" && path.extension() != ".h") continue;
      if (path.filename().string().ends_with("reason_words.h")) continue;
      std::ostringstream text;
      text << std::ifstream(path).rdbuf();
      collect_literals(text.str(), all);
    }
  }
  ASSERT_GT(all.size(), 1'000U);
  for (int number = 1; number < 134; ++number) all.insert(std::strerror(number));
  for (const auto words : words::kReasons) {
    EXPECT_TRUE(all.contains(std::string(words))) << "no source says: " << words;
    EXPECT_EQ(std::ranges::count(words, '{'), std::ranges::count(words, '}')) << words;
    EXPECT_EQ(std::ranges::count(words::kReasons, words), 1) << words;
  }
}

}  // namespace
}  // namespace syncline
