// SPDX-License-Identifier: Apache-2.0
// Machines with several networks: one is in work, the others wait as they are.
#include <gtest/gtest.h>

#include <QAction>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTreeView>

#include "eni/project/project_file.h"
#include "support/running_window.h"
#include "ui/editors/choice_edit.h"
#include "ui/models/network_model.h"
#include "ui/panels/explorer_panel.h"
#include "ui/session/comparison.h"
#include "ui/session/project_document.h"

namespace syncline::ui {
namespace {

Machine twoNetworks() {
  Machine machine;
  machine.networks = {test::smallProject(), test::smallProject()};
  machine.networks[0].name = "Feeder";
  machine.networks[1].name = "Press";
  machine.networks[1].slaves.pop_back();
  return machine;
}

ProjectEdit cycle(Nanoseconds time) {
  return [time](Project& project) -> Status {
    project.master.cycle_time = time;
    return {};
  };
}

TEST(Networks, KeepTheirEditsAndStepsWhileAnotherIsInWork) {
  ProjectDocument document;
  document.take(twoNetworks(), {});
  EXPECT_EQ(document.networks(), (QStringList{QStringLiteral("Feeder"), QStringLiteral("Press")}));
  ASSERT_TRUE(document.edit(QStringLiteral("one"), cycle(2 * kMillisecond)));
  const auto generation = document.generation();
  QSignalSpy taken(&document, &ProjectDocument::taken);
  document.chooseNetwork(1);
  EXPECT_EQ(taken.count(), 1);
  EXPECT_NE(document.generation(), generation) << "what was asked about slaves is not about these";
  EXPECT_EQ(document.project().slaves.size(), 2U);
  EXPECT_FALSE(document.undoGroup().canUndo()) << "nothing was done here";
  EXPECT_TRUE(document.isModified()) << "there was";
  ASSERT_TRUE(document.edit(QStringLiteral("two"), cycle(4 * kMillisecond)));
  document.undoGroup().undo();
  EXPECT_EQ(document.project().master.cycle_time, kMillisecond);
  document.chooseNetwork(0);
  EXPECT_EQ(document.project().master.cycle_time, 2 * kMillisecond);
  document.undoGroup().undo();
  EXPECT_EQ(document.project().master.cycle_time, kMillisecond);
  EXPECT_FALSE(document.isModified());
  document.chooseNetwork(7);
  EXPECT_EQ(document.network(), 0);
}

TEST(Networks, LookingAtAnotherChangesNothing) {
  ProjectDocument document;
  document.take(twoNetworks(), {});
  document.chooseNetwork(1);
  EXPECT_FALSE(document.isModified());
  EXPECT_EQ(document.machine(), twoNetworks());
}

TEST(Networks, AreAllSavedWhicheverIsInWork) {
  const QTemporaryDir folder;
  const auto path = folder.filePath(QStringLiteral("two.syncline"));
  ProjectDocument document;
  document.take(twoNetworks(), {});
  ASSERT_TRUE(document.edit(QStringLiteral("one"), cycle(2 * kMillisecond)));
  document.chooseNetwork(1);
  ASSERT_TRUE(document.edit(QStringLiteral("two"), cycle(4 * kMillisecond)));
  ASSERT_TRUE(document.save(path));
  EXPECT_FALSE(document.isModified()) << "both are in the file";
  EXPECT_EQ(document.network(), 1) << "still in work";
  const auto file = eni::load_machine(path.toStdString());
  ASSERT_TRUE(file);
  ASSERT_EQ(file->networks.size(), 2U);
  EXPECT_EQ(file->networks[0].master.cycle_time, 2 * kMillisecond);
  EXPECT_EQ(file->networks[1].master.cycle_time, 4 * kMillisecond);
}

TEST(Networks, ComeAndGo) {
  ProjectDocument document;
  document.take(twoNetworks(), {});
  document.addNetwork(QStringLiteral("Exit"));
  EXPECT_EQ(document.network(), 2);
  EXPECT_TRUE(document.project().slaves.empty());
  EXPECT_TRUE(document.isModified());
  document.chooseNetwork(0);
  document.removeNetwork();
  EXPECT_EQ(document.networks(), (QStringList{QStringLiteral("Press"), QStringLiteral("Exit")}));
  EXPECT_EQ(document.project().slaves.size(), 2U);
  ASSERT_TRUE(document.edit(QStringLiteral("cycle"), cycle(2 * kMillisecond)));
  EXPECT_EQ(document.machine().networks[0].master.cycle_time, 2 * kMillisecond);
  document.removeNetwork();
  document.removeNetwork();
  EXPECT_EQ(document.networks().size(), 1) << "the only one stays";
  document.take(twoNetworks(), {});
  EXPECT_FALSE(document.isModified());
  EXPECT_EQ(document.network(), 0);
}

/// The network in work beside its file is beside itself, not beside the file's first one.
TEST(Networks, AreComparedWithTheOneOfTheirName) {
  const QTemporaryDir folder;
  const auto path = folder.filePath(QStringLiteral("two.syncline"));
  auto machine = twoNetworks();
  ASSERT_TRUE(eni::save_machine(machine, path.toStdString()));
  Comparison comparison({});
  const auto compare = [&](const Project& project) {
    comparison.start({ComparedSide::Kind::kProject}, {ComparedSide::Kind::kFile, path}, project, {});
    EXPECT_TRUE(test::waitFor([&] { return !comparison.isRunning(); }));
  };
  compare(machine.networks[1]);
  ASSERT_TRUE(comparison.result());
  EXPECT_TRUE(comparison.result()->network.empty());
  machine.networks[1].name = "Unheard of";
  compare(machine.networks[1]);
  EXPECT_FALSE(comparison.result());
  ASSERT_TRUE(comparison.failure()) << "which names the file's networks";
  EXPECT_NE(comparison.failure()->detail.text().find("Press"), std::string::npos)
      << comparison.failure()->detail.text();
}

class NetworksInTheWindow : public test::RunningWindow {
 protected:
  NetworksInTheWindow() { workspace_.document().take(twoNetworks(), {}); }
  QTreeView& tree() { return field<QTreeView>("explorerTree"); }
  QModelIndex node(int network, int slave) { return workspace_.network().indexOf(network, slave); }
  ChoiceEdit& choice() { return field<ChoiceEdit>("networkChoice"); }
  QAction& action(const char* name) { return *window_.findChild<QAction*>(QLatin1String(name)); }
};

TEST_F(NetworksInTheWindow, StandInOneTreeAndComeInWorkByTheirNodes) {
  EXPECT_FALSE(choice().isVisible()) << "the tree has them all";
  ASSERT_EQ(tree().model()->rowCount(), 2);
  EXPECT_EQ(node(0, -1).data().toString(), QStringLiteral("Feeder"));
  EXPECT_EQ(node(1, -1).data().toString(), QStringLiteral("Press"));
  EXPECT_TRUE(tree().isExpanded(node(1, -1)));
  tree().setCurrentIndex(node(1, 1));
  ASSERT_TRUE(test::waitFor([this] { return workspace_.document().network() == 1; }));
  EXPECT_EQ(window_.explorer().selected(), 1);
  EXPECT_EQ(tree().currentIndex(), node(1, 1));
  EXPECT_TRUE(node(0, 1).data(NetworkModel::kOtherRole).toBool());
  EXPECT_FALSE(node(1, 1).data(NetworkModel::kOtherRole).toBool());
  // By keyboard over the border between them, and what was folded stays so.
  tree().setCurrentIndex(node(1, -1));
  tree().setFocus();
  QTest::keyClick(&tree(), Qt::Key_Up);
  ASSERT_TRUE(test::waitFor([this] { return workspace_.document().network() == 0; }));
  EXPECT_EQ(window_.explorer().selected(), 2) << "the last slave of the network above";
  tree().collapse(node(1, -1));
  ASSERT_TRUE(workspace_.document().edit(QStringLiteral("fewer"), [](Project& project) -> Status {
    project.slaves.pop_back();
    return {};
  }));
  EXPECT_FALSE(tree().isExpanded(node(1, -1)));
  EXPECT_TRUE(tree().isExpanded(node(0, -1)));
  EXPECT_EQ(workspace_.network().rowCount(node(0, -1)), 2);
}

TEST_F(NetworksInTheWindow, HaveMarksOfTheirOwn) {
  const auto compiled = [this] { return !workspace_.configuration().current()->config.slaves.empty(); };
  ASSERT_TRUE(compiled());
  const auto marks = [this](int network, int slave) {
    return node(network, slave).data(NetworkModel::kMarksRole).toStringList();
  };
  const auto leads = marks(0, 1), follows = marks(0, 2);
  EXPECT_TRUE(leads.contains(QStringLiteral("REF")));
  EXPECT_TRUE(follows.contains(QStringLiteral("DC")));
  workspace_.document().chooseNetwork(1);
  ASSERT_TRUE(workspace_.document().edit(QStringLiteral("off"), [](Project& project) -> Status {
    project.master.dc.enabled = false;
    return {};
  }));
  ASSERT_TRUE(compiled());
  QApplication::processEvents();
  EXPECT_EQ(marks(1, 1), QStringList());
  EXPECT_EQ(marks(0, 1), leads) << "as it was when it was in work";
  EXPECT_EQ(marks(0, 2), follows);
  workspace_.document().chooseNetwork(0);
  EXPECT_EQ(marks(1, 1), QStringList()) << "the one that was left keeps its own";
}

TEST_F(NetworksInTheWindow, ANodeOfAnotherComesInWorkOnlyWhereThatMayBe) {
  window_.selectNode(0);
  ASSERT_TRUE(window_.editor().showKey(QStringLiteral("slave.0.station_address")));
  auto* address = QApplication::focusWidget();
  ASSERT_NE(address, nullptr);
  QTest::keyClick(address, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(address, QStringLiteral("none"));
  tree().setCurrentIndex(node(1, 0));
  EXPECT_TRUE(test::waitFor([this] { return tree().currentIndex() == node(0, 0); })) << "what is typed is kept";
  EXPECT_EQ(workspace_.document().network(), 0);
}

TEST_F(NetworksInTheWindow, AreChosenAboveTheExplorer) {
  window_.explorer().setView(ExplorerPanel::View::kTopology);
  ASSERT_TRUE(choice().isVisible());
  EXPECT_EQ(choice().currentText(), QStringLiteral("Feeder"));
  choice().setCurrentIndex(1);
  Q_EMIT choice().activated(1);
  EXPECT_EQ(workspace_.document().network(), 1);
  EXPECT_EQ(workspace_.network().slaveCount(), 2);
  action("actionNextNetwork").trigger();
  EXPECT_EQ(choice().currentText(), QStringLiteral("Feeder"));
  window_.selectNode(-1);
  ASSERT_TRUE(window_.editor().showKey(QStringLiteral("network.name")));
  auto* name = QApplication::focusWidget();
  ASSERT_NE(name, nullptr);
  test::type(*name, QStringLiteral("Infeed"));
  EXPECT_EQ(choice().currentText(), QStringLiteral("Infeed")) << "a name is followed";
}

TEST_F(NetworksInTheWindow, OnesThatHoldSlavesAreRemovedAfterAQuestion) {
  window_.explorer().setView(ExplorerPanel::View::kTopology);
  answerQuestion("removeNetworkQuestion", false);
  action("actionRemoveNetwork").trigger();
  EXPECT_EQ(workspace_.document().networks().size(), 2);
  answerQuestion("removeNetworkQuestion", true);
  action("actionRemoveNetwork").trigger();
  EXPECT_EQ(workspace_.document().networks(), QStringList{QStringLiteral("Press")});
  EXPECT_FALSE(choice().isVisible()) << "nothing to choose";
  EXPECT_FALSE(action("actionRemoveNetwork").isEnabled());
  action("actionAddNetwork").trigger();
  EXPECT_TRUE(choice().isVisible());
  action("actionRemoveNetwork").trigger();
  EXPECT_EQ(workspace_.document().networks().size(), 1) << "an empty one goes without a question";
}

}  // namespace
}  // namespace syncline::ui
