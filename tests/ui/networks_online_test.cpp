// SPDX-License-Identifier: Apache-2.0
// Several networks of a machine run at once; one is looked at.
#include <gtest/gtest.h>

#include <QAction>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "support/patient_master.h"
#include "support/running_window.h"
#include "ui/dialogs/file_commands.h"
#include "ui/dialogs/network_commands.h"
#include "ui/editors/choice_edit.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/messages_panel.h"
#include "ui/widgets/pill.h"

namespace syncline::ui {
namespace {

class NetworksOnline : public test::RunningWindow {
 protected:
  using Phase = NetworkRun::Phase;

  NetworksOnline() {
    Machine machine;
    machine.networks.resize(2);
    workspace_.document().take(machine, {}, true);
  }
  ChoiceEdit& choice() { return field<ChoiceEdit>("networkChoice"); }
  void choose(int network) { window_.findChild<NetworkCommands*>()->choose(network); }
  /// Both in OP, the second one is looked at.
  void startBoth() {
    goOnline();
    first_ = &workspace_.live().run();
    choose(1);
    ASSERT_EQ(workspace_.document().network(), 1);
    goOnline();
    ASSERT_NE(&workspace_.live().run(), first_);
    ASSERT_EQ(first_->snapshot().state, AlState::kOp);
  }
  /// What the message log has of this source, newest first.
  std::vector<int> rowsOf(const QString& source) {
    std::vector<int> rows;
    for (int row = 0; row < workspace_.messages().rowCount(); ++row) {
      if (workspace_.messages().message(row).source == source) rows.push_back(row);
    }
    return rows;
  }

