// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config/slave_settings.h"

/// ETG.2000, OpMode/Sm/Pdo: an operation mode may bring its own assignment of PDOs.
namespace syncline {
namespace {

using testing::ElementsAre;

Pdo pdo(std::uint16_t index, std::uint8_t sync_manager) {
  Pdo made;
  made.index = index;
  made.sync_manager = sync_manager;
  return made;
}

DcOpMode mode(const char* name, std::vector<OpModeSyncManager> managers) {
  DcOpMode made;
  made.name = name;
  made.sync_managers = std::move(managers);
  return made;
}

OpModeSyncManager manager(std::uint8_t number, std::vector<std::uint16_t> pdos) {
  OpModeSyncManager made;
  made.number = number;
  made.pdos = std::move(pdos);
  return made;
}

SlaveSettings with_modes() {
  SlaveSettings slave;
  slave.device.rx_pdos = {pdo(0x1600, 2), pdo(0x1601, 2), pdo(0x1610, 4)};
  slave.device.tx_pdos = {pdo(0x1A00, 3), pdo(0x1A01, 3)};
  slave.assigned_rx_pdos = {0x1600, 0x1610};
  slave.assigned_tx_pdos = {0x1A00};
  slave.device.dc.emplace().op_modes = {mode("Plain", {manager(2, {}), manager(3, {})}),
                                        mode("Short", {manager(2, {0x1601}), manager(3, {0x1A01, 0x1A00})}),
                                        mode("Foreign", {manager(2, {0x1601, 0x16FF})})};
  return slave;
}

TEST(OpModeAssignment, TakesThePlaceOfWhatItsSyncManagerCarries) {
  auto slave = with_modes();
  select_op_mode(slave, "Short");
  EXPECT_EQ(slave.dc.op_mode, "Short");
  EXPECT_THAT(slave.assigned_rx_pdos, ElementsAre(0x1610, 0x1601)) << "SM4 keeps what it has";
  EXPECT_THAT(slave.assigned_tx_pdos, ElementsAre(0x1A01, 0x1A00));
}

TEST(OpModeAssignment, StaysWhereTheModeSaysNothingOrNamesWhatIsNotThere) {
  for (const char* name : {"Plain", "Foreign", "None of these", ""}) {
    auto slave = with_modes();
    select_op_mode(slave, name);
    EXPECT_EQ(slave.dc.op_mode, name);
    EXPECT_THAT(slave.assigned_rx_pdos, ElementsAre(0x1600, 0x1610)) << name;
    EXPECT_THAT(slave.assigned_tx_pdos, ElementsAre(0x1A00)) << name;
  }
}

}  // namespace
}  // namespace syncline
