// SPDX-License-Identifier: Apache-2.0
#include "config/slave_edits.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <numeric>

#include "config/device_description.h"
#include "config/project.h"
#include "config/wiring_tree.h"

namespace syncline {
namespace {

DeviceDescription device(const char* type, const char* physics) {
  DeviceDescription made;
  made.type = type;
  made.physics = physics;
  return made;
}
const DeviceDescription kCoupler = device("coupler", "YKY"), kTerminal = device("terminal", "KK"),
                        kDrive = device("drive", "YY"), kJunction = device("junction", "YYYY"),
                        kLastTerminal = device("last", "K"), kUnknownDevice = device("unknown", "");

std::string types(const Project& project) {
  std::string all;
  for (const auto& slave : project.slaves) all += slave.device.type + " ";
  return all;
}

std::string wiring(const Project& project) {
  std::string all;
  for (const auto& slave : project.slaves) {
    const auto& at = slave.previous;
    all += at ? std::to_string(at->position) + static_cast<char>('A' + at->port) + " " : "- ";
  }
  return all;
}

/// coupler, two terminals, drive, coupler, terminal.
Project plant() {
  Project project;
  EXPECT_EQ(add_slave(project, kCoupler, {}), 0U);
  EXPECT_EQ(add_slave(project, kTerminal, 0), 1U);
  EXPECT_EQ(add_slave(project, kTerminal, 0), 2U);
  EXPECT_EQ(add_slave(project, kDrive, 2), 3U);
  EXPECT_EQ(add_slave(project, kCoupler, 3), 4U);
  EXPECT_EQ(add_slave(project, kTerminal, {}), 5U);
  return project;
}

TEST(SlaveEdits, PlugDevicesWhereTheyFit) {
  const auto project = plant();
  EXPECT_EQ(types(project), "coupler terminal terminal drive coupler terminal ");
  EXPECT_EQ(wiring(project), "- 0B 1B 0C 3B 4B ") << "terminals on the E-bus, drives on the cable";
}

TEST(SlaveEdits, GoOnALineInTheMiddle) {
  auto project = plant();
  EXPECT_EQ(add_slave(project, kTerminal, 1), 2U);
  EXPECT_EQ(add_slave(project, kDrive, 0), 4U);
  EXPECT_EQ(types(project), "coupler terminal terminal terminal drive drive coupler terminal ");
  EXPECT_EQ(wiring(project), "- 0B 1B 2B 0C 4B 5B 6B ");
  EXPECT_EQ(add_slave(project, kTerminal, 4), 4U) << "a terminal behind a drive goes to the coupler before it";
}

/// ESI files of old devices do not say what their ports are: any kind seems to fit, what hangs there says otherwise.
TEST(SlaveEdits, LookFurtherWhereAnUnknownPortDoesNotTakeIt) {
  Project project;
  EXPECT_EQ(add_slave(project, kCoupler, {}), 0U);
  EXPECT_EQ(add_slave(project, kTerminal, 0), 1U);
  EXPECT_EQ(add_slave(project, kUnknownDevice, 1), 2U);
  EXPECT_EQ(add_slave(project, kTerminal, 2), 3U);
  EXPECT_EQ(add_slave(project, kDrive, 3), 4U);
  EXPECT_EQ(wiring(project), "- 0B 1B 2B 0C ") << "on the coupler's cable";
  EXPECT_EQ(add_slave(project, kDrive, 2), 4U) << "behind the unknown one itself, too";
  EXPECT_EQ(types(project), "coupler terminal unknown terminal drive drive ");
  EXPECT_EQ(wiring(project), "- 0B 1B 2B 0C 4B ");
}

TEST(SlaveEdits, SayWhereNothingFits) {
  Project drives;
  ASSERT_TRUE(add_slave(drives, kDrive, {}));
  const auto before = drives;
  EXPECT_EQ(add_slave(drives, kTerminal, 0).error(), WiringObstacle::kNoPort);
  EXPECT_EQ(add_slave_at(drives, kDrive, {0, 2}).error(), WiringObstacle::kPortTaken) << "it has no port C";
  EXPECT_EQ(add_slave_at(drives, kTerminal, {0, 1}).error(), WiringObstacle::kOtherKind);
  EXPECT_EQ(add_slave(drives, kDrive, 7).error(), WiringObstacle::kNoSuchSlave);
  EXPECT_EQ(drives, before);
}

TEST(SlaveEdits, PutADeviceThatEndsALineAtTheEnd) {
  auto project = plant();
  EXPECT_EQ(add_slave(project, kLastTerminal, 1), 3U);
  EXPECT_EQ(types(project), "coupler terminal terminal last drive coupler terminal ");
  EXPECT_EQ(add_slave(project, kTerminal, 3), 3U) << "what is put behind it stands before it";
}

TEST(SlaveEdits, GiveNewSlavesAddressesAndNamesOfTheirOwn) {
  auto project = plant();
  project.slaves[1].station_address = 1007;
  const auto added = add_slave(project, kTerminal, 1);
  ASSERT_TRUE(added);
  EXPECT_EQ(project.slaves[*added].station_address, 1008);
  EXPECT_EQ(project.slaves[*added].name, "Slave_1008 [terminal]");
}

TEST(SlaveEdits, RemoveASlaveWithItsBranches) {
  auto project = plant();
  project.master.dc.reference_clock = 3;
  EXPECT_EQ(remove_slave(project, 0), 0U);
  EXPECT_EQ(types(project), "drive coupler terminal ");
  EXPECT_EQ(wiring(project), "- 0B 1B ");
  EXPECT_EQ(project.master.dc.reference_clock, 0) << "the same drive";
  EXPECT_EQ(remove_slave(project, 0), 0U);
  EXPECT_EQ(project.master.dc.reference_clock, std::nullopt) << "it is gone";
  EXPECT_EQ(remove_slave(project, 1), 0U);
  EXPECT_EQ(types(project), "coupler ");
  EXPECT_TRUE(remove_slave(project, 0));
  EXPECT_TRUE(project.slaves.empty());
}

TEST(SlaveEdits, CopyASlaveWithItsBranches) {
  auto project = plant();
  project.slaves[0].alias = 5;
  project.slaves[2].name = "Valve";
  EXPECT_EQ(duplicate_slave(project, 0), 3U);
  EXPECT_EQ(types(project), "coupler terminal terminal coupler terminal terminal drive coupler terminal ");
  EXPECT_EQ(wiring(project), "- 0B 1B 0C 3B 4B 3C 6B 7B ");
  EXPECT_EQ(project.slaves[3].alias, 0) << "no two slaves have one";
  EXPECT_EQ(project.slaves[5].name, "Valve (2)");
  std::set<std::uint16_t> addresses;
  for (const auto& slave : project.slaves) EXPECT_TRUE(addresses.insert(slave.station_address).second);
}

TEST(SlaveEdits, MoveUpAndDownInTheLine) {
  auto project = plant();
  project.master.dc.reference_clock = 3;
  EXPECT_EQ(move_slave_up(project, 3), 0U);
  EXPECT_EQ(types(project), "drive coupler terminal terminal coupler terminal ");
  EXPECT_EQ(wiring(project), "- 0B 1B 2B 1C 4B ");
  EXPECT_EQ(project.master.dc.reference_clock, 0);
  EXPECT_EQ(move_slave_up(project, 0).error(), WiringObstacle::kFirst);
  EXPECT_EQ(move_slave_up(project, 2).error(), WiringObstacle::kFirst) << "only its coupler is before it";
  EXPECT_EQ(move_slave_down(project, 0), 3U);
  EXPECT_EQ(project, [] {
    auto again = plant();
    again.master.dc.reference_clock = 3;
    return again;
  }());
  EXPECT_EQ(move_slave_down(project, 5).error(), WiringObstacle::kLast);
}

TEST(SlaveEdits, MoveBehindAnother) {
  auto project = plant();
  EXPECT_EQ(move_slave_behind(project, 1, 4), 5U) << "to the terminals of the other coupler, at the end";
  EXPECT_EQ(wiring(project), "- 0B 0C 2B 3B 4B ");
  EXPECT_EQ(move_slave_behind(project, 0, 1).error(), WiringObstacle::kBehindIt);
  EXPECT_EQ(move_slave_behind(project, 3, 0), 2U) << "the coupler takes its terminals along";
  EXPECT_EQ(types(project), "coupler terminal coupler terminal terminal drive ");
  EXPECT_EQ(move_slave_first(project, 5), 0U);
  EXPECT_EQ(types(project), "drive coupler terminal coupler terminal terminal ");
  EXPECT_EQ(move_slave_first(project, 2).error(), WiringObstacle::kOtherKind)
      << "a coupler does not hang at a terminal";
}

TEST(SlaveEdits, PutASlaveBetweenTwoOthersAndNowhereElse) {
  auto project = plant();
  EXPECT_EQ(add_slave_before(project, kTerminal, 1), 1U) << "the first terminal of the coupler";
  EXPECT_EQ(wiring(project), "- 0B 1B 2B 0C 4B 5B ");
  EXPECT_EQ(add_slave_before(project, kTerminal, 4), 4U) << "the last one: the drive behind it has no place for it";
  EXPECT_EQ(wiring(project), "- 0B 1B 2B 3B 0C 5B 6B ");
  EXPECT_EQ(add_slave_before(project, kDrive, 0), 0U);
  EXPECT_EQ(types(project), "drive coupler terminal terminal terminal terminal drive coupler terminal ");
  const auto before = project;
  EXPECT_EQ(add_slave_before(project, kDrive, 2).error(), WiringObstacle::kOtherKind) << "no cable among terminals";
  EXPECT_EQ(add_slave_before(project, kTerminal, 7).error(), WiringObstacle::kOtherKind);
  EXPECT_EQ(move_slave_before(project, 6, 3).error(), WiringObstacle::kOtherKind);
  EXPECT_EQ(move_slave_before(project, 1, 2).error(), WiringObstacle::kBehindIt);
  EXPECT_EQ(project, before);
  const auto address = project.slaves[5].station_address;
  EXPECT_EQ(move_slave_before(project, 5, 2), 2U);
  EXPECT_EQ(project.slaves[2].station_address, address);
  EXPECT_EQ(move_slave_before(project, 2, 6), 5U) << "back to the end of the terminals";
  EXPECT_EQ(project, before);
  EXPECT_EQ(move_slave_before(project, 7, 6), 6U) << "with its terminal";
  EXPECT_EQ(types(project), "drive coupler terminal terminal terminal terminal coupler terminal drive ");
}

TEST(SlaveEdits, PlugACableIntoAnotherPort) {
  Project project;
  for (const auto* one : {&kDrive, &kJunction, &kDrive, &kDrive}) ASSERT_TRUE(add_slave(project, *one, {}));
  EXPECT_EQ(wiring(project), "- 0B 1B 2B ");
  EXPECT_EQ(rewire_slave(project, 3, {1, 3}), 2U) << "port D is passed before port B";
  EXPECT_EQ(wiring(project), "- 0B 1D 1B ");
  EXPECT_EQ(rewire_slave(project, 1, {2, 1}).error(), WiringObstacle::kBehindIt);
  EXPECT_EQ(rewire_slave(project, 2, {1, 1}).error(), WiringObstacle::kPortTaken);
  EXPECT_EQ(rewire_slave(project, 2, {1, 0}).error(), WiringObstacle::kPortTaken) << "the way to the master";
}

TEST(SlaveEdits, KeepTheOrderOfAProjectWhoseWiringIsUnknown) {
  Project project;
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(add_slave(project, kUnknownDevice, {}));
  for (auto& slave : project.slaves) slave.previous.reset();
  const auto fifth = add_slave(project, kTerminal, 1);
  ASSERT_TRUE(fifth);
  EXPECT_EQ(*fifth, 2U);
  EXPECT_EQ(project.slaves[2].previous, (PreviousPort{1, 1}));
}

/// Two drives at the master; two, a coupler and a terminal of which nobody knows where they hang.
Project two_lines() {
  Project project;
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(add_slave(project, kDrive, {}));
  project.slaves[2].previous.reset();
  return project;
}

TEST(SlaveEdits, LeaveALineAloneThatIsNotMeant) {
  auto project = two_lines();
  EXPECT_EQ(wiring(project), "- 0B - 2B ");
  const auto address = project.slaves[3].station_address;
  EXPECT_EQ(move_slave_up(project, 3), 2U);
  EXPECT_EQ(project.slaves[2].station_address, address);
  EXPECT_EQ(wiring(project), "- 0B - 2B ") << "it took the place of the one before it, not of that at the master";
}

TEST(SlaveEdits, MoveToTheMasterThoughAnotherHangsAtNobody) {
  auto project = two_lines();
  const auto address = project.slaves[3].station_address;
  EXPECT_EQ(move_slave_first(project, 3), 0U);
  EXPECT_EQ(project.slaves[0].station_address, address);
  EXPECT_EQ(wiring(project), "- 0B 1B - ");
  EXPECT_EQ(move_slave_first(project, 3), 0U) << "it is plugged in itself";
  EXPECT_EQ(wiring(project), "- 0B 1B 2B ");
}

/// An order that is not what the wiring says stays, and a new slave stands behind the one that it hangs at.
TEST(SlaveEdits, PutASlaveBehindItsNeighbourWhereTheOrderIsNotThatOfTheFrame) {
  Project project;
  ASSERT_TRUE(add_slave(project, kJunction, {}));
  ASSERT_TRUE(add_slave_at(project, kDrive, {0, 2}));
  ASSERT_TRUE(add_slave_at(project, kDrive, {0, 3}));
  std::swap(project.slaves[1], project.slaves[2]);
  ASSERT_EQ(wiring(project), "- 0C 0D ") << "a frame comes to port D first";
  EXPECT_EQ(add_slave_at(project, kJunction, {1, 1}), 2U);
  EXPECT_EQ(types(project), "junction drive junction drive ");
  EXPECT_EQ(wiring(project), "- 0C 1B 0D ");
}

TEST(SlaveEdits, SayThatThereIsNoSuchSlave) {
  auto project = plant();
  const auto before = project;
  for (const std::size_t none : {project.slaves.size(), project.slaves.size() + 1}) {
    const EditedSlave edits[] = {add_slave(project, kDrive, none),    add_slave_before(project, kDrive, none),
                                 remove_slave(project, none),         duplicate_slave(project, none),
                                 move_slave_behind(project, none, 0), move_slave_behind(project, 0, none),
                                 move_slave_before(project, none, 0), move_slave_before(project, 0, none),
                                 move_slave_first(project, none),     move_slave_up(project, none),
                                 move_slave_down(project, none),      rewire_slave(project, none, {0, 1})};
    for (const auto& edit : edits) {
      EXPECT_EQ(edit, EditedSlave(tl::unexpected(WiringObstacle::kNoSuchSlave))) << &edit - edits;
    }
  }
  EXPECT_EQ(project, before);
}

TEST(SlaveEdits, TakeAPortThatNoSlaveHasForNone) {
  auto project = plant();
  for (const std::uint8_t port : {4, 9}) {
    project.slaves[3].previous->port = port;
    EXPECT_EQ(WiringTree::of(project.slaves).slaves()[3].previous, std::nullopt) << int{port};
  }
  const auto tree = WiringTree::of(project.slaves);
  EXPECT_EQ(tree.slaves()[3].previous, std::nullopt);
  EXPECT_TRUE(tree.behind(2).empty());
  project.slaves[3].device.physics = "YYYYYY";
  EXPECT_EQ(add_slave_at(project, kDrive, {3, 4}).error(), WiringObstacle::kPortTaken) << "there are four";
  EXPECT_EQ(move_slave_first(project, 3), 0U);
  EXPECT_EQ(wiring(project), "- 0B 1B 2B - 4B ") << "what hung behind it hangs at nobody as it did";
}

/// The slave and all that is behind it.
std::vector<std::size_t> subtree(const WiringTree& tree, std::size_t slave) {
  std::vector<std::size_t> all{slave};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& behind = tree.behind(all[i]);
    all.insert(all.end(), behind.begin(), behind.end());
  }
  return all;
}

/// Station addresses of those that are reached from the master.
std::set<std::uint16_t> at_the_master(const Project& project) {
  std::set<std::uint16_t> addresses;
  if (project.slaves.empty()) return addresses;
  for (const auto one : subtree(WiringTree::of(project.slaves), 0))
    addresses.insert(project.slaves[one].station_address);
  return addresses;
}

/// Who was reached from the master and neither went nor moved still is.
void expect_reached(const Project& before, const Project& after, const std::vector<std::size_t>& moved) {
  auto stayed = at_the_master(before);
  for (const auto one : moved) stayed.erase(before.slaves[one].station_address);
  const auto now = at_the_master(after);
  RC_ASSERT(std::ranges::includes(now, stayed) || stayed.empty());
}

/// What every edit has to leave behind.
void expect_sound(const Project& project, std::uint16_t reference_address) {
  std::vector<std::size_t> positions(project.slaves.size());
  std::iota(positions.begin(), positions.end(), std::size_t{0});
  RC_ASSERT(WiringTree::of(project.slaves).frame_order() == positions);
  std::set<std::uint16_t> addresses;
  std::set<std::pair<std::uint16_t, std::uint8_t>> ports;
  std::set<std::string> names;
  std::size_t loose = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto& slave = project.slaves[i];
    RC_ASSERT(addresses.insert(slave.station_address).second);
    RC_ASSERT(names.insert(slave.name).second);
    loose += slave.previous ? 0U : 1U;
    RC_ASSERT(!slave.previous || i > 0);
    if (!slave.previous) continue;
    RC_ASSERT(slave.previous->position < i);
    RC_ASSERT(ports.insert({slave.previous->position, slave.previous->port}).second);
    const auto& before = project.slaves[slave.previous->position].device;
    RC_ASSERT(ports_fit(port_kind(before, slave.previous->port), port_kind(slave.device, 0)));
  }
  RC_ASSERT(loose <= 2);
  const auto& reference = project.master.dc.reference_clock;
  if (reference) RC_ASSERT(project.slaves[*reference].station_address == reference_address);
}

