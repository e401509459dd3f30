// SPDX-License-Identifier: Apache-2.0
#include "config/module_slots.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/modular_device.h"

namespace syncline {
namespace {

using sample::gateway;
using sample::kAxis;
using sample::kIo;
using sample::module;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(ModuleSlots, PlacesCountIncrementsOfThoseBefore) {
  const auto device = gateway();
  const auto places = slot_places(device);
  ASSERT_EQ(places.size(), 4U);
  EXPECT_EQ(places[1].pdo_offset, 0);  // the first slot moves nothing
  EXPECT_EQ(places[3].pdo_offset, 0x20);
  EXPECT_EQ(places[3].index_offset, 0x1000);
  EXPECT_TRUE(places[1].demanded);
  EXPECT_FALSE(places[2].demanded);
}

/// ETG.2000, SlotGroup: a module's indices move by the number of its group, too, where it says so.
TEST(ModuleSlots, PlacesMoveByTheirGroup) {
  auto device = gateway();
  device.slots->increments.slot_group_pdo = 0x40;
  device.slots->increments.slot_group_index = 0x100;
  device.slots->slots[1].slot_group = 3;
  device.slots->slots[1].increments.slot_group_index = 0x200;
  const auto places = slot_places(device);
  ASSERT_EQ(places.size(), 4U);
  EXPECT_EQ(places[0].group_pdo_offset, 0);
  EXPECT_EQ(places[0].group_index_offset, 0);
  EXPECT_EQ(places[2].group_pdo_offset, 0xC0);
  EXPECT_EQ(places[2].group_index_offset, 0x600) << "the slot's own increment before that of all";
  EXPECT_EQ(places[2].pdo_offset, 0x10);
}

/// Each index moves by what it depends on, and by nothing else.
TEST(ModuleSlots, AModuleMovesWhatDependsOnItsPlace) {
  SlotPlace place;
  place.pdo_offset = 0x10;
  place.index_offset = 0x800;
  place.group_pdo_offset = 0x20;
  place.group_index_offset = 0x1000;
  for (const bool slot : {false, true}) {
    for (const bool group : {false, true}) {
      auto fixed = module(kAxis, 0x1600, 0x1A00, 0x6040, 16);
      for (auto* pdo : {&fixed.rx_pdos[0], &fixed.tx_pdos[0]}) {
        pdo->depend_on_slot = pdo->entries[0].depend_on_slot = slot;
        pdo->depend_on_slot_group = pdo->entries[0].depend_on_slot_group = group;
        pdo->exclude = {0x1650, 0x1651};
        pdo->exclude_by_slot = {0x1651};
      }
      StartupCommand command;
      command.index = 0x8000;
      command.depend_on_slot = slot;
      command.depend_on_slot_group = group;
      fixed.coe.emplace().init_commands = {command};
      const auto made = module_at(fixed, place);
      const auto pdo_moved = (slot ? 0x10 : 0) + (group ? 0x20 : 0);
      const auto object_moved = (slot ? 0x800 : 0) + (group ? 0x1000 : 0);
      EXPECT_EQ(made.rx_pdos[0].index, 0x1600 + pdo_moved);
      EXPECT_EQ(made.tx_pdos[0].index, 0x1A00 + pdo_moved);
      EXPECT_EQ(made.rx_pdos[0].entries[0].index, 0x6040 + object_moved);
      EXPECT_EQ(made.tx_pdos[0].entries[0].index, 0x6041 + object_moved);
      EXPECT_THAT(made.rx_pdos[0].exclude, ElementsAre(0x1650, 0x1661 + (group ? 0x20 : 0)));
      EXPECT_EQ(made.coe->init_commands[0].index, 0x8000 + object_moved);
      EXPECT_FALSE(made.rx_pdos[0].depend_on_slot || made.rx_pdos[0].depend_on_slot_group);
    }
  }
}

/// Whatever was plugged first: the PDOs of the device, then those of the modules by their places.
TEST(ModuleSlots, TheDevicesOwnPdosComeFirst) {
  auto device = gateway();
  device.slots->slots[1].modules[0].is_default = false;
  device.slots->slots[1].min_instances = 0;
  for (const std::uint16_t index : {0x1680, 0x1681, 0x1682}) {
    device.rx_pdos.push_back(sample::pdo(index, "Own", 2, {{0x7FFF, 1, 8, "Own", "USINT"}}));
  }
  device.rx_pdos[2].sync_manager.reset();
  auto slave = default_slave(device, 0);
  ASSERT_THAT(slave.modules, IsEmpty());
  ASSERT_TRUE(plug_module(slave, 0, kIo));
  EXPECT_THAT(slave.assigned_rx_pdos, ElementsAre(0x1680, 0x1681, 0x1601));
  slave.assigned_rx_pdos.push_back(0x1682);
  ASSERT_TRUE(plug_module(slave, 2, kAxis));
  EXPECT_THAT(slave.assigned_rx_pdos, ElementsAre(0x1680, 0x1681, 0x1682, 0x1601, 0x1610));
}

TEST(ModuleSlots, NoMoreThanTheDeviceTakes) {
  auto device = gateway();
  device.slots->slots[1].max_instances = 0xFFFF;
  EXPECT_EQ(slot_places(device).size(), 1024U);
  device.slots->max_slot_count = 12;
  EXPECT_EQ(slot_places(device).size(), 12U);
}

TEST(ModuleSlots, DefaultsArePlugged) {
  const auto slave = default_slave(gateway(), 0);
  EXPECT_THAT(slave.modules, ElementsAre(PluggedModule{1, kAxis}, PluggedModule{2, kAxis}, PluggedModule{3, kAxis}));
  EXPECT_THAT(slave.assigned_rx_pdos, ElementsAre(0x1600, 0x1610, 0x1620));
  EXPECT_THAT(slave.assigned_tx_pdos, ElementsAre(0x1A00, 0x1A10, 0x1A20));
}

TEST(ModuleSlots, PullingTakesBackWhatPluggingBrought) {
  auto slave = default_slave(gateway(), 0);
  const auto before = slave;
  ASSERT_TRUE(plug_module(slave, 2, kIo));
  EXPECT_THAT(slave.assigned_rx_pdos, ElementsAre(0x1600, 0x1611, 0x1620));
  ASSERT_TRUE(plug_module(slave, 2, std::nullopt));
  EXPECT_THAT(slave.assigned_rx_pdos, ElementsAre(0x1600, 0x1620));
  EXPECT_EQ(slave.startup.size(), before.startup.size() - 1);
  ASSERT_TRUE(plug_module(slave, 2, kAxis));
  EXPECT_EQ(slave.assigned_rx_pdos, before.assigned_rx_pdos);
  EXPECT_EQ(slave.modules, before.modules);
}

TEST(ModuleSlots, APdoThatTheModuleOverwritesIsTheModules) {
  auto device = gateway();
  device.rx_pdos = {sample::pdo(0x16FF, "Own", 2, {{0x7FFF, 1, 8, "Own", "USINT"}}),
                    sample::pdo(0x1600, "Place holder", 2, {{0x7000, 1, 8, "Nothing", "USINT"}})};
  device.rx_pdos[1].overwritten_by_module = true;
  auto slave = sample::slave(device, 0);
  EXPECT_EQ(pdo_of(slave, 0x1600)->name, "Place holder");
  ASSERT_TRUE(plug_module(slave, 1, kAxis));
  std::vector<std::uint16_t> indices;
  for (const auto& pdo : pdos_of(slave, PdoDirection::kRx)) indices.push_back(pdo.index);
  EXPECT_THAT(indices, ElementsAre(0x16FF, 0x1600));
  EXPECT_EQ(pdo_of(slave, 0x1600)->name, "Outputs");
  // A PDO of the device that is no place holder stays beside one of the same index, which check names.
  slave.device.rx_pdos[1].overwritten_by_module = false;
  EXPECT_EQ(pdos_of(slave, PdoDirection::kRx).size(), 3U);
}

TEST(ModuleSlots, TheDeviceWithItsModulesHasTheirPdosOfBothDirections) {
  auto slave = default_slave(gateway(), 0);
  const auto device = device_with_modules(slave);
  EXPECT_THAT(device.rx_pdos, testing::SizeIs(3));
  EXPECT_THAT(device.tx_pdos, testing::SizeIs(3));
  ASSERT_TRUE(plug_module(slave, 2, std::nullopt));
  EXPECT_THAT(device_with_modules(slave).rx_pdos, testing::SizeIs(2));
  EXPECT_THAT(device_with_modules(slave).tx_pdos, testing::SizeIs(2));
}

TEST(ModuleSlots, WhatDoesNotFitIsRefused) {
  auto slave = default_slave(gateway(), 0);
  const auto before = slave;
  EXPECT_THAT(plug_module(slave, 0, kAxis).error().detail.text(), HasSubstr("these do: 0x00000200 M512"));
  EXPECT_THAT(plug_module(slave, 4, kAxis).error().detail.text(), HasSubstr("4 places"));
  EXPECT_EQ(slave, before);
}

TEST(ModuleSlots, ARefusalNamesEightThatFitAndCountsTheOthers) {
  auto device = gateway();
  auto& slot = device.slots->slots[0];
  slot.modules.clear();
  for (std::uint32_t ident = 0x301; ident <= 0x309; ++ident) {
    device.modules.push_back(module(ident, 0x1601, 0x1A01, 0x7000, 8));
    slot.modules.push_back({ident, false});
    auto slave = sample::slave(device, 0);
    const auto text = plug_module(slave, 0, kAxis).error().detail.text();
    const bool all = ident < 0x309;
    EXPECT_THAT(text, HasSubstr(fmt::format("0x{:08x} M{}{}", all ? ident : 0x308, all ? ident : 0x308,
                                            all ? "" : " and 1 more")));
  }
}

TEST(ModuleSlots, GroupsComeInOrderAndAligned) {
  auto device = gateway();
  ModulePdoGroup group;
  group.alignment = 2;
  group.rx_pdo = 0x16FF;
  device.rx_pdos = {sample::pdo(0x16FF, "Gap", std::nullopt, {{0, 0, 8, "", ""}})};
  device.slots->pdo_groups = {group};
  device.modules[0].pdo_group = 1;
  auto slave = default_slave(device, 0);
  ASSERT_TRUE(plug_module(slave, 0, kIo));
  ASSERT_TRUE(plug_module(slave, 3, std::nullopt));
  EXPECT_THAT(slave.assigned_rx_pdos, ElementsAre(0x1601, 0x16FF, 0x1600, 0x1610));  // 8 bits, gap, the axes
}

}  // namespace
}  // namespace syncline
