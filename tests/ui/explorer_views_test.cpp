// SPDX-License-Identifier: Apache-2.0
// The views of the explorer: classic, flat, and the topology with its cables.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QScrollBar>
#include <QTemporaryDir>

#include "eni/project/project_file.h"
#include "settings/settings_table.h"
#include "support/building_window.h"

namespace syncline::ui {
namespace {

using test::Building;
using test::plain;

TEST_F(Building, ShowsAProjectWithAPortThatNoSlaveHas) {
  auto odd = project();
  odd.slaves[3].previous->port = 9;
  QTemporaryDir folder;
  const auto path = folder.filePath(QStringLiteral("odd.syncline"));
  ASSERT_TRUE(eni::save_project(odd, path.toStdString()));
  ASSERT_TRUE(workspace_.document().load(path));
  for (const auto view : {ExplorerPanel::View::kClassic, ExplorerPanel::View::kTopology}) {
    window_.explorer().setView(view);
    window_.selectNode(3);
    topology().viewport()->repaint();
  }
  const auto& row = settings::row("slave.N.previous");
  auto written = odd;
  EXPECT_FALSE(row.write(written, {.slave = 3}, row.read(odd, {.slave = 3}))) << "it is no port of another slave";
  EXPECT_EQ(written, odd);
  ASSERT_TRUE(move_slave_first(odd, 3));
}

TEST_F(Building, ShowsTheTreeByWiringAndByPosition) {
  auto& network = workspace_.network();
  const QAbstractItemModelTester tester(&network, QAbstractItemModelTester::FailureReportingMode::Fatal);
  QTest::keyClick(&window_, Qt::Key_1, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(network.rowCount(network.indexOf(-1)), 3) << "coupler, junction, drive";
  EXPECT_EQ(network.rowCount(network.indexOf(0)), 2) << "its terminals";
  window_.selectNode(2);
  QTest::keyClick(&window_, Qt::Key_2, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(network.rowCount(network.indexOf(-1)), 5);
  EXPECT_EQ(selected(), 2);
  EXPECT_TRUE(network.indexOf(2).data(Qt::AccessibleTextRole).toString().contains(QStringLiteral("position 2")));
}

/// What the mouse takes stays below it; a cable that is let go of elsewhere selects nothing and hides nothing.
TEST_F(Building, TheMouseMovesNoPaperAndNoSelection) {
  QTest::keyClick(&window_, Qt::Key_3, Qt::ControlModifier | Qt::AltModifier);
  window_.selectNode(0);
  auto* paper = topology().viewport();
  auto box = topology().visualRect(workspace_.network().indexOf(1));
  auto* bar = topology().horizontalScrollBar();
  bar->setValue(bar->value() + box.left() - paper->width() + 20);
  box = topology().visualRect(workspace_.network().indexOf(1));
  ASSERT_TRUE(box.right() > paper->width() && box.left() < paper->width()) << "one half is seen";
  const int before = bar->value();
  const QPoint from(box.left() + 10, box.center().y()), to(from.x() - 8, paper->height() - 4);
  ASSERT_FALSE(topology().indexAt(to).isValid());
  QTest::mousePress(paper, Qt::LeftButton, {}, from);
  topology().scrollTo(topology().currentIndex());  // as views do when the time for a second click is over
  EXPECT_EQ(selected(), 1);
  EXPECT_EQ(bar->value(), before);
  QMouseEvent move(QEvent::MouseMove, to, paper->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(paper, &move);
  QTest::mouseRelease(paper, Qt::LeftButton, {}, to);
  EXPECT_EQ(bar->value(), before);
  EXPECT_TRUE(topology().selectionModel()->isSelected(workspace_.network().indexOf(1)));
  topology().setFocus();
  QTest::keyClick(&topology(), Qt::Key_Down);
  EXPECT_EQ(selected(), 2);
  EXPECT_NE(bar->value(), before) << "by keys it comes into sight";
}

/// The slave whose pages are shown is the one that is marked.
TEST_F(Building, AClickIntoTheFreeRoomSelectsNobodyElse) {
  window_.resize(1400, 900);
  for (const auto view : {ExplorerPanel::View::kClassic, ExplorerPanel::View::kFlat, ExplorerPanel::View::kTopology}) {
    window_.explorer().setView(view);
    window_.selectNode(2);
    auto& shown = view == ExplorerPanel::View::kTopology ? static_cast<QAbstractItemView&>(topology()) : tree();
    const QPoint free(shown.viewport()->width() / 2, shown.viewport()->height() - 5);
    ASSERT_FALSE(shown.indexAt(free).isValid());
    QTest::mouseClick(shown.viewport(), Qt::LeftButton, {}, free);
    EXPECT_EQ(selected(), 2);
    EXPECT_TRUE(shown.selectionModel()->isSelected(workspace_.network().indexOf(2))) << static_cast<int>(view);
  }
}

TEST_F(Building, RewiresByDraggingACableToAFreePort) {
  const QAbstractItemModelTester tester(&workspace_.network(), QAbstractItemModelTester::FailureReportingMode::Fatal);
  window_.resize(1400, 900);
  QTest::keyClick(&window_, Qt::Key_3, Qt::ControlModifier | Qt::AltModifier);
  topology().setZoom(0.6);
  const int steps_before = steps();
  const auto drag = [this](int slave, QPoint to) {
    auto* paper = topology().viewport();
    const auto from = topology().visualRect(workspace_.network().indexOf(slave)).center();
    QTest::mousePress(paper, Qt::LeftButton, {}, from);
    for (const auto point : {(from + to) / 2, to}) {
      QMouseEvent move(QEvent::MouseMove, point, paper->mapToGlobal(point), Qt::NoButton, Qt::LeftButton, {});
      QApplication::sendEvent(paper, &move);
    }
    QTest::mouseRelease(paper, Qt::LeftButton, {}, to);
  };
  ASSERT_EQ(project().slaves[4].previous, (PreviousPort{3, 1}));
  drag(4, topology().portPosition(3, 3));
  EXPECT_EQ(project().slaves[4].previous, (PreviousPort{3, 3}));
  EXPECT_EQ(steps(), steps_before + 1);
  drag(1, topology().portPosition(3, 2));
  EXPECT_EQ(steps(), steps_before + 1) << "a terminal does not fit there";
  QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(project().slaves[4].previous, (PreviousPort{3, 1}));
}

TEST_F(Building, WalksThroughTheTopologyByKeys) {
  QTest::keyClick(&window_, Qt::Key_3, Qt::ControlModifier | Qt::AltModifier);
  window_.selectNode(0);
  topology().setFocus();
  QTest::keyClick(&topology(), Qt::Key_Right);
  EXPECT_EQ(selected(), 1) << "into the branch";
  QTest::keyClick(&topology(), Qt::Key_Down);
  EXPECT_EQ(selected(), 2);
  QTest::keyClick(&topology(), Qt::Key_Left);
  EXPECT_EQ(selected(), 0) << "back to its coupler";
  QTest::keyClick(&topology(), Qt::Key_Down);
  EXPECT_EQ(selected(), 3) << "on along the line";
}

/// A hundred couplers with nine terminals each.
Project thousand() {
  const auto coupler = plain("Coupler", "YKY"), terminal = plain("Terminal", "KK");
  Project project;
  for (std::uint16_t i = 0; i < 1000; ++i) {
    auto slave = default_slave(i % 10 == 0 ? coupler : terminal, i);
    if (i % 10 != 0) slave.previous = PreviousPort{static_cast<std::uint16_t>(i - 1), 1};
    if (i % 10 == 0 && i > 0) slave.previous = PreviousPort{static_cast<std::uint16_t>(i - 10), 2};
    project.slaves.push_back(std::move(slave));
  }
  return project;
}

class Thousand : public Building {
 protected:
  Thousand() : Building(thousand()) {}
};

/// How long it takes is timed by scripts/bench.
TEST_F(Thousand, AreShownChosenAndMoved) {
  window_.explorer().setView(ExplorerPanel::View::kTopology);
  window_.selectNode(371);
  EXPECT_EQ(selected(), 371);
  const auto moved = project().slaves[500].station_address;
  window_.selectNode(500);
  topology().setFocus();
  QTest::keyClick(&topology(), Qt::Key_Up, Qt::AltModifier);
  EXPECT_NE(selected(), 500);
  EXPECT_EQ(project().slaves[static_cast<std::size_t>(selected())].station_address, moved);
}

Project two_drives() {
  Project project;
  for (const char* name : {"A", "B"})
    project.slaves.push_back(default_slave(plain(name, "YY"), static_cast<std::uint16_t>(project.slaves.size())));
  project.slaves[1].previous = PreviousPort{0, 1};
  return project;
}

class TwoDrives : public Building {
 protected:
  TwoDrives() : Building(two_drives()) {}
};

TEST_F(TwoDrives, TheOneThatComesToTheFrontStaysSelected) {
  window_.selectNode(1);
  press(Qt::Key_Up, Qt::AltModifier);
  ASSERT_EQ(types(), QStringLiteral("B A"));
  EXPECT_EQ(selected(), 0);
}

TEST(ExplorerViews, AreRemembered) {
  QTemporaryDir folder;
  auto environment = test::virtualEnvironment();
  environment.settings_file = folder.filePath(QStringLiteral("settings.ini"));
  {
    Workspace workspace(environment);
    MainWindow window(workspace);
    window.explorer().setView(ExplorerPanel::View::kTopology);
    window.explorer().topology().setZoom(0.6);
  }
  Workspace workspace(environment);
  MainWindow window(workspace);
  EXPECT_EQ(window.explorer().view(), ExplorerPanel::View::kTopology);
  EXPECT_DOUBLE_EQ(window.explorer().topology().zoom(), 0.6);
}

}  // namespace
}  // namespace syncline::ui
