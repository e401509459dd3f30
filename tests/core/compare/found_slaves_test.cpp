// SPDX-License-Identifier: Apache-2.0
#include "compare/found_slaves.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>

#include "config/device_description.h"
#include "config/slave_edits.h"

namespace syncline {
namespace {

/// A line of devices with these product codes.
Project line(std::initializer_list<std::uint32_t> products) {
  Project project;
  std::uint16_t position = 0;
  for (const auto product : products) {
    DeviceDescription device;
    device.identity = {2, product, 1, 0};
    auto slave = default_slave(device, position);
    if (position > 0) slave.previous = PreviousPort{static_cast<std::uint16_t>(position - 1), 1};
    project.slaves.push_back(std::move(slave));
    ++position;
  }
  return project;
}

std::vector<FoundKind> kinds(const std::vector<FoundSlave>& lines) {
  std::vector<FoundKind> all;
  for (const auto& one : lines) all.push_back(one.kind);
  return all;
}

std::vector<std::uint32_t> products(const Project& project) {
  std::vector<std::uint32_t> all;
  for (const auto& slave : project.slaves) all.push_back(slave.device.identity.product_code);
  return all;
}

using Kinds = std::vector<FoundKind>;
using Products = std::vector<std::uint32_t>;

TEST(FoundSlaves, TheSameBusMatches) {
  const auto ours = line({1, 2, 3});
  EXPECT_EQ(kinds(compare_found(ours, ours)), Kinds(3, FoundKind::kMatched));
}

TEST(FoundSlaves, OneMoreAndOneLessAreOneLineEach) {
  const auto ours = line({1, 2, 3});
  EXPECT_EQ(kinds(compare_found(ours, line({1, 9, 2, 3}))),
            Kinds({FoundKind::kMatched, FoundKind::kExtra, FoundKind::kRewired, FoundKind::kMatched}));
  EXPECT_EQ(kinds(compare_found(ours, line({1, 3}))),
            Kinds({FoundKind::kMatched, FoundKind::kMissing, FoundKind::kRewired}));
}

TEST(FoundSlaves, RevisionOrderAndDeviceAreToldApart) {
  const auto ours = line({1, 2, 3, 4});
  auto found = ours;
  found.slaves[1].device.identity.revision_no = 7;
  found.slaves[2].device.identity.product_code = 99;
  EXPECT_EQ(kinds(compare_found(ours, found)),
            Kinds({FoundKind::kMatched, FoundKind::kRevision, FoundKind::kOtherDevice, FoundKind::kMatched}));
  const auto moved = compare_found(ours, line({1, 3, 4, 2}));
  EXPECT_EQ(std::ranges::count(moved, FoundKind::kMoved, &FoundSlave::kind), 1);
  found = ours;
  found.slaves[3].previous = PreviousPort{1, 2};
  EXPECT_EQ(kinds(compare_found(ours, found)).back(), FoundKind::kRewired);
}

TEST(FoundSlaves, PieceByPiece) {
  auto ours = line({1, 2, 3});
  ours.slaves[2].alias = 77;
  ours.master.dc.reference_clock = std::uint16_t{2};
  const auto found = line({1, 9, 3});
  auto lines = compare_found(ours, found);
  ASSERT_EQ(kinds(lines), Kinds({FoundKind::kMatched, FoundKind::kOtherDevice, FoundKind::kMatched}));
  const auto kept = take_over(ours, found, lines, {true, false, true}).project;
  EXPECT_EQ(kept, ours);

  const auto longer = line({1, 9, 2, 3});
  lines = compare_found(ours, longer);
  const auto with = take_over(ours, longer, lines, {true, true, true, true}).project;
  EXPECT_EQ(products(with), Products({1, 9, 2, 3}));
  EXPECT_EQ(with.slaves[3].alias, 77) << "what is known keeps its settings";
  EXPECT_EQ(with.master.dc.reference_clock, 3);
  EXPECT_EQ(with.slaves[2].previous, (PreviousPort{1, 1}));
  EXPECT_EQ(take_over(ours, longer, lines, {true, false, false, true}).project, ours);

  const auto shorter = line({1, 3});
  lines = compare_found(ours, shorter);
  const auto less = take_over(ours, shorter, lines, {true, true, true}).project;
  EXPECT_EQ(products(less), Products({1, 3}));
  EXPECT_EQ(less.slaves[1].previous, (PreviousPort{0, 1}));
  EXPECT_EQ(less.master.dc.reference_clock, 1);
  EXPECT_EQ(take_over(ours, shorter, lines, {true, false, false}).project, ours);
}

TEST(FoundSlaves, AnotherRevisionKeepsWhatItTakes) {
  auto ours = line({1, 2});
  ours.slaves[1].name = "Axis 1";
  ours.slaves[1].alias = 5;
  ours.slaves[1].device.mailbox.emplace().coe.emplace();
  StartupCommand command;
  command.index = 0x6060;
  command.data = {8};
  command.transitions = {Transition::kPS};
  ours.slaves[1].startup = {command};
  auto found = line({1, 2});
  found.slaves[1].device.identity.revision_no = 2;
  const auto lines = compare_found(ours, found);
  const auto taken = take_over(ours, found, lines, {true, true});
  EXPECT_EQ(taken.project.slaves[1].device.identity.revision_no, 2U);
  EXPECT_EQ(taken.project.slaves[1].name, "Axis 1");
  EXPECT_EQ(taken.project.slaves[1].alias, 5);
  EXPECT_EQ(taken.lost, std::vector<std::string>({"slave.1.startup.0"})) << "it has no mailbox any more";
}

TEST(FoundSlaves, ASlaveThatComesInGetsAFreeAddressWhateverTheOthersHave) {
  auto ours = line({1});
  ours.slaves[0].station_address = 0xFFFF;
  auto found = line({1, 9, 9});
  found.slaves[1].station_address = 0xFFFF;
  found.slaves[2].station_address = 1;
  const auto lines = compare_found(ours, found);
  const auto taken = take_over(ours, found, lines, std::vector<bool>(lines.size(), true)).project;
  ASSERT_EQ(taken.slaves.size(), 3U);
  EXPECT_EQ(taken.slaves[0].station_address, 0xFFFF);
  EXPECT_EQ(taken.slaves[1].station_address, 1);
  EXPECT_EQ(taken.slaves[2].station_address, 2);
}

TEST(FoundSlaves, ASlaveThatComesInIsCalledByItsOwnAddressAndLikeNobodyElse) {
  auto ours = line({1});
  ours.slaves[0].station_address = 1001;
  ours.slaves[0].name = "Slave_1001 [mine]";
  auto found = line({1, 9, 9});
  for (const std::size_t i : {1, 2}) {
    auto& slave = found.slaves[i];
    slave.device.type = "SL-1002";
    slave.station_address = static_cast<std::uint16_t>(1000 + i);
    slave.name = default_name(slave.station_address, slave.device);
  }
  found.slaves[2].name = "Slave_1001 [mine]";
  const auto lines = compare_found(ours, found);
  const auto taken = take_over(ours, found, lines, std::vector<bool>(lines.size(), true)).project;
  ASSERT_EQ(taken.slaves.size(), 3U);
  EXPECT_EQ(taken.slaves[0].name, "Slave_1001 [mine]");
  EXPECT_EQ(taken.slaves[1].station_address, 1002);
  EXPECT_EQ(taken.slaves[1].name, "Slave_1002 [SL-1002]");
  EXPECT_EQ(taken.slaves[2].name, "Slave_1001 [mine] (2)");
}

/// Whatever is ticked: nothing taken is the project, all taken is the bus in order and wiring, and every result can be
/// wired and addressed.
TEST(FoundSlaves, AnyChoiceGivesAWholeProject) {
  EXPECT_TRUE(rc::check([] {
    const auto machine = [] {
      Project project;
      const auto count = *rc::gen::inRange(1, 8);
      for (int i = 0; i < count; ++i) {
        DeviceDescription device;
        device.identity = {2, static_cast<std::uint32_t>(*rc::gen::inRange(1, 4)),
                           static_cast<std::uint32_t>(*rc::gen::inRange(1, 3)), 0};
        project.slaves.push_back(default_slave(device, static_cast<std::uint16_t>(i)));
        if (i > 0)
          project.slaves.back().previous = PreviousPort{static_cast<std::uint16_t>(*rc::gen::inRange(0, i)), 1};
      }
      return project;
    };
    const auto ours = machine();
    const auto found = machine();
    const auto lines = compare_found(ours, found);
    std::vector<bool> take;
    for (std::size_t i = 0; i < lines.size(); ++i) take.push_back(*rc::gen::arbitrary<bool>());
    const auto some = take_over(ours, found, lines, take).project;
    std::set<std::uint16_t> addresses;
    for (std::size_t i = 0; i < some.slaves.size(); ++i) {
      RC_ASSERT(addresses.insert(some.slaves[i].station_address).second);
      RC_ASSERT(some.slaves[i].previous.has_value() == (i > 0) || i == 0);
      if (some.slaves[i].previous) RC_ASSERT(some.slaves[i].previous->position < some.slaves.size());
    }
    const auto all = take_over(ours, found, lines, std::vector<bool>(lines.size(), true)).project;
    RC_ASSERT(products(all) == products(found));
    for (std::size_t i = 0; i < all.slaves.size(); ++i) RC_ASSERT(all.slaves[i].previous == found.slaves[i].previous);
    const auto none = take_over(ours, found, lines, std::vector<bool>(lines.size(), false)).project;
    RC_ASSERT(products(none) == products(ours));
  }));
}

}  // namespace
}  // namespace syncline