TEST(SlaveEdits, LeaveASoundProjectWhateverIsDone) {
  EXPECT_TRUE(rc::check("any edits in any order", [] {
    auto project = plant();
    project.master.dc.reference_clock = 3;
    const auto reference = project.slaves[3].station_address;
    if (*rc::gen::arbitrary<bool>()) project.slaves[4].previous.reset();
    // One of which nobody knows the ports joins what fits nothing else: it stays out.
    const auto devices = std::array{kCoupler, kTerminal, kDrive, kJunction, kLastTerminal};
    const auto steps = *rc::gen::inRange(1, 30);
    for (int i = 0; i < steps && !project.slaves.empty(); ++i) {
      const auto at = *rc::gen::inRange<std::size_t>(0, project.slaves.size());
      const auto other = *rc::gen::inRange<std::size_t>(0, project.slaves.size());
      const auto& made = devices[*rc::gen::inRange<std::size_t>(0, devices.size())];
      const PreviousPort port{static_cast<std::uint16_t>(other), *rc::gen::inRange<std::uint8_t>(0, 4)};
      const auto before = project;
      const auto address = project.slaves[at].station_address;
      const auto kind = *rc::gen::inRange(0, 12);
      const auto done = kind < 2     ? add_slave(project, made, at)
                        : kind == 2  ? add_slave_at(project, made, port)
                        : kind == 3  ? remove_slave(project, at)
                        : kind == 4  ? duplicate_slave(project, at)
                        : kind == 5  ? move_slave_behind(project, at, other)
                        : kind == 6  ? move_slave_up(project, at)
                        : kind == 7  ? move_slave_down(project, at)
                        : kind == 8  ? move_slave_first(project, at)
                        : kind == 9  ? rewire_slave(project, at, port)
                        : kind == 10 ? move_slave_before(project, at, other)
                                     : add_slave_before(project, made, at);
      if (!done) RC_ASSERT(project == before);
      if (done && kind > 4 && kind < 11) RC_ASSERT(project.slaves[*done].station_address == address);
      const auto tree = WiringTree::of(before.slaves);
      const bool in_its_line = kind < 3 || kind == 4 || kind == 6 || kind == 7 || kind == 11;
      expect_reached(before, project,
                     in_its_line ? std::vector<std::size_t>{}
                     : kind == 9 ? subtree(tree, at)
                                 : tree.group(at));
      expect_sound(project, reference);
    }
  }));
}

}  // namespace
}  // namespace syncline
