// SPDX-License-Identifier: Apache-2.0
// A machine is built offline from the catalogue.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTreeView>
#include <algorithm>
#include <memory>

#include "eni/format/eni_file.h"
#include "support/cut_texts.h"
#include "support/own_cache.h"
#include "support/project_window.h"
#include "ui/dialogs/bus_commands.h"
#include "ui/dialogs/file_commands.h"
#include "ui/dialogs/slave_commands.h"
#include "ui/machine_building.h"
#include "ui/models/catalogue_model.h"
#include "ui/panels/explorer_panel.h"
#include "ui/panels/topology_view.h"
#include "ui/session/device_catalogue.h"

namespace syncline::ui {
namespace {

using test::find;
using test::waitFor;

QByteArray deviceXml(int product, int revision, const char* type, const char* physics) {
  return QStringLiteral(
             "<Device Physics=\"%4\"><Type ProductCode=\"%1\" RevisionNo=\"%2\">%3</Type><Name>%3 "
             "thing</Name><GroupType>Digital</GroupType></Device>\n")
      .arg(product)
      .arg(revision)
      .arg(QLatin1String(type), QLatin1String(physics))
      .toUtf8();
}

void writeEsi(const QString& path, const QByteArray& devices) {
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(
      "<EtherCATInfo><Vendor><Id>1516</Id><Name>Maker</Name></Vendor><Descriptions><Groups><Group>"
      "<Type>Digital</Type><Name>Digital terminals</Name></Group></Groups><Devices>\n");
  file.write(devices);
  file.write("</Devices></Descriptions></EtherCATInfo>\n");
}

eni::CatalogueSearch wordsOf(const char* words) {
  eni::CatalogueSearch search;
  search.words = words;
  return search;
}

TEST(CatalogueModel, StandsByVendorGroupDeviceAndRevision) {
  CatalogueModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  std::vector<eni::CatalogueEntry> entries(4);
  for (auto& entry : entries) entry.vendor_name = "Maker", entry.group_name = "Digital", entry.type = "T1";
  entries[0].identity = {1, 1, 3, 0};
  entries[1].identity = {1, 1, 2, 0};
  entries[2].identity = {1, 2, 1, 0};
  entries[3].vendor_name = "Other";
  model.setEntries(entries);
  EXPECT_EQ(model.rowCount(), 2);
  const auto group = model.index(0, 0, model.index(0, 0));
  EXPECT_EQ(model.rowCount(group), 2);
  EXPECT_EQ(model.rowCount(model.index(0, 0, group)), 1) << "the older revision";
  EXPECT_EQ(model.index(0, 1, group).data().toString(), QStringLiteral("0x00000003"));
  model.setEntries({});
  EXPECT_EQ(model.rowCount(), 0);
}

/// The catalogue has the simulated devices and one in two revisions.
class FromCatalogue : private test::OwnCache, public ::testing::Test {
 protected:
  FromCatalogue() {
    writeEsi(esi_.filePath(QStringLiteral("maker.xml")),
             deviceXml(7, 16, "T7", "YY") + deviceXml(7, 32, "T7", "YY") + deviceXml(8, 1, "T8", "KK"));
    auto environment = test::virtualEnvironment();
    environment.esi_folders << esi_.path();
    workspace_ = std::make_unique<Workspace>(environment);
    window_ = std::make_unique<MainWindow>(*workspace_);
    window_->show();
    window_->activateWindow();
    static_cast<void>(QTest::qWaitForWindowActive(window_.get()));
  }
  ~FromCatalogue() override { workspace_->document().undoStack().setClean(); }

  const Project& project() { return workspace_->document().project(); }
  QLineEdit& words() { return *find<QLineEdit>(*window_, "catalogueSearch"); }
  QTreeView& devices() { return *find<QTreeView>(*window_, "catalogueTree"); }
  /// As a user: keys only.
  void add(const char* type) {
    const auto count = project().slaves.size();
    QTest::keyClick(window_.get(), Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(words().hasFocus());
    QTest::keyClicks(&words(), QLatin1String(type));
    ASSERT_TRUE(waitFor([&] {
      return devices().currentIndex().isValid() &&
             devices().currentIndex().data().toString().contains(QLatin1String(type));
    })) << type;
    QTest::keyClick(&words(), Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return project().slaves.size() == count + 1; })) << type;
  }

