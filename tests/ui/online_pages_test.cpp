// SPDX-License-Identifier: Apache-2.0
// The pages that ask one slave, with a master that answers as the test says: what is missing, what is over, and whose
// an answer is when the project has changed meanwhile.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <functional>

#include "protocol/registers.h"
#include "support/patient_master.h"
#include "support/ui_test_support.h"
#include "ui/dialogs/slave_state_commands.h"
#include "ui/models/object_model.h"
#include "ui/models/register_model.h"
#include "ui/pages/slave_counters_page.h"
#include "ui/pages/slave_objects_page.h"
#include "ui/pages/slave_registers_page.h"
#include "ui/panels/slave_state_bar.h"
#include "ui/session/dictionary_reader.h"
#include "ui/session/workspace.h"
#include "ui/widgets/poll_choice.h"

namespace syncline::ui {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Answer = std::function<void(RequestTicket&)>;

constexpr int kDrive = 1, kSecondDrive = 2;

/// A machine of a coupler and two drives that speak CoE, in PREOP.
class PagesOfASlave : public ::testing::Test {
 protected:
  PagesOfASlave() : workspace_(environment()) {
    workspace_.live().setAutoAdvance(false);
    workspace_.document().replace(QStringLiteral("load"), machine());
  }
  ~PagesOfASlave() override { workspace_.live().shutDown(); }

