// SPDX-License-Identifier: Apache-2.0
#include "master/scan/bus_match.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace syncline {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

std::vector<WantedDevice> wanted(std::initializer_list<std::uint32_t> products) {
  std::vector<WantedDevice> devices;
  for (const auto product : products) devices.push_back({{1, product, 0, 0}, 0, 0, false});
  return devices;
}
std::vector<FoundDevice> found(std::initializer_list<std::uint32_t> products) {
  std::vector<FoundDevice> devices;
  for (const auto product : products) devices.push_back({{1, product, 0, 0}, 0, 0});
  return devices;
}

TEST(BusMatch, OfTheConfiguredBusIsExact) {
  const auto match = match_bus(wanted({1, 2, 2, 3}), found({1, 2, 2, 3}));
  EXPECT_TRUE(match.exact());
  EXPECT_THAT(match.position, ElementsAre(0, 1, 2, 3));
}

TEST(BusMatch, NamesTheMissingSlaveAndWhereTheOthersAre) {
  const auto match = match_bus(wanted({1, 2, 3, 4}), found({1, 3, 4}));
  EXPECT_THAT(match.missing, ElementsAre(1));
  EXPECT_THAT(match.extra, IsEmpty());
  EXPECT_THAT(match.position, ElementsAre(0, std::nullopt, 1, 2));
}

TEST(BusMatch, AHotConnectGroupMayBeAbsentAndStandAnywhere) {
  auto want = wanted({1, 2, 3, 2});
  want[1].optional = want[2].optional = true;  // a group of two with the alias 77
  want[1].alias = 77;
  want[2].follows = 1;
  const auto absent = match_bus(want, found({1, 2}));
  EXPECT_THAT(absent.position, ElementsAre(0, std::nullopt, std::nullopt, 1));
  EXPECT_THAT(absent.absent, ElementsAre(1, 2));
  EXPECT_TRUE(absent.exact()) << "the other of its kind has no such alias, and nobody is missing";
  auto there = found({1, 2, 2, 3});
  there[2].alias = 77;
  EXPECT_THAT(match_bus(want, there).position, ElementsAre(0, 2, 3, 1));
}

TEST(BusMatch, NamesTheExtraDevice) {
  const auto match = match_bus(wanted({1, 2, 3}), found({1, 2, 9, 3}));
  EXPECT_THAT(match.extra, ElementsAre(2));
  EXPECT_THAT(match.missing, IsEmpty());
  EXPECT_THAT(match.position, ElementsAre(0, 1, 3));
}

TEST(BusMatch, NamesBothSwappedSlaves) {
  const auto match = match_bus(wanted({1, 2, 3, 4}), found({1, 4, 3, 2}));
  EXPECT_THAT(match.swapped, ElementsAre(Pair(1, 3)));
  EXPECT_THAT(match.missing, IsEmpty());
  EXPECT_THAT(match.extra, IsEmpty());
  EXPECT_THAT(match.wrong, IsEmpty());
}

TEST(BusMatch, TellsAnotherDeviceFromAMissingOne) {
  const auto match = match_bus(wanted({1, 2, 3}), found({1, 7, 3}));
  EXPECT_THAT(match.wrong, ElementsAre(1));
  EXPECT_THAT(match.missing, IsEmpty());
  EXPECT_THAT(match.extra, IsEmpty());
}

TEST(BusMatch, FindsASlaveWithAnAliasAnywhere) {
  auto want = wanted({1, 2, 2, 3});
  want[2].alias = 77;
  auto there = found({1, 2, 3, 2});
  there[3].alias = 77;
  const auto match = match_bus(want, there);
  EXPECT_TRUE(match.missing.empty());
  EXPECT_THAT(match.position, ElementsAre(0, 1, 3, 2));
}

TEST(BusMatch, OfAnEmptyBusMissesAll) {
  EXPECT_THAT(match_bus(wanted({1, 2}), {}).missing, ElementsAre(0, 1));
  EXPECT_THAT(match_bus({}, found({1, 2})).extra, ElementsAre(0, 1));
}

}  // namespace
}  // namespace syncline
