// SPDX-License-Identifier: Apache-2.0
// The page of the diagnosis history: with a master that answers as the test says, and on the simulated machine.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <map>

#include "support/patient_master.h"
#include "support/running_window.h"
#include "ui/models/diagnosis_model.h"
#include "ui/pages/slave_history_page.h"
#include "ui/session/diagnosis_reader.h"

namespace syncline::ui {
namespace {

using HistoryBytes = std::vector<std::uint8_t>;
using DiagType = DiagnosisMessage::Type;

DiagnosisMessage diagMessage(DiagType type, std::uint16_t text_id, std::uint64_t time) {
  return {0x8700E000, type, text_id, time, {{6, {0x1A, 0}}}};
}

TEST(DiagnosisModel, ShowsTheNewestFirstWithTheWordsOfTheEsi) {
  DiagnosisModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  const auto old = diagMessage(DiagType::kWarning, 1, 5'000'000'000).encode();
  const auto fresh = diagMessage(DiagType::kError, 2, 800'000'000ULL * 1'000'000'000).encode();
  const auto log = diagnosis_log({8, 3, 7, 6, true, 0}, {{6, old}, {7, fresh}, {8, HistoryBytes{1, 2}}});
  model.setLog(log);
  ASSERT_EQ(model.rowCount(), 3);
  const auto cell = [&](int row, DiagnosisModel::Column column) { return model.index(row, column).data().toString(); };
  EXPECT_EQ(cell(0, DiagnosisModel::kPlace), QStringLiteral("0x07"));
  EXPECT_EQ(cell(0, DiagnosisModel::kText), QStringLiteral("text 0x0002 [26]")) << "nobody knows its words";
  EXPECT_EQ(cell(0, DiagnosisModel::kState), QStringLiteral("New"));
  EXPECT_EQ(cell(1, DiagnosisModel::kState), QStringLiteral("Acknowledged"));
  EXPECT_EQ(cell(0, DiagnosisModel::kCode), QStringLiteral("0x8700E000"));
  EXPECT_TRUE(cell(0, DiagnosisModel::kTime).startsWith(QStringLiteral("2025-05-0")))
      << qPrintable(cell(0, DiagnosisModel::kTime));
  EXPECT_TRUE(cell(1, DiagnosisModel::kTime).contains(QStringLiteral("since its start")));
  EXPECT_TRUE(cell(2, DiagnosisModel::kText).contains(QStringLiteral("01 02"))) << "too short for a message";
  model.setTexts({{2, "Left OP: 0x%04X", "Look at the frames"}});
  EXPECT_EQ(cell(0, DiagnosisModel::kText), QStringLiteral("Left OP: 0x001A"));
  EXPECT_TRUE(model.index(0, DiagnosisModel::kText)
                  .data(Qt::ToolTipRole)
                  .toString()
                  .contains(QStringLiteral("Look at the frames")));
  const auto lines = model.csv().split(u'\n');
  ASSERT_EQ(lines.size(), 5);
  EXPECT_TRUE(
      lines[2].startsWith(QStringLiteral("0x06,Acknowledged,Warning,0x8700E000,0x0001,text 0x0001 [26],5000000000,")))
      << qPrintable(lines[2]);
  int resets = 0;
  QObject::connect(&model, &DiagnosisModel::modelReset, [&] { ++resets; });
  model.setLog(log);
  EXPECT_EQ(resets, 0) << "a selection stays while it is polled";
}

/// A drive in PREOP whose history is what the test has put into it.
class HistoryOfASlave : public ::testing::Test {
 protected:
  HistoryOfASlave() : workspace_(environment()) {
    workspace_.live().setAutoAdvance(false);
    auto machine = test::smallProject();
    for (auto& slave : machine.slaves) slave.device.mailbox.emplace().coe.emplace();
    workspace_.document().replace(QStringLiteral("load"), machine);
    for (std::uint8_t sub = 6; sub <= 9; ++sub) entries_[sub] = HistoryBytes(16, 0);
    set({9}, {4}, {0}, {0}, {0});
    entries_[5] = {0, 0};
  }
  ~HistoryOfASlave() override { workspace_.live().shutDown(); }
  void set(HistoryBytes last, HistoryBytes most, HistoryBytes newest, HistoryBytes acknowledged, HistoryBytes fresh) {
    entries_[0] = std::move(last);
    entries_[1] = std::move(most);
    entries_[2] = std::move(newest);
    entries_[3] = std::move(acknowledged);
    entries_[4] = std::move(fresh);
  }
  Environment environment() {
    Environment result;
    result.open_master = [this](const QString&, const Project&) -> Result<std::unique_ptr<BackgroundMaster>> {
      auto master = std::make_unique<test::PatientMaster>();
      master_ = master.get();
      return master;
    };
    return result;
  }
  void goOnline(bool coe = true) {
    NetworkConfig config;
    for (const auto& slave : workspace_.document().project().slaves) {
      SlaveConfig one;
      one.station_address = slave.station_address;
      one.identity = slave.device.identity;
      one.mailbox.emplace().coe = coe;
      config.slaves.push_back(one);
    }
    snapshot_.slaves.assign(config.slaves.size(), {});
    for (auto& slave : snapshot_.slaves) {
      slave.present = true;
      slave.al_status = 2;
    }
    snapshot_.online = true;
    ASSERT_TRUE(workspace_.live().goOnline(QStringLiteral("sim:patient"), {{}, {}, config}));
    tick(kSecond);
    page_.setNode(1);
    page_.show();
    QObject::connect(&workspace_.live(), &LiveSession::snapshotChanged, &page_,
                     [this] { page_.showLive(workspace_.live().snapshot()); });
    tick(2 * kSecond);
  }
  void tick(Nanoseconds time) {
    snapshot_.time = time;
    master_->channels().snapshot.publish_first(snapshot_);
    workspace_.live().advance(kMillisecond);
  }
  void answer(RequestTicket& ticket) {
    ++asked_;
    if (const auto* write = std::get_if<requests::SdoWrite>(&ticket.request)) {
      written_ = *write;
      entries_[write->object.sub_index] = write->data;
      entries_[4] = {0};
      ticket.bytes.clear();
      return;
    }
    const auto object = std::get<requests::SdoRead>(ticket.request).object;
    EXPECT_EQ(object.index, 0x10F3);
    const auto entry = entries_.find(object.sub_index);
    if (entry != entries_.end() && !absent_) {
      ticket.bytes = entry->second;
    } else {
      ticket.failure = BriefError{.code = failure_, .received = 0x06020000};
    }
  }
  void answerAll() {
    for (auto tickets = master_->taken(); !tickets.empty(); tickets = master_->taken()) {
      for (auto* ticket : tickets) {
        answer(*ticket);
        if (after_answer_) after_answer_();
        master_->channels().requests.answer(*ticket, snapshot_.time);
      }
      workspace_.live().advance(kMillisecond);
    }
    tick(snapshot_.time + kMillisecond);
  }
  QString text(const char* label) { return test::find<QLabel>(page_, label)->text(); }
  QPushButton& button(const char* name) { return *test::find<QPushButton>(page_, name); }

  test::PatientMaster* master_ = nullptr;
  Workspace workspace_;
  Snapshot snapshot_;
  SlaveHistoryPage page_{workspace_};
  std::map<std::uint8_t, HistoryBytes> entries_;
  bool absent_ = false;
  ErrorCode failure_ = ErrorCode::kSdoAbort;
  int asked_ = 0;
  std::optional<requests::SdoWrite> written_;
  std::function<void()> after_answer_;
};

TEST_F(HistoryOfASlave, IsReadByItselfAndOnlyOnce) {
  set({9}, {4}, {7}, {6}, {1});
  entries_[6] = diagMessage(DiagType::kInfo, 1, 5).encode();
  entries_[7] = diagMessage(DiagType::kError, 2, 6).encode();
  entries_[5] = {0x11, 0};
  goOnline();
  answerAll();
  ASSERT_EQ(page_.model().rowCount(), 2);
  EXPECT_EQ(page_.model().unacknowledged(), 1);
  EXPECT_EQ(text("historySummary"),
            QStringLiteral("2 of at most 4 messages. Newest: 0x10F3:07. Newest acknowledged: 0x10F3:06. New messages "
                           "available: yes."));
  EXPECT_TRUE(text("historyFlags").contains(QStringLiteral("keeps what nobody has acknowledged")));
  EXPECT_EQ(text("historyStatus"), QString());
  const int before = asked_;
  answerAll();
  EXPECT_EQ(asked_, before) << "nobody wants it again";
  button("historyRead").click();
  answerAll();
  EXPECT_GT(asked_, before);
}

TEST_F(HistoryOfASlave, ADeviceWithoutOneSaysSo) {
  absent_ = true;
  goOnline();
  answerAll();
  EXPECT_TRUE(text("historyStatus").contains(QStringLiteral("no object 0x10F3")));
  EXPECT_FALSE(button("historyAcknowledge").isEnabled());
  EXPECT_FALSE(button("historyExport").isEnabled());
  EXPECT_EQ(asked_, 1);
}

TEST_F(HistoryOfASlave, AMailboxThatIsSilentIsNoMissingHistory) {
  absent_ = true;
  failure_ = ErrorCode::kMailboxTimeout;
  goOnline();
  answerAll();
  EXPECT_FALSE(text("historyStatus").isEmpty());
  EXPECT_FALSE(text("historyStatus").contains(QStringLiteral("no object 0x10F3")));
}

TEST_F(HistoryOfASlave, WithoutCoENothingIsAsked) {
  goOnline(false);
  answerAll();
  EXPECT_EQ(asked_, 0);
  EXPECT_TRUE(text("slaveHistoryPageHint").contains(QStringLiteral("CoE")));
}

TEST_F(HistoryOfASlave, AMessageThatComesWhileItIsReadIsNotTakenForAnOldOne) {
  set({9}, {4}, {6}, {0}, {1});
  entries_[6] = diagMessage(DiagType::kInfo, 1, 5).encode();
  bool told = false;
  after_answer_ = [&] {
    if (asked_ != 8 || std::exchange(told, true)) return;  // in the middle of the messages
    entries_[7] = diagMessage(DiagType::kError, 2, 6).encode();
    entries_[2] = {7};
  };
  goOnline();
  answerAll();
  ASSERT_EQ(page_.model().rowCount(), 2);
  EXPECT_EQ(page_.model().log().header.newest, 7);
  EXPECT_EQ(page_.model().log().entries.back().sub_index, 7);
}

// ---- on the simulated machine ---------------------------------------------------------------------

class HistoryInTheWindow : public test::RunningWindow {
 protected:
  /// Machine time until the history was read.
  void read() {
    field<QPushButton>("historyRead").click();
    run(500 * kMillisecond);
  }
};

TEST_F(HistoryInTheWindow, ADrivesFaultIsThereIsAcknowledgedAndStays) {
  goOnline();
  show(kServo, "slaveHistoryPage");
  run(kSecond);
  auto& model = *field<QTableView>("historyTable").model();
  auto& acknowledge = field<QPushButton>("historyAcknowledge");
  EXPECT_EQ(model.rowCount(), 0) << "it started without a fault";
  EXPECT_FALSE(acknowledge.isEnabled());
  EXPECT_EQ(workspace_.live().snapshot().state, AlState::kOp) << "reading disturbs nothing";

  const auto slave = runningSlave(workspace_, kServo);
  ASSERT_TRUE(slave);
  QObject asker;
  workspace_.requests().post(requests::RegisterWrite{.slave = slave->position, .address = 0x0981, .data = {0}}, asker,
                             [](const RequestOutcome& outcome) { EXPECT_TRUE(outcome.ok()); });
  run(2 * kSecond);
  read();
  ASSERT_GE(model.rowCount(), 1) << "SYNC0 has stopped";
  const auto cell = [&](DiagnosisModel::Column column) { return model.index(0, column).data().toString(); };
  EXPECT_EQ(cell(DiagnosisModel::kType), QStringLiteral("Error"));
  EXPECT_EQ(cell(DiagnosisModel::kState), QStringLiteral("New"));
  EXPECT_TRUE(cell(DiagnosisModel::kCode).endsWith(QStringLiteral("E000"))) << qPrintable(cell(DiagnosisModel::kCode));
  const auto rows = model.rowCount();
  ASSERT_TRUE(acknowledge.isEnabled());
  answerQuestion("acknowledgeQuestion", false);
  acknowledge.click();
  run(kSecond);
  EXPECT_EQ(cell(DiagnosisModel::kState), QStringLiteral("New")) << "nobody wanted it";
  answerQuestion("acknowledgeQuestion", true);
  acknowledge.click();
  run(kSecond);
  EXPECT_EQ(model.rowCount(), rows);
  EXPECT_EQ(cell(DiagnosisModel::kState), QStringLiteral("Acknowledged"));
  EXPECT_FALSE(acknowledge.isEnabled());
}

}  // namespace
}  // namespace syncline::ui
