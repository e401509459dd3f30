// SPDX-License-Identifier: Apache-2.0
#include "advice/quick_fixes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compile/compile.h"
#include "tests/support/small_machines.h"

namespace syncline {
namespace {

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
  auto project = test::two_axes().project;
  project.slaves[2].station_address = project.slaves[1].station_address;
  expect_cures(project, "station-address-twice");
}

TEST(QuickFixes, ShortenOrFreeASetValueThatDoesNotFit) {
  auto project = test::two_axes().project;
  project.master.dc.dcm.set_value = 1;
  const auto findings = findings_of(project);
  ASSERT_NE(find(findings, "set-value-too-small"), nullptr);
  expect_cures(project, "set-value-too-small");
}

TEST(QuickFixes, SwitchOnWhatASlaveNeeds) {
  auto project = test::two_axes().project;
  project.master.dc.enabled = false;
  const auto findings = findings_of(project);
  const auto* finding = find(findings, "dc-switched-off");
  ASSERT_NE(finding, nullptr);
  const auto fixes = quick_fixes(project, *finding);
  ASSERT_FALSE(fixes.empty());
  apply(project, fixes.front());
  EXPECT_EQ(find(findings_of(project), "dc-switched-off"), nullptr);
}

TEST(QuickFixes, OfferNothingWhereNoSingleValueDoesIt) {
  const auto project = test::two_axes().project;
  Finding unknown{.code = "station-address-twice", .severity = Severity::kError, .place = Place(1, "slave.1.nonsense")};
  EXPECT_TRUE(quick_fixes(project, unknown).empty());
  EXPECT_TRUE(quick_fixes(Project{}, unknown).empty()) << "cannot be compiled";
  unknown.place = Place(1);
  EXPECT_TRUE(quick_fixes(project, unknown).empty()) << "names no setting";
}

/// An operation mode brings PDOs with it: what one trial set is gone in the next, and nothing but the value is offered.
TEST(QuickFixes, TryEachValueOnTheProjectAsItIs) {
  auto project = test::two_axes().project;
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

TEST(QuickFixes, AreNoMoreThanWanted) {
  auto project = test::two_axes().project;
  project.slaves[2].station_address = project.slaves[1].station_address;
  const auto findings = findings_of(project);
  EXPECT_LE(quick_fixes(project, *find(findings, "station-address-twice"), {}, 1).size(), 1U);
}

}  // namespace
}  // namespace syncline