  NetworkRun* first_ = nullptr;
};

TEST_F(NetworksOnline, ClosingTheWindowAsksWhileOneRuns) {
  window_.show();
  startBoth();
  answerQuestion("offlineQuestion", false);
  EXPECT_FALSE(window_.close());
  EXPECT_TRUE(asked_.contains(workspace_.document().networks()[0])) << asked_.toStdString();
  EXPECT_TRUE(asked_.contains(workspace_.document().networks()[1])) << asked_.toStdString();
  EXPECT_TRUE(window_.isVisible());
  EXPECT_EQ(first_->phase(), Phase::kOnline);
  EXPECT_EQ(workspace_.live().phase(), Phase::kOnline);
  asked_.clear();
  answerQuestion("offlineQuestion", true);
  EXPECT_TRUE(window_.close());
  EXPECT_FALSE(asked_.isEmpty());
  EXPECT_EQ(first_->phase(), Phase::kOffline);
}

TEST_F(NetworksOnline, ClosingTheWindowAsksNothingWhenNoneRuns) {
  window_.show();
  answerQuestion("offlineQuestion", false);
  EXPECT_TRUE(window_.close());
  EXPECT_TRUE(asked_.isEmpty()) << asked_.toStdString();
}

TEST_F(NetworksOnline, RunSideBySide) {
  goOnline();
  auto& first = workspace_.live().run();
  const auto* record = workspace_.live().record();
  ASSERT_NE(record, nullptr);
  QSignalSpy records(&workspace_.live(), &LiveSession::recordChanged);
  choose(1);
  EXPECT_EQ(records.count(), 1);
  EXPECT_EQ(workspace_.live().phase(), Phase::kOffline);
  EXPECT_EQ(workspace_.shownRecord(), nullptr) << "nothing of the other one is drawn";
  EXPECT_TRUE(workspace_.mayEditSlaves()) << "this one does not run";
  EXPECT_EQ(first.phase(), Phase::kOnline);
  EXPECT_TRUE(field<Pill>("statusOthers").isVisible());
  goOnline();
  EXPECT_FALSE(workspace_.mayEditSlaves());
  const auto cycles = first.snapshot().cycles;
  first.advance(kSecond);
  EXPECT_GT(first.snapshot().cycles, cycles) << "it goes on unseen";
  choose(0);
  EXPECT_EQ(workspace_.live().phase(), Phase::kOnline);
  EXPECT_EQ(workspace_.live().record(), record);
  EXPECT_EQ(window_.liveStrip().isVisible(), true);
  EXPECT_EQ(workspace_.network().index(0, 0).isValid(), true);
  EXPECT_TRUE(choice().itemText(0).contains(QStringLiteral("OP"))) << choice().itemText(0).toStdString();
  EXPECT_TRUE(choice().itemText(1).contains(QStringLiteral("OP"))) << choice().itemText(1).toStdString();
  window_.bus().goOffline();
  EXPECT_EQ(workspace_.live().phase(), Phase::kOffline);
  EXPECT_TRUE(workspace_.runs().any()) << "the other one runs on";
}

TEST_F(NetworksOnline, WhatIsToldOfOneThatIsNotLookedAtSaysSoAndLeadsThere) {
  startBoth();
  const auto name = workspace_.document().networks().front();
  const auto before = rowsOf(name + QStringLiteral(": Master")).size();
  first_->requestState(AlState::kSafeop);
  first_->advance(kSecond);
  const auto rows = rowsOf(name + QStringLiteral(": Master"));
  ASSERT_GT(rows.size(), before);
  const auto message = workspace_.messages().message(rows.front());
  EXPECT_EQ(workspace_.document().network(), 1);
  EXPECT_TRUE(field<Pill>("statusOthers").text().contains(QStringLiteral("SAFEOP")));
  Q_EMIT window_.findChild<MessagesPanel*>()->activated(message);
  EXPECT_EQ(workspace_.document().network(), 0);
  workspace_.runs().shutDown();
  workspace_.document().removeNetwork();
  Q_EMIT window_.findChild<MessagesPanel*>()->activated(message);
  EXPECT_EQ(workspace_.document().networks().size(), 1) << "it is gone: nothing to go to";
}

TEST_F(NetworksOnline, ARecordingGoesOnWhileAnotherIsLookedAt) {
  const QTemporaryDir folder;
  goOnline();
  auto& first = workspace_.live().run();
  ASSERT_TRUE(workspace_.disk().start(folder.filePath(QStringLiteral("first.slrec"))));
  choose(1);
  EXPECT_FALSE(workspace_.disk().isRecording());
  first.advance(kSecond);
  choose(0);
  EXPECT_TRUE(workspace_.disk().isRecording());
  EXPECT_GE(workspace_.disk().duration(), 900 * kMillisecond);
  QSignalSpy ended(&workspace_.runs(), &NetworkRuns::recordingEnded);
  choose(1);
  first.shutDown();
  EXPECT_TRUE(test::waitFor([&] { return ended.count() == 1; })) << "told whichever is looked at";
}

TEST_F(NetworksOnline, AnotherMachineEndsAllOfThemAfterAQuestionThatNamesThem) {
  startBoth();
  answerQuestion("offlineQuestion", false);
  window_.files().create();
  for (const auto& name : workspace_.document().networks()) EXPECT_TRUE(asked_.contains(name)) << asked_.toStdString();
  EXPECT_EQ(workspace_.live().phase(), Phase::kOnline);
  answerQuestion("offlineQuestion", true);
  window_.files().create();
  EXPECT_EQ(workspace_.document().networks().size(), 1);
  EXPECT_FALSE(workspace_.runs().any());
  EXPECT_EQ(workspace_.live().record(), nullptr) << "nothing of the machine before";
  EXPECT_EQ(workspace_.runs().count(), 1);
}

/// A machine that moves because somebody holds an output is not forgotten behind another one.
TEST_F(NetworksOnline, OutputsForcedElsewhereAreSaid) {
  startBoth();
  EXPECT_FALSE(field<Pill>("statusOthers").text().contains(QStringLiteral("forced")));
  first_->forceOutput(0, 1, 1);
  first_->advance(kSecond);
  EXPECT_TRUE(field<Pill>("statusOthers").text().contains(QStringLiteral("forced")));
  EXPECT_GE(field<Pill>("statusOthers").tone(), theme::Tone::kWarning);
}

TEST_F(NetworksOnline, AreTakenOfflineTogether) {
  startBoth();
  auto& offline = *window_.findChild<QAction*>(QStringLiteral("actionAllOffline"));
  EXPECT_TRUE(offline.isEnabled());
  offline.trigger();
  EXPECT_FALSE(workspace_.runs().any());
  EXPECT_FALSE(offline.isEnabled());
  EXPECT_FALSE(field<Pill>("statusOthers").isVisible());
}

TEST_F(NetworksOnline, OneThatRunsIsNotRemoved) {
  goOnline();
  EXPECT_FALSE(window_.findChild<QAction*>(QStringLiteral("actionRemoveNetwork"))->isEnabled());
  choose(1);
  auto& remove = *window_.findChild<QAction*>(QStringLiteral("actionRemoveNetwork"));
  EXPECT_TRUE(remove.isEnabled());
  remove.trigger();
  EXPECT_EQ(workspace_.document().networks().size(), 1);
  EXPECT_EQ(workspace_.live().phase(), Phase::kOnline) << "the one that is left is the one that runs";
  EXPECT_EQ(workspace_.live().snapshot().state, AlState::kOp);
}

TEST_F(NetworksOnline, ARecordingThatIsShownKeepsTheNetworkInWork) {
  const QTemporaryDir folder;
  const auto path = folder.filePath(QStringLiteral("first.slrec"));
  goOnline();
  QSignalSpy saved(&workspace_.runs(), &NetworkRuns::stretchSaved);
  ASSERT_TRUE(workspace_.disk().saveLast(kSecond, path));
  ASSERT_TRUE(test::waitFor([&] { return saved.count() == 1; }));
  workspace_.runs().shutDown();
  window_.files().openAny(path);
  ASSERT_TRUE(test::waitFor([&] { return workspace_.recording().isOpen(); }));
  EXPECT_FALSE(choice().isEnabled());
  QSignalSpy refused(window_.findChild<NetworkCommands*>(), &NetworkCommands::refused);
  choose(1);
  EXPECT_EQ(workspace_.document().network(), 0);
  EXPECT_EQ(refused.count(), 1);
}

/// Two masters on one adapter would take each other's frames.
TEST(NetworksOnOneLink, AreRefused) {
  auto environment = test::virtualEnvironment();
  environment.open_master = [](const QString&, const Project&) -> Result<std::unique_ptr<BackgroundMaster>> {
    return std::make_unique<test::PatientMaster>(false);
  };
  Workspace workspace(environment);
  Machine machine;
  machine.networks = {test::smallProject(), test::smallProject()};
  machine.networks[0].name = "Feeder";
  workspace.document().take(machine, {});
  workspace.setLink(QStringLiteral("nic:eth0"));
  ASSERT_TRUE(workspace.live().goOnline(QStringLiteral("nic:eth0"), {}));
  workspace.document().chooseNetwork(1);
  EXPECT_TRUE(workspace.link().isEmpty()) << "each has its own";
  workspace.setLink(QStringLiteral("nic:eth0"));
  const auto status = workspace.mayUse(workspace.link());
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().detail.text().find("Feeder"), std::string::npos);
  EXPECT_TRUE(workspace.mayUse(QStringLiteral("nic:eth1")));
  EXPECT_TRUE(workspace.mayUse(QStringLiteral("sim:machine.toml")));
  workspace.document().chooseNetwork(0);
  EXPECT_TRUE(workspace.mayUse(workspace.link())) << "its own";
  workspace.runs().shutDown();
}

}  // namespace
}  // namespace syncline::ui
