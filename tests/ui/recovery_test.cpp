// SPDX-License-Identifier: Apache-2.0
// What a window that is killed, or a file that is wrong or open twice, does to work: nothing.
#include <gtest/gtest.h>
#include <signal.h>

#include <QDir>
#include <QFile>
#include <QListWidget>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTimer>

#include "eni/project/project_file.h"
#include "settings/settings_table.h"
#include "support/ui_test_support.h"
#include "ui/dialogs/bus_commands.h"
#include "ui/dialogs/file_commands.h"
#include "ui/dialogs/recovery_dialog.h"
#include "ui/main_window.h"
#include "ui/session/workspace.h"

namespace syncline::ui {
namespace {

constexpr const char* kFolder = "SYNCLINE_TEST_RECOVERY";

Environment keepingIn(const QString& folder) {
  auto environment = test::virtualEnvironment();
  environment.recovery_folder = folder;
  return environment;
}

void setAlias(Workspace& workspace, std::int64_t alias) {
  ASSERT_TRUE(workspace.document().set(QStringLiteral("Change: Alias"),
                                       {{&settings::row("slave.N.alias"), {.slave = 1}, settings::Value{alias}}}));
}

/// The part of the window that is killed: the test below starts it in a process of its own.
TEST(RecoveryVictim, DISABLED_EditsAndIsKilled) {
  const QDir folder(qEnvironmentVariable(kFolder));
  Workspace workspace(keepingIn(folder.filePath(QStringLiteral("kept"))));
  workspace.document().replace(QStringLiteral("load"), test::smallProject());
  ASSERT_TRUE(workspace.document().save(folder.filePath(QStringLiteral("machine.syncline"))).has_value());
  setAlias(workspace, 77);
  const QDir kept(folder.filePath(QStringLiteral("kept")));
  const bool there = test::waitFor([&kept] { return !kept.entryList({QStringLiteral("*.recovery")}).isEmpty(); });
  ASSERT_TRUE(there) << "a moment after the edit, without anybody asking";
  ::raise(SIGKILL);
}

TEST(Recovery, AKilledWindowLosesNothing) {
  QTemporaryDir folder;
  QProcess victim;
  auto environment = QProcessEnvironment::systemEnvironment();
  environment.insert(QLatin1String(kFolder), folder.path());
  victim.setProcessEnvironment(environment);
  victim.start(QCoreApplication::applicationFilePath(),
               {QStringLiteral("--gtest_filter=RecoveryVictim.*"), QStringLiteral("--gtest_also_run_disabled_tests")});
  ASSERT_TRUE(victim.waitForFinished());
  ASSERT_EQ(victim.exitStatus(), QProcess::CrashExit) << victim.readAllStandardOutput().toStdString();

  const auto path = folder.filePath(QStringLiteral("machine.syncline"));
  Workspace workspace(keepingIn(folder.filePath(QStringLiteral("kept"))));
  const auto lost = workspace.autosave().lost();
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_EQ(lost.front().work.path, path);
  EXPECT_EQ(lost.front().work.last_edit, QStringLiteral("Change: Alias"));
  EXPECT_EQ(lost.front().work.slaves, 3);
  EXPECT_LT(lost.front().work.saved.secsTo(QDateTime::currentDateTime()), 60);
  {
    Workspace other(keepingIn(folder.filePath(QStringLiteral("kept"))));
    EXPECT_TRUE(other.autosave().lost().empty()) << "offered in one window at a time";
  }
  ASSERT_TRUE(workspace.autosave().recover(lost.front()).has_value());
  EXPECT_EQ(workspace.document().project().slaves[1].alias, 77);
  EXPECT_EQ(workspace.document().path(), path);
  EXPECT_TRUE(workspace.document().isModified());
  EXPECT_FALSE(workspace.document().readOnly()) << "the killed window holds nothing any more";
  EXPECT_EQ(eni::load_machine(path.toStdString())->networks.front().slaves[1].alias, 0)
      << "the file is as it was saved";
  ASSERT_TRUE(workspace.document().save(path).has_value());
  EXPECT_TRUE(QDir(folder.filePath(QStringLiteral("kept"))).entryList({QStringLiteral("*.recovery")}).isEmpty());
}

TEST(Recovery, NothingIsKeptOfWhatIsSavedOrUndone) {
  QTemporaryDir folder;
  const QDir kept(folder.filePath(QStringLiteral("kept")));
  const auto files = [&kept] { return kept.entryList({QStringLiteral("*.recovery")}).size(); };
  Workspace workspace(keepingIn(kept.path()));
  workspace.document().take(Machine{{}, {test::smallProject()}}, {});
  workspace.autosave().flush();
  EXPECT_EQ(files(), 0) << "nothing was edited";
  setAlias(workspace, 5);
  workspace.autosave().flush();
  EXPECT_EQ(files(), 1);
  workspace.document().undoStack().undo();
  EXPECT_EQ(files(), 0);
  workspace.document().undoStack().redo();
  workspace.autosave().flush();
  EXPECT_EQ(files(), 1);
  workspace.autosave().forget();
  EXPECT_EQ(files(), 0) << "the user does not want it";
}

/// As when the machine shuts down: nobody is asked.
TEST(Recovery, AWindowThatIsEndedLeavesItsWork) {
  QTemporaryDir folder;
  {
    Workspace workspace(keepingIn(folder.path()));
    workspace.document().take(Machine{{}, {test::smallProject()}}, {});
    setAlias(workspace, 5);
  }
  Workspace workspace(keepingIn(folder.path()));
  MainWindow window(workspace);
  window.show();
  bool then = false;
  window.files().offerRecovery([&then] { then = true; });
  auto* dialog = window.findChild<RecoveryDialog*>();
  ASSERT_NE(dialog, nullptr);
  const auto text = test::find<QListWidget>(*dialog, "recoveryList")->item(0)->text();
  EXPECT_TRUE(text.contains(QStringLiteral("Untitled"))) << qPrintable(text);
  EXPECT_TRUE(text.contains(QStringLiteral("Change: Alias"))) << qPrintable(text);
  EXPECT_FALSE(then);
  test::find<QPushButton>(*dialog, "recoveryRecover")->click();
  EXPECT_EQ(workspace.document().project().slaves[1].alias, 5);
  workspace.autosave().forget();
  workspace.document().undoStack().setClean();
}

/// The file of the command line is not dropped without a word when the work of a killed window is taken.
TEST(Recovery, TheFileThatWasAskedForIsOfferedBehindTheRecoveredWork) {
  QTemporaryDir folder;
  {
    Workspace workspace(keepingIn(folder.path()));
    workspace.document().take(Machine{{}, {test::smallProject()}}, {});
    setAlias(workspace, 5);
  }
  Workspace workspace(keepingIn(folder.path()));
  MainWindow window(workspace);
  window.show();
  window.files().offerRecovery([] {}, folder.filePath(QStringLiteral("other.syncline")));
  QString asked;
  QTimer::singleShot(0, &window, [&asked] {
    for (auto* widget : QApplication::topLevelWidgets()) {
      auto* box = qobject_cast<QMessageBox*>(widget);
      if (box == nullptr || box->objectName() != QLatin1String("askedFileQuestion")) continue;
      asked = box->text();
      box->button(QMessageBox::Cancel)->click();
    }
  });
  test::find<QPushButton>(*window.findChild<RecoveryDialog*>(), "recoveryRecover")->click();
  EXPECT_TRUE(asked.contains(QStringLiteral("other.syncline"))) << qPrintable(asked);
  EXPECT_EQ(workspace.document().project().slaves[1].alias, 5) << "the recovered work stays";
  workspace.autosave().forget();
  workspace.document().undoStack().setClean();
}

TEST(Recovery, AFolderThatTakesNoFilesIsToldOnce) {
  QTemporaryDir folder;
  QFile blocker(folder.filePath(QStringLiteral("kept")));
  ASSERT_TRUE(blocker.open(QIODevice::WriteOnly));  // a file where the folder should be
  Workspace workspace(keepingIn(blocker.fileName()));
  workspace.document().take(Machine{{}, {test::smallProject()}}, {});
  QSignalSpy failed(&workspace.autosave(), &Autosave::failed);
  for (const int alias : {5, 6}) {
    setAlias(workspace, alias);
    workspace.autosave().flush();
  }
  EXPECT_EQ(failed.count(), 1);
  workspace.autosave().forget();
}

TEST(ProjectLocks, TwoWindowsDoNotWriteOneFile) {
  QTemporaryDir folder;
  const auto path = folder.filePath(QStringLiteral("machine.syncline"));
  ProjectDocument first, second;
  first.take(Machine{{}, {test::smallProject()}}, {});
  ASSERT_TRUE(first.save(path).has_value());
  ASSERT_TRUE(first.save(path).has_value()) << "its own lock does not hinder it";
  EXPECT_FALSE(second.holder(path).isEmpty());
  ASSERT_TRUE(second.load(path).has_value()) << "it may be looked at";
  EXPECT_TRUE(second.readOnly());
  const auto refused = second.save(path);
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().detail.text().find("another window has it open"), std::string::npos)
      << refused.error().detail.text();
  const auto other = folder.filePath(QStringLiteral("copy.syncline"));
  ASSERT_TRUE(second.save(other).has_value());
  EXPECT_FALSE(second.readOnly());
  first.reset();
  EXPECT_TRUE(second.holder(path).isEmpty());
  ASSERT_TRUE(second.save(path).has_value());
}

/// What asks is answered by its button; how often anybody asked.
class Answers : public QObject {
 public:
  explicit Answers(const char* name) : button_(name) {
    timer_.callOnTimeout(this, [this] {
      auto* box = QApplication::activeModalWidget();
      if (box == nullptr) return;
      auto* button = box->findChild<QPushButton*>(QLatin1String(button_));
      if (button == nullptr) return;
      ++asked;
      button->click();
    });
    timer_.start(5);
  }
  int asked = 0;

