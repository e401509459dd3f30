// SPDX-License-Identifier: Apache-2.0
// Notes on the time line: of a run, in its recording, and changed there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QInputDialog>
#include <QKeyEvent>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTimer>

#include "support/running_window.h"
#include "ui/dialogs/file_commands.h"
#include "ui/main_window.h"
#include "ui/models/message_model.h"
#include "ui/panels/live_strip.h"
#include "ui/session/workspace.h"

namespace syncline::ui {
namespace {

using test::waitFor;

class Notes : public test::RunningWindow {
 protected:
  void advance(int seconds) {
    run(seconds * kSecond);
    strip().refresh();
  }
  void goOffline() {
    workspace_.live().goOffline();
    ASSERT_TRUE(waitFor([&] { return workspace_.live().phase() == LiveSession::Phase::kOffline; }));
  }
  LiveStrip& strip() { return window_.liveStrip(); }
  /// N at a moment, and what is typed; what stood there before.
  QString press(Nanoseconds time, const QString& typed) {
    QString before;
    strip().cursors()->setPointer(time);
    QTimer::singleShot(0, &window_, [&] {
      auto* dialog = window_.findChild<QInputDialog*>();
      ASSERT_NE(dialog, nullptr);
      before = dialog->textValue();
      dialog->setTextValue(typed);
      dialog->accept();
    });
    QKeyEvent key(QEvent::KeyPress, Qt::Key_N, Qt::NoModifier);
    QCoreApplication::sendEvent(&strip(), &key);
    strip().refresh();
    return before;
  }
  int messagesWith(const QString& text) {
    int found = 0;
    const auto& model = workspace_.messages();
    for (int row = 0; row < model.rowCount(); ++row) found += model.message(row).text == text ? 1 : 0;
    return found;
  }
  std::vector<EventMark> noteMarks() {
    std::vector<EventMark> notes;
    for (const auto& mark : strip().panels().front()->plot()->marks().within(0, INT64_MAX)) {
      if (mark.note) notes.push_back(mark);
    }
    return notes;
  }

  QTemporaryDir folder_;
};

TEST_F(Notes, OfARunStandInItsRecordingAndAreChangedThere) {
  goOnline();
  int ended = 0;
  QObject::connect(&workspace_.disk(), &DiskRecording::ended, &window_, [&ended] { ++ended; });
  const auto path = folder_.filePath(QStringLiteral("run.slrec"));
  ASSERT_TRUE(workspace_.disk().start(path));
  advance(2);
  const auto moment = workspace_.shownRecord()->samples().last_time() - kSecond;
  press(moment, QStringLiteral("door opened"));
  ASSERT_EQ(workspace_.shownRecord()->notes().size(), 1U);
  EXPECT_EQ(workspace_.shownRecord()->notes()[0], (RunNote{moment, "door opened"}));
  EXPECT_EQ(messagesWith(QStringLiteral("door opened")), 1);
  ASSERT_EQ(noteMarks().size(), 1U);
  EXPECT_EQ(noteMarks()[0].time, moment);
  press(moment + kSecond / 2, QStringLiteral("   "));
  EXPECT_EQ(workspace_.shownRecord()->notes().size(), 1U) << "nothing written is no note";
  advance(2);
  goOffline();
  ASSERT_TRUE(waitFor([&] { return ended > 0; }));

  window_.files().openAny(path);
  ASSERT_TRUE(waitFor([&] { return workspace_.recording().isOpen(); }));
  strip().refresh();
  ASSERT_EQ(noteMarks().size(), 1U);
  EXPECT_EQ(noteMarks()[0].time, moment);
  EXPECT_EQ(messagesWith(QStringLiteral("door opened")), 1);
  // A little beside it: the note that is there is meant.
  EXPECT_EQ(press(moment + kMillisecond, QStringLiteral("door opened by hand")), QStringLiteral("door opened"));
  EXPECT_EQ(workspace_.shownRecord()->notes(), (std::vector<RunNote>{{moment, "door opened by hand"}}));
  press(moment + kSecond, QStringLiteral("closed"));
  EXPECT_EQ(noteMarks().size(), 2U);
  press(moment, QString());
  EXPECT_EQ(workspace_.shownRecord()->notes(), (std::vector<RunNote>{{moment + kSecond, "closed"}}));
  EXPECT_EQ(messagesWith(QStringLiteral("door opened by hand")), 0);
  EXPECT_EQ(messagesWith(QStringLiteral("closed")), 1);

  // It is in the file.
  workspace_.recording().close();
  window_.files().openAny(path);
  ASSERT_TRUE(waitFor([&] { return workspace_.recording().isOpen(); }));
  EXPECT_EQ(workspace_.shownRecord()->notes(), (std::vector<RunNote>{{moment + kSecond, "closed"}}));
}

TEST_F(Notes, OfTheLastStretchGoWithIt) {
  goOnline();
  advance(4);
  const auto last = workspace_.shownRecord()->samples().last_time();
  workspace_.live().run().addNote({last - 3 * kSecond, "before"});
  workspace_.live().run().addNote({last - kSecond / 2, "within"});
  int saved = 0;
  QObject::connect(&workspace_.disk(), &DiskRecording::saved, &window_, [&saved] { ++saved; });
  const auto path = folder_.filePath(QStringLiteral("last.slrec"));
  ASSERT_TRUE(workspace_.disk().saveLast(kSecond, path));
  ASSERT_TRUE(waitFor([&] { return saved > 0; }));
  goOffline();
  window_.files().openAny(path);
  ASSERT_TRUE(waitFor([&] { return workspace_.recording().isOpen(); }));
  EXPECT_EQ(workspace_.shownRecord()->notes(), (std::vector<RunNote>{{last - kSecond / 2, "within"}}));
}

TEST_F(Notes, SayOfWhichOfSeveralNetworksTheyAre) {
  goOnline();
  advance(1);
  workspace_.document().addNetwork(QStringLiteral("Press"));
  workspace_.document().chooseNetwork(0);
  workspace_.live().run().addNote({workspace_.shownRecord()->samples().last_time(), "here"});
  ASSERT_EQ(messagesWith(QStringLiteral("here")), 1);
  const auto& model = workspace_.messages();
  QString source;
  for (int row = 0; row < model.rowCount(); ++row) {
    if (model.message(row).text == QStringLiteral("here")) source = model.message(row).source;
  }
  EXPECT_TRUE(source.startsWith(workspace_.document().networks().front() + u':')) << source.toStdString();
}

}  // namespace
}  // namespace syncline::ui
