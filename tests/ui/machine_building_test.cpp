// SPDX-License-Identifier: Apache-2.0
// A machine is built offline in the tree: by keys and by dragging.
#include <gtest/gtest.h>

#include <QLineEdit>

#include "support/building_window.h"
#include "ui/dialogs/slave_commands.h"
#include "ui/machine_building.h"
#include "ui/models/dragged.h"

namespace syncline::ui {
namespace {

using test::Building;

TEST_F(Building, EditsTheTreeByKeys) {
  const auto before = project();
  const int steps_before = steps();
  window_.selectNode(0);
  press(Qt::Key_D, Qt::ControlModifier);
  EXPECT_EQ(types(), QStringLiteral("Coupler Terminal Terminal Coupler Terminal Terminal Junction Drive"));
  EXPECT_EQ(selected(), 3) << "the copy";
  EXPECT_EQ(steps(), steps_before + 1);
  press(Qt::Key_Down, Qt::AltModifier);
  EXPECT_EQ(types(), QStringLiteral("Coupler Terminal Terminal Junction Coupler Terminal Terminal Drive"));
  EXPECT_EQ(selected(), 4) << "selection follows";
  press(Qt::Key_Up, Qt::AltModifier);
  EXPECT_EQ(selected(), 3);
  press(Qt::Key_Delete);
  EXPECT_EQ(types(), QStringLiteral("Coupler Terminal Terminal Junction Drive"));
  EXPECT_EQ(steps(), steps_before + 4);
  for (int i = 0; i < 4; ++i) QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(project(), before);
}

TEST_F(Building, SaysWhyASlaveStays) {
  const int steps_before = steps();
  window_.selectNode(1);
  press(Qt::Key_Up, Qt::AltModifier);
  EXPECT_EQ(steps(), steps_before);
  QString told;
  QObject::connect(&window_.building().commands(), &SlaveCommands::told, [&](const QString& text) { told = text; });
  press(Qt::Key_Up, Qt::AltModifier);
  EXPECT_EQ(told, obstacleText(WiringObstacle::kFirst));
}

TEST_F(Building, KeepsTheSelectedSlaveOverUndo) {
  window_.selectNode(0);
  press(Qt::Key_D, Qt::ControlModifier);
  window_.selectNode(7);
  QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(selected(), 4) << "the same drive";
}

TEST_F(Building, KeysOfTheExplorerAreNotThoseOfAField) {
  show(1, "slaveGeneralPage");
  auto* name = window_.findChild<QLineEdit*>(QStringLiteral("field_name"));
  for (auto* one : window_.editor().findChildren<QLineEdit*>()) {
    if (name == nullptr && one->isVisible() && one->isEnabled() && !one->isReadOnly()) name = one;
  }
  ASSERT_NE(name, nullptr);
  name->setFocus();
  QTest::keyClick(name, Qt::Key_Home);
  QTest::keyClick(name, Qt::Key_Delete);
  EXPECT_EQ(project().slaves.size(), 5U);
}

TEST_F(Building, MovesASlaveThatIsDroppedOnAnother) {
  const auto address = project().slaves[1].station_address;
  ASSERT_TRUE(drop(*dragged(1), tree().visualRect(workspace_.network().indexOf(2)).center()));
  EXPECT_EQ(project().slaves[2].station_address, address);
  EXPECT_EQ(selected(), 2);
}

/// Most of the explorer is free room; a new machine has nothing but it.
TEST_F(Building, PutsWhatIsDroppedIntoTheFreeRoomBehindTheLastSlave) {
  const auto below = tree().visualRect(workspace_.network().indexOf(4)).bottomLeft() + QPoint(60, 80);
  ASSERT_FALSE(tree().indexAt(below).isValid());
  const auto address = project().slaves[3].station_address;
  ASSERT_TRUE(drop(*dragged(3), below));
  EXPECT_EQ(project().slaves.back().station_address, address);
  EXPECT_EQ(selected(), 4);
}

TEST_F(Building, DropsLandWhereTheLineIsDrawn) {
  auto& network = workspace_.network();
  const auto put = [&](int slave, int row, int parent) {
    const auto address = project().slaves[static_cast<std::size_t>(slave)].station_address;
    EXPECT_TRUE(network.dropMimeData(dragged(slave).get(), Qt::MoveAction, row, 0, network.indexOf(parent)));
    return network.slaveAt(address);
  };
  EXPECT_EQ(put(2, 0, 0), 1) << "above the first terminal";
  EXPECT_EQ(put(1, 2, 0), 2) << "below the last one";
  EXPECT_EQ(put(4, 1, -1), 3) << "between coupler and junction";
  EXPECT_EQ(put(4, 0, -1), 0) << "above all";
  EXPECT_EQ(types(), QStringLiteral("Junction Coupler Terminal Terminal Drive"));
  EXPECT_EQ(put(4, -1, -1), 0) << "on the master";
  const auto before = project();
  EXPECT_EQ(put(0, 1, 2), 0) << "no cable between terminals";
  EXPECT_EQ(project(), before) << "nor anywhere else";
  const int coupler = network.slaveAt(1001);
  const auto row = tree().visualRect(network.indexOf(coupler));
  const auto last = project().slaves[static_cast<std::size_t>(coupler) + 2].station_address;
  ASSERT_TRUE(drop(*dragged(coupler + 2), {row.center().x(), row.bottom()}));
  EXPECT_EQ(network.slaveAt(last), coupler + 1) << "the line is drawn above the first terminal";
}

TEST_F(Building, TakesWhatIsDraggedForWhatItIs) {
  auto& network = workspace_.network();
  QMimeData other;
  other.setData(kSlaveMime, "1");
  EXPECT_FALSE(network.canDropMimeData(&other, Qt::MoveAction, -1, 0, network.indexOf(2))) << "of another window";
  const auto terminal = dragged(1), drive = dragged(4);
  window_.selectNode(1);
  press(Qt::Key_Delete);
  EXPECT_FALSE(network.canDropMimeData(terminal.get(), Qt::MoveAction, -1, 0, network.indexOf(2))) << "it is gone";
  ASSERT_TRUE(network.dropMimeData(drive.get(), Qt::MoveAction, 0, 0, network.indexOf(-1)));
  EXPECT_EQ(types(), QStringLiteral("Drive Coupler Terminal Junction"));
}

}  // namespace
}  // namespace syncline::ui
