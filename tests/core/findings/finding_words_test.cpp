// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "findings/difference_words.h"
#include "findings/eni_words.h"
#include "findings/error_words.h"
#include "findings/event_words.h"
#include "findings/fold.h"
#include "findings/project_words.h"
#include "findings/run_bus_words.h"
#include "findings/run_codes.h"
#include "findings/run_slaves_words.h"
#include "findings/scan_words.h"
#include "findings/sentence.h"
#include "tests/support/source_dir.h"

namespace syncline {
namespace {

TEST(FindingWords, EachCodeHasItsOwnRowWithTitleAndFacts) {
  std::set<std::string_view> codes;
  for (const FindingWords& row : all_finding_words()) {
    EXPECT_TRUE(codes.insert(row.code).second) << row.code;
    EXPECT_EQ(find_finding_words(row.code)->title, row.title);
    EXPECT_FALSE(row.title.empty() || row.facts[0].text.empty()) << row.code;
    EXPECT_TRUE(row.facts[0].variant.empty()) << row.code;
    std::set<std::string_view> variants;
    for (const auto& facts : row.facts) {
      EXPECT_TRUE(facts.text.empty() || variants.insert(facts.variant).second) << row.code;
    }
  }
  EXPECT_GT(codes.size(), 200U);
  EXPECT_EQ(find_finding_words("no-such-code"), nullptr);
}

TEST(FindingWords, RulesOfTheEniSayWhyAndWhatToDo) {
  for (const FindingWords& row : words::kEni) {
    EXPECT_FALSE(row.why.empty() || row.mend.empty()) << row.code;
  }
}

std::set<std::string> lines_of(const std::string& page) {
  std::ifstream in(test::source_dir() + "/docs/" + page);
  std::set<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.insert(line);
  return lines;
}

TEST(FindingWords, TheManualHasEachFindingAboutAProject) {
  const auto lines = lines_of("check.md");
  for (const FindingWords& row : words::kProject) {
    const auto line = fmt::format("| {} | {} | {} | {} |", row.code, severity_name(row.severity), row.title, row.mend);
    EXPECT_TRUE(lines.contains(line)) << line;
  }
}

TEST(FindingWords, TheManualHasEachFindingOfARun) {
  std::string all;
  for (const auto& line : lines_of("diagnosis.md")) all += line.substr(0, line.find('|', 1)) + "\n";
  for (const auto& table :
       {std::span<const FindingWords>(words::kRunSlaves), std::span<const FindingWords>(words::kRunBus)}) {
    for (const FindingWords& row : table)
      EXPECT_NE(all.find(fmt::format("`{}`", row.code)), std::string::npos) << row.code;
  }
}

TEST(FindingWords, TheManualHasEachMessage) {
  const auto lines = lines_of("messages.md");
  const std::span<const FindingWords> tables[] = {words::kEvents, words::kScan, words::kDifferences, words::kFileErrors,
                                                  words::kBusErrors};
  for (const auto& table : tables) {
    for (const FindingWords& row : table) {
      const auto line =
          fmt::format("| {} | {} | {} | {} |", row.code, severity_name(row.severity), row.title, row.mend);
      EXPECT_TRUE(lines.contains(line)) << line;
    }
  }
}

/// All texts of all rows that may show figures.
std::vector<std::string_view> sentences() {
  std::vector<std::string_view> all;
  for (const FindingWords& row : all_finding_words()) {
    all.push_back(row.mend);
    for (const auto& facts : row.facts) all.push_back(facts.text);
  }
  std::erase(all, std::string_view{});
  return all;
}

/// The sentence with the same number in all places.
std::string counted(std::string_view text, std::int64_t number) {
  Finding finding;
  for (auto open = text.find('{'); open != std::string_view::npos; open = text.find('{', open + 1)) {
    const Placeholder placeholder(text.substr(open + 1, text.find('}', open) - open - 1));
    finding.figures.push_back({placeholder.name, Figure::Unit::kCount, number});
  }
  return fill_finding_template(text, finding);
}

TEST(FindingWords, OneIsNotSeveral) {
  const std::string before = "(?:damaged |missed |SM2 |mailbox |slave-to-slave |wrong |more |other )*";
  const std::regex plural("(?:^|[^.:0-9A-Za-z])1 " + before +
                          "(?:bits|bytes|clocks|commands|copies|cycles|datagrams|devices|EEPROMs|entries|errors|events|"
                          "files|FMMUs|frames|links|members|objects|PDOs|places|ports|samples|slaves|steps|times|tries|"
                          "variables|words|mailbox requests)\\b");
  for (const auto text : sentences()) {
    const auto one = counted(text, 1);
    EXPECT_FALSE(std::regex_search(one, plural)) << one;
    EXPECT_EQ(one.find("(s)"), std::string::npos) << one;
  }
}

TEST(FindingWords, ACountChoosesItsWords) {
  const auto frames = [](std::int64_t count, std::string at_least = {}) {
    Finding finding;
    finding.figures.push_back({"count", Figure::Unit::kCount, count, 0, std::move(at_least)});
    return fill_finding_template("{count:# frame was|# frames were} lost, {count}", finding);
  };
  EXPECT_EQ(frames(0), "0 frames were lost, 0");
  EXPECT_EQ(frames(1), "1 frame was lost, 1");
  EXPECT_EQ(frames(12), "12 frames were lost, 12");
  EXPECT_EQ(frames(1, "at least"), "at least 1 frame was lost, at least 1");
  EXPECT_EQ(fill_finding_template("{count:# frame|# frames}", {}), "{count:# frame|# frames}");
}

/// The names of the sentences' placeholders that name something instead of counting it.
std::set<std::string_view> names_of_things(std::span<const FindingWords> rows) {
  std::set<std::string_view> names;
  const auto look = [&names](std::string_view text) {
    for (auto open = text.find('{'); open != std::string_view::npos; open = text.find('{', open + 1)) {
      const Placeholder placeholder(text.substr(open + 1, text.find('}', open) - open - 1));
      if (names_something(text, open)) names.insert(placeholder.name);
    }
  };
  for (const FindingWords& row : rows) {
    look(row.mend);
    for (const auto& facts : row.facts) look(facts.text);
  }
  return names;
}

/// make_finding() takes no count for one of these; the rules of a run and errors choose their figures as they go.
TEST(FindingWords, WhatNamesSomethingIsToldFromACount) {
  const auto all = names_of_things(all_finding_words());
  for (const std::string_view name : {"address", "alias", "bit", "block", "first", "first_bit", "fmmu", "id", "line",
                                      "manager", "number", "place", "position", "sm", "sub_index", "task", "version"})
    EXPECT_TRUE(all.contains(name)) << name;
  for (const std::string_view name : {"bytes", "count", "cycles", "expected", "frames", "received", "slaves"})
    EXPECT_FALSE(all.contains(name)) << name;
  EXPECT_TRUE(names_something("slaves with the alias {most}", 22));
  EXPECT_FALSE(names_something("an alias of {most}", 12));
  EXPECT_FALSE(names_something("position {most:# slave|# slaves}", 9));
  using testing::IsEmpty;
  EXPECT_THAT(names_of_things(words::kRunSlaves), IsEmpty());
  EXPECT_THAT(names_of_things(words::kRunBus), IsEmpty());
  EXPECT_THAT(names_of_things(words::kFileErrors), IsEmpty());
  EXPECT_THAT(names_of_things(words::kBusErrors), IsEmpty());
}

/// The window shows the same words, and has no options.
TEST(FindingWords, NameNoOptionOfTheCommandLineWithoutItsCommand) {
  for (const auto text : sentences()) {
    for (auto at = text.find("--"); at != std::string_view::npos; at = text.find("--", at + 2)) {
      const auto quote = text.rfind('"', at);
      EXPECT_TRUE(quote != std::string_view::npos && text[quote + 1] != ' ') << text;
    }
  }
}

TEST(FindingWords, AFindingKeepsItsFigures) {
  const auto finding =
      make_finding<words::kEni>("ENI-DC-19", 3, fig::time<"shift">(1'250'000), fig::time<"cycle">(kMillisecond));
  EXPECT_EQ(finding.code, "ENI-DC-19");
  EXPECT_EQ(finding.severity, Severity::kWarning);
  EXPECT_EQ(finding.place.slave, 3);
  EXPECT_EQ(finding.place.key, "slave.3.dc.sync0.shift_us");
  EXPECT_EQ(facts_text(finding), "ShiftTime is 1.25 ms, the SYNC0 cycle 1 ms");
  EXPECT_EQ(finding.figures[0].value, 1'250'000);
}

TEST(FindingWords, TheFactsCanBeAVariant) {
  EXPECT_EQ(facts_text(make_finding<words::kEni>("ENI-DC-10", 1)), "SYNC0 is switched on with a cycle time of 0");
  EXPECT_EQ(facts_text(make_finding<words::kEni>("ENI-DC-10/never", 1)),
            "SYNC0 is switched on, and nothing writes its cycle time (0x09A0)");
}

TEST(FindingWords, ASettingOfNoSlaveStaysAsItIs) {
  EXPECT_EQ(setting_at("master.dc.mode", 3), "master.dc.mode");
  EXPECT_EQ(setting_at("slave.N.alias", 3), "slave.3.alias");
  EXPECT_EQ(setting_at("slave.N.alias", -1), "");
}

TEST(FigureText, TimesKeepAllDigits) {
  EXPECT_EQ(exact_time_text(0), "0 ns");
  EXPECT_EQ(exact_time_text(-999), "-999 ns");
  EXPECT_EQ(exact_time_text(62'500), "62.5 us");
  EXPECT_EQ(exact_time_text(125'001), "125.001 us");
  EXPECT_EQ(exact_time_text(1'000'125), "1.000125 ms");
  EXPECT_EQ(exact_time_text(-10'000'000), "-10 ms");
  EXPECT_EQ(exact_time_text(2'000'000'000), "2 s");
}

TEST(FigureText, NamesASlaveWhereItsNameIsKnown) {
  EXPECT_EQ(figure_text(fig::slave<"slave">(3, "Drive").figure), "slave 3 (Drive)");
  EXPECT_EQ(figure_text(fig::slave<"slave">(3).figure), "slave 3");
}

TEST(FindingWords, TimesAreSaidInWordsThatFitTheNumber) {
  const auto said = [](std::int64_t times, const char* at_least) {
    return figure_text({"times", Figure::Unit::kTimes, times, 0, at_least});
  };
  EXPECT_EQ(said(1, ""), "once");
  EXPECT_EQ(said(1, "at least"), "at least once");
  EXPECT_EQ(said(2, ""), "2 times");
  EXPECT_EQ(said(2, "at least"), "at least 2 times");
}

Finding behind(int slave, std::uint16_t state) {
  Finding finding{code::kSlaveBehind, Severity::kWarning, slave};
  finding.figures = {{"slave", Figure::Unit::kSlave, slave, slave}, {"state", Figure::Unit::kAlStatus, state}};
  return finding;
}

TEST(FoldedFindings, WhatManySlavesHaveAlikeIsOneLineWithTheirRanges) {
  std::vector<Finding> findings;
  for (int slave = 3; slave < 1000; ++slave) {
    if (slave != 18) findings.push_back(behind(slave, 4));
  }
  findings.push_back(behind(18, 2));
  findings.push_back({"not-monitored"});
  const auto all = folded(findings);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].slaves.size(), 996U);
  EXPECT_EQ(describe(all[0].finding),
            "Each of slaves 3 to 17, 19 to 999 stays in SAFEOP while others went further. Request the state again and "
            "watch its AL status.");
  EXPECT_EQ(all[1].slaves, std::vector<int>{18});
  EXPECT_TRUE(all[2].slaves.empty());
}

TEST(FoldedFindings, TwoStayTwo) {
  const std::vector<Finding> findings{behind(1, 4), behind(2, 4)};
  EXPECT_EQ(folded(findings).size(), 2U);
}

}  // namespace
}  // namespace syncline
