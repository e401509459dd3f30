// SPDX-License-Identifier: Apache-2.0
// The page of objects: offline from the ESI, online on the simulated machine while it runs.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTimer>
#include <QTreeView>

#include "eni/project/project_file.h"
#include "protocol/object_value.h"
#include "support/running_window.h"
#include "ui/models/object_filter.h"
#include "ui/models/object_model.h"
#include "ui/pages/slave_objects_page.h"
#include "ui/session/favourite_objects.h"
#include "ui/session/running_slave.h"
#include "ui/session/watch_list.h"

namespace syncline::ui {
namespace {

using Bytes = std::vector<std::uint8_t>;

DictionaryEntry entry(std::uint8_t sub, const char* name, std::uint16_t type, const char* type_name,
                      std::uint16_t bits) {
  DictionaryEntry one{.sub_index = sub};
  one.name = QLatin1String(name);
  one.type = type;
  one.type_name = QLatin1String(type_name);
  one.bits = bits;
  one.access = coe::access::kRead | coe::access::kWrite;
  return one;
}

Dictionary smallDictionary() {
  DictionaryObject type{.index = 0x1000, .name = QStringLiteral("Device type"), .single = true};
  type.entries = {entry(0, "Device type", 7, "UDINT", 32)};
  type.entries.front().default_value = {1, 2, 3, 4};
  DictionaryObject sync{.index = 0x1C32, .name = QStringLiteral("SM output parameter")};
  sync.entries = {entry(0, "Count", 5, "USINT", 8), entry(1, "Mode", 6, "UINT", 16), entry(2, "Cycle", 7, "UDINT", 32)};
  return {type, sync};
}

TEST(ObjectModel, IsATreeThatCanGrow) {
  ObjectModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  ObjectFilter filter;
  const QAbstractItemModelTester filtered(&filter, QAbstractItemModelTester::FailureReportingMode::Fatal);
  filter.setSourceModel(&model);
  model.setDictionary(smallDictionary());
  ASSERT_EQ(model.rowCount(), 2);
  EXPECT_EQ(model.rowCount(model.index(0, 0)), 0) << "a variable is its own entry";
  EXPECT_EQ(model.rowCount(model.index(1, 0)), 3);
  const auto value = model.find({0x1000, 0}, ObjectModel::kValue);
  EXPECT_EQ(value.data().toString(), QString::number(0x04030201)) << "the ESI's default";
  model.setValue({0x1000, 0}, {5, 0, 0, 0}, 1);
  EXPECT_EQ(value.data().toString(), QStringLiteral("5"));
  EXPECT_EQ(value.siblingAtColumn(ObjectModel::kRaw).data().toString(), QStringLiteral("0x00000005"));
  model.setFailure({0x1C32, 1}, QStringLiteral("no"));
  EXPECT_EQ(model.find({0x1C32, 1}, ObjectModel::kValue).data().toString(), QStringLiteral("no"));
  auto more = smallDictionary()[1];
  more.entries.pop_back();
  model.setObject(more);
  EXPECT_EQ(model.rowCount(model.index(1, 0)), 2);
  more.index = 0x1800;
  model.setObject(more);
  EXPECT_EQ(model.rowCount(), 3);
  model.setObject({.index = 0x1000, .name = QStringLiteral("gone"), .single = true});
  EXPECT_EQ(model.entry(model.index(0, 0)), nullptr);
  model.clearValues();
}

TEST(ObjectModel, TicksAreWhatIsWatched) {
  ObjectModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  model.setDictionary(smallDictionary());
  EXPECT_FALSE(model.setData(model.index(1, 0), Qt::Checked, Qt::CheckStateRole)) << "an object of several entries";
  EXPECT_TRUE(model.setData(model.find({0x1C32, 2}), Qt::Checked, Qt::CheckStateRole));
  ASSERT_EQ(model.watched().size(), 1U);
  EXPECT_EQ(model.watched().front(), (coe::ObjectAddress{0x1C32, 2}));
  model.clearValues();
  EXPECT_EQ(model.watched().size(), 1U);
  model.setWatched({});
  EXPECT_TRUE(model.watched().empty());
}

TEST(ObjectFilter, FindsByWordsOfTheLine) {
  ObjectModel model;
  model.setDictionary(smallDictionary());
  ObjectFilter filter;
  filter.setSourceModel(&model);
  filter.setWords(QStringLiteral("1c32 cycle"));
  ASSERT_EQ(filter.rowCount(), 1);
  ASSERT_EQ(filter.rowCount(filter.index(0, 0)), 1);
  EXPECT_EQ(filter.index(0, ObjectModel::kName, filter.index(0, 0)).data().toString(), QStringLiteral("Cycle"));
  filter.setWords(QStringLiteral("parameter"));
  EXPECT_EQ(filter.rowCount(filter.index(0, 0)), 3) << "an object brings its entries";
  filter.setWords({});
  model.setWatched({{0x1C32, 1}});
  filter.setWatchedOnly(true);
  EXPECT_EQ(filter.rowCount(), 1);
  EXPECT_EQ(filter.rowCount(filter.index(0, 0)), 1);
  EXPECT_TRUE(tableCsv(filter).contains(QStringLiteral("0x1C32:01,Mode,UINT")));
}

TEST(ObjectTable, ADefaultIsNoValue) {
  ObjectModel model;
  model.setDictionary(smallDictionary());
  const auto line = [&] { return tableCsv(model).split(u'\n').at(1); };
  EXPECT_EQ(line(), QStringLiteral("0x1000,Device type,UDINT,rw,,,,67305985"));
  EXPECT_EQ(rowsText({model.find({0x1000, 0})}).split(u'\t').last(), QStringLiteral("67305985"));
  EXPECT_FALSE(model.find({0x1000, 0}, ObjectModel::kValue).data(Qt::ToolTipRole).toString().contains(u"ESI"))
      << "be it the slave's own";
  model.setValue({0x1000, 0}, {5, 0, 0, 0}, 1);
  EXPECT_EQ(line(), QStringLiteral("0x1000,Device type,UDINT,rw,,5,0x00000005,67305985"));
  model.setFailure({0x1000, 0}, QStringLiteral("no"));
  EXPECT_EQ(line(), QStringLiteral("0x1000,Device type,UDINT,rw,,no,,67305985"));
}

TEST(DictionaryText, ValuesAreTypedAndLimited) {
  auto mode = entry(1, "Mode", 2, "SINT", 8);
  mode.words = {{8, "Cyclic position"}};
  EXPECT_EQ(valueText(mode, Bytes{8}), QStringLiteral("8 (Cyclic position)"));
  EXPECT_EQ(valueText(mode, Bytes{0xFF}), QStringLiteral("-1"));
  EXPECT_EQ(rangeText(mode), QStringLiteral("-128 to 127"));
  EXPECT_EQ(typedValue(mode, QStringLiteral("-128")), Bytes{0x80});
  EXPECT_EQ(typedValue(mode, QStringLiteral("128")), std::nullopt);
  mode.minimum = {0xFE};
  mode.maximum = {10};
  EXPECT_EQ(rangeText(mode), QStringLiteral("-2 to 10"));
  EXPECT_EQ(typedValue(mode, QStringLiteral("-3")), std::nullopt);
  EXPECT_EQ(typedValue(mode, QStringLiteral("0x0A")), Bytes{10});
  mode.minimum = mode.maximum = {0};
  EXPECT_EQ(rangeText(mode), QStringLiteral("-128 to 127")) << "0 and 0 is what devices say that have no limits";
  const auto bits = entry(1, "Bits", 0x31, "BIT2", 2);
  EXPECT_EQ(rangeText(bits), QStringLiteral("0 to 3"));
  EXPECT_EQ(typedValue(bits, QStringLiteral("4")), std::nullopt);
  const auto large = entry(1, "Large", 0x1B, "ULINT", 64);
  EXPECT_EQ(rangeText(large), QStringLiteral("0 to 18446744073709551615"));
  const auto text = entry(1, "Text", kStringType, "STRING(3)", 24);
  EXPECT_EQ(typedValue(text, QStringLiteral("abc")), (Bytes{'a', 'b', 'c'}));
  EXPECT_EQ(typedValue(text, QStringLiteral("abcd")), std::nullopt);
  const auto raw = entry(1, "Raw", kBytesType, "OCTETS", 16);
  EXPECT_EQ(typedValue(raw, QStringLiteral("0A ff")), (Bytes{10, 255}));
  EXPECT_EQ(typedValue(raw, QStringLiteral("0A")), std::nullopt);
}

/// The window while the demonstration machine runs.
class ObjectsOfARunningSlave : public test::RunningWindow {
 protected:
  SlaveObjectsPage& page() { return field<SlaveObjectsPage>("slaveObjectsPage"); }
  ObjectModel& model() { return page().model(); }
  QString status() { return field<QLabel>("objectStatus").text(); }
  void select(coe::ObjectAddress object) {
    auto& tree = field<QTreeView>("objectTree");
    auto* filter = static_cast<QSortFilterProxyModel*>(tree.model());
    const auto index = filter->mapFromSource(model().find(object));
    ASSERT_TRUE(index.isValid());
    tree.setCurrentIndex(index);
  }
  void press(const char* name) { field<QPushButton>(name).click(); }
  /// The ESI of the demonstration's drives has no dictionary.
  void askForAll() {
    choose("objectSource", 1);
    EXPECT_TRUE(field("objectStop").isVisible());
    for (int i = 0; i < 400 && field("objectStop").isVisible(); ++i) run(50 * kMillisecond);
    ASSERT_FALSE(field("objectStop").isVisible()) << qPrintable(status());
  }
  void choose(const char* name, int row) {
    auto& box = field<QComboBox>(name);
    box.setCurrentIndex(row);
    Q_EMIT box.activated(row);
  }
};

TEST_F(ObjectsOfARunningSlave, OfflineTheEsiDescribesThem) {
  auto machine = test::smallProject();
  auto& device = machine.slaves[1].device;
  device.mailbox.emplace().coe.emplace();
  ObjectEntry only;
  only.name = "Device type";
  only.data_type = "UDINT";
  only.bit_length = 32;
  ObjectDescription type;
  type.index = 0x1000;
  type.name = "Device type";
  type.entries = {only};
  type.entries.front().default_data = {0x92, 1, 2, 0};
  device.dictionary = {type};
  workspace_.document().replace(QStringLiteral("load"), machine);
  show(1, "slaveObjectsPage");
  EXPECT_TRUE(field("slaveObjectsPageHint").isVisible());
  EXPECT_TRUE(field<QLabel>("slaveObjectsPageHint").text().contains(QStringLiteral("F5")));
  ASSERT_EQ(model().rowCount(), 1);
  EXPECT_EQ(model().find({0x1000, 0}, ObjectModel::kRaw).data().toString(), QStringLiteral("0x00020192"));
  EXPECT_FALSE(field("objectRead").isEnabled());
  choose("objectSource", 1);
  EXPECT_EQ(field<QComboBox>("objectSource").currentIndex(), 0) << "nobody there to tell";
  EXPECT_TRUE(status().contains(QStringLiteral("F5"))) << qPrintable(status());
  window_.selectNode(kCoupler);
  EXPECT_NE(window_.editor().tabs()->currentWidget()->objectName(), QLatin1String("slaveObjectsPage"))
      << "it does not speak CoE";
}

TEST_F(ObjectsOfARunningSlave, AreReadAndWrittenInOp) {
  goOnline();
  show(kServo, "slaveObjectsPage");
  const QAbstractItemModelTester tester(&model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
  EXPECT_FALSE(field("slaveObjectsPageHint").isVisible());
  askForAll();
  select({0x1018, 1});
  press("objectRead");
  run(200 * kMillisecond);
  EXPECT_EQ(model().value({0x1018, 1}).size(), 4U) << qPrintable(status());
  EXPECT_FALSE(field("objectWrite").isVisible()) << "the vendor cannot be written";

  // A new value: asked for, sent, read back.
  select({0x10F1, 2});
  test::type(field("objectValue"), QStringLiteral("99999999999"), false);
  EXPECT_FALSE(field("objectWrite").isEnabled());
  test::type(field("objectValue"), QStringLiteral("7"), false);
  ASSERT_TRUE(field("objectWrite").isEnabled());
  answerQuestion("disturbQuestion", false);
  press("objectWrite");
  run(200 * kMillisecond);
  EXPECT_TRUE(model().value({0x10F1, 2}).empty()) << "who says no writes nothing";
  answerQuestion("disturbQuestion", true);
  press("objectWrite");
  run(200 * kMillisecond);
  ASSERT_FALSE(model().value({0x10F1, 2}).empty()) << qPrintable(status());
  EXPECT_EQ(model().value({0x10F1, 2}).front(), 7) << qPrintable(status());
  EXPECT_EQ(workspace_.live().snapshot().state, AlState::kOp);
  EXPECT_EQ(workspace_.live().snapshot().wkc_errors, 0U);
  EXPECT_EQ(workspace_.live().snapshot().lost_frames, 0U);
}

TEST_F(ObjectsOfARunningSlave, TheSlaveTellsItsOwn) {
  goOnline();
  show(kServo, "slaveObjectsPage");
  const QAbstractItemModelTester tester(&model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
  askForAll();
  EXPECT_GT(model().rowCount(), 5) << qPrintable(status());
  const auto* vendor = model().entry(model().find({0x1018, 1}));
  ASSERT_NE(vendor, nullptr);
  EXPECT_EQ(vendor->type_name, QStringLiteral("UDINT"));
  EXPECT_FALSE(vendor->writable());
  press("objectReadShown");
  for (int i = 0; i < 300 && field("objectStop").isVisible(); ++i) run(50 * kMillisecond);
  EXPECT_EQ(model().value({0x1018, 1}).size(), 4U);
  EXPECT_EQ(workspace_.live().snapshot().wkc_errors, 0U);
}

TEST_F(ObjectsOfARunningSlave, WatchedOnesArePolledAndRemembered) {
  goOnline();
  show(kServo, "slaveObjectsPage");
  askForAll();
  ASSERT_TRUE(model().setData(model().find({0x1018, 1}), Qt::Checked, Qt::CheckStateRole));
  const auto station = project().slaves[kServo].station_address;
  EXPECT_EQ(workspace_.watched().of(station).size(), 1U);
  choose("objectPoll", 1);
  run(500 * kMillisecond);
  EXPECT_EQ(model().value({0x1018, 1}).size(), 4U);
  show(kOtherServo, "slaveObjectsPage");
  EXPECT_TRUE(model().watched().empty()) << "another slave's";
  show(kServo, "slaveObjectsPage");
  EXPECT_EQ(model().watched().size(), 1U);
  EXPECT_TRUE(model().value({0x1018, 1}).empty()) << "it was another slave in between";
  EXPECT_NE(model().entry(model().find({0x1018, 1})), nullptr) << "what it told is known in this run";
}

TEST_F(ObjectsOfARunningSlave, FavouritesAreThoseOfAKindOfDevice) {
  goOnline();
  show(kServo, "slaveObjectsPage");
  askForAll();
  auto& menu = field<QMenu>("objectFavouritesMenu");
  const auto action = [&menu](const char* name) {
    Q_EMIT menu.aboutToShow();
    return menu.findChild<QAction*>(QLatin1String(name));
  };
  EXPECT_FALSE(action("favouritesWatch")->isEnabled());
  EXPECT_FALSE(action("favouritesTake")->isEnabled()) << "nothing is watched";
  ASSERT_TRUE(model().setData(model().find({0x1018, 1}), Qt::Checked, Qt::CheckStateRole));
  ASSERT_TRUE(model().setData(model().find({0x6041, 0}), Qt::Checked, Qt::CheckStateRole));
  action("favouritesTake")->trigger();
  EXPECT_EQ(FavouriteObjects(workspace_.memory()).of(project().slaves[kServo].device.identity).size(), 2U);
  show(kOtherServo, "slaveObjectsPage");
  ASSERT_TRUE(model().watched().empty());
  action("favouritesWatch")->trigger();
  EXPECT_EQ(model().watched().size(), 2U) << "of the same kind";
  EXPECT_EQ(workspace_.watched().of(project().slaves[kOtherServo].station_address).size(), 2U);
  EXPECT_TRUE(FavouriteObjects(workspace_.memory()).of(project().slaves[5].device.identity).empty()) << "another kind";
  action("favouritesForget")->trigger();
  EXPECT_FALSE(action("favouritesWatch")->isEnabled());
}

TEST_F(ObjectsOfARunningSlave, WhatTheSlaveRefusesIsSaidInWords) {
  goOnline();
  show(kServo, "slaveObjectsPage");
  DictionaryObject none{.index = 0x5FFF, .name = QStringLiteral("None"), .single = true};
  none.entries = {entry(0, "None", 6, "UINT", 16)};
  model().setObject(none);
  select({0x5FFF, 0});
  press("objectRead");
  run(200 * kMillisecond);
  const auto said = model().find({0x5FFF, 0}, ObjectModel::kValue).data().toString();
  EXPECT_TRUE(said.contains(QStringLiteral("0x06020000"))) << qPrintable(said);
  field<QTreeView>("objectTree").setFocus();
  QTest::keyClick(&field("objectTree"), Qt::Key_C, Qt::ControlModifier);
  EXPECT_TRUE(QGuiApplication::clipboard()->text().contains(QStringLiteral("0x5FFF")));
}

TEST_F(ObjectsOfARunningSlave, GoingOfflineKeepsWhatWasRead) {
  goOnline();
  show(kServo, "slaveObjectsPage");
  askForAll();
  select({0x1018, 1});
  press("objectRead");
  run(200 * kMillisecond);
  press("objectReadShown");
  workspace_.live().shutDown();
  EXPECT_FALSE(field("objectRead").isEnabled());
  EXPECT_TRUE(field("slaveObjectsPageHint").isVisible());
  EXPECT_EQ(model().value({0x1018, 1}).size(), 4U);
}

/// The project was edited: what is meant for one slave never reaches another.
TEST_F(ObjectsOfARunningSlave, ASlaveThatDoesNotRunIsNotAsked) {
  goOnline();
  auto edited = project();
  edited.slaves[kServo].station_address = 999;
  workspace_.document().replace(QStringLiteral("edit"), edited);
  EXPECT_FALSE(runningSlave(workspace_, kServo).has_value());
  EXPECT_TRUE(runningSlave(workspace_, kOtherServo).has_value());
  EXPECT_TRUE(runningSlave(workspace_, 0).has_value());
  show(kServo, "slaveObjectsPage");
  EXPECT_TRUE(field<QLabel>("slaveObjectsPageHint").text().contains(QStringLiteral("restart")));
  EXPECT_FALSE(field("objectRead").isEnabled());
}

/// A slave was taken out in front of others: each still shows its own state, and events lead to the right one.
TEST_F(ObjectsOfARunningSlave, SlavesAreKnownAgainAfterAnEdit) {
  goOnline();
  const auto before = project();
  auto edited = before;
  edited.slaves.erase(edited.slaves.begin() + 1);
  workspace_.document().replace(QStringLiteral("edit"), edited);
  const auto& running = workspace_.runningSlaves();
  EXPECT_EQ(running.positionOf(0), 0);
  EXPECT_EQ(running.positionOf(kServo - 1), kServo);
  EXPECT_EQ(running.slaveOf(kServo), kServo - 1);
  EXPECT_EQ(running.slaveOf(1), -1);
  EXPECT_EQ(running.positionOf(static_cast<int>(edited.slaves.size())), -1);
  workspace_.document().replace(QStringLiteral("back"), before);
  EXPECT_EQ(running.positionOf(kServo), kServo);
}

TEST(WatchLists, StayWithTheProject) {
  QTemporaryDir folder;
  auto environment = test::virtualEnvironment();
  environment.settings_file = folder.filePath(QStringLiteral("settings.ini"));
  const auto file = folder.filePath(QStringLiteral("machine.syncline"));
  {
    Workspace workspace(environment);
    workspace.document().replace(QStringLiteral("load"), test::smallProject());
    workspace.watched().set(1002, {{0x6041, 0}, {0x1C32, 11}});
    ASSERT_TRUE(workspace.document().save(file));
    EXPECT_EQ(workspace.watched().of(1002).size(), 2U) << "its first name";
  }
  Workspace workspace(environment);
  EXPECT_TRUE(workspace.watched().of(1002).empty());
  const auto other = folder.filePath(QStringLiteral("other.syncline"));
  workspace.document().replace(QStringLiteral("load"), test::smallProject());
  workspace.watched().set(1002, {{0x1018, 1}});
  ASSERT_TRUE(workspace.document().save(other));
  ASSERT_TRUE(workspace.document().load(file));
  ASSERT_EQ(workspace.watched().of(1002).size(), 2U);
  // Saved over another file it stays the same machine.
  ASSERT_TRUE(workspace.document().save(other));
  EXPECT_EQ(workspace.watched().of(1002).size(), 2U);
  workspace.watched().set(1003, {{0x1018, 1}});
  ASSERT_TRUE(workspace.document().load(file));
  EXPECT_TRUE(workspace.watched().of(1003).empty()) << "ticked for the other file";
  ASSERT_TRUE(workspace.document().load(other));
  EXPECT_EQ(workspace.watched().of(1003).size(), 1U);
  workspace.document().reset();
  EXPECT_TRUE(workspace.watched().of(1002).empty());
  ASSERT_TRUE(workspace.document().load(file));
  EXPECT_EQ(workspace.watched().of(1002)[1], (coe::ObjectAddress{0x1C32, 11}));
}

}  // namespace
}  // namespace syncline::ui
