// SPDX-License-Identifier: Apache-2.0
// What was counted at the cables, as the topology draws it.
#include <gtest/gtest.h>

#include <QHelpEvent>
#include <QMenu>
#include <QSignalSpy>
#include <QToolTip>

#include "support/running_window.h"
#include "tests/support/source_dir.h"
#include "ui/models/cable_counters.h"
#include "ui/models/network_model.h"
#include "ui/panels/explorer_panel.h"
#include "ui/panels/topology_view.h"
#include "ui/theme/theme.h"

namespace syncline::ui {
namespace {

/// A coupler and two drives in a line, read at 1 s.
class Cables : public ::testing::Test {
 protected:
  Cables() {
    cables_.setProject(project_);
    network_.setProject(project_);
    snapshot_.online = true;
    snapshot_.slaves.resize(3);
    for (auto& slave : snapshot_.slaves) {
      slave.present = true;
      slave.al_status = 8;
      slave.evidence.ports_time = kSecond;
    }
  }

  PortErrors& port(std::size_t slave, std::size_t port) { return snapshot_.slaves[slave].evidence.ports[port]; }
  void tell(Nanoseconds time = kSecond) {
    snapshot_.time = time;
    cables_.setSnapshot(snapshot_, {0, 1, 2});
    network_.setSnapshot(snapshot_, {0, 1, 2});
  }

  const Project project_ = test::smallProject();
  Snapshot snapshot_;
  CableCounters cables_;
  NetworkModel network_;
};

TEST_F(Cables, MarkWhereFramesAreDamagedFirst) {
  tell();
  for (int slave = 0; slave < 3; ++slave) EXPECT_EQ(cables_.badge(slave), CableBadge());
  port(1, 0) = {.invalid_frames = 5, .receive_errors = 3};
  port(2, 0) = {.invalid_frames = 1, .forwarded_errors = 5};
  tell();
  EXPECT_EQ(cables_.badge(0), CableBadge());
  EXPECT_EQ(cables_.badge(1), (CableBadge{CableDamage::kFirst, 5, false, 1}));
  EXPECT_EQ(cables_.badge(2), (CableBadge{CableDamage::kHere, 1, false, 2}));
}

TEST_F(Cables, TellForwardedErrorsFromTheDamageItself) {
  port(2, 0).forwarded_errors = 7;
  tell();
  EXPECT_EQ(cables_.badge(2), (CableBadge{CableDamage::kForwarded, 7, false, 2}));
}

/// On the way back: the port that counts is that of the slave in front.
TEST_F(Cables, BelongToBothEnds) {
  port(1, 1) = {.invalid_frames = 2, .receive_errors = 4, .at_least = true};
  port(2, 0).invalid_frames = 1;
  tell();
  EXPECT_EQ(cables_.badge(2), (CableBadge{CableDamage::kFirst, 5, true, 1}));
  EXPECT_EQ(badgeText(cables_.badge(2)), QStringLiteral("\u22655"));
  EXPECT_EQ(cables_.badge(1), CableBadge());
}

TEST_F(Cables, CountALinkThatBothEndsLostOnce) {
  port(0, 1).lost_links = 1;
  port(1, 0).lost_links = 1;
  tell();
  EXPECT_EQ(cables_.badge(1).count, 1U);
  EXPECT_EQ(cables_.badge(1).damage, CableDamage::kHere);
}

TEST_F(Cables, NeverShowWhatIsNotReadNow) {
  port(1, 0).invalid_frames = 5;
  snapshot_.slaves[1].evidence.ports_time = 0;
  tell();
  EXPECT_EQ(cables_.badge(1), CableBadge()) << "not read yet";
  snapshot_.slaves[1].evidence.ports_time = kSecond;
  snapshot_.slaves[1].present = false;
  tell();
  EXPECT_EQ(cables_.badge(1), CableBadge()) << "it does not answer";
  EXPECT_FALSE(cables_.ends(1)[1].reading);
  snapshot_.slaves[1].present = true;
  tell();
  EXPECT_EQ(cables_.badge(1).count, 5U);
  cables_.setSnapshot({}, {0, 1, 2});
  EXPECT_EQ(cables_.badge(1), CableBadge()) << "offline";
  EXPECT_FALSE(cables_.ends(1)[1].reading);
}

TEST_F(Cables, SayHowFastTheCountersGrow) {
  tell(kSecond);
  port(1, 0).invalid_frames = 3;
  tell(2 * kSecond);
  EXPECT_EQ(cables_.ends(1)[1].reading->growth[0], 3U) << "they stood at zero before";
  tell(20 * kSecond);
  EXPECT_EQ(cables_.ends(1)[1].reading->growth[0], 0U);
  EXPECT_EQ(cables_.ends(1)[1].reading->age, 19 * kSecond);
}

class DrawnCables : public Cables {
 protected:
  DrawnCables() : view_(network_, cables_) {
    view_.setProject(project_);
    view_.resize(400, 400);
    view_.show();
  }
  QString tipAt(const QPoint& point) {
    QToolTip::hideText();
    QHelpEvent help(QEvent::ToolTip, point, view_.viewport()->mapToGlobal(point));
    QApplication::sendEvent(view_.viewport(), &help);
    return QToolTip::text();
  }