  QTemporaryDir esi_;
  std::unique_ptr<Workspace> workspace_;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(FromCatalogue, SaysWhatItReadsWithinItsWidth) {
  QTest::keyClick(window_.get(), Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(waitFor([this] { return devices().model()->rowCount() > 0; }));
  const auto file = QStringLiteral("maker__a_name_without_any_place_where_its_line_could_end_of_many_devices.xml");
  Q_EMIT workspace_->catalogue().progress(3, 76, QStringLiteral("/esi/") + file);
  QApplication::processEvents();
  const auto* line = find<QLabel>(*window_, "catalogueCount");
  EXPECT_TRUE(line->text().contains(QStringLiteral("(4 of 76)"))) << qPrintable(line->text());
  EXPECT_EQ(line->toolTip(), file);
  const test::CutTexts cut(*window_);
  EXPECT_TRUE(cut.found().isEmpty()) << qPrintable(cut.found().join(u'\n'));
}

TEST_F(FromCatalogue, AMachineIsBuiltAndExportedByKeys) {
  for (const char* type : {"SL-1100", "SL-1002", "SL-2002", "SL-SV7", "SL-XE2"}) add(type);
  ASSERT_EQ(project().slaves.size(), 5U);
  EXPECT_EQ(project().slaves[1].previous, (PreviousPort{0, 1})) << "the terminal on the E-bus";
  EXPECT_EQ(project().slaves[3].previous, (PreviousPort{0, 2})) << "the drive on the cable";
  EXPECT_EQ(workspace_->document().undoStack().index(), 5) << "a step each";
  EXPECT_EQ(window_->explorer().selected(), 4);
  QTemporaryDir out;
  const auto path = out.filePath(QStringLiteral("machine.xml"));
  ASSERT_TRUE(window_->files().exportTo(path));
  const auto eni = eni::read_eni(path.toStdString());
  ASSERT_TRUE(eni);
  EXPECT_EQ(eni->slaves.size(), 5U);
  for (int i = 0; i < 5; ++i) QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(project().slaves.empty());
}

TEST_F(FromCatalogue, TakesWhatWasTypedHoweverFast) {
  QTest::keyClick(window_.get(), Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
  QTest::keyClicks(&words(), QStringLiteral("SL-SV7"));
  QTest::keyClick(&words(), Qt::Key_Return);
  ASSERT_TRUE(waitFor([&] { return project().slaves.size() == 1; }));
  EXPECT_EQ(project().slaves[0].device.type, "SL-SV7");
}

TEST_F(FromCatalogue, LeavesARunningMachineAlone) {
  workspace_->live().setAutoAdvance(false);
  window_->bus().startDemo();
  ASSERT_TRUE(waitFor([this] { return workspace_->live().phase() != LiveSession::Phase::kOffline; }));
  window_->selectNode(1);
  const auto slaves = project().slaves.size();
  auto& tree = *find<QTreeView>(*window_, "explorerTree");
  tree.setFocus();
  QTest::keyClick(&tree, Qt::Key_Delete);
  QTest::keyClick(&tree, Qt::Key_D, Qt::ControlModifier);
  EXPECT_EQ(project().slaves.size(), slaves);
  EXPECT_FALSE(workspace_->network().flags(workspace_->network().indexOf(1)).testFlag(Qt::ItemIsDragEnabled));
  workspace_->live().shutDown();
}

TEST_F(FromCatalogue, FindsByProductCodeAndShowsRevisionsOnDemand) {
  QTest::keyClick(window_.get(), Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
  QTest::keyClicks(&words(), QStringLiteral("maker 0x00000007"));
  auto& model = *qobject_cast<CatalogueModel*>(devices().model());
  const auto device = [&] { return model.index(0, 0, model.index(0, 0, model.index(0, 0))); };
  ASSERT_TRUE(waitFor([&] { return device().isValid() && model.rowCount() == 1 && words().text() != QString(); }));
  EXPECT_EQ(model.rowCount(device()), 0) << "the newest alone";
  QTest::mouseClick(find<QCheckBox>(*window_, "catalogueRevisions"), Qt::LeftButton, {}, {8, 8});
  ASSERT_TRUE(waitFor([&] { return device().isValid() && model.rowCount(device()) == 1; }));
  EXPECT_TRUE(find<QLabel>(*window_, "catalogueDetails")->text().contains(QStringLiteral("Maker")));
}

TEST_F(FromCatalogue, NamesFilesThatCannotBeRead) {
  QTemporaryDir folder;
  {
    QFile broken(folder.filePath(QStringLiteral("broken.xml")));
    ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
    broken.write("<EtherCATInfo><Vendor>");
  }
  writeEsi(folder.filePath(QStringLiteral("good.xml")), deviceXml(99, 1, "T99", "YY"));
  DeviceCatalogue catalogue({});
  QStringList files;
  int added = -1;
  QObject::connect(&catalogue, &DeviceCatalogue::warned,
                   [&](const eni::FileWarning& warning) { files << QString::fromStdString(warning.file); });
  QObject::connect(&catalogue, &DeviceCatalogue::added, [&](int devices) { added = std::max(added, devices); });
  catalogue.add({folder.path()});
  ASSERT_TRUE(waitFor([&] { return added > 0; }));
  EXPECT_EQ(added, 1);
  ASSERT_EQ(files.size(), 1);
  EXPECT_TRUE(files.front().endsWith(QStringLiteral("broken.xml")));
  // It is there at the next start, too.
  DeviceCatalogue again({});
  std::size_t entries = 0;
  again.search(wordsOf("T99"), &again,
               [&](const Result<CatalogueAnswer>& answer) { entries = answer->entries.size(); });
  EXPECT_TRUE(waitFor([&] { return entries == 1; }));
}

TEST_F(FromCatalogue, AnswersEachAskerWhatItAsked) {
  QObject panel, dialog;
  std::vector<std::string> found;
  const auto ask = [&](const char* words, QObject& asker) {
    workspace_->catalogue().search(wordsOf(words), &asker, [&](const Result<CatalogueAnswer>& answer) {
      found.push_back(answer->entries.empty() ? "" : answer->entries.front().type);
    });
  };
  ask("SL-SV7", panel);
  ask("T7", panel);
  ask("T8", dialog);
  ASSERT_TRUE(waitFor([&] { return found.size() == 2; }));
  EXPECT_EQ(found, (std::vector<std::string>{"T7", "T8"})) << "the last question of each";
}

TEST_F(FromCatalogue, FindsAtTheNextStartWhatIsInAFolderThatWasNotReadToTheEnd) {
  QTemporaryDir folder;
  writeEsi(folder.filePath(QStringLiteral("good.xml")), deviceXml(99, 1, "T99", "YY"));
  {
    DeviceCatalogue catalogue({});
    int ended = 0;
    QObject::connect(&catalogue, &DeviceCatalogue::added, [&] { ++ended; });
    catalogue.add({folder.path()});
    catalogue.cancel();
    ASSERT_TRUE(waitFor([&] { return ended == 2; }));
  }
  DeviceCatalogue again({});
  std::size_t entries = 0;
  again.search(wordsOf("T99"), &again,
               [&](const Result<CatalogueAnswer>& answer) { entries = answer->entries.size(); });
  EXPECT_TRUE(waitFor([&] { return entries == 1; }));
}

TEST_F(FromCatalogue, AddsToTheSlaveThatWasMeantWhereverItIs) {
  for (const char* type : {"SL-SV7", "SL-SV7", "SL-SV7"}) add(type);
  eni::CatalogueEntry device;
  workspace_->catalogue().search(wordsOf("T7"), window_.get(),
                                 [&](const Result<CatalogueAnswer>& answer) { device = answer->entries.front(); });
  ASSERT_TRUE(waitFor([&] { return !device.type.empty(); }));
  auto& document = workspace_->document();
  auto& commands = window_->building().commands();
  commands.addDeviceTo(device, {1});
  ASSERT_TRUE(document.edit(QStringLiteral("remove"), [](Project& edited) -> Status {
    EXPECT_TRUE(remove_slave(edited, 0));
    return {};
  }));
  ASSERT_TRUE(waitFor([&] { return project().slaves.size() == 3; }));
  EXPECT_EQ(project().slaves[1].device.type, "T7") << "behind the second drive, which is the first one now";
  QString told;
  QObject::connect(&commands, &SlaveCommands::told, [&](const QString& text) { told = text; });
  commands.addDeviceTo(device, {1});
  document.take(document.machine(), {});
  ASSERT_TRUE(waitFor([&] { return !told.isEmpty(); }));
  EXPECT_EQ(told, obstacleText(WiringObstacle::kNoSuchSlave));
  EXPECT_EQ(project().slaves.size(), 3U) << "nobody asked for it in this project";
}

TEST_F(FromCatalogue, ADeviceDroppedOnAPortHangsThere) {
  for (const char* type : {"SL-1100", "SL-1122"}) add(type);
  window_->explorer().setView(ExplorerPanel::View::kTopology);
  QTest::keyClick(window_.get(), Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
  QTest::keyClicks(&words(), QStringLiteral("SL-SV7"));
  ASSERT_TRUE(waitFor([&] { return devices().currentIndex().data().toString().contains(QStringLiteral("SL-SV7")); }));
  const std::unique_ptr<QMimeData> data(devices().model()->mimeData({devices().currentIndex()}));
  ASSERT_NE(data, nullptr);
  auto& topology = window_->explorer().topology();
  const auto point = topology.portPosition(1, 2);
  QDragEnterEvent enter(point, Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(topology.viewport(), &enter);
  ASSERT_TRUE(enter.isAccepted());
  const std::unique_ptr<QMimeData> terminal(draggedDevice({7, "KK"}));
  QDragMoveEvent over(point, Qt::CopyAction, terminal.get(), Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(topology.viewport(), &over);
  EXPECT_FALSE(over.isAccepted()) << "a terminal does not fit there";
  QDragMoveEvent move(point, Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(topology.viewport(), &move);
  ASSERT_TRUE(move.isAccepted());
  QDropEvent drop(point, Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(topology.viewport(), &drop);
  ASSERT_TRUE(waitFor([&] { return project().slaves.size() == 3; }));
  EXPECT_EQ(project().slaves[2].previous, (PreviousPort{1, 2}));
}

TEST_F(FromCatalogue, AnotherRevisionKeepsWhatTheUserSet) {
  add("T7");
  const auto& identity = project().slaves[0].device.identity;
  ASSERT_EQ(identity.revision_no, 32U);
  ASSERT_TRUE(workspace_->document().edit(QStringLiteral("alias"), [](Project& edited) -> Status {
    edited.slaves[0].alias = 12;
    return {};
  }));
  auto& tree = *find<QTreeView>(*window_, "explorerTree");
  tree.setFocus();
  QTest::keyClick(&tree, Qt::Key_H, Qt::ControlModifier);
  auto* dialog = window_->findChild<QDialog*>(QStringLiteral("replaceDialog"));
  ASSERT_NE(dialog, nullptr);
  auto* list = find<QListWidget>(*dialog, "replaceList");
  ASSERT_TRUE(waitFor([&] { return list->count() == 2; })) << "all revisions";
  list->setFocus();
  QTest::keyClick(list, Qt::Key_End);
  auto* go = find<QPushButton>(*dialog, "replaceGo");
  ASSERT_TRUE(waitFor([&] { return go->isEnabled(); }));
  const int before = workspace_->document().undoStack().index();
  QTest::mouseClick(go, Qt::LeftButton);
  EXPECT_EQ(project().slaves[0].device.identity.revision_no, 16U);
  EXPECT_EQ(project().slaves[0].alias, 12);
  EXPECT_EQ(workspace_->document().undoStack().index(), before + 1);
  workspace_->document().undoStack().undo();
  EXPECT_EQ(project().slaves[0].device.identity.revision_no, 32U);
}

}  // namespace
}  // namespace syncline::ui
