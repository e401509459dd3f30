// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "compare/compare_configs.h"
#include "compare/network_compare.h"
#include "config/network_config.h"
#include "eni/check/check_bed.h"
#include "protocol/command.h"
#include "support/cases.h"
#include "support/eni_values.h"
#include "support/sample_folder.h"

namespace syncline::test {
namespace {

/// Numbers that say nothing about what a master does: spelling, limits, places that follow, and what the checker finds
/// when it contradicts the rest.
bool is_spelling(const std::string& element) {
  static const std::set<std::string> elements = {"InputOffs", "OutputOffs",  "BitOffs",   "BitSize", "MinSize",
                                                 "MaxSize",   "DefaultSize", "ProfileNo", "AddInfo", "AutoIncAddr"};
  return elements.contains(element);
}

/// The entries of a PDO that no SyncManager carries.
bool is_in_unassigned_pdo(const std::string& text, std::size_t at) {
  const auto pdo = std::max(text.rfind("<RxPdo", at) + 1, text.rfind("<TxPdo", at) + 1);
  const auto end = text.find('>', pdo);
  return pdo != 0 && text.find("Pdo>", end) > at && text.substr(pdo, end - pdo).find("Sm=") == std::string::npos;
}

/// Address of a command that goes to nobody or to all.
bool is_address_of_broadcast(const std::string& text, const EniValue& place) {
  if (place.element != "Adp") return false;
  const auto command = text.rfind("<Cmd>", place.at) + 5;
  const std::string code = text.substr(command, text.find('<', command) - command);
  return code == "0" || code == "7" || code == "8";
}

/// Any one value of an ENI that is changed is a difference, unless it is spelling.
TEST(EniCompare, EachChangedValueIsADifference) {
  const std::string whole = eni::write_eni(checked_machine());
  const auto original = eni::parse_eni(whole, "whole.xml");
  std::map<std::string, int> tried, missed;
  std::size_t seen = 0;
  for (const EniValue& place : values_of(whole)) {
    if (seen++ % test::kEvery != 0) continue;
    if (is_spelling(place.element) || is_in_unassigned_pdo(whole, place.at)) continue;
    if (is_address_of_broadcast(whole, place)) continue;
    // The last digit keeps the value in its range and the bytes whole.
    std::string text = whole;
    char& digit = text[place.at + place.length - 1];
    digit = digit == '1' ? '0' : '1';
    const auto changed = eni::parse_eni(text, "changed.xml");
    if (!changed) continue;
    ++tried[place.element];
    if (compare_configs(*original, *changed).empty()) {
      ++missed[place.element];
      const auto begin = text.rfind('\n', place.at) + 1;
      ADD_FAILURE() << text.substr(text.rfind('\n', begin - 2) + 1, 200);
    }
  }
  EXPECT_GT(tried.size(), 30U / test::kEvery);
  EXPECT_THAT(missed, testing::IsEmpty());
}

bool differs(const NetworkConfig& left, const NetworkConfig& right) { return !compare_configs(left, right).empty(); }

/// Places follow from the order of the slaves; one that moves against the others is a difference.
TEST(EniCompare, AnFmmuOrVariableOnAnothersPlaceIsADifference) {
  const NetworkConfig good = checked_machine();
  NetworkConfig moved = good;
  auto& fmmu_data = command(moved, kLastDrive, Transition::kPS, reg::fmmu(1)).data;
  std::ranges::copy_n(command(moved, kDrive, Transition::kPS, reg::fmmu(1)).data.begin(), 4, fmmu_data.begin());
  EXPECT_TRUE(differs(good, moved));
  moved = good;
  moved.image.inputs[1].bit_offset = moved.image.inputs[0].bit_offset;
  EXPECT_TRUE(differs(good, moved));
  moved = good;
  cyclic(moved, Command::kLrw).input_offset += 4;
  EXPECT_TRUE(differs(good, moved));
  moved = good;
  command(moved, kInput, Transition::kIP, reg::kSiiData, false).validate->type = ValidateType::kGreaterOrEqual;
  EXPECT_TRUE(differs(good, moved));
  EXPECT_FALSE(differs(good, good));
}

/// What a damaged or extreme file gives is checked and compared without harm, and equals itself.
RC_GTEST_PROP(EniCompare, ExtremeValuesHarmNeitherCheckNorComparison, ()) {
  static const std::string whole = eni::write_eni(checked_machine());
  static const auto places = values_of(whole);
  static const auto original = eni::parse_eni(whole, "whole.xml");
  std::string text = whole;
  auto chosen = *rc::gen::container<std::vector<std::size_t>>(4, rc::gen::inRange<std::size_t>(0, places.size()));
  std::ranges::sort(chosen, std::greater{});
  for (const std::size_t place : chosen) {
    const auto value = *rc::gen::element<std::string>("0", "-1", "1", "ff", "65535", "-32768", "2147483647",
                                                      "-2147483648", "4294967295", "99999999999999999999", "");
    text.replace(places[place].at, places[place].length, value);
  }
  const auto check = eni::check_eni_text(text, "extreme.xml");
  RC_ASSERT(check.has_value());
  const auto config = eni::parse_eni(text, "extreme.xml");
  RC_ASSERT(check->understood == config.has_value());
  if (!config) return;
  RC_ASSERT(compare_configs(*config, *config).empty());
  RC_ASSERT(compare_networks(*config, *config).empty());
  // The same either way round.
  RC_ASSERT(compare_configs(*config, *original).empty() == compare_configs(*original, *config).empty());
}

RC_GTEST_PROP(EniCompare, DamagedTextHarmsNoCheck, ()) {
  static const std::string whole = eni::write_eni(checked_machine());
  std::string text = whole;
  for (int i = *rc::gen::inRange(1, 5); i > 0; --i) {
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
    if (*rc::gen::arbitrary<bool>()) {
      text.erase(at, *rc::gen::inRange<std::size_t>(1, 60));
    } else {
      text.insert(at,
                  text.substr(*rc::gen::inRange<std::size_t>(0, text.size()), *rc::gen::inRange<std::size_t>(1, 60)));
    }
  }
  const auto check = eni::check_eni_text(text, "damaged.xml");
  if (check) {
    for (const auto& finding : check->findings) RC_ASSERT(find_finding_words(finding.code) != nullptr);
  }
}

TEST(EniCompare, EveryRealFileEqualsWhatIsWrittenOfIt) {
  int compared = 0;
  for (const auto& path : all_samples("eni", ".xml")) {
    const auto config = eni::read_eni(path.string());
    if (!config) continue;
    const auto again = eni::parse_eni(eni::write_eni(*config), "again.xml");
    ASSERT_TRUE(again) << path;
    for (const auto& difference : compare_configs(*config, *again))
      ADD_FAILURE() << path << ": " << describe(difference);
    ++compared;
  }
  EXPECT_GE(compared, sample_folder() ? 14 : 4);
}

}  // namespace
}  // namespace syncline::test
