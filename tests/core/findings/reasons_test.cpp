// SPDX-License-Identifier: Apache-2.0
#include "findings/reasons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <set>
#include <string>

#include "findings/finding.h"
#include "findings/reason_row.h"
#include "findings/reason_words.h"
#include "support/whole_file.h"
#include "tests/support/source_dir.h"

namespace syncline {
namespace {

TEST(Reasons, ASentenceIsTakenApartAgain) {
  const auto plain = find_reason("it has no mailbox");
  ASSERT_TRUE(plain);
  EXPECT_TRUE(plain->given.empty());
  const auto found = find_reason("the EEPROM stays busy at word 0x0040 (twice)");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->words, "the EEPROM stays busy at word 0x{word}{which}");
  const std::vector<std::pair<std::string_view, std::string>> given{{"word", "0040"}, {"which", " (twice)"}};
  EXPECT_EQ(found->given, given);
  const auto quoted = find_reason("\"a\" is no \" is no number");
  ASSERT_TRUE(quoted);
  EXPECT_EQ(quoted->given[0].second, "a\" is no ");
}

TEST(Reasons, OfSeveralTheOneWithMostOfOurWordsIsMeant) {
  EXPECT_EQ(find_reason("\"x\" is no state transition like PS or SO")->words,
            "\"{text}\" is no state transition like PS or SO");
  EXPECT_EQ(find_reason("\"x\" is no state transition")->words, "\"{text}\" is no state transition");
}

TEST(Reasons, TheTextsOfOthersAreLeftAlone) {
  EXPECT_EQ(find_reason(""), std::nullopt);
  EXPECT_EQ(find_reason("Axis X"), std::nullopt);
  EXPECT_EQ(find_reason("0x1a00 0x1a01"), std::nullopt);
}

TEST(Reasons, ARowTakesWhatIsGivenInItsOrder) {
  const ReasonRow<words::kScenarioReasons, int, std::string_view> row(
      "this port of slave {slave} has slave {other} already");
  EXPECT_EQ(row.text(3, "{4}"), "this port of slave 3 has slave {4} already");
  const ReasonRow<words::kScenarioReasons, double> single("is more than there and back over {length} m together");
  EXPECT_EQ(single.text(0.5), "is more than there and back over 0.5 m together");
  const ReasonRow<words::kScenarioReasons> plain("needs a slave");
  EXPECT_EQ(plain.text(), "needs a slave");
  EXPECT_EQ(plain.words().data(), std::ranges::find(words::kScenarioReasons, plain.words())->data());
}

/// With {} for each placeholder and format; one for several behind each other.
std::string without_names(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const auto open = text.find('{'), close = text.find('}', open);
    if (open == std::string_view::npos || close == std::string_view::npos) break;
    out += text.substr(0, open);
    if (!out.ends_with("{}")) out += "{}";
    text.remove_prefix(close + 1);
  }
  return out += text;
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
      all.insert(without_names(literal));
      literal.clear();
      joined = false;
    }
    if (!inside && c == '/' && source.substr(i, 2) == "//") i = std::min(source.find('\n', i), source.size());
  }
}

std::set<std::string> literals() {
  std::set<std::string> all;
  for (const auto* folder : {"core", "eni", "app", "ui"}) {
    const auto root = std::filesystem::path(test::source_dir()) / folder;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
      const auto path = entry.path();
      if ((path.extension() != ".cpp" && path.extension() != ".h") ||
          path.filename().string().ends_with("reason_words.h"))
        continue;
      collect_literals(read_whole_file(path.string(), std::size_t{1} << 24).value(), all);
    }
  }
  for (int number = 1; number < 134; ++number) all.insert(std::strerror(number));
  return all;
}

/// A literal may have a quoted text in front of it, or something behind it.
bool said(const std::string& reason, const std::set<std::string>& all) {
  if (all.contains(reason)) return true;
  if (reason.ends_with("{}") && all.contains(reason.substr(0, reason.size() - 2))) return true;
  constexpr std::string_view kQuoted = "\"{}\" ";
  if (!reason.starts_with(kQuoted)) return false;
  const auto rest = reason.substr(kQuoted.size());
  return all.contains(rest) || all.contains("\" " + rest);
}

TEST(Reasons, AreWhatTheSourcesSay) {
  const auto all = literals();
  ASSERT_GT(all.size(), 1'000U);
  for (const auto words : words::kReasons) {
    EXPECT_TRUE(said(without_names(words), all)) << "no source says: " << words;
    const auto found = find_reason(words);
    EXPECT_TRUE(found && found->words == words) << words;
  }
}

}  // namespace
}  // namespace syncline
