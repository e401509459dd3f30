// SPDX-License-Identifier: Apache-2.0
// One slave of a running machine: its states, registers, EEPROM and counters.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QTableView>
#include <QTreeView>
#include <algorithm>
#include <fstream>
#include <string>

#include "protocol/registers.h"
#include "protocol/sii.h"
#include "support/byte_order.h"
#include "support/running_window.h"
#include "support/whole_file.h"
#include "tests/support/temporary_folder.h"
#include "ui/dialogs/slave_state_commands.h"
#include "ui/models/count_history.h"
#include "ui/models/eeprom_lines.h"
#include "ui/models/register_model.h"
#include "ui/pages/slave_eeprom_page.h"
#include "ui/pages/slave_files_page.h"
#include "ui/pages/slave_registers_page.h"

namespace syncline::ui {
namespace {

using Bytes = std::vector<std::uint8_t>;

class ASlaveOfARunningMachine : public test::RunningWindow {
 protected:
  AlState stateOf(int slave) {
    return al_state_of(workspace_.live().snapshot().slaves[static_cast<std::size_t>(slave)].al_status);
  }
  void press(const char* name) { field<QPushButton>(name).click(); }
  QString text(const char* name) { return field<QLabel>(name).text(); }
};

// ---- states -------------------------------------------------------------------------------------

TEST_F(ASlaveOfARunningMachine, IsLedWhileTheOthersStay) {
  goOnline();
  window_.selectNode(kServo);
  run(100 * kMillisecond);
  EXPECT_TRUE(field("slaveStatus").isVisible());
  EXPECT_TRUE(field("slaveRequestOP").isEnabled());
  answerQuestion("stateQuestion", false);
  press("slaveRequestPREOP");
  run(kSecond);
  EXPECT_EQ(stateOf(kServo), AlState::kOp) << "who says no changes nothing";
  EXPECT_TRUE(asked_.contains(QStringLiteral("recovery"))) << qPrintable(asked_);
  answerQuestion("stateQuestion", true);
  press("slaveRequestPREOP");
  run(3 * kSecond);
  EXPECT_EQ(stateOf(kServo), AlState::kPreop) << qPrintable(text("slaveStatus"));
  EXPECT_EQ(stateOf(kOtherServo), AlState::kOp);
  run(5 * kSecond);
  EXPECT_EQ(stateOf(kServo), AlState::kPreop) << "nobody brings it back behind the engineer's back";
  // Upwards nothing is hurt: nothing is asked.
  press("slaveRequestOP");
  run(5 * kSecond);
  EXPECT_EQ(stateOf(kServo), AlState::kOp) << qPrintable(text("slaveStatus"));
}

TEST_F(ASlaveOfARunningMachine, OfflineHasNoButtons) {
  load();
  window_.selectNode(kServo);
  EXPECT_FALSE(field("slaveStatus").isVisible());
  QMenu menu;
  window_.editor().states().addTo(menu, kServo);
  for (auto* action : menu.actions()) EXPECT_TRUE(action->isSeparator() || !action->isEnabled());
}

TEST_F(ASlaveOfARunningMachine, HasBootWhereItTakesFiles) {
  goOnline();
  const auto& commands = window_.editor().states();
  const auto boots = [&](int slave) {
    const auto states = commands.states(slave);
    return std::ranges::find(states, AlState::kBoot) != states.end();
  };
  EXPECT_FALSE(boots(kCoupler));
  const auto& mailbox = workspace_.live().record()->config().slaves[kServo].mailbox;
  EXPECT_EQ(boots(kServo), mailbox && mailbox->foe && mailbox->bootstrap_send.has_value());
}

// ---- registers ----------------------------------------------------------------------------------

TEST(RegisterModel, IsATreeOfFields) {
  RegisterModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  const auto row = [&](std::uint16_t address) {
    const auto& all = model.layouts();
    return static_cast<int>(std::ranges::find(all, address, &reg::RegisterLayout::address) - all.begin());
  };
  model.setValues(0x0130, {0x14, 0, 0, 0, 0x1B, 0}, 5 * kSecond);
  model.setNow(6 * kSecond);
  const auto status = model.index(row(reg::kAlStatus), RegisterModel::kValue);
  EXPECT_EQ(status.data().toString(), QStringLiteral("SAFEOP + ERR"));
  EXPECT_TRUE(status.siblingAtColumn(RegisterModel::kAge).data().toString().startsWith(QStringLiteral("1")));
  EXPECT_EQ(model.value(reg::kAlStatusCode), (Bytes{0x1B, 0}));
  const auto top = status.siblingAtColumn(0);
  ASSERT_EQ(model.rowCount(top), 3);
  EXPECT_EQ(model.index(1, RegisterModel::kValue, top).data().toString(), QStringLiteral("yes"));
  model.setFailure(0x0130, 2, QStringLiteral("none"));
  EXPECT_TRUE(model.value(reg::kAlStatus).empty());
  EXPECT_FALSE(model.value(reg::kAlStatusCode).empty());
  model.setUnits(1, 1);
  EXPECT_TRUE(model.value(reg::kAlStatusCode).empty());
}

TEST_F(ASlaveOfARunningMachine, ShowsItsRegisters) {
  goOnline();
  show(kServo, "slaveRegistersPage");
  auto& model = field<SlaveRegistersPage>("slaveRegistersPage").model();
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  press("registerRead");
  run(kSecond);
  EXPECT_EQ(model.value(reg::kAlStatus), (Bytes{8, 0})) << qPrintable(text("registerStatus"));
  EXPECT_EQ(model.value(reg::kStationAddress).at(0), project().slaves[kServo].station_address & 0xFF);
  EXPECT_FALSE(model.value(reg::kSync0CycleTime).empty());
  EXPECT_TRUE(model.value(reg::kLatch0PositiveEdge).empty()) << "reading it takes something away";
  EXPECT_EQ(workspace_.live().snapshot().wkc_errors, 0U);
  EXPECT_FALSE(field("registerWrite").isVisible()) << "for experts";
}

TEST_F(ASlaveOfARunningMachine, PollsRegistersAndWritesThemForExperts) {
  goOnline();
  workspace_.setExpert(true);
  show(kServo, "slaveRegistersPage");
  auto& model = field<SlaveRegistersPage>("slaveRegistersPage").model();
  auto& search = field<QLineEdit>("registerSearch");
  search.setText(QStringLiteral("0x0400"));
  auto& poll = field<QComboBox>("registerPoll");
  poll.setCurrentIndex(1);
  run(2 * kSecond);
  ASSERT_FALSE(model.value(reg::kWatchdogDivider).empty());
  EXPECT_TRUE(model.value(reg::kAlStatus).empty()) << "not shown";
  auto& tree = field<QTreeView>("registerTree");
  tree.setCurrentIndex(tree.model()->index(0, 0));
  field<QLineEdit>("registerValue").setText(QStringLiteral("0x10000"));
  EXPECT_FALSE(field("registerWrite").isEnabled()) << "two bytes";
  field<QLineEdit>("registerValue").setText(QStringLiteral("0x09C3"));
  ASSERT_TRUE(field("registerWrite").isEnabled());
  answerQuestion("registerQuestion", true);
  workspace_.document().replace(QStringLiteral("edit"), [this] {
    auto edited = project();
    edited.slaves[kOtherServo].name = "Other";
    return edited;
  }());
  EXPECT_EQ(field<QLineEdit>("registerValue").text(), QStringLiteral("0x09C3")) << "what is typed stays";
  press("registerWrite");
  run(kSecond);
  EXPECT_EQ(model.value(reg::kWatchdogDivider), (Bytes{0xC3, 0x09})) << qPrintable(text("registerStatus"));
  EXPECT_TRUE(text("registerStatus").contains(QStringLiteral("is 0x09C3 now"))) << qPrintable(text("registerStatus"));
  // Another list of registers: none of them is selected.
  model.setUnits(1, 1);
  EXPECT_FALSE(field("registerWrite").isEnabled());
  EXPECT_TRUE(field<QLineEdit>("registerValue").text().isEmpty());
}

// ---- EEPROM -------------------------------------------------------------------------------------

TEST(EepromText, SaysWhatIsInIt) {
  sii::Image image;
  image.vendor_id = 0x2;
  image.alias = 77;
  image.mailbox_protocols = sii::kProtocolCoe | sii::kProtocolFoe;
  const auto lines = eepromLines(*sii::decode(sii::encode(image)));
  const auto has = [&](const QString& part, const QString& value) {
    return std::ranges::any_of(lines, [&](const QStringList& line) { return line[0] == part && line[1] == value; });
  };
  EXPECT_TRUE(has(QStringLiteral("Alias"), QStringLiteral("77")));
  EXPECT_TRUE(has(QStringLiteral("Mailbox protocols"), QStringLiteral("CoE, FoE")));
  EXPECT_TRUE(has(QStringLiteral("Checksum of the configuration"), QStringLiteral("right")));
  const auto hex = hexView(Bytes{'H', 'i', 0});
  EXPECT_TRUE(hex.startsWith(QStringLiteral("0x0000  48 69 00"))) << qPrintable(hex);
  EXPECT_TRUE(hex.endsWith(QStringLiteral("Hi.\n"))) << qPrintable(hex);
}

/// The window with a journal of its own.
class TheEepromOfARunningSlave : public ASlaveOfARunningMachine {
 protected:
  SlaveEepromPage& page() { return field<SlaveEepromPage>("slaveEepromPage"); }
  void readAll() {
    show(kServo, "slaveEepromPage");
    press("eepromRead");
    for (int i = 0; i < 200 && page().image().empty(); ++i) run(100 * kMillisecond);
    ASSERT_FALSE(page().image().empty()) << qPrintable(text("eepromStatus"));
  }
};

TEST_F(TheEepromOfARunningSlave, IsReadAndGetsAnAlias) {
  goOnline();
  readAll();
  const auto decoded = sii::decode(page().image());
  ASSERT_TRUE(decoded);
  EXPECT_EQ(decoded->vendor_id, project().slaves[kServo].device.identity.vendor_id);
  EXPECT_FALSE(field<QPlainTextEdit>("eepromHex").toPlainText().isEmpty());
  field<QSpinBox>("eepromAlias").setValue(4711);
  answerQuestion("eepromQuestion", true);
  press("eepromWriteAlias");
  bool told = false;
  for (int i = 0; i < 150; ++i) {
    run(20 * kMillisecond);
    told = told || text("eepromStatus").contains(QStringLiteral("of 2 words are written"));
  }
  EXPECT_TRUE(told) << "how far it is";
  EXPECT_TRUE(text("eepromStatus").contains(QStringLiteral("4711"))) << qPrintable(text("eepromStatus"));
  const auto again = sii::decode(page().image());
  ASSERT_TRUE(again);
  EXPECT_EQ(again->alias, 4711);
  EXPECT_TRUE(again->checksum_ok);
  EXPECT_EQ(workspace_.live().snapshot().wkc_errors, 0U);
  EXPECT_EQ(stateOf(kServo), AlState::kOp);
}

TEST_F(TheEepromOfARunningSlave, TakesAnImageOfExpertsAndRefusesWhatDoesNotFit) {
  goOnline();
  show(kServo, "slaveEepromPage");
  EXPECT_FALSE(field("eepromLoad").isVisible()) << "for experts";
  workspace_.setExpert(true);
  readAll();
  EXPECT_TRUE(field("eepromLoad").isVisible());
  auto image = page().image();
  page().writeImage(Bytes(image.size() + 2, 0));
  EXPECT_TRUE(text("eepromStatus").contains(QStringLiteral("does not fit"))) << qPrintable(text("eepromStatus"));
  auto decoded = sii::decode(image);
  ASSERT_TRUE(decoded);
  decoded->serial_no = 99;
  answerQuestion("eepromQuestion", true);
  page().writeImage(sii::encode(*decoded));
  // Who looks at another slave meanwhile does not end it.
  window_.selectNode(kOtherServo);
  run(40 * kSecond);
  readAll();
  const auto again = sii::decode(page().image());
  ASSERT_TRUE(again);
  EXPECT_EQ(again->serial_no, 99U);
}

// ---- files --------------------------------------------------------------------------------------

class TheFilesOfARunningSlave : public ASlaveOfARunningMachine {
 protected:
  TheFilesOfARunningSlave() { std::ofstream(folder_.file("in.bin"), std::ios::binary) << content_; }
  SlaveFilesPage& page() { return field<SlaveFilesPage>("slaveFilesPage"); }
  QString here(const char* name) const { return QString::fromStdString(folder_.file(name)); }
  void open() {
    goOnline();
    show(kServo, "slaveFilesPage");
    run(100 * kMillisecond);
  }
  void write(const char* name) {
    field<QLineEdit>("fileName").setText(QLatin1String(name));
    answerQuestion("fileQuestion", true);
    page().writeFrom(here("in.bin"));
  }
  void finish() {
    for (int i = 0; i < 400 && field("fileCancel").isEnabled(); ++i) run(100 * kMillisecond);
    ASSERT_FALSE(field("fileCancel").isEnabled()) << qPrintable(text("fileStatus"));
  }
  const QAbstractItemModel& transfers() { return *field<QTableView>("fileTransfers").model(); }

