// SPDX-License-Identifier: Apache-2.0
#include "settings/settings_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "families/device_family.h"
#include "families/families.h"
#include "settings/default_value.h"
#include "settings/limits.h"
#include "settings/predicates.h"
#include "support/random_project.h"
#include "tests/support/sample_devices.h"

namespace syncline::settings {
namespace {

using ::testing::HasSubstr;

/// What a project holds is what its setting takes: for every key of random projects.
TEST(SettingsTable, TypedValuesGoBackAsTheyCame) {
  EXPECT_TRUE(rc::check([](std::uint32_t seed) {
    const Project before = test::RandomProject(seed).project();
    for (const Setting& setting : table()) {
      if (setting.of_slave() && before.slaves.empty()) continue;
      const auto places = setting.items ? setting.items(before, 0) : std::vector<Place>{{}};
      for (const Place& place : places) {
        Project project = before;
        const auto value = setting.read(before, place);
        const auto status = set_value(setting, project, place, value);
        if (!status) RC_FAIL(setting.key + ": " + status.error().detail.text());
        RC_ASSERT(project == before);
      }
    }
  }));
}

TEST(SettingsTable, NumbersTakeBothEndsAndNothingBeyond) {
  for (const Setting& setting : table()) {
    const auto* number = std::get_if<Number>(&setting.type);
    if (number == nullptr || setting.items || setting.options) continue;
    Project project;
    project.slaves.emplace_back();
    project.slaves.front().device.mailbox.emplace().coe.emplace();
    if (setting.key.starts_with("slave.N.can.")) continue;  // for gateways only
    const Project before = project;
    for (const auto beyond : {number->range.low - 1, number->range.high + 1}) {
      EXPECT_FALSE(set_value(setting, project, {}, beyond)) << setting.key << ' ' << beyond;
      EXPECT_EQ(project, before);
    }
    for (const auto end : {number->range.low, number->range.high}) {
      ASSERT_TRUE(set_value(setting, project, {}, end)) << setting.key << ' ' << end;
      EXPECT_EQ(setting.read(project, {}), Value{end}) << setting.key;
    }
  }
}

TEST(SettingsTable, ValuesOfAnotherKindAreRefused) {
  for (const Setting& setting : table()) {
    if (setting.items) continue;
    Project project;
    project.slaves.emplace_back();
    const Project before = project;
    for (const Value& value : {Value{}, Value{true}, Value{std::int64_t{-1'000'000'000'000}}, Value{std::string("\n")},
                               Value{std::vector<std::uint8_t>{1}}, Value{std::vector<std::uint16_t>{1}}}) {
      if (value == setting.read(project, {})) continue;
      const bool unset = std::holds_alternative<Unset>(value) && !setting.unset.empty();
      if (std::holds_alternative<Switch>(setting.type) && std::holds_alternative<bool>(value)) continue;
      if (unset) continue;
      EXPECT_FALSE(set_value(setting, project, {}, value)) << setting.key << ' ' << value.index();
      EXPECT_EQ(project, before) << setting.key;
    }
  }
}

TEST(SettingsTable, EveryRowSaysWhatPeopleNeed) {
  for (const Setting& setting : table()) {
    EXPECT_FALSE(setting.words.label.empty()) << setting.key;
    EXPECT_TRUE(setting.words.help.ends_with('.')) << setting.key;
    EXPECT_FALSE(setting.items ? false : preset_text(setting).empty()) << setting.key;
    EXPECT_NE(setting.words.eni.empty(), setting.words.no_eni.empty())
        << setting.key << ": where in the ENI, or why not";
    EXPECT_EQ(setting.words.help.find('|'), std::string::npos) << setting.key << ": it stands in a Markdown table";
  }
}

TEST(SettingsTable, WhatAutoStandsForFollowsTheProject) {
  Project project;
  const auto& row_of_set_value = row("master.dc.set_value_us");
  EXPECT_EQ(effective_value(row_of_set_value, project, {}), Value{kMillisecond * 2 / 3});
  project.master.cycle_time = 300 * kMicrosecond;
  EXPECT_EQ(effective_value(row_of_set_value, project, {}), Value{200 * kMicrosecond});
  EXPECT_EQ(working_range(row_of_set_value, project, {}), (Range{1, 300 * kMicrosecond - 1}));
  project.master.dc.dcm.set_value = 300 * kMicrosecond;
  const auto status = check_number(row_of_set_value, project, {});
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().subject, "master.dc.set_value_us");
  EXPECT_THAT(status.error().detail.text(), HasSubstr("300 us is outside 0.001..299.999 us"));
}

TEST(SettingsTable, ASyncUnitThatIsOffStandsForNoTime) {
  Project project;
  auto& slave = project.slaves.emplace_back();
  slave.device.dc.emplace();
  auto& mode = slave.device.dc->op_modes.emplace_back();
  mode.name = slave.dc.op_mode = "DC";
  mode.assign_activate = 0x0300;  // SYNC0 alone
  const Place place{0};
  EXPECT_EQ(effective_value(row("slave.N.dc.sync0.cycle_us"), project, place), Value{kMillisecond});
  EXPECT_EQ(effective_value(row("slave.N.dc.sync1.cycle_us"), project, place), Value{});
  EXPECT_EQ(effective_value(row("slave.N.dc.sync1.shift_us"), project, place), Value{});
  project.slaves[0].device.dc->op_modes[0].assign_activate = 0x0700;
  EXPECT_NE(effective_value(row("slave.N.dc.sync1.shift_us"), project, place), Value{});
}

TEST(SettingsTable, TheDefaultOfASlaveIsThatOfItsDevice) {
  Project project = sample::small_machine();
  auto& servo = project.slaves[3];
  const Place place{3};
  const auto usual = servo.dc.op_mode;
  servo.dc.op_mode.clear();
  servo.assigned_rx_pdos.clear();
  servo.station_address = 7;
  EXPECT_EQ(default_value(row("slave.N.dc.op_mode"), project, place), Value{usual});
  EXPECT_EQ(default_value(row("slave.N.pdo.rx"), project, place), Value{std::vector<std::uint16_t>{0x1600}});
  EXPECT_EQ(default_value(row("slave.N.station_address"), project, place), Value{std::int64_t{1004}});
  EXPECT_EQ(default_value(row("slave.N.alias"), project, Place{9}), std::nullopt) << "there is no such slave";
  EXPECT_EQ(default_value(row("slave.N.startup.K"), project, Place{3, 99}), std::nullopt);
  project.master.cycle_time = 5 * kMillisecond;
  EXPECT_EQ(default_value(row("master.cycle_time_us"), project, {}), Value{kMillisecond});
}

TEST(SettingsTable, TheDevicesFamilyLimitsItsErrorCounter) {
  const auto& limit = row("slave.N.sync.error_limit");
  for (const auto* family : families::all()) {
    if (!family->error_limit) continue;
    EXPECT_LE(family->error_limit->usual, family->error_limit->largest);
  }
  Project project;
  project.slaves.emplace_back();
  EXPECT_EQ(working_range(limit, project, {}), (Range{0, limits::kLargestWord}));
}

TEST(Predicates, SyncAndFramesKeepStep) {
  EXPECT_TRUE(keeps_step(kMillisecond, kMillisecond));
  EXPECT_TRUE(keeps_step(2 * kMillisecond, kMillisecond));
  EXPECT_TRUE(keeps_step(kMillisecond, 2 * kMillisecond));
  EXPECT_FALSE(keeps_step(kMillisecond, 1'500 * kMicrosecond));
  EXPECT_FALSE(keeps_step(kMillisecond + 1, kMillisecond));
  EXPECT_TRUE(keeps_step(kMillisecond + 1, kMillisecond, kMicrosecond)) << "files hold whole microseconds";
  EXPECT_FALSE(keeps_step(0, kMillisecond));
  EXPECT_FALSE(keeps_step(kMillisecond, 0));
  EXPECT_FALSE(keeps_step(-kMillisecond, kMillisecond));
}

}  // namespace
}  // namespace syncline::settings
