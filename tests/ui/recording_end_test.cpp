// SPDX-License-Identifier: Apache-2.0
// How the window's recording ends when nobody ends it: the program is killed, or the disk is full.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QUndoStack>
#include <cstdlib>
#include <optional>
#include <string>

#include "record/recorder.h"
#include "record/recording_reader.h"
#include "support/ui_test_support.h"
#include "ui/dialogs/bus_commands.h"
#include "ui/dialogs/file_commands.h"
#include "ui/main_window.h"
#include "ui/panels/live_strip.h"
#include "ui/session/workspace.h"
#include "ui/widgets/pill.h"

namespace syncline::ui {
namespace {

using test::waitFor;

constexpr const char* kFile = "SYNCLINE_TEST_RECORDING";  // where the window that is to be killed records to

constexpr int kTold = 3;  // descriptor by which it tells how far it has come: the standard output has other words

class RecordingEnd : public testing::Test {
 protected:
  RecordingEnd() : workspace_(test::virtualEnvironment()), window_(workspace_) {
    workspace_.live().setAutoAdvance(false);
    window_.show();
  }
  ~RecordingEnd() override {
    workspace_.document().undoStack().setClean();
    workspace_.live().shutDown();
  }
  void goOnline() {
    window_.bus().startDemo();
    ASSERT_TRUE(waitFor([&] { return workspace_.live().phase() != LiveSession::Phase::kOffline; }));
    for (int i = 0; i < 80; ++i) workspace_.live().advance(100 * kMillisecond);
    ASSERT_EQ(workspace_.live().phase(), LiveSession::Phase::kOnline);
  }
  Nanoseconds newest() { return workspace_.live().record()->samples().last_time(); }

  QTemporaryDir folder_;
  Workspace workspace_;
  MainWindow window_;
};

/// The window that is killed: it tells how far it has come, as fast as a machine would.
TEST_F(RecordingEnd, DISABLED_RecordsUntilItIsKilled) {
  ASSERT_NE(std::getenv(kFile), nullptr);
  goOnline();
  ASSERT_TRUE(workspace_.disk().start(QString::fromLocal8Bit(std::getenv(kFile))));
  for (;;) {
    workspace_.live().advance(20 * kMillisecond);
    QTest::qWait(20);
    const Nanoseconds told = newest();
    if (::write(kTold, &told, sizeof told) != sizeof told) return;
  }
}

/// A window of its own, as a program of its own; what it tells comes through a pipe.
class KilledWindow {
 public:
  explicit KilledWindow(const std::string& file) {
    int told[2];
    if (::pipe(told) != 0) return;
    child_ = ::fork();
    if (child_ == 0) {
      ::setenv(kFile, file.c_str(), 1);
      ::dup2(told[1], kTold);
      ::execl("/proc/self/exe", "test_ui", "--gtest_also_run_disabled_tests", "--gtest_brief=1",
              "--gtest_filter=RecordingEnd.DISABLED_RecordsUntilItIsKilled", nullptr);
      ::_exit(127);
    }
    ::close(told[1]);
    told_ = told[0];
  }
  ~KilledWindow() {
    kill();
    ::close(told_);
  }
  KilledWindow(const KilledWindow&) = delete;
  KilledWindow& operator=(const KilledWindow&) = delete;

  /// The newest time of its run; nothing: it has ended by itself.
  std::optional<Nanoseconds> read() const {
    Nanoseconds time = 0;
    if (::read(told_, &time, sizeof time) != sizeof time) return std::nullopt;
    return time;
  }
  void kill() {
    if (child_ <= 0) return;
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
    child_ = -1;
  }