  test::TemporaryFolder folder_;
  const std::string content_ = std::string(5000, 'p') + "end";
};

TEST_F(TheFilesOfARunningSlave, ComeAndGoWhileTheMachineRuns) {
  open();
  EXPECT_FALSE(field("fileRead").isEnabled()) << "no name yet";
  write("parameters.bin");
  EXPECT_TRUE(asked_.contains(QStringLiteral("in OP"))) << qPrintable(asked_);
  finish();
  EXPECT_TRUE(text("fileStatus").contains(QStringLiteral("Written"))) << qPrintable(text("fileStatus"));
  page().readInto(here("out.bin"));
  finish();
  EXPECT_EQ(read_whole_file(folder_.file("out.bin")), content_) << qPrintable(text("fileStatus"));
  ASSERT_EQ(transfers().rowCount(), 2);
  EXPECT_EQ(transfers().index(0, 2).data().toString(), QStringLiteral("parameters.bin"));
  EXPECT_EQ(workspace_.live().snapshot().wkc_errors, 0U);
  EXPECT_EQ(stateOf(kServo), AlState::kOp);
}

TEST_F(TheFilesOfARunningSlave, WhatTheSlaveRefusesLeavesTheFileHereAsItWas) {
  open();
  field<QLineEdit>("fileName").setText(QStringLiteral("nothing.bin"));
  page().readInto(here("in.bin"));
  finish();
  EXPECT_TRUE(text("fileStatus").contains(QStringLiteral("nothing.bin"))) << qPrintable(text("fileStatus"));
  EXPECT_EQ(read_whole_file(folder_.file("in.bin")), content_);
  EXPECT_NE(transfers().index(0, 5).data().toString(), QStringLiteral("Read"));
}

TEST_F(TheFilesOfARunningSlave, AreNotWrittenWithoutAYesNorWithAPasswordThatIsNoNumber) {
  open();
  field<QLineEdit>("fileName").setText(QStringLiteral("a.bin"));
  answerQuestion("fileQuestion", false);
  page().writeFrom(here("in.bin"));
  EXPECT_FALSE(field("fileCancel").isEnabled());
  field<QLineEdit>("filePassword").setText(QStringLiteral("secret"));
  page().writeFrom(here("in.bin"));
  EXPECT_TRUE(text("fileStatus").contains(QStringLiteral("secret"))) << qPrintable(text("fileStatus"));
  EXPECT_FALSE(field("fileCancel").isEnabled());
  EXPECT_EQ(transfers().rowCount(), 0);
}

TEST_F(TheFilesOfARunningSlave, GoOnWhileAnotherSlaveIsShownAndCanBeCancelled) {
  std::ofstream(folder_.file("in.bin"), std::ios::binary) << std::string(200'000, 'x');
  open();
  write("large.bin");
  window_.selectNode(kOtherServo);
  run(200 * kMillisecond);
  EXPECT_TRUE(workspace_.requests().writing());
  EXPECT_TRUE(text("fileStatus").contains(QStringLiteral("large.bin"))) << qPrintable(text("fileStatus"));
  EXPECT_FALSE(field("fileWrite").isEnabled()) << "one at a time";
  answerQuestion("writingQuestion", false);
  window_.bus().goOffline();
  EXPECT_TRUE(workspace_.requests().writing()) << "who says no stays online";
  press("fileCancel");
  finish();
  EXPECT_TRUE(transfers().index(0, 5).data().toString().startsWith(QStringLiteral("Cancelled")))
      << qPrintable(transfers().index(0, 5).data().toString());
}

TEST_F(TheFilesOfARunningSlave, AreNoPageOfASlaveWithoutThem) {
  EXPECT_FALSE(page().appliesTo(-1));
  open();
  EXPECT_TRUE(page().appliesTo(kServo));
  EXPECT_FALSE(page().appliesTo(kCoupler));
  EXPECT_FALSE(page().appliesTo(1000));
}

// ---- counters -----------------------------------------------------------------------------------

TEST(CountHistory, SaysHowFastTheyGrow) {
  CountHistory history;
  EXPECT_EQ(history.growth(0), 0U);
  for (int second = 0; second <= 30; ++second)
    history.add(second * kSecond, {static_cast<std::uint32_t>(2 * second), 5});
  EXPECT_EQ(history.growth(0), 20U) << "in ten seconds";
  EXPECT_EQ(history.growth(1), 0U);
  history.add(31 * kSecond, {0, 0});
  EXPECT_EQ(history.growth(0), 0U) << "cleared in between";
  EXPECT_EQ(growingText(255, true, 3), QStringLiteral("at least 255 (+3 in 10 s)"));
}

TEST_F(ASlaveOfARunningMachine, ShowsItsCounters) {
  goOnline();
  show(kServo, "slaveCountersPage");
  run(3 * kSecond);
  const auto* ports = field<QTableView>("portCounters").model();
  ASSERT_EQ(ports->rowCount(), 4);
  EXPECT_EQ(ports->index(0, 1).data().toString(), QStringLiteral("0"));
  ASSERT_EQ(field<QTableView>("otherCounters").model()->rowCount(), 4);
  for (int row = 0; row < 4; ++row) {
    const auto* others = field<QTableView>("otherCounters").model();
    EXPECT_EQ(others->index(row, 1).data().toString(), QStringLiteral("0")) << row;
    EXPECT_TRUE(others->index(row, 3).data().toString().endsWith(QStringLiteral("s ago"))) << row;
  }
  workspace_.live().shutDown();
  EXPECT_EQ(ports->rowCount(), 4) << "what was counted stays";
}

}  // namespace
}  // namespace syncline::ui
