// SPDX-License-Identifier: Apache-2.0
#include "advice/quick_fixes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "check/check_network.h"
#include "compile/compile.h"
#include "settings/settings_table.h"
#include "tests/support/machine_devices.h"
#include "tests/support/sample_devices.h"

namespace syncline {
namespace {

/// A terminal and two servo axes in bus shift, the sync window watched.
Project two_axes() {
  auto project = sample::project({test::io8(), test::servo(), test::servo()});
  for (std::size_t i = 0; i < project.slaves.size(); ++i)
    project.slaves[i].name = project.slaves[i].device.type + " " + std::to_string(i);
  project.master.dc.sync_window.enabled = true;
  project.master.dc.dcm.mode = DcmMode::kBusShift;
  return project;
}

std::vector<Finding> findings_of(const Project& project) { return compile(project).value().findings; }

const Finding* find(const std::vector<Finding>& findings, std::string_view code) {
  const auto found = std::ranges::find(findings, code, &Finding::code);
  return found == findings.end() ? nullptr : &*found;
}

void apply(Project& project, const QuickFix& fix) {
  for (const auto& place : fix.places) ASSERT_TRUE(settings::set_value(*fix.setting, project, place, fix.value));
}

/// Whatever is found of the machine: each fix that is offered takes it away and brings nothing as heavy.
void expect_cures(const Project& project, std::string_view code) {
  const auto before = findings_of(project);
  const auto* finding = find(before, code);
  ASSERT_NE(finding, nullptr) << code;
  const auto fixes = quick_fixes(project, *finding);
  ASSERT_FALSE(fixes.empty()) << code << " " << finding->place.key;
  for (const auto& fix : fixes) {
    auto changed = project;
    apply(changed, fix);
    const auto after = findings_of(changed);
    const auto* still = find(after, code);
    EXPECT_TRUE(still == nullptr || still->place.key != finding->place.key) << code;
    for (const auto& one : after) {
      EXPECT_TRUE(one.severity < finding->severity || find(before, one.code) != nullptr) << one.code;
    }
  }
}

TEST(QuickFixes, TakeAwayAnAddressThatIsUsedTwice) {
  auto project = two_axes();
  project.slaves[2].station_address = project.slaves[1].station_address;
  expect_cures(project, "station-address-twice");
  const auto findings = findings_of(project);
  const auto fixes = quick_fixes(project, *find(findings, "station-address-twice"));
  ASSERT_FALSE(fixes.empty());
  const std::int64_t next = project.slaves[1].station_address + 1;
  EXPECT_EQ(fixes.front().value, settings::Value{next}) << "the one behind those of the others comes first";
}

TEST(QuickFixes, ShortenOrFreeASetValueThatDoesNotFit) {
  auto project = two_axes();
  project.master.dc.dcm.set_value = 1;
  const auto findings = findings_of(project);
  ASSERT_NE(find(findings, "set-value-too-small"), nullptr);
  expect_cures(project, "set-value-too-small");
}

TEST(QuickFixes, SwitchOnWhatASlaveNeeds) {
  auto project = two_axes();
  project.master.dc.enabled = false;
  const auto findings = findings_of(project);
  const auto* finding = find(findings, "dc-switched-off");
  ASSERT_NE(finding, nullptr);
  const auto fixes = quick_fixes(project, *finding);
  ASSERT_FALSE(fixes.empty());
  apply(project, fixes.front());
  EXPECT_EQ(find(findings_of(project), "dc-switched-off"), nullptr);
}

/// As the window has them: of the ENI that is exported, with the settings that cure them.
std::vector<Finding> checked(const Project& project) {
  auto findings = check_network(compile(project).value().config);
  for (auto& one : findings) {
    if (one.place.key.empty()) one.place.key = setting_at(find_finding_words(one.code)->setting, one.place.slave);
  }
  return findings;
}

TEST(QuickFixes, TakeAwayWhatTheCheckerSaysOfTheEni) {
  struct Spoiled {
    const char *code, *key, *value;
  };
  constexpr Spoiled kCases[] = {
      {"ENI-REF-03", "slave.2.station_address", "1002"},  {"ENI-REF-06", "slave.2.name", "SL-SV7 1"},
      {"ENI-DC-07", "master.dc.reference_clock", "2"},    {"ENI-DC-18", "slave.2.dc.sync0.cycle_us", "1500"},
      {"ENI-DC-19", "slave.2.dc.sync0.shift_us", "1200"},
  };
  for (const auto& one : kCases) {
    auto project = two_axes();
    const auto setting = settings::find(project, one.key, false);
    ASSERT_TRUE(setting) << one.key;
    const auto value = settings::parse_value(setting->setting->type, one.value);
    ASSERT_TRUE(value && settings::set_value(*setting->setting, project, setting->place, *value)) << one.key;
    const auto before = checked(project);
    const auto* finding = find(before, one.code);
    ASSERT_NE(finding, nullptr) << one.code;
    const auto fixes = quick_fixes(project, *finding);
    EXPECT_FALSE(fixes.empty()) << one.code;
    for (const auto& fix : fixes) {
      auto changed = project;
      apply(changed, fix);
      EXPECT_EQ(find(checked(changed), one.code), nullptr) << one.code;
      EXPECT_FALSE(has_errors(checked(changed))) << one.code;
    }
  }
}

/// What the sentence names is what is offered first.
TEST(QuickFixes, OfferTheCyclesNextToOneThatADeviceRefuses) {
  auto project = two_axes();
  project.slaves[2].device.identity = {0x539, 0x02200301, 0x00040000, 0};  // takes multiples of 125 us
  project.slaves[2].dc.sync0.user_cycle = 800 * kMicrosecond;
  const auto before = checked(project);
  const auto* finding = find(before, "ENI-DEV-01");
  ASSERT_NE(finding, nullptr);
  std::vector<settings::Value> offered;
  for (const auto& fix : quick_fixes(project, *finding, {}, 8)) offered.push_back(fix.value);
  const auto offers = [&](std::int64_t value) {
    return std::ranges::find(offered, settings::Value{value}) != offered.end();
  };
  EXPECT_TRUE(offers(750 * kMicrosecond) || offers(875 * kMicrosecond) || offers(1 * kMillisecond));
  for (const auto& value : offered) {
    const auto* number = std::get_if<std::int64_t>(&value);
    if (number != nullptr) {
      EXPECT_EQ(*number % (125 * kMicrosecond), 0);
    }
  }
}

/// An error that goes is no bargain where a warning comes.
TEST(QuickFixes, BringNoOtherFinding) {
  auto project = two_axes();
  project.master.cycle_time = 200 * kMicrosecond;
  project.slaves[2].device.identity = {0x539, 0x02200301, 0x00040000, 0};
  const auto before = checked(project);
  const auto* finding = find(before, "ENI-DEV-01");
  ASSERT_NE(finding, nullptr);
  for (const auto& fix : quick_fixes(project, *finding, {}, 8)) {
    auto changed = project;
    apply(changed, fix);
    for (const auto& one : checked(changed)) {
      EXPECT_TRUE(one.severity == Severity::kNote || find(before, one.code) != nullptr) << one.code;
    }
  }
}

TEST(QuickFixes, GiveANameThatOthersHaveTheNextNumber) {
  auto project = two_axes();
  project.slaves[0].name = "Axis (2)";
  project.slaves[1].name = project.slaves[2].name = "Axis";
  const auto findings = checked(project);
  const auto* finding = find(findings, "ENI-REF-06");
  ASSERT_NE(finding, nullptr);
  const auto fixes = quick_fixes(project, *finding);
  ASSERT_EQ(fixes.size(), 1U);
  apply(project, fixes.front());
  EXPECT_EQ(project.slaves[2].name, "Axis (3)");
}

TEST(QuickFixes, OfferNothingWhereNoSingleValueDoesIt) {
  const auto project = two_axes();
  Finding unknown{.code = "station-address-twice", .severity = Severity::kError, .place = Place(1, "slave.1.nonsense")};
  EXPECT_TRUE(quick_fixes(project, unknown).empty());
  EXPECT_TRUE(quick_fixes(Project{}, unknown).empty()) << "cannot be compiled";
  unknown.place = Place(1);
  EXPECT_TRUE(quick_fixes(project, unknown).empty()) << "names no setting";
}

/// An operation mode brings PDOs with it: what one trial set is gone in the next, and nothing but the value is offered.
TEST(QuickFixes, TryEachValueOnTheProjectAsItIs) {
  auto project = two_axes();
  auto& slave = project.slaves[1];
  slave.dc.op_mode = "no such mode";
  const auto findings = findings_of(project);
  const auto* finding = find(findings, "operation-mode-missing");
  ASSERT_NE(finding, nullptr);
  for (const auto& fix : quick_fixes(project, *finding, {}, 24)) {
    auto changed = project;
    apply(changed, fix);
    EXPECT_EQ(find(findings_of(changed), "operation-mode-missing"), nullptr);
  }
  EXPECT_FALSE(quick_fixes(project, *finding, {}, 24).empty());
}

/// A run that nobody watched: no compilation shows it, its row names what to switch on.
TEST(QuickFixes, SwitchOnWhatARunMissed) {
  auto project = two_axes();
  project.master.dc.sync_window.enabled = false;
  const Finding finding{.code = "not-monitored", .severity = Severity::kNote};
  const auto fixes = quick_fixes(project, finding);
  ASSERT_EQ(fixes.size(), 1U);
  apply(project, fixes.front());
  EXPECT_TRUE(project.master.dc.sync_window.enabled);
  EXPECT_TRUE(quick_fixes(project, finding).empty()) << "it is on already";
  EXPECT_TRUE(quick_fixes(project, {.code = "frames-lost", .severity = Severity::kError}).empty());
}

TEST(QuickFixes, SetTheNumberThatARunAdvises) {
  auto project = two_axes();
  const auto before = settings::effective_value(settings::row("master.dc.set_value_us"), project, {});
  Finding tight{.code = "sync0-too-tight", .severity = Severity::kWarning, .place = Place(1)};
  tight.figures = {{"more", Figure::Unit::kNanoseconds, 20'000}};
  auto fixes = quick_fixes(project, tight);
  ASSERT_EQ(fixes.size(), 1U);
  apply(project, fixes.front());
  EXPECT_EQ(project.master.dc.dcm.set_value, std::get<std::int64_t>(before) + 20'000);
  EXPECT_TRUE(quick_fixes(project, tight).empty()) << "it was set since";
  project.master.dc.dcm.set_value.reset();
  tight.figures.front().value = project.master.cycle_time;
  EXPECT_TRUE(quick_fixes(project, tight).empty()) << "no frame is sent a cycle before";
  Finding shift{.code = "shift-too-short", .severity = Severity::kWarning, .place = Place(2)};
  shift.figures = {{"more", Figure::Unit::kNanoseconds, 30'000}, {"shift", Figure::Unit::kNanoseconds, 40'000}};
  fixes = quick_fixes(project, shift);
  ASSERT_EQ(fixes.size(), 1U);
  EXPECT_EQ(fixes.front().places.front().slave, 2U);
  apply(project, fixes.front());
  EXPECT_EQ(project.slaves[2].dc.sync0.shift, 40'000);
  EXPECT_TRUE(quick_fixes(project, shift).empty()) << "it is that already";
  project.slaves[2].dc.input_reference = true;
  project.master.dc.input_shift = 15'000;
  fixes = quick_fixes(project, shift);
  ASSERT_EQ(fixes.size(), 1U);
  apply(project, fixes.front());
  EXPECT_EQ(project.slaves[2].dc.sync0.shift, 25'000) << "the master's input shift comes on top";
}

TEST(QuickFixes, AreNoMoreThanWanted) {
  auto project = two_axes();
  project.slaves[2].station_address = project.slaves[1].station_address;
  const auto findings = findings_of(project);
  EXPECT_LE(quick_fixes(project, *find(findings, "station-address-twice"), {}, 1).size(), 1U);
}

}  // namespace
}  // namespace syncline