  static Project machine() {
    auto machine = test::smallProject();
    for (auto& slave : machine.slaves) {
      slave.device.mailbox.emplace().coe.emplace();
      slave.device.dictionary = {object(0x1000, "Device type"), object(0x1008, "Device name")};
    }
    return machine;
  }
  static ObjectDescription object(std::uint16_t index, const char* name) {
    ObjectEntry only;
    only.name = name;
    only.data_type = "UDINT";
    only.bit_length = 32;
    only.readable = true;
    ObjectDescription result;
    result.index = index;
    result.name = name;
    result.entries = {only};
    return result;
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

  const Project& project() { return workspace_.document().project(); }
  void goOnline() {
    NetworkConfig config;
    for (const auto& slave : project().slaves) {
      SlaveConfig one;
      one.station_address = slave.station_address;
      one.identity = slave.device.identity;
      one.mailbox.emplace().coe = true;
      config.slaves.push_back(one);
    }
    snapshot_.slaves.assign(config.slaves.size(), {});
    for (auto& slave : snapshot_.slaves) {
      slave.present = true;
      slave.al_status = 2;
    }
    snapshot_.online = true;
    snapshot_.state = snapshot_.requested = AlState::kPreop;
    ASSERT_TRUE(workspace_.live().goOnline(QStringLiteral("sim:patient"), {{}, {}, config}));
    tick(kSecond);
  }
  void tick(Nanoseconds time) {
    snapshot_.time = time;
    master_->channels().snapshot.publish_first(snapshot_);
    workspace_.live().advance(kMillisecond);
  }
  /// Shown, and told of each tick.
  template <class Shown>
  Shown& open(Shown& page, int slave) {
    page.setNode(slave);
    page.show();
    QObject::connect(&workspace_.live(), &LiveSession::snapshotChanged, &page,
                     [this, &page] { page.showLive(workspace_.live().snapshot()); });
    QObject::connect(&workspace_.live(), &LiveSession::phaseChanged, &page,
                     [this, &page] { page.showLive(workspace_.live().snapshot()); });
    return page;
  }
  /// Whatever is asked until nothing is asked any more.
  void answerAll(const Answer& how) {
    for (auto tickets = master_->taken(); !tickets.empty(); tickets = master_->taken()) {
      for (auto* ticket : tickets) {
        how(*ticket);
        master_->channels().requests.answer(*ticket, snapshot_.time);
      }
      workspace_.live().advance(kMillisecond);
    }
  }
  static void fail(RequestTicket& ticket, ErrorCode code) {
    ticket.bytes.clear();
    ticket.failure = BriefError{.code = code, .expected = 1};
  }
  /// Registers that hold zeros.
  static void zeros(RequestTicket& ticket) {
    ticket.bytes.assign(std::get<requests::RegisterRead>(ticket.request).length, 0);
  }

  test::PatientMaster* master_ = nullptr;
  Workspace workspace_;
  Snapshot snapshot_;
};

QString textOf(QWidget& page, const char* label) { return test::find<QLabel>(page, label)->text(); }
void click(QWidget& page, const char* button) { test::find<QPushButton>(page, button)->click(); }

// ---- registers ----------------------------------------------------------------------------------

class RegistersOfASlave : public PagesOfASlave {
 protected:
  QString shown(std::uint16_t address, RegisterModel::Column column) {
    const auto& all = page_.model().layouts();
    const auto at = std::ranges::find(all, address, &reg::RegisterLayout::address);
    return page_.model().index(static_cast<int>(at - all.begin()), column).data().toString();
  }
  SlaveRegistersPage page_{workspace_};
};

TEST_F(RegistersOfASlave, WhatTheEscHasNotIsSaid) {
  goOnline();
  open(page_, kDrive);
  click(page_, "registerRead");
  answerAll([](RequestTicket& ticket) {
    const auto address = std::get<requests::RegisterRead>(ticket.request).address;
    if (address >= 0x0900 && address < 0x0A00) return fail(ticket, ErrorCode::kWorkingCounter);
    zeros(ticket);
    if (address == 0) ticket.bytes.at(4) = ticket.bytes.at(5) = 8;  // FMMUs and SyncManagers
  });
  EXPECT_EQ(shown(reg::kSystemTime, RegisterModel::kValue), QStringLiteral("not in this ESC"));
  EXPECT_FALSE(page_.model().value(reg::kAlStatus).empty());
  EXPECT_EQ(textOf(page_, "registerStatus"), QString());
}

TEST_F(RegistersOfASlave, APulledCableTakesNoRegisterAway) {
  goOnline();
  open(page_, kDrive);
  click(page_, "registerRead");
  int answered = 0;
  answerAll([&](RequestTicket& ticket) {
    // In the middle of it.
    ++answered < 4 ? zeros(ticket) : fail(ticket, ErrorCode::kWorkingCounter);
  });
  EXPECT_EQ(shown(reg::kSystemTime, RegisterModel::kValue), QString());
  EXPECT_FALSE(textOf(page_, "registerStatus").isEmpty()) << "nothing more answers";
}

TEST_F(RegistersOfASlave, AgesEndWithTheRun) {
  goOnline();
  open(page_, kDrive);
  click(page_, "registerRead");
  answerAll(zeros);
  tick(3 * kSecond);
  EXPECT_EQ(shown(reg::kAlStatus, RegisterModel::kAge), QStringLiteral("2.0 s"));
  workspace_.live().shutDown();
  EXPECT_EQ(shown(reg::kAlStatus, RegisterModel::kAge), QStringLiteral("last run"));
}

TEST_F(RegistersOfASlave, AnotherMachineHasOthers) {
  goOnline();
  open(page_, kDrive);
  click(page_, "registerRead");
  answerAll(zeros);
  workspace_.live().shutDown();
  ASSERT_FALSE(page_.model().value(reg::kAlStatus).empty());
  workspace_.document().take(workspace_.document().machine(), {}, false);
  EXPECT_TRUE(page_.model().value(reg::kAlStatus).empty()) << "alike as its slaves are";
}

TEST_F(RegistersOfASlave, ASecondRunIsPolledToo) {
  PollChoice poll(QStringLiteral("no"), QStringLiteral("%1"), {500, 1000});
  EXPECT_FALSE(poll.due(kSecond));
  poll.setCurrentIndex(1);
  EXPECT_TRUE(poll.due(100 * kSecond));
  EXPECT_FALSE(poll.due(100 * kSecond + 499 * kMillisecond));
  EXPECT_TRUE(poll.due(100 * kSecond + 500 * kMillisecond));
  EXPECT_TRUE(poll.due(kSecond)) << "the clock has begun anew";
  poll.reset();
  EXPECT_FALSE(poll.due(200 * kSecond));
}

// ---- counters -----------------------------------------------------------------------------------

TEST_F(PagesOfASlave, CountersSayWhenTheyWereRead) {
  goOnline();
  SlaveCountersPage page(workspace_);
  open(page, kDrive);
  tick(2 * kSecond);
  const auto* ports = test::find<QTableView>(page, "portCounters")->model();
  const auto* others = test::find<QTableView>(page, "otherCounters")->model();
  ASSERT_EQ(ports->rowCount(), 4);
  EXPECT_EQ(ports->index(0, 1).data().toString(), QStringLiteral("\u2013")) << "never read is not 0";
  EXPECT_EQ(others->index(0, 1).data().toString(), QStringLiteral("\u2013"));
  EXPECT_TRUE(textOf(page, "portCountersAge").contains(QStringLiteral("not yet")));

  auto& evidence = snapshot_.slaves[kDrive].evidence;
  evidence.ports_time = 2 * kSecond;
  evidence.ports[1].invalid_frames = 3;
  evidence.ports[2] = {.lost_links = 255, .at_least = true};
  evidence.pdi_errors = {7, false, 2 * kSecond};
  evidence.processing_unit_errors = {255, true, 2 * kSecond};
  evidence.pdi_watchdog = {2, false, 2 * kSecond};
  tick(2 * kSecond + 300 * kMillisecond);
  EXPECT_EQ(ports->index(0, 1).data().toString(), QStringLiteral("0"));
  EXPECT_TRUE(ports->index(1, 1).data().toString().startsWith(u'3')) << "with how fast it grows";
  EXPECT_TRUE(ports->index(2, 4).data().toString().startsWith(QStringLiteral("at least 255")));
  EXPECT_TRUE(others->index(0, 1).data().toString().startsWith(QStringLiteral("at least 255"))) << "at its end stop";
  EXPECT_TRUE(others->index(1, 1).data().toString().startsWith(u'7'));
  EXPECT_EQ(others->index(2, 1).data().toString(), QStringLiteral("\u2013")) << "this watchdog was not read";
  EXPECT_TRUE(others->index(3, 1).data().toString().startsWith(u'2'));
  EXPECT_TRUE(textOf(page, "portCountersAge").contains(QStringLiteral("0.3 s ago")));

  workspace_.live().shutDown();
  EXPECT_EQ(ports->index(1, 1).data().toString(), QStringLiteral("3")) << "stays and grows no more";
  EXPECT_TRUE(textOf(page, "portCountersAge").contains(QStringLiteral("in the last run")));
  EXPECT_EQ(others->index(3, 3).data().toString(), QStringLiteral("in the last run"));
}

TEST_F(PagesOfASlave, PortsAreAllInSight) {
  goOnline();
  SlaveCountersPage page(workspace_);
  page.resize(700, 420);
  open(page, kDrive);
  tick(2 * kSecond);
  QApplication::processEvents();
  for (const auto* name : {"portCounters", "otherCounters"}) {
    auto* table = test::find<QTableView>(page, name);
    const auto last = table->visualRect(table->model()->index(3, 0));
    EXPECT_TRUE(table->viewport()->rect().contains(last)) << name;
  }
}

// ---- objects ------------------------------------------------------------------------------------

class ObjectsOfASlave : public PagesOfASlave {
 protected:
  /// The slave is asked for all its objects.
  void askForAll() {
    auto* source = test::find<QComboBox>(page_, "objectSource");
    source->setCurrentIndex(1);
    Q_EMIT source->activated(1);
  }
  static void list(RequestTicket& ticket, const std::vector<std::uint16_t>& indices) {
    ticket.bytes = {1, 0};
    for (const auto index : indices) {
      ticket.bytes.push_back(static_cast<std::uint8_t>(index));
      ticket.bytes.push_back(static_cast<std::uint8_t>(index >> 8));
    }
  }
  static bool asksForList(const RequestTicket& ticket) {
    return std::holds_alternative<requests::ObjectListRead>(ticket.request);
  }
  SlaveObjectsPage page_{workspace_};
};

TEST_F(ObjectsOfASlave, AReadingThatBreaksOffIsNoDictionary) {
  goOnline();
  DictionaryReader reader(workspace_.requests());
  int finished = 0, objects = 0;
  QString why;
  QObject::connect(&reader, &DictionaryReader::finished, [&] { ++finished; });
  QObject::connect(&reader, &DictionaryReader::objectRead, [&] { ++objects; });
  QObject::connect(&reader, &DictionaryReader::failed, [&](const QString& text) { why = text; });
  const auto refusing = [](ErrorCode code) {
    return [code](RequestTicket& ticket) {
      asksForList(ticket) ? list(ticket, {0x1000, 0x1008, 0x1018}) : fail(ticket, code);
    };
  };
  reader.start(kDrive, coe::ObjectListType::kAll);
  answerAll(refusing(ErrorCode::kSdoAbort));
  EXPECT_EQ(finished, 1) << "the slave itself refuses them: that is all there is";
  EXPECT_EQ(objects, 3);
  reader.start(kDrive, coe::ObjectListType::kAll);
  answerAll(refusing(ErrorCode::kMailboxTimeout));
  EXPECT_EQ(finished, 1);
  EXPECT_EQ(objects, 3);
  EXPECT_FALSE(why.isEmpty());
  EXPECT_FALSE(reader.isRunning());
}

TEST_F(ObjectsOfASlave, NoDictionaryIsKeptForASlaveThatIsGone) {
  goOnline();
  open(page_, kSecondDrive);
  askForAll();
  page_.hide();  // the master is looked at
  auto shorter = project();
  shorter.slaves.resize(2);
  workspace_.document().replace(QStringLiteral("edit"), shorter);
  answerAll([](RequestTicket& ticket) { list(ticket, {}); });
  workspace_.document().replace(QStringLiteral("back"), machine());
  page_.show();
  page_.setNode(kSecondDrive);
  EXPECT_EQ(test::find<QComboBox>(page_, "objectSource")->currentIndex(), 0) << "it has told nothing";
}

TEST_F(ObjectsOfASlave, WhatASlaveHasToldIsKeptForItsPlaceOnTheBus) {
  goOnline();
  open(page_, kDrive);
  askForAll();
  answerAll(
      [](RequestTicket& ticket) { asksForList(ticket) ? list(ticket, {0x5000}) : fail(ticket, ErrorCode::kSdoAbort); });
  ASSERT_EQ(page_.model().rowCount(), 1);
  page_.setNode(kSecondDrive);
  EXPECT_EQ(page_.model().rowCount(), 2) << "from its ESI";
  page_.setNode(kDrive);
  EXPECT_EQ(page_.model().rowCount(), 1);
  workspace_.document().take(workspace_.document().machine(), {}, false);
  EXPECT_EQ(page_.model().rowCount(), 2) << "another machine";
}

TEST_F(ObjectsOfASlave, ReadIsWhatWasRead) {
  goOnline();
  open(page_, kDrive);
  tick(2 * kSecond);
  click(page_, "objectReadShown");
  answerAll([](RequestTicket& ticket) {
    if (std::get<requests::SdoRead>(ticket.request).object.index == 0x1000) return fail(ticket, ErrorCode::kSdoAbort);
    ticket.bytes = {1, 0, 0, 0};
  });
  EXPECT_TRUE(textOf(page_, "objectStatus").startsWith(QStringLiteral("1 of 2 entries;")))
      << qPrintable(textOf(page_, "objectStatus"));
}

// ---- states -------------------------------------------------------------------------------------

TEST_F(PagesOfASlave, AnAnswerIsForTheSlaveThatWasAsked) {
  goOnline();
  QWidget window;
  SlaveStateCommands commands(workspace_, window);
  std::vector<int> told;
  QObject::connect(&commands, &SlaveStateCommands::told, [&](int slave) { told.push_back(slave); });
  commands.request(kSecondDrive, AlState::kSafeop);
  auto edited = project();
  edited.slaves.erase(edited.slaves.begin() + kDrive);
  workspace_.document().replace(QStringLiteral("edit"), edited);
  answerAll([](RequestTicket&) {});
  EXPECT_EQ(told, (std::vector<int>{kSecondDrive, kSecondDrive - 1}));
}

TEST_F(PagesOfASlave, ARefusalIsReadAndGoesWithItsState) {
  goOnline();
  QWidget window;
  SlaveStateCommands commands(workspace_, window);
  SlaveStateBar bar(workspace_, commands);
  bar.setSlave(kDrive);
  const auto text = [&](Nanoseconds time, std::uint16_t status) {
    snapshot_.slaves[kDrive].al_status = status;
    tick(time);
    bar.showLive();
    return textOf(bar, "slaveStatus");
  };
  commands.request(kDrive, AlState::kSafeop);
  answerAll([](RequestTicket& ticket) { ticket.failure = BriefError{.code = ErrorCode::kTimeout}; });
  const auto refusal = textOf(bar, "slaveStatus");
  EXPECT_FALSE(refusal.startsWith(QStringLiteral("AL status"))) << qPrintable(refusal);
  // The error flag comes with the next snapshot.
  EXPECT_FALSE(text(1100 * kMillisecond, 0x12).startsWith(QStringLiteral("AL status")));
  EXPECT_FALSE(text(5 * kSecond, 0x12).startsWith(QStringLiteral("AL status")));
  EXPECT_TRUE(text(6 * kSecond, 0x02).startsWith(QStringLiteral("AL status"))) << "it was acknowledged";
  commands.request(kDrive, AlState::kSafeop);
  answerAll([](RequestTicket& ticket) { ticket.failure = BriefError{.code = ErrorCode::kTimeout}; });
  EXPECT_TRUE(text(60 * kSecond, 0x02).startsWith(QStringLiteral("AL status"))) << "nobody needs it any more";
}

}  // namespace
}  // namespace syncline::ui
