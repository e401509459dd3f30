// SPDX-License-Identifier: Apache-2.0
#include "families/family_problems.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "config/identity.h"
#include "config/mailbox_config.h"
#include "config/slave_config.h"
#include "families/device_family.h"
#include "families/families.h"

namespace syncline::families {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using Topic = Problem::Topic;

const Family& family(std::uint32_t vendor, std::uint32_t product) { return *find(Identity{vendor, product, 0, 0}); }
const Family& sigma5() { return family(0x539, 0x0220'0001); }
const Family& copley() { return family(0xAB, 0x10B0); }
const Family& el6751() { return family(0x2, 0x1A5F'3052); }

SlaveConfig slave(Nanoseconds sync0) {
  SlaveConfig config;
  config.mailbox.emplace().coe = true;
  if (sync0 > 0) config.dc = SlaveDcConfig{false, false, sync0, 0, 0, 0x0300};
  return config;
}

void write_object(SlaveConfig& config, std::uint16_t index, std::uint8_t sub_index, std::vector<std::uint8_t> data) {
  CoeInitCmd cmd;
  cmd.command.index = index;
  cmd.command.sub_index = sub_index;
  cmd.command.data = std::move(data);
  config.mailbox->coe_commands.push_back(std::move(cmd));
}

std::vector<Topic> topics(const Family* family, const SlaveConfig& config, Nanoseconds bus = kMillisecond) {
  std::vector<Topic> out;
  for (const auto& problem : problems(family, config, bus)) out.push_back(problem.topic);
  return out;
}

TEST(FamilyProblems, CyclesThatTheDriveRefuses) {
  for (const auto& [us, refused] : std::vector<std::pair<int, bool>>{{125, false},
                                                                     {250, false},
                                                                     {300, true},
                                                                     {700, true},
                                                                     {1000, false},
                                                                     {4000, false},
                                                                     {4125, true},
                                                                     {5000, true},
                                                                     {100, true}}) {
    const auto found = problems(&sigma5(), slave(us * kMicrosecond), us * kMicrosecond);
    ASSERT_EQ(found.size(), refused ? 1U : 0U) << us;
    if (refused) {
      EXPECT_TRUE(found[0].refused && found[0].topic == Topic::kCycleRefused) << us;
    }
  }
  EXPECT_THAT(facts_text(problems(&sigma5(), slave(300 * kMicrosecond), kMillisecond)[0].finding),
              HasSubstr("Next to it: 250 us or 375 us."));
  EXPECT_THAT(facts_text(problems(&sigma5(), slave(5 * kMillisecond), kMillisecond)[0].finding),
              HasSubstr("Next to it: 4000 us."));
  EXPECT_THAT(topics(&sigma5(), slave(0)), IsEmpty()) << "free run takes any";
}

TEST(FamilyProblems, CyclesThatAreTakenWithLosses) {
  const auto found = problems(&copley(), slave(312'500), 312'500);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_FALSE(found[0].refused);
  EXPECT_THAT(facts_text(found[0].finding), testing::AllOf(HasSubstr("250 us"), HasSubstr("current loop")));
  EXPECT_THAT(topics(&copley(), slave(10 * kMillisecond)), IsEmpty());
  EXPECT_THAT(topics(&copley(), slave(300'000)), testing::ElementsAre(Topic::kCycleRefused));
}

TEST(FamilyProblems, ErrorLimit) {
  for (const auto& [value, topic] : std::vector<std::pair<std::uint8_t, std::optional<Topic>>>{
           {15, std::nullopt}, {16, Topic::kErrorLimit}, {0, Topic::kErrorLimitOff}}) {
    auto config = slave(kMillisecond);
    write_object(config, 0x10F1, 2, {value, 0});
    const auto found = problems(&sigma5(), config, kMillisecond);
    ASSERT_EQ(found.size(), topic ? 1U : 0U) << int{value};
    if (!topic) continue;
    EXPECT_EQ(found[0].topic, *topic);
    EXPECT_EQ(found[0].refused, value != 0);
    EXPECT_EQ(found[0].coe_command, 0U);
  }
}

TEST(FamilyProblems, ModesThatNeedSync0) {
  for (const std::uint8_t mode : {7, 8, 9, 10}) {
    auto config = slave(0);
    write_object(config, 0x6860, 0, {mode});  // of the second axis
    EXPECT_THAT(topics(&sigma5(), config), testing::ElementsAre(Topic::kModeNeedsDc)) << int{mode};
    config.dc = slave(kMillisecond).dc;
    EXPECT_THAT(topics(&sigma5(), config), IsEmpty()) << int{mode};
  }
  auto config = slave(0);
  write_object(config, 0x6060, 0, {1});
  EXPECT_THAT(topics(&sigma5(), config), IsEmpty()) << "profile position";
  write_object(config, 0x6060, 0, {9});
  EXPECT_THAT(topics(nullptr, config), IsEmpty()) << "nothing is known";
  config.mailbox->profiles = {{402, 0}};
  EXPECT_THAT(topics(nullptr, config), testing::ElementsAre(Topic::kModeNeedsDc)) << "any CiA 402 drive";
}

TEST(FamilyProblems, SyncTypes) {
  auto config = slave(kMillisecond);
  write_object(config, 0x1C32, 1, {2, 0});
  EXPECT_TRUE(problems(&sigma5(), config, kMillisecond).at(0).refused) << "read-only there";
  EXPECT_THAT(topics(&copley(), config), IsEmpty());
  config.dc.reset();
  EXPECT_TRUE(problems(&copley(), config, kMillisecond).at(0).refused) << "SYNC0 is asked for and off";
  auto unused = slave(kMillisecond);
  write_object(unused, 0x1C33, 1, {0, 0});
  const auto found = problems(&copley(), unused, kMillisecond);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_FALSE(found[0].refused);
  EXPECT_THAT(facts_text(found[0].finding), HasSubstr("inputs are not those of SYNC0"));
  auto odd = slave(kMillisecond);
  write_object(odd, 0x1C32, 1, {3, 0});
  EXPECT_TRUE(problems(&copley(), odd, kMillisecond).at(0).refused) << "SYNC1 is none of its types";
}

TEST(FamilyProblems, CanCycleOfAGateway) {
  auto config = slave(kMillisecond);
  write_object(config, 0xF800, 4, {0x60, 0xE3, 0x16, 0});  // 1.5 ms
  EXPECT_TRUE(problems(&el6751(), config, kMillisecond).at(0).refused);
  auto fits = slave(kMillisecond);
  write_object(fits, 0xF800, 4, {0x00, 0x09, 0x3D, 0});  // 4 ms
  EXPECT_THAT(topics(&el6751(), fits), IsEmpty());
  fits.dc.reset();
  EXPECT_FALSE(problems(&el6751(), fits, kMillisecond).at(0).refused) << "it is not told its bus cycle";
  write_object(fits, 0x1C32, 2, {0x40, 0x42, 0x0F, 0});  // 1 ms
  EXPECT_THAT(topics(&el6751(), fits), IsEmpty());
  EXPECT_THAT(topics(&el6751(), fits, 2 * kMillisecond), testing::ElementsAre(Topic::kCanCycle)) << "told wrongly";
}

/// What their tables bring into sentences has to be known to the translations.
TEST(FamilyProblems, EachPhraseOfAFamilyIsAPhraseOfFindings) {
  const auto phrases = finding_phrases();
  const auto knows = [&](std::string_view text) { return std::ranges::find(phrases, text) != phrases.end(); };
  for (const Family* family : all()) {
    EXPECT_TRUE(knows(family->devices)) << family->devices;
    if (family->cycle && !family->cycle->otherwise.empty()) {
      EXPECT_TRUE(knows(family->cycle->otherwise)) << family->cycle->otherwise;
    }
    for (const auto& mode : family->modes_need_dc.list) EXPECT_TRUE(knows(mode.why)) << mode.why;
  }
}

}  // namespace
}  // namespace syncline::families
