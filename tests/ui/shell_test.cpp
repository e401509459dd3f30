// SPDX-License-Identifier: Apache-2.0
// What holds the pages together: files of every kind, what is remembered, what runs, and the way to any field.
#include <gtest/gtest.h>

#include <QAction>
#include <QFile>
#include <QHeaderView>
#include <QLabel>
#include <QMouseEvent>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTimer>
#include <QToolButton>
#include <set>

#include "compile/compile.h"
#include "eni/format/eni_file.h"
#include "eni/project/project_file.h"
#include "settings/settings_table.h"
#include "support/ui_test_support.h"
#include "tests/support/source_dir.h"
#include "ui/dialogs/bus_commands.h"
#include "ui/dialogs/file_commands.h"
#include "ui/dialogs/link_chooser.h"
#include "ui/editors/number_edit.h"
#include "ui/editors/page.h"
#include "ui/main_window.h"
#include "ui/models/message_model.h"
#include "ui/pages/device_editor.h"
#include "ui/panels/run_bar.h"
#include "ui/session/file_kind.h"
#include "ui/session/workspace.h"
#include "ui/text/finding_text.h"
#include "ui/window_layout.h"

namespace syncline::ui {
namespace {

void write(const QString& path, const QByteArray& content) {
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(content);
}

TEST(FileKinds, AreToldByContent) {
  QTemporaryDir folder;
  const auto kind = [&](const char* name, const QByteArray& content) {
    const auto path = folder.filePath(QLatin1String(name));
    write(path, content);
    return fileKind(path);
  };
  EXPECT_EQ(kind("a.xml", "<?xml version=\"1.0\"?>\n<!-- <Other/> -->\n<EtherCATConfig Version=\"1.3\">"),
            FileKind::kEni);
  EXPECT_EQ(kind("b.xml", "<EtherCATInfo xmlns:xsi=\"x\">"), FileKind::kEsi);
  EXPECT_EQ(kind("c.xml", "<html>"), FileKind::kOther);
  EXPECT_EQ(kind("d.xml", "<SynclineProject>"), FileKind::kProject);
  EXPECT_EQ(kind("e", QByteArray("\xd4\xc3\xb2\xa1\x02\x00", 6)), FileKind::kCapture);
  EXPECT_EQ(kind("f", QByteArray("\x0a\x0d\x0d\x0a", 4)), FileKind::kCapture);
  EXPECT_EQ(kind("g.toml", "[bus]"), FileKind::kScenario);
  EXPECT_EQ(kind("h.syncline", "rubbish"), FileKind::kProject) << "it is said what is wrong with it";
  EXPECT_EQ(kind("i", ""), FileKind::kOther);
  EXPECT_EQ(kind("j.csv", "Time[ms];SyncSetVal [ns];CtlErr [ns]\n0;1;2\n"), FileKind::kRunTable);
  EXPECT_EQ(kind("k.csv", "cycle,send_time_ns,lateness_ns\n"), FileKind::kRunTable);
  EXPECT_EQ(kind("l.csv", "time,value\n"), FileKind::kOther);
  EXPECT_EQ(fileKind(folder.filePath(QStringLiteral("none"))), FileKind::kUnreadable);
  const auto ascii = QByteArray("<EtherCATInfo>");
  QByteArray wide("\xff\xfe");
  for (const char c : ascii) wide.append(c).append('\0');
  EXPECT_EQ(kind("j.xml", wide), FileKind::kEsi) << "UTF-16";
}

TEST(WindowMemory, KeepsPinnedProjectsOnTop) {
  QTemporaryDir folder;
  const auto file = folder.filePath(QStringLiteral("settings.ini"));
  const auto name = [](int i) { return QStringLiteral("/p/%1.syncline").arg(i); };
  {
    WindowMemory memory(file);
    for (int i = 0; i < 14; ++i) memory.remember(name(i));
    EXPECT_EQ(memory.recent().size(), 10) << "the oldest go";
    memory.pin(name(8), true);
    memory.remember(name(20));
    EXPECT_EQ(memory.recent().front().path, name(8));
    EXPECT_EQ(memory.recent()[1].path, name(20));
    for (int i = 30; i < 44; ++i) memory.remember(name(i));
  }
  WindowMemory again(file);
  EXPECT_EQ(again.recent().front(), (WindowMemory::Recent{name(8), true})) << "pinned ones stay, also after a restart";
  again.clearUnpinned();
  EXPECT_EQ(again.recent().size(), 1);
}

TEST(WindowMemory, KeepsTheLayoutOfItsVersion) {
  QTemporaryDir folder;
  auto environment = test::virtualEnvironment();
  environment.settings_file = folder.filePath(QStringLiteral("settings.ini"));
  {
    Workspace workspace(environment);
    MainWindow window(workspace);
    window.show();
    window.resize(1100, 700);
    window.findChild<QWidget*>(QStringLiteral("messagesDock"))->hide();
    window.panels().remember();
  }
  {
    Workspace workspace(environment);
    MainWindow window(workspace);
    window.show();
    EXPECT_EQ(window.size(), QSize(1100, 700));
    EXPECT_TRUE(window.findChild<QWidget*>(QStringLiteral("messagesDock"))->isHidden());
    workspace.memory().setValue(QStringLiteral("layout/version"), 999);
  }
  Workspace workspace(environment);
  MainWindow window(workspace);
  window.show();
  EXPECT_FALSE(window.findChild<QWidget*>(QStringLiteral("messagesDock"))->isHidden()) << "another version's is left";
}

/// A width that was dragged is there again; those that nobody dragged, and those that take the room that is left, are
/// not.
TEST(RememberedWindow, GivesColumnsTheWidthsThatTheUserGaveThem) {
  const QTemporaryDir folder;
  auto environment = test::virtualEnvironment();
  environment.settings_file = folder.filePath(QStringLiteral("columns.ini"));
  const auto headerOf = [](MainWindow& window) {
    return test::find<QTableView>(window, "messageTable")->horizontalHeader();
  };
  int usual = 0;
  {
    Workspace workspace(environment);
    MainWindow window(workspace);
    window.show();
    auto* header = headerOf(window);
    usual = header->sectionSize(MessageModel::kTime);
    auto* area = header->viewport();
    const QPoint edge(header->sectionViewportPosition(MessageModel::kTime) + usual - 1, area->height() / 2);
    QTest::mouseMove(area, edge);
    QTest::mousePress(area, Qt::LeftButton, {}, edge);
    QMouseEvent move(QEvent::MouseMove, edge + QPoint(60, 0), area->mapToGlobal(edge + QPoint(60, 0)), Qt::NoButton,
                     Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(area, &move);
    QTest::mouseRelease(area, Qt::LeftButton, {}, edge + QPoint(60, 0));
    ASSERT_NEAR(header->sectionSize(MessageModel::kTime), usual + 60, 2);
    header->resizeSection(MessageModel::kSource, 333);  // the table's own doing
  }
  Workspace workspace(environment);
  MainWindow window(workspace);
  window.show();
  auto* header = headerOf(window);
  EXPECT_NEAR(header->sectionSize(MessageModel::kTime), usual + 60, 2);
  EXPECT_NE(header->sectionSize(MessageModel::kSource), 333);
  window.findChild<QAction*>(QStringLiteral("actionResetLayout"))->trigger();
  EXPECT_EQ(header->sectionSize(MessageModel::kTime), usual);
  EXPECT_TRUE(workspace.memory().value(QStringLiteral("columns/messageTable")).toMap().isEmpty());
}

/// Whoever closes the window at the overview finds the pages as large as they were.
TEST(RememberedWindow, GivesThePagesTheirRoomBackAfterTheOverview) {
  const QTemporaryDir folder;
  auto environment = test::virtualEnvironment();
  environment.settings_file = folder.filePath(QStringLiteral("window.ini"));
  const auto heightOf = [](MainWindow& window) { return window.editor().height(); };
  int before = 0;
  {
    Workspace workspace(environment);
    MainWindow window(workspace);
    workspace.document().replace(QStringLiteral("load"), test::smallProject());
    window.show();
    QApplication::processEvents();
    before = heightOf(window);
    window.findChild<QAction*>(QStringLiteral("actionOverview"))->trigger();
    QApplication::processEvents();
    window.panels().remember();
  }
  Workspace workspace(environment);
  MainWindow window(workspace);
  workspace.document().replace(QStringLiteral("load"), test::smallProject());
  window.show();
  QApplication::processEvents();
  EXPECT_NEAR(heightOf(window), before, 2);
}

class Shell : public ::testing::Test {
 protected:
  Shell() : workspace_(test::virtualEnvironment()), window_(workspace_) {
    workspace_.live().setAutoAdvance(false);
    window_.show();
    window_.activateWindow();
    static_cast<void>(QTest::qWaitForWindowActive(&window_));
  }
  ~Shell() override {
    workspace_.live().shutDown();
    workspace_.document().undoStack().setClean();
  }
  const Project& project() { return workspace_.document().project(); }
  void load(const Project& machine) {
    workspace_.document().replace(QStringLiteral("load"), machine);
    workspace_.document().undoStack().setClean();
  }
  void startDemo() {
    window_.bus().startDemo();
    ASSERT_TRUE(test::waitFor([this] { return workspace_.live().phase() != LiveSession::Phase::kOffline; }));
    workspace_.live().advance(kSecond);
    workspace_.document().undoStack().setClean();
  }
  void set(const char* key, const settings::Value& value, std::size_t slave = 0) {
    ASSERT_TRUE(workspace_.document().set(QStringLiteral("set"), {{&settings::row(key), {.slave = slave}, value}}));
    static_cast<void>(workspace_.configuration().current());
  }
  QWidget& widget(const char* name) { return *test::find<QWidget>(window_, name); }

  Workspace workspace_;
  MainWindow window_;
};

TEST_F(Shell, AnEniBecomesAProject) {
  QTemporaryDir folder;
  const auto compiled = compile(test::smallProject());
  ASSERT_TRUE(compiled.has_value());
  const auto path = folder.filePath(QStringLiteral("other-tool.xml"));
  ASSERT_TRUE(eni::save_eni(compiled->config, path.toStdString()).has_value());
  window_.files().openAny(path);
  EXPECT_TRUE(project().slaves.empty()) << "the catalogue is read in its own thread";
  ASSERT_TRUE(test::waitFor([this] { return project().slaves.size() == 3; }));
  EXPECT_EQ(project().slaves[1].device.identity.product_code, 0x02200301U);
  EXPECT_TRUE(workspace_.document().isModified());
  EXPECT_TRUE(workspace_.document().path().isEmpty()) << "the ENI is not written over";
}

TEST_F(Shell, ACaptureAndAScenarioAreScanned) {
  QTemporaryDir folder;
  const auto capture = folder.filePath(QStringLiteral("frames.pcap"));
  write(capture, QByteArray("\xd4\xc3\xb2\xa1\x02\x00", 6));
  QSignalSpy wanted(&window_.files(), &FileCommands::linkWanted);
  window_.files().openAny(capture);
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_EQ(wanted.front().front().toString(), QStringLiteral("replay:") + capture);
  ASSERT_TRUE(test::waitFor([this] { return !workspace_.scan().isRunning(); }));
  EXPECT_GE(workspace_.messages().count(Severity::kError), 1) << "a capture of six bytes";
}

/// Where the bus cannot be had, another one is a button away, also when it was chosen long ago.
TEST_F(Shell, ABusThatIsNotThereLeadsToAnotherOne) {
  const auto another = [this] {
    QPointer<QWidget> box;
    ASSERT_TRUE(test::waitFor([&] { return (box = window_.findChild<QWidget*>(QStringLiteral("errorDialog"))); }));
    test::find<QPushButton>(*box, "errorWay")->click();
    QPointer<LinkChooser> chooser;
    ASSERT_TRUE(test::waitFor([&] { return !box && (chooser = window_.findChild<LinkChooser*>()); }));
    chooser->reject();
    ASSERT_TRUE(test::waitFor([&] { return !chooser; }));
  };
  auto machine = test::smallProject();
  machine.slaves.resize(1);  // a coupler alone: what the others lack would be told before
  load(machine);
  workspace_.setLink(QStringLiteral("nic:nosuch0"));
  window_.bus().goOnline();
  another();
  window_.bus().scanLink(QStringLiteral("sim:/no/such/file.toml?virtual"));
  another();
  EXPECT_EQ(workspace_.link(), QStringLiteral("nic:nosuch0")) << "nothing else was chosen";
}

TEST_F(Shell, AMachineThatCannotRunIsOfNoBus) {
  load(test::smallProject());
  workspace_.setLink(QStringLiteral("nic:nosuch0"));
  window_.bus().goOnline();
  auto* box = window_.findChild<QWidget*>(QStringLiteral("errorDialog"));
  ASSERT_NE(box, nullptr);
  EXPECT_EQ(box->findChild<QPushButton*>(QStringLiteral("errorWay")), nullptr);
}

TEST_F(Shell, WhatIsNothingIsRefusedWithAReason) {
  QTemporaryDir folder;
  const auto path = folder.filePath(QStringLiteral("letter.txt"));
  write(path, "Dear Sir");
  load(test::smallProject());
  window_.files().openAny(path);
  auto* box = window_.findChild<QWidget*>(QStringLiteral("errorDialog"));
  ASSERT_NE(box, nullptr);
  bool said = false;
  for (const auto* label : box->findChildren<QLabel*>())
    said = said || label->text().contains(QStringLiteral("expected: a project, an ENI"));
  EXPECT_TRUE(said);
  EXPECT_EQ(project(), test::smallProject());
}

/// In the smallest window the explorer has the width that it has in others: names of slaves fit.
TEST_F(Shell, TheExplorerKeepsItsWidthInASmallWindow) {
  window_.resize(1280, 800);
  startDemo();
  ASSERT_FALSE(HasFatalFailure());
  QApplication::processEvents();
  const auto wide = widget("explorerDock").width();
  window_.resize(1024, 640);
  QApplication::processEvents();
  EXPECT_EQ(window_.width(), 1024);
  EXPECT_EQ(widget("explorerDock").width(), wide);
}

TEST_F(Shell, ABarSaysThatTheMachineRunsSomethingElse) {
  startDemo();
  ASSERT_FALSE(HasFatalFailure());
  const auto running = project();
  EXPECT_FALSE(widget("runBar").isVisible());
  set("slave.N.name", settings::Value{std::string("Another name")}, 1);
  EXPECT_FALSE(widget("runBar").isVisible()) << "a name makes no difference to the machine";
  const auto* pages = window_.editor().tabs();
  const auto place = pages->mapTo(&window_, QPoint());
  set("master.cycle_time_us", settings::Value{std::int64_t{2 * kMillisecond}});
  ASSERT_TRUE(widget("runBar").isVisible());
  QApplication::processEvents();
  EXPECT_EQ(pages->mapTo(&window_, QPoint()), place) << "no field moves away from the pointer by an edit";
  EXPECT_FALSE(widget("runBarApply").isEnabled());
  EXPECT_EQ(workspace_.runDifference().changes(), 1) << "neither a name nor what follows from the cycle";
  set("slave.N.dc.sync0.shift_us", settings::Value{std::int64_t{0}}, 3);
  EXPECT_EQ(workspace_.runDifference().changes(), 1) << "as the operation mode has it: the same by another word";
  set("slave.N.dc.sync0.shift_us", settings::Value{std::int64_t{50 * kMicrosecond}}, 3);
  EXPECT_EQ(workspace_.runDifference().changes(), 2);
  static_cast<void>(workspace_.configuration().current());
  EXPECT_TRUE(static_cast<QLabel&>(widget("runBarText")).text().contains(u'2'));
  static_cast<QPushButton&>(widget("runBarRevert")).click();
  EXPECT_EQ(project(), running);
  static_cast<void>(workspace_.configuration().current());
  EXPECT_FALSE(widget("runBar").isVisible());
  EXPECT_EQ(workspace_.live().phase(), LiveSession::Phase::kOnline) << "nobody touched it";
}

TEST_F(Shell, ParametersOfTheControllerAreApplied) {
  startDemo();
  ASSERT_FALSE(HasFatalFailure());
  set("master.dc.gain_ppt", settings::Value{std::int64_t{5}});
  ASSERT_TRUE(widget("runBar").isVisible());
  ASSERT_TRUE(widget("runBarApply").isEnabled());
  const auto before = workspace_.runDifference().running();
  static_cast<QPushButton&>(widget("runBarApply")).click();
  EXPECT_TRUE(widget("runBar").isVisible()) << "the machine has not taken it yet";
  EXPECT_FALSE(widget("runBarApply").isEnabled()) << "nor is it asked twice";
  EXPECT_EQ(workspace_.runDifference().running(), before);
  workspace_.live().advance(100 * kMillisecond);
  EXPECT_FALSE(widget("runBar").isVisible());
  EXPECT_EQ(workspace_.live().phase(), LiveSession::Phase::kOnline);
  EXPECT_EQ(workspace_.runDifference().running(), project());
}

/// What is taken from a field by the click on the button is not compiled yet when the button is told of the click.
TEST_F(Shell, WhatComesWithTheClickIsNotSaidToRun) {
  startDemo();
  ASSERT_FALSE(HasFatalFailure());
  set("master.dc.gain_ppt", settings::Value{std::int64_t{5}});
  ASSERT_TRUE(widget("runBarApply").isEnabled());
  const auto before = workspace_.runDifference().running();
  const auto& cycle = settings::row("master.cycle_time_us");
  ASSERT_TRUE(workspace_.document().set(QStringLiteral("cycle"), {{&cycle, {}, std::int64_t{2 * kMillisecond}}}));
  static_cast<QPushButton&>(widget("runBarApply")).click();
  workspace_.live().advance(100 * kMillisecond);
  static_cast<void>(workspace_.configuration().current());
  EXPECT_EQ(workspace_.runDifference().running(), before) << "not all of it can be given to a machine that runs";
  EXPECT_TRUE(widget("runBar").isVisible()) << "the machine goes on with another cycle";
  EXPECT_FALSE(widget("runBarApply").isEnabled());
}

TEST_F(Shell, EveryKeyLeadsToItsField) {
  auto machine = test::smallProject();
  machine.master.tasks = {{"Slow", 4}};
  machine.master.sync_units = {{"Infeed", "Slow"}};
  auto& device = machine.slaves[1].device;
  device.mailbox.emplace().coe.emplace().pdo_config = true;
  device.mailbox->soe = device.mailbox->eoe = device.mailbox->aoe = true;
  StartupCommand command;
  command.transitions = {Transition::kPS};
  command.index = 0x6060;
  machine.slaves[1].startup = {command, command};
  load(machine);
  int keys = 0;
  for (const auto& setting : settings::table()) {
    if (setting.applies && !setting.applies(machine.slaves[1])) continue;
    const auto places = setting.items ? setting.items(machine, 1) : std::vector<settings::Place>{{.slave = 1}};
    if (places.empty()) continue;
    const auto key = settings::key_of(setting, places.back());
    workspace_.setExpert(false);
    window_.selectNode(2);
    EXPECT_TRUE(window_.editor().showKey(QString::fromStdString(key))) << key;
    ++keys;
  }
  EXPECT_GT(keys, 95);
  EXPECT_FALSE(window_.editor().showKey(QStringLiteral("slave.9.alias")));
  EXPECT_FALSE(window_.editor().showKey(QStringLiteral("nothing")));
  ASSERT_TRUE(window_.editor().showKey(QStringLiteral("slave.1.alias")));
  EXPECT_TRUE(widget("slaveAlias").hasFocus());
}

TEST_F(Shell, WhatIsWrongStandsBelowItsField) {
  auto machine = test::smallProject();
  load(machine);
  window_.selectNode(2);
  set("slave.N.station_address", settings::Value{std::int64_t{1002}}, 2);  // another one's
  const auto& findings = workspace_.configuration().current()->findings;
  const auto about =
      std::ranges::find_if(findings, [](const Finding& f) { return f.place.key.ends_with("station_address"); });
  ASSERT_NE(about, findings.end());
  ASSERT_TRUE(window_.editor().showKey(QString::fromStdString(about->place.key)));
  auto* note = test::find<QLabel>(window_, "slaveAddressNote");
  ASSERT_NE(note, nullptr);
  EXPECT_TRUE(note->isVisible());
  EXPECT_FALSE(note->text().isEmpty());
  workspace_.document().undoStack().undo();
  static_cast<void>(workspace_.configuration().current());
  EXPECT_FALSE(note->isVisible());
}

TEST(FindingKeys, ExistInTheTable) {
  for (const FindingWords& words : all_finding_words()) {
    Finding finding;
    finding.code = words.code;
    finding.place.slave = 1;
    const auto key = findingKey(finding);
    if (key.isEmpty()) continue;
    EXPECT_TRUE(settings::find(test::smallProject(), key.toStdString(), false).has_value()) << qPrintable(key);
  }
}

}  // namespace
}  // namespace syncline::ui