  TopologyView view_;
};

TEST_F(DrawnCables, ShowTheNumberAtItsCableAndLeadToItsCounters) {
  tell();
  EXPECT_TRUE(view_.badgeRect(1).isEmpty());
  port(1, 0) = {.invalid_frames = 12, .lost_links = 1};
  port(2, 0).forwarded_errors = 12;
  tell();
  const auto place = view_.badgeRect(1);
  ASSERT_FALSE(place.isEmpty());
  const auto above = view_.visualRect(network_.indexOf(0)), below = view_.visualRect(network_.indexOf(1));
  EXPECT_GT(place.top(), above.bottom());
  EXPECT_LT(place.bottom(), below.top());
  EXPECT_LT(place.right(), below.right());
  const auto painted = view_.viewport()->grab().toImage();
  const auto bad = theme::toneColor(view_.palette(), theme::Tone::kBad).rgb();
  EXPECT_EQ(painted.pixel(place.left() + 4, place.center().y()), bad) << "filled where it begins";
  const auto other = view_.badgeRect(2);
  EXPECT_NE(painted.pixel(other.left() + 4, other.center().y()), bad);

  QSignalSpy wanted(&view_, &TopologyView::countersWanted);
  QTest::mouseClick(view_.viewport(), Qt::LeftButton, {}, place.center());
  ASSERT_EQ(wanted.size(), 1);
  EXPECT_EQ(wanted[0][0].toInt(), 1);
}

TEST_F(DrawnCables, SayBothEndsInTheirToolTip) {
  tell(kSecond);
  port(1, 0) = {.invalid_frames = 255, .at_least = true};
  tell(3 * kSecond);
  const auto tip = tipAt(view_.badgeRect(1).center());
  for (const auto* part : {"Slave_1001 port B to Slave_1002 port A", "The link is up", "at least 255", "+255 in 10 s",
                           "2.0 s ago", "damaged first"})
    EXPECT_TRUE(tip.contains(QLatin1String(part))) << part << " in\n" << qPrintable(tip);
  const auto cable = (view_.portPosition(0, 1) + view_.portPosition(1, 0)) / 2;
  EXPECT_EQ(tipAt(cable), tip) << "the cable itself says the same";
  snapshot_.slaves[1].present = false;
  tell(4 * kSecond);
  EXPECT_TRUE(view_.badgeRect(1).isEmpty());
  const auto silent = tipAt(cable);
  EXPECT_TRUE(silent.contains(QStringLiteral("Slave_1002 does not answer"))) << qPrintable(silent);
  EXPECT_FALSE(silent.contains(QStringLiteral("255"))) << qPrintable(silent);
}

class RunningCables : public test::RunningWindow {};

TEST_F(RunningCables, ShowTheDamagedCableOfASimulatedMachine) {
  auto& live = workspace_.live();
  window_.bus().startDemo(QStringLiteral("sim:") + QString::fromStdString(test::source_dir()) +
                          QStringLiteral("/resources/scenarios/faults/bit-errors.toml?virtual"));
  ASSERT_TRUE(test::waitFor([&] { return live.phase() != LiveSession::Phase::kOffline; }));
  auto& explorer = window_.explorer();
  explorer.setView(ExplorerPanel::View::kTopology);
  run(12 * kSecond);
  auto& cables = workspace_.cables();
  const auto count = static_cast<int>(project().slaves.size());
  EXPECT_EQ(cables.badge(kOtherServo).damage, CableDamage::kFirst);
  EXPECT_GT(cables.badge(kOtherServo).count, 0U);
  EXPECT_EQ(cables.badge(kOtherServo).slave, kOtherServo);
  for (int slave = 0; slave < count; ++slave) {
    EXPECT_EQ(cables.badge(slave).damage == CableDamage::kFirst, slave == kOtherServo) << slave;
  }
  window_.selectNode(0);
  explorer.topology().scrollTo(workspace_.network().indexOf(kOtherServo));
  QTest::mouseClick(explorer.topology().viewport(), Qt::LeftButton, {},
                    explorer.topology().badgeRect(kOtherServo).center());
  EXPECT_EQ(window_.editor().node(), kOtherServo);
  EXPECT_EQ(window_.editor().tabs()->currentWidget()->objectName(), QStringLiteral("slaveCountersPage"));
  live.shutDown();
  for (int slave = 0; slave < count; ++slave) EXPECT_EQ(cables.badge(slave), CableBadge()) << slave;
}

/// The number cannot be reached by keys: the menu of its slave has it.
TEST_F(RunningCables, AreInTheMenuOfTheirSlave) {
  goOnline();
  auto snapshot = workspace_.live().snapshot();
  snapshot.slaves[kServo].evidence.ports[0].invalid_frames = 9;
  workspace_.cables().setSnapshot(snapshot, workspace_.runningSlaves().positions());
  auto& explorer = window_.explorer();
  window_.selectNode(kServo);
  Q_EMIT explorer.topology().customContextMenuRequested(
      explorer.topology().visualRect(workspace_.network().indexOf(kServo)).center());
  auto* action = explorer.findChild<QAction*>(QStringLiteral("cableCounters"));
  ASSERT_NE(action, nullptr);
  EXPECT_TRUE(action->text().contains(QStringLiteral("(9)"))) << qPrintable(action->text());
  action->trigger();
  EXPECT_EQ(window_.editor().tabs()->currentWidget()->objectName(), QStringLiteral("slaveCountersPage"));
  for (auto* menu : explorer.findChildren<QMenu*>(QStringLiteral("slaveMenu"))) menu->close();
}

}  // namespace
}  // namespace syncline::ui
