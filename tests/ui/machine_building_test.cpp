// SPDX-License-Identifier: Apache-2.0
// A machine is built offline in the window: from the catalogue, in the tree, in the topology.
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
#include "eni/project/project_file.h"
#include "settings/settings_table.h"
#include "support/cut_texts.h"
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
using Tester = QAbstractItemModelTester;

/// The catalogue's database is the test's own.
class OwnCache {
 public:
  OwnCache() : before_(qgetenv("XDG_CACHE_HOME")) { qputenv("XDG_CACHE_HOME", folder_.path().toUtf8()); }
  ~OwnCache() { qputenv("XDG_CACHE_HOME", before_); }

 private:
  QTemporaryDir folder_;
  QByteArray before_;
};

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

DeviceDescription plain(const char* type, const char* physics) {
  DeviceDescription device;
  device.type = type;
  device.name = type;
  device.physics = physics;
  device.identity.product_code = static_cast<std::uint32_t>(qHash(QLatin1String(type)) | 1U);
  return device;
}

/// Coupler, two terminals, junction, drive.
Project plant() {
  Project project;
  EXPECT_TRUE(add_slave(project, plain("Coupler", "YKY"), {}));
  EXPECT_TRUE(add_slave(project, plain("Terminal", "KK"), 0));
  EXPECT_TRUE(add_slave(project, plain("Terminal", "KK"), 0));
  EXPECT_TRUE(add_slave(project, plain("Junction", "YYYY"), 0));
  EXPECT_TRUE(add_slave(project, plain("Drive", "YY"), 3));
  return project;
}

class Building : private OwnCache, public test::ProjectWindow {
 protected:
  explicit Building(const Project& machine = plant()) : ProjectWindow(machine) {}
  ~Building() override { workspace_.document().undoStack().setClean(); }

