// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QMimeData>
#include <QSignalSpy>
#include <QStandardItemModel>
#include <algorithm>
#include <memory>

#include "channels/snapshot.h"
#include "support/ui_test_support.h"
#include "ui/models/message_model.h"
#include "ui/models/network_model.h"
#include "ui/models/pdo_model.h"
#include "ui/models/slave_figures_model.h"
#include "ui/models/word_filter.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

using test::smallProject;

Snapshot runningSnapshot(std::size_t slaves) {
  Snapshot snapshot;
  snapshot.online = true;
  snapshot.state = AlState::kOp;
  snapshot.slaves.resize(slaves);
  for (auto& slave : snapshot.slaves) {
    slave.present = true;
    slave.al_status = 8;
  }
  return snapshot;
}

QStringList marks(std::initializer_list<const char*> names) {
  QStringList list;
  for (const char* name : names) list << QLatin1String(name);
  return list;
}

TEST(NetworkModel, HasMasterAndSlavesInBusOrder) {
  NetworkModel model;
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Warning);
  model.setProject(smallProject());
  const auto root = model.index(0, 0);
  EXPECT_EQ(root.data().toString(), QStringLiteral("Master"));
  ASSERT_EQ(model.rowCount(root), 3);
  EXPECT_EQ(model.index(1, 0, root).data().toString(), QStringLiteral("Slave_1002"));
  EXPECT_EQ(model.index(1, 0, root).data(NetworkModel::kSlaveRole).toInt(), 1);
  EXPECT_EQ(model.index(1, 0, root).parent(), root);
}

TEST(NetworkModel, MarksTheReferenceClockThatWasCompiled) {
  NetworkModel model;
  model.setProject(smallProject());
  NetworkConfig config;
  config.slaves.resize(3);
  config.slaves[1].dc = SlaveDcConfig{};
  config.slaves[2].dc = SlaveDcConfig{};
  config.slaves[1].dc->reference_clock = true;
  model.setConfiguration(&config);
  EXPECT_EQ(model.indexOf(0).data(NetworkModel::kMarksRole).toStringList(), QStringList());
  EXPECT_EQ(model.indexOf(1).data(NetworkModel::kMarksRole).toStringList(), marks({"REF", "DC"}));
  EXPECT_EQ(model.indexOf(2).data(NetworkModel::kMarksRole).toStringList(), marks({"DC"}));
  model.setConfiguration(nullptr);
  EXPECT_EQ(model.indexOf(1).data(NetworkModel::kMarksRole).toStringList(), QStringList());
}

TEST(NetworkModel, TellsOnlyOfTheSlavesThatChanged) {
  NetworkModel model;
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Warning);
  model.setProject(smallProject());
  auto snapshot = runningSnapshot(3);
  const std::vector<int> positions{0, 1, 2};
  model.setSnapshot(snapshot, positions);
  EXPECT_EQ(model.indexOf(2).data(NetworkModel::kStateRole).toInt(), 8);
  QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
  model.setSnapshot(snapshot, positions);
  EXPECT_EQ(changed.count(), 0);
  snapshot.slaves[1].al_status = 0x14;
  model.setSnapshot(snapshot, positions);
  ASSERT_EQ(changed.count(), 1);
  EXPECT_EQ(changed[0][0].toModelIndex().row(), 1);
  EXPECT_EQ(changed[0][1].toModelIndex().row(), 1);
  EXPECT_TRUE(model.indexOf(1).data(NetworkModel::kErrorRole).toBool());
  snapshot.slaves[1].present = false;
  model.setSnapshot(snapshot, positions);
  EXPECT_EQ(model.indexOf(1).data(NetworkModel::kStateRole).toInt(), 0) << "a silent slave shows no stale state";
}

TEST(NetworkModel, ShowsOfEachSlaveItsOwnState) {
  NetworkModel model;
  model.setProject(smallProject());
  auto snapshot = runningSnapshot(2);
  snapshot.slaves[0].al_status = 0x14;
  model.setSnapshot(snapshot, {1, -1, 0});
  EXPECT_EQ(model.indexOf(0).data(NetworkModel::kStateRole).toInt(), 8);
  EXPECT_FALSE(model.indexOf(1).data(NetworkModel::kErrorRole).toBool());
  EXPECT_EQ(model.indexOf(1).data(NetworkModel::kStateRole).toInt(), -1) << "it does not run";
  EXPECT_TRUE(model.indexOf(2).data(NetworkModel::kErrorRole).toBool());
}