 private:
  const char* button_;
  QTimer timer_;
};

class RunningMachine : public ::testing::Test {
 protected:
  RunningMachine() : workspace_(test::virtualEnvironment()), window_(workspace_) {
    workspace_.live().setAutoAdvance(false);
    window_.show();
    window_.bus().startDemo();
    static_cast<void>(test::waitFor([this] { return workspace_.live().phase() != LiveSession::Phase::kOffline; }));
    workspace_.live().advance(kSecond);
    workspace_.document().undoStack().setClean();
  }
  ~RunningMachine() override {
    workspace_.live().shutDown();
    workspace_.document().undoStack().setClean();
  }
  Workspace workspace_;
  MainWindow window_;
};

TEST_F(RunningMachine, AWrongFileLeavesProjectAndMachineAlone) {
  ASSERT_EQ(workspace_.live().phase(), LiveSession::Phase::kOnline);
  const auto project = workspace_.document().project();
  QTemporaryDir folder;
  const auto path = folder.filePath(QStringLiteral("wrong.syncline"));
  {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("<SynclineProject><Network>");
  }
  EXPECT_FALSE(window_.files().openFile(path));
  EXPECT_FALSE(window_.files().openFile(folder.filePath(QStringLiteral("none.syncline"))));
  EXPECT_EQ(workspace_.document().project(), project);
  EXPECT_EQ(workspace_.live().phase(), LiveSession::Phase::kOnline);
}

TEST_F(RunningMachine, AnotherProjectAndAScanAskBeforeItGoesOffline) {
  const auto project = workspace_.document().project();
  QTemporaryDir folder;
  const auto path = folder.filePath(QStringLiteral("small.syncline"));
  ASSERT_TRUE(eni::save_project(test::smallProject(), path.toStdString()).has_value());
  {
    struct Cancel : QObject {
      QTimer timer;
      int asked = 0;
    } no;
    no.timer.callOnTimeout(&no, [&no] {
      if (auto* box = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
        ++no.asked;
        box->reject();
      }
    });
    no.timer.start(5);
    EXPECT_FALSE(window_.files().openFile(path));
    window_.bus().scanLink(workspace_.link());
    EXPECT_EQ(no.asked, 2);
  }
  EXPECT_FALSE(workspace_.scan().isRunning());
  EXPECT_EQ(workspace_.live().phase(), LiveSession::Phase::kOnline);
  EXPECT_EQ(workspace_.document().project(), project);
  Answers yes("questionGo");
  EXPECT_TRUE(window_.files().openFile(path));
  EXPECT_EQ(yes.asked, 1);
  EXPECT_EQ(workspace_.live().phase(), LiveSession::Phase::kOffline);
  EXPECT_EQ(workspace_.document().project(), test::smallProject());
}

}  // namespace
}  // namespace syncline::ui