  QTreeView& tree() { return field<QTreeView>("explorerTree"); }
  TopologyView& topology() { return window_.explorer().topology(); }
  int steps() { return workspace_.document().undoStack().index(); }
  QString types() {
    QStringList all;
    for (const auto& slave : project().slaves) all << QString::fromStdString(slave.device.type);
    return all.join(u' ');
  }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    tree().setFocus();
    QTest::keyClick(&tree(), key, modifiers);
  }
  int selected() { return window_.explorer().selected(); }
  std::unique_ptr<QMimeData> dragged(int slave) {
    auto& network = workspace_.network();
    return std::unique_ptr<QMimeData>(network.mimeData({network.indexOf(slave)}));
  }
  /// In the tree, as the mouse does it; false where it is refused.
  bool drop(const QMimeData& data, QPoint point) {
    auto* viewport = tree().viewport();
    QDragEnterEvent enter(point, Qt::MoveAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(viewport, &enter);
    QDragMoveEvent move(point, Qt::MoveAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(viewport, &move);
    if (!move.isAccepted()) return false;
    QDropEvent dropped(point, Qt::MoveAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(viewport, &dropped);
    return true;
  }
};

TEST_F(Building, EditsTheTreeByKeys) {
  const auto before = project();
  const int steps_before = steps();
  window_.selectNode(0);
  press(Qt::Key_D, Qt::ControlModifier);
  EXPECT_EQ(types(), QStringLiteral("Coupler Terminal Terminal Coupler Terminal Terminal Junction Drive"));
  EXPECT_EQ(selected(), 3) << "the copy";
  EXPECT_EQ(steps(), steps_before + 1);
  press(Qt::Key_Down, Qt::AltModifier);
  EXPECT_EQ(types(), QStringLiteral("Coupler Terminal Terminal Junction Coupler Terminal Terminal Drive"));
  EXPECT_EQ(selected(), 4) << "selection follows";
  press(Qt::Key_Up, Qt::AltModifier);
  EXPECT_EQ(selected(), 3);
  press(Qt::Key_Delete);
  EXPECT_EQ(types(), QStringLiteral("Coupler Terminal Terminal Junction Drive"));
  EXPECT_EQ(steps(), steps_before + 4);
  for (int i = 0; i < 4; ++i) QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(project(), before);
}

TEST_F(Building, SaysWhyASlaveStays) {
  const int steps_before = steps();
  window_.selectNode(1);
  press(Qt::Key_Up, Qt::AltModifier);
  EXPECT_EQ(steps(), steps_before);
  QString told;
  QObject::connect(&window_.building().commands(), &SlaveCommands::told, [&](const QString& text) { told = text; });
  press(Qt::Key_Up, Qt::AltModifier);
  EXPECT_EQ(told, obstacleText(WiringObstacle::kFirst));
}

TEST_F(Building, KeepsTheSelectedSlaveOverUndo) {
  window_.selectNode(0);
  press(Qt::Key_D, Qt::ControlModifier);
  window_.selectNode(7);
  QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(selected(), 4) << "the same drive";
}

TEST_F(Building, KeysOfTheExplorerAreNotThoseOfAField) {
  show(1, "slaveGeneralPage");
  auto* name = window_.findChild<QLineEdit*>(QStringLiteral("field_name"));
  for (auto* one : window_.editor().findChildren<QLineEdit*>()) {
    if (name == nullptr && one->isVisible() && one->isEnabled() && !one->isReadOnly()) name = one;
  }
  ASSERT_NE(name, nullptr);
  name->setFocus();
  QTest::keyClick(name, Qt::Key_Home);
  QTest::keyClick(name, Qt::Key_Delete);
  EXPECT_EQ(project().slaves.size(), 5U);
}

TEST_F(Building, MovesASlaveThatIsDroppedOnAnother) {
  const auto address = project().slaves[1].station_address;
  ASSERT_TRUE(drop(*dragged(1), tree().visualRect(workspace_.network().indexOf(2)).center()));
  EXPECT_EQ(project().slaves[2].station_address, address);
  EXPECT_EQ(selected(), 2);
}

TEST_F(Building, DropsLandWhereTheLineIsDrawn) {
  auto& network = workspace_.network();
  const auto put = [&](int slave, int row, int parent) {
    const auto address = project().slaves[static_cast<std::size_t>(slave)].station_address;
    EXPECT_TRUE(network.dropMimeData(dragged(slave).get(), Qt::MoveAction, row, 0, network.indexOf(parent)));
    return network.slaveAt(address);
  };
  EXPECT_EQ(put(2, 0, 0), 1) << "above the first terminal";
  EXPECT_EQ(put(1, 2, 0), 2) << "below the last one";
  EXPECT_EQ(put(4, 1, -1), 3) << "between coupler and junction";
  EXPECT_EQ(put(4, 0, -1), 0) << "above all";
  EXPECT_EQ(types(), QStringLiteral("Junction Coupler Terminal Terminal Drive"));
  EXPECT_EQ(put(4, -1, -1), 0) << "on the master";
  const auto before = project();
  EXPECT_EQ(put(0, 1, 2), 0) << "no cable between terminals";
  EXPECT_EQ(project(), before) << "nor anywhere else";
  const int coupler = network.slaveAt(1001);
  const auto row = tree().visualRect(network.indexOf(coupler));
  const auto last = project().slaves[static_cast<std::size_t>(coupler) + 2].station_address;
  ASSERT_TRUE(drop(*dragged(coupler + 2), {row.center().x(), row.bottom()}));
  EXPECT_EQ(network.slaveAt(last), coupler + 1) << "the line is drawn above the first terminal";
}

TEST_F(Building, TakesWhatIsDraggedForWhatItIs) {
  auto& network = workspace_.network();
  QMimeData other;
  other.setData(kSlaveMime, "1");
  EXPECT_FALSE(network.canDropMimeData(&other, Qt::MoveAction, -1, 0, network.indexOf(2))) << "of another window";
  const auto terminal = dragged(1), drive = dragged(4);
  window_.selectNode(1);
  press(Qt::Key_Delete);
  EXPECT_FALSE(network.canDropMimeData(terminal.get(), Qt::MoveAction, -1, 0, network.indexOf(2))) << "it is gone";
  ASSERT_TRUE(network.dropMimeData(drive.get(), Qt::MoveAction, 0, 0, network.indexOf(-1)));
  EXPECT_EQ(types(), QStringLiteral("Drive Coupler Terminal Junction"));
}

TEST_F(Building, GoToOffersWhatTheDeviceHas) {
  const auto& slave = project().slaves[1];
  const auto setting = std::ranges::find_if(
      settings::table(), [&](const auto& one) { return one.applies && !one.items && !one.applies(slave); });
  ASSERT_NE(setting, settings::table().end());
  const auto key = QString::fromStdString(settings::key_of(*setting, {.slave = 1}));
  window_.selectNode(1);
  QTest::keyClick(&window_, Qt::Key_K, Qt::ControlModifier);
  QTest::keyClicks(&field<QLineEdit>("goToSearch"), key);
  EXPECT_TRUE(field<QListWidget>("goToList").findItems(QStringLiteral(" ") + key, Qt::MatchEndsWith).isEmpty())
      << key.toStdString();
  QTest::keyClick(&field<QLineEdit>("goToSearch"), Qt::Key_Escape);
  const bool shown = window_.editor().showKey(key);
  EXPECT_EQ(workspace_.expert(), shown && setting->words.expert);
}

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
  const Tester tester(&network, Tester::FailureReportingMode::Fatal);
  QTest::keyClick(&window_, Qt::Key_1, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(network.rowCount(network.indexOf(-1)), 3) << "coupler, junction, drive";
  EXPECT_EQ(network.rowCount(network.indexOf(0)), 2) << "its terminals";
  window_.selectNode(2);
  QTest::keyClick(&window_, Qt::Key_2, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(network.rowCount(network.indexOf(-1)), 5);
  EXPECT_EQ(selected(), 2);
  EXPECT_TRUE(network.indexOf(2).data(Qt::AccessibleTextRole).toString().contains(QStringLiteral("position 2")));
}

TEST_F(Building, RewiresByDraggingACableToAFreePort) {
  const Tester tester(&workspace_.network(), Tester::FailureReportingMode::Fatal);
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

TEST_F(Building, GoesToSlavesSettingsAndCommandsByAFewLetters) {
  const auto go = [this](const char* words) {
    QTest::keyClick(&window_, Qt::Key_K, Qt::ControlModifier);
    auto* dialog = window_.findChild<QDialog*>(QStringLiteral("goToDialog"));
    ASSERT_NE(dialog, nullptr);
    auto* field = find<QLineEdit>(*dialog, "goToSearch");
    QTest::keyClicks(field, QLatin1String(words));
    QTest::keyClick(field, Qt::Key_Return);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  };
  go("drive 1005");
  EXPECT_EQ(selected(), 4);
  go("slave.4.alias");
  EXPECT_EQ(window_.editor().tabs()->currentWidget()->objectName(), QStringLiteral("slaveGeneralPage"));
  go("flat");
  EXPECT_EQ(window_.explorer().view(), ExplorerPanel::View::kFlat);
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

TEST(CatalogueModel, StandsByVendorGroupDeviceAndRevision) {
  CatalogueModel model;
  const Tester tester(&model, Tester::FailureReportingMode::Fatal);
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
class FromCatalogue : private OwnCache, public ::testing::Test {
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
  QTest::keyClick(&tree, Qt::Key_R, Qt::ControlModifier);
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