/// The tree of a machine with two networks.
class ModelOfNetworks : public testing::Test {
 protected:
  ModelOfNetworks() {
    fewer_.slaves.pop_back();
    model_.setNetworks({QStringLiteral("Feeder"), QStringLiteral("Press")}, {&project_, &fewer_}, 0);
  }
  const Project project_ = smallProject();
  Project fewer_ = smallProject();
  NetworkModel model_;
  QAbstractItemModelTester tester_{&model_, QAbstractItemModelTester::FailureReportingMode::Warning};
};

TEST_F(ModelOfNetworks, HasTheMasterOfEachWithItsSlaves) {
  ASSERT_EQ(model_.rowCount(), 2);
  EXPECT_EQ(model_.index(0, 0).data().toString(), QStringLiteral("Feeder"));
  EXPECT_EQ(model_.index(1, 0).data().toString(), QStringLiteral("Press"));
  EXPECT_EQ(model_.rowCount(model_.index(0, 0)), 3);
  EXPECT_EQ(model_.rowCount(model_.index(1, 0)), 2);
  EXPECT_EQ(model_.slaveCount(), 3) << "of the one in work";
  const auto other = model_.indexOf(1, 1);
  EXPECT_EQ(other.parent(), model_.index(1, 0));
  EXPECT_EQ(other.data(NetworkModel::kSlaveRole).toInt(), 1);
  EXPECT_EQ(other.data(NetworkModel::kNetworkRole).toInt(), 1);
  EXPECT_FALSE(model_.flags(other) & (Qt::ItemIsDragEnabled | Qt::ItemIsDropEnabled)) << "only seen";
  EXPECT_TRUE(model_.flags(model_.indexOf(1)) & Qt::ItemIsDragEnabled);
  const std::unique_ptr<QMimeData> slave(model_.mimeData({model_.indexOf(1)}));
  EXPECT_FALSE(model_.canDropMimeData(slave.get(), Qt::MoveAction, -1, 0, other));
}

TEST_F(ModelOfNetworks, KeepsTheStatesOfEachWhicheverIsInWork) {
  QSignalSpy changed(&model_, &QAbstractItemModel::dataChanged);
  model_.setSnapshot(1, runningSnapshot(2), {0, 1});
  ASSERT_EQ(changed.count(), 2) << "its master and its slaves";
  EXPECT_EQ(changed[1][0].toModelIndex().parent(), model_.index(1, 0));
  EXPECT_EQ(model_.indexOf(1, 1).data(NetworkModel::kStateRole).toInt(), 8);
  EXPECT_EQ(model_.indexOf(0, 1).data(NetworkModel::kStateRole).toInt(), -1);
  model_.setNetworks({QStringLiteral("Feeder"), QStringLiteral("Press")}, {&project_, &fewer_}, 1);
  EXPECT_EQ(model_.slaveCount(), 2);
  EXPECT_EQ(model_.indexOf(1).data(NetworkModel::kStateRole).toInt(), 8);
  model_.setProject(project_);
  EXPECT_EQ(model_.slaveCount(), 3);
  EXPECT_EQ(model_.rowCount(model_.index(0, 0)), 3) << "the other one is as it was";
}

TEST_F(ModelOfNetworks, TellsOfSlavesOfAnotherMachineThatStandAlike) {
  auto other = project_;
  other.slaves[1].name = "Another drive";
  QSignalSpy changed(&model_, &QAbstractItemModel::dataChanged);
  model_.setNetworks({QStringLiteral("Feeder"), QStringLiteral("Press")}, {&other, &fewer_}, 0);
  EXPECT_EQ(model_.indexOf(0, 1).data().toString(), QStringLiteral("Another drive"));
  EXPECT_TRUE(std::ranges::any_of(changed, [&](const auto& of) {
    return of[0].toModelIndex() == model_.indexOf(0, 1);
  })) << "who draws it hears of it";
}

Message message(Severity severity, const char* text) {
  return {QDateTime::currentDateTime(), severity, QStringLiteral("Master"), QString::fromUtf8(text), 2, {}};
}

TEST(MessageModel, KeepsFindingsOnTopAndNewestFirst) {
  MessageModel model;
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Warning);
  model.append(message(Severity::kNote, "first"));
  model.setFindings({message(Severity::kWarning, "finding")});
  model.append(message(Severity::kError, "second"));
  ASSERT_EQ(model.rowCount(), 3);
  const auto text = [&](int row) { return model.index(row, MessageModel::kText).data().toString(); };
  EXPECT_EQ(text(0), QStringLiteral("finding"));
  EXPECT_EQ(text(1), QStringLiteral("second"));
  EXPECT_EQ(text(2), QStringLiteral("first"));
  model.clearLog();
  EXPECT_EQ(model.rowCount(), 1);
  model.setFindings({});
  EXPECT_EQ(model.rowCount(), 0);
}