 private:
  pid_t child_ = -1;
  int told_ = -1;
};

TEST_F(RecordingEnd, KilledItIsWholeUpToTheLastTwoSeconds) {
  const auto file = folder_.filePath(QStringLiteral("killed.slrec")).toStdString();
  KilledWindow window(file);
  const auto first = window.read();
  ASSERT_TRUE(first) << "the window did not come up";
  auto last = first;
  while (last && *last < *first + 4 * kSecond) last = window.read();
  ASSERT_TRUE(last);
  window.kill();
  auto reader = RecordingReader::open(file);
  ASSERT_TRUE(reader) << reader.error().detail.text();
  const auto verified = reader->verify();
  ASSERT_TRUE(verified) << verified.error().detail.text();
  const auto info = reader->info();
  ASSERT_TRUE(info);
  EXPECT_FALSE(info->ended) << "cut short, and says so";
  EXPECT_EQ(info->missing_cycles, 0U);
  EXPECT_LE(*last - info->end, 2 * kSecond);
  EXPECT_EQ(info->about.documents.size(), 2U) << "what was run is in it";
}

/// A disk of memory that has next to nothing left; gone at the end.
class FullDisk {
 public:
  explicit FullDisk(const QString& folder) : folder_(folder.toStdString()) {
    mounted_ = QDir().mkpath(folder) && ::mount("none", folder_.c_str(), "tmpfs", 0, "size=2m") == 0;
  }
  ~FullDisk() {
    if (mounted_) ::umount2(folder_.c_str(), MNT_DETACH);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  [[nodiscard]] bool isThere() const { return mounted_; }

 private:
  std::string folder_;
  bool mounted_ = false;
};

TEST_F(RecordingEnd, AFullDiskEndsItWithAMessageAndTheMachineGoesOn) {
  const FullDisk disk(folder_.filePath(QStringLiteral("disk")));
  if (!disk.isThere()) GTEST_SKIP() << "this user may not mount a small disk";
  goOnline();
  int ended = 0;
  std::optional<Error> error;
  QObject::connect(&workspace_.disk(), &DiskRecording::ended, &window_,
                   [&](const QString&, const QString&, const std::optional<Error>& why) {
                     ++ended;
                     error = why;
                   });
  const auto file = folder_.filePath(QStringLiteral("disk/run.slrec"));
  ASSERT_TRUE(workspace_.disk().start(file));
  const auto before = newest();
  const int errors = workspace_.messages().count(Severity::kError);
  for (int i = 0; i < 600 && ended == 0; ++i) {
    workspace_.live().advance(100 * kMillisecond);
    QApplication::processEvents();
  }
  ASSERT_TRUE(waitFor([&] { return ended > 0; }));
  EXPECT_EQ(ended, 1);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code, ErrorCode::kFileNotWritable);
  EXPECT_NE(error->detail.text().find("disk"), std::string::npos) << error->detail.text();
  EXPECT_GT(workspace_.messages().count(Severity::kError), errors);
  EXPECT_FALSE(workspace_.disk().isRecording());
  EXPECT_FALSE(window_.findChild<Pill*>(QStringLiteral("statusRecording"))->isVisible());
  workspace_.live().advance(kSecond);
  EXPECT_EQ(workspace_.live().phase(), LiveSession::Phase::kOnline) << "the machine goes on";
  EXPECT_GT(newest(), before);
  auto reader = RecordingReader::open(file.toStdString());
  ASSERT_TRUE(reader) << reader.error().detail.text();
  EXPECT_TRUE(reader->verify());
}

/// Killed before its first commit it says what was to be run, and every view of the window does without a cycle.
TEST_F(RecordingEnd, WithoutACycleItOpens) {
  RecordingAbout about;
  about.program = "syncline";
  about.slaves = {{"Coupler", 2, 3, 4}};
  about.limits = {kMillisecond, 500, 4000};
  const auto file = folder_.filePath(QStringLiteral("short.slrec"));
  {
    auto recorder = Recorder::start(file.toStdString(), about, {}, {});
    ASSERT_TRUE(recorder);
    (*recorder)->add(RecordedEvent{kSecond, 0, "state", "slave 0: PREOP"});
    ASSERT_TRUE((*recorder)->finish());
  }
  window_.files().openAny(file);
  ASSERT_TRUE(waitFor([&] { return workspace_.recording().isOpen(); }));
  EXPECT_EQ(workspace_.recording().run().info.cycles, 0U);
  EXPECT_EQ(workspace_.recording().replay(), nullptr);
  for (auto* action : window_.findChildren<QAction*>()) {
    if (action->objectName().startsWith(QLatin1String("actionView")) && action->isEnabled()) action->trigger();
  }
  window_.liveStrip().refresh();
  QApplication::processEvents();
  workspace_.recording().close();
}

/// As /proc/PID/status has it.
bool catches(qint64 pid, int number) {
  QFile file(QStringLiteral("/proc/%1/status").arg(pid));
  if (!file.open(QIODevice::ReadOnly)) return false;
  const auto text = file.readAll();
  const auto at = text.indexOf("SigCgt:");
  return at >= 0 && (text.mid(at + 7, 17).trimmed().toULongLong(nullptr, 16) >> (number - 1) & 1U) != 0;
}

TEST(WindowProgram, EndsInOrderOnAnySignalThatCanBeCaught) {
  QTemporaryDir home;
  auto environment = QProcessEnvironment::systemEnvironment();
  environment.insert(QStringLiteral("HOME"), home.path());
  environment.insert(QStringLiteral("XDG_STATE_HOME"), home.path());
  environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
  for (const int number : {SIGUSR1, SIGXCPU, SIGRTMAX}) {
    QProcess program;
    program.setProcessEnvironment(environment);
    program.start(QCoreApplication::applicationDirPath() + QStringLiteral("/syncline"), {});
    ASSERT_TRUE(program.waitForStarted());
    ASSERT_TRUE(waitFor([&] { return catches(program.processId(), number); })) << number;
    ::kill(static_cast<pid_t>(program.processId()), number);
    ASSERT_TRUE(program.waitForFinished()) << number;
    EXPECT_EQ(program.exitStatus(), QProcess::NormalExit) << number;
    EXPECT_EQ(program.exitCode(), 0) << number;
  }
}

}  // namespace
}  // namespace syncline::ui
