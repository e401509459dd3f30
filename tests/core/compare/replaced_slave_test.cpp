// SPDX-License-Identifier: Apache-2.0
#include "compare/replaced_slave.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "config/slave_edits.h"
#include "settings/setting_type.h"

namespace syncline {
namespace {

DeviceDescription product(const char* type, const char* physics, std::uint32_t code) {
  DeviceDescription made;
  made.type = type;
  made.physics = physics;
  made.identity = {1516, code, 1, 0};
  return made;
}

/// Coupler, terminal, drive.
Project three() {
  Project project;
  EXPECT_TRUE(add_slave(project, product("coupler", "YKY", 1), {}));
  EXPECT_TRUE(add_slave(project, product("terminal", "KK", 2), 0));
  EXPECT_TRUE(add_slave(project, product("drive", "YY", 3), 0));
  return project;
}

TEST(ReplaceDevice, KeepsThePlaceAndTheNameThatTheUserGave) {
  auto project = three();
  const auto other = product("other", "YY", 4);
  const auto by_default = replace_device(project, 2, other);
  ASSERT_TRUE(by_default);
  const auto& now = by_default->project.slaves[2];
  EXPECT_EQ(now.device, other);
  EXPECT_EQ(now.previous, project.slaves[2].previous);
  EXPECT_EQ(now.station_address, project.slaves[2].station_address);
  EXPECT_EQ(now.name, default_name(now.station_address, other)) << "a default name is that of the new device";
  project.slaves[2].name = "Axis";
  EXPECT_EQ(replace_device(project, 2, other)->project.slaves[2].name, "Axis");
}

TEST(ReplaceDevice, SaysWhatDoesNotLetItStandThere) {
  const auto project = three();
  EXPECT_EQ(replace_device(project, 3, product("other", "YY", 4)).error(), WiringObstacle::kNoSuchSlave);
  EXPECT_EQ(replace_device(project, 1, product("other", "YY", 4)).error(), WiringObstacle::kOtherKind)
      << "a cable does not go into the E-bus";
  EXPECT_EQ(replace_device(project, 0, product("other", "YY", 4)).error(), WiringObstacle::kNoPort)
      << "its terminals need an E-bus";
  EXPECT_TRUE(replace_device(project, 0, product("other", "YKY", 4)));
}

TEST(ReplaceDevice, LeavesWhatWasWiredOtherwiseByHand) {
  auto project = three();
  project.slaves[2].previous = PreviousPort{1, 1};
  EXPECT_TRUE(replace_device(project, 2, product("other", "YY", 4))) << "it did not fit before, either";
}

/// A device with the TxPDOs 0x1A00 and 0x1A01; one of them is assigned by default.
DeviceDescription sender(std::uint32_t code, std::uint16_t by_default) {
  auto made = product("sender", "YY", code);
  for (const std::uint16_t index : {0x1A00, 0x1A01}) {
    Pdo pdo;
    pdo.index = index;
    if (index == by_default) pdo.sync_manager = std::uint8_t{3};
    made.tx_pdos.push_back(pdo);
  }
  return made;
}

TEST(ReplaceDevice, TakesDefaultsOfAnotherProductAndKeepsThoseOfARevision) {
  using Indices = std::vector<std::uint16_t>;
  Project project;
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(add_slave(project, sender(7, 0x1A00), {}));
  project.slaves[1].assigned_tx_pdos = {0x1A00, 0x1A01};
  const auto assigned = [&](std::size_t slave, std::uint32_t code) {
    return replace_device(project, slave, sender(code, 0x1A01))->project.slaves[slave].assigned_tx_pdos;
  };
  EXPECT_EQ(assigned(0, 8), Indices{0x1A01}) << "nobody chose the default of the old product";
  EXPECT_EQ(assigned(1, 8), (Indices{0x1A00, 0x1A01})) << "the user chose it";
  EXPECT_EQ(assigned(0, 7), Indices{0x1A00}) << "another revision is set up as the old one was";
}

TEST(ReplaceDevice, NamesWhatTheNewDeviceDoesNotTake) {
  Project project;
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(add_slave(project, sender(7, 0x1A00), {}));
  project.slaves[1].assigned_tx_pdos = {0x1A01};
  project.slaves[1].alias = 5;
  const auto replaced = replace_device(project, 1, product("other", "YY", 8));
  ASSERT_TRUE(replaced);
  EXPECT_EQ(replaced->lost, std::vector<std::string>{"slave.1.pdo.tx"});
  EXPECT_EQ(replaced->project.slaves[1].alias, 5);
  EXPECT_TRUE(replace_device(project, 0, product("other", "YY", 8))->lost.empty()) << "what nobody chose is not missed";
}

}  // namespace
}  // namespace syncline