TEST(MessageModel, SaysWhenInItsRunAMessageWas) {
  MessageModel model;
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Warning);
  const auto add = [&](int run, qint64 moment) {
    auto line = message(Severity::kNote, "line");
    line.run = run;
    line.moment = moment;
    model.append(line);
  };
  const auto time = [&](int row) { return model.index(row, MessageModel::kRunTime).data().toString(); };
  add(0, 0);
  add(1, 5'000'000'000);
  EXPECT_EQ(time(0), QString()) << "before the first sample nobody knows";
  int changes = 0;
  QObject::connect(&model, &MessageModel::dataChanged, [&] { ++changes; });
  model.setRunBegin(1, 5'250'000'000);
  EXPECT_EQ(changes, 1);
  EXPECT_EQ(time(0), runTimeText(-250'000'000));
  add(1, 7'500'000'000);
  EXPECT_EQ(time(0), runTimeText(2'250'000'000));
  add(2, 7'500'000'000);
  EXPECT_EQ(time(0), QString()) << "the next run has a beginning of its own";
  model.setRunBegin(2, 7'000'000'000);
  EXPECT_EQ(time(0), runTimeText(500'000'000));
  EXPECT_EQ(time(1), runTimeText(2'250'000'000));
  EXPECT_EQ(time(3), QString()) << "of no run";
}

TEST(MessageModel, IsCapped) {
  MessageModel model;
  for (std::size_t i = 0; i < MessageModel::kMaximum + 10; ++i) model.append(message(Severity::kNote, "line"));
  EXPECT_EQ(model.rowCount(), static_cast<int>(MessageModel::kMaximum));
}

TEST(MessageFilter, ShowsSeverityAndText) {
  MessageModel model;
  MessageFilter filter;
  filter.setSourceModel(&model);
  QAbstractItemModelTester tester(&filter, QAbstractItemModelTester::FailureReportingMode::Warning);
  model.append(message(Severity::kNote, "apple"));
  model.append(message(Severity::kError, "pear"));
  filter.setShown(Severity::kNote, false);
  EXPECT_EQ(filter.rowCount(), 1);
  filter.setShown(Severity::kNote, true);
  filter.setText(QStringLiteral("APP"));
  ASSERT_EQ(filter.rowCount(), 1);
  EXPECT_EQ(filter.index(0, MessageModel::kText).data().toString(), QStringLiteral("apple"));
}

/// No keyboard has the minus, the micro and the space that stand in a figure.
TEST(MessageFilter, FiguresAreFoundAsTheyAreTyped) {
  MessageModel model;
  MessageFilter filter;
  filter.setSourceModel(&model);
  model.append(message(Severity::kNote, "stepped by \u22127\u00A0\u00B5s"));
  model.append(message(Severity::kNote, "stepped by 7\u00A0ns"));
  for (const auto* typed : {"-7", "7 us", "\u22127", "-7 \u00B5s", "-7\u00A0\u03BCs"}) {
    filter.setText(QString::fromUtf8(typed));
    EXPECT_EQ(filter.rowCount(), 1) << typed;
  }
}

TEST(WordFilter, FiguresAreFoundAsTheyAreTyped) {
  QStandardItemModel model;
  model.appendRow(new QStandardItem(QStringLiteral("shift \u2212500\u00A0\u00B5s")));
  model.appendRow(new QStandardItem(QStringLiteral("shift 500\u00A0ns")));
  WordFilter filter(Qt::DisplayRole);
  filter.setSourceModel(&model);
  filter.setWords(QStringLiteral("shift -500"));
  EXPECT_EQ(filter.rowCount(), 1);
  filter.setWords(QStringLiteral("500 us"));
  EXPECT_EQ(filter.rowCount(), 1);
}

TEST(PdoModel, LocksWhatAMandatoryPdoExcludes) {
  auto project = smallProject();
  project.slaves[1].device.rx_pdos[0].mandatory = true;
  PdoModel model(PdoDirection::kRx);
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Warning);
  model.setSlave(project.slaves[1]);
  ASSERT_EQ(model.rowCount(), 3);
  EXPECT_EQ(model.index(0, 0).data(Qt::CheckStateRole).toInt(), static_cast<int>(Qt::Checked));
  EXPECT_FALSE(model.flags(model.index(0, 0)) & Qt::ItemIsUserCheckable);
  EXPECT_FALSE(model.flags(model.index(1, 0)) & Qt::ItemIsUserCheckable);
  EXPECT_TRUE(model.index(1, 0).data(Qt::ToolTipRole).toString().contains(QStringLiteral("0x1600")));
  EXPECT_FALSE(model.setData(model.index(1, 0), static_cast<int>(Qt::Checked), Qt::CheckStateRole));
  EXPECT_TRUE(model.flags(model.index(2, 0)) & Qt::ItemIsUserCheckable);
  EXPECT_EQ(model.assignedBits(), 56U);
}

class PdoAssignment : public testing::Test {
 protected:
  PdoAssignment() {
    model_.setSlave(project_.slaves[1]);
    QObject::connect(&model_, &PdoModel::assignmentWanted,
                     [this](const std::vector<std::uint16_t>& pdos) { wanted_ = pdos; });
  }
  Project project_ = smallProject();
  PdoModel model_{PdoDirection::kRx};
  std::vector<std::uint16_t> wanted_;
};

TEST_F(PdoAssignment, AsksForTheEditInsteadOfChanging) {
  EXPECT_TRUE(model_.setData(model_.index(2, 0), static_cast<int>(Qt::Checked), Qt::CheckStateRole));
  EXPECT_EQ(wanted_, (std::vector<std::uint16_t>{0x1600, 0x1602}));
  EXPECT_EQ(model_.index(2, 0).data(Qt::CheckStateRole).toInt(), static_cast<int>(Qt::Unchecked));
}

/// In the place of the one that it excludes, whatever else is assigned.
TEST_F(PdoAssignment, OneTickExchangesWhatExcludesEachOther) {
  project_.slaves[1].assigned_rx_pdos = {0x1600, 0x1602};
  model_.setSlave(project_.slaves[1]);
  EXPECT_TRUE(model_.index(1, 0).data(Qt::ToolTipRole).toString().contains(QStringLiteral("place of 0x1600")));
  EXPECT_TRUE(model_.setData(model_.index(1, 0), static_cast<int>(Qt::Checked), Qt::CheckStateRole));
  EXPECT_EQ(wanted_, (std::vector<std::uint16_t>{0x1601, 0x1602}));
  project_.slaves[1].assigned_rx_pdos = wanted_;
  model_.setSlave(project_.slaves[1]);
  EXPECT_TRUE(model_.setData(model_.index(0, 0), static_cast<int>(Qt::Checked), Qt::CheckStateRole));
  EXPECT_EQ(wanted_, (std::vector<std::uint16_t>{0x1600, 0x1602}));
}

/// As the ENI says it: of those that are assigned, also where the ESI names none.
TEST_F(PdoAssignment, SaysWhichSyncManagerExchangesIt) {
  auto& slave = project_.slaves[1];
  slave.device.sync_managers.resize(4);
  slave.device.sync_managers[2].type = SyncManagerType::kOutputs;
  slave.device.sync_managers[3].type = SyncManagerType::kInputs;
  slave.device.rx_pdos[1].sync_manager.reset();
  const auto said = [this](int row) { return model_.index(row, PdoModel::kSyncManager).data().toString(); };
  model_.setSlave(slave);
  EXPECT_EQ(said(0), QStringLiteral("SM2"));
  EXPECT_EQ(said(1), QStringLiteral("\u2013"));
  slave.assigned_rx_pdos = {0x1601};
  model_.setSlave(slave);
  EXPECT_EQ(said(0), QStringLiteral("\u2013"));
  EXPECT_EQ(said(1), QStringLiteral("SM2"));
}

TEST(PdoEntryModel, CountsBitOffsetsOverPadding) {
  PdoEntryModel model;
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Warning);
  model.setEntries(smallProject().slaves[1].device.rx_pdos[0].entries);
  ASSERT_EQ(model.rowCount(), 3);
  EXPECT_EQ(model.index(2, PdoEntryModel::kOffset).data().toString(), QStringLiteral("3.0"));
  EXPECT_EQ(model.index(0, PdoEntryModel::kObject).data().toString(), QStringLiteral("0x6040:00"));
}

TEST(SlaveFiguresModel, KeepsToTheRulesOfModels) {
  SlaveFiguresModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  const auto rows = [](int count) {
    std::vector<SlaveFiguresModel::Row> made(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) made[static_cast<std::size_t>(i)].name = QString::number(i);
    return made;
  };
  for (const int count : {0, 3, 5, 2, 2, 0}) {
    model.setRows(rows(count), 127);
    EXPECT_EQ(model.rowCount(), count);
  }
}

}  // namespace
}  // namespace syncline::ui
