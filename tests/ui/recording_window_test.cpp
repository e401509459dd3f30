// SPDX-License-Identifier: Apache-2.0
// Recordings in the window: made there, opened there, and the overview of either.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <qwt_scale_map.h>
#include <QAction>
#include <QDialog>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QTableView>
#include <QTemporaryDir>

#include <QUndoStack>
#include <cmath>
#include <memory>
#include <thread>

#include "eni/project/project_file.h"
#include "findings/run_codes.h"
#include "link/link.h"
#include "record/typed_values.h"
#include "settings/settings_table.h"
#include "support/ui_test_support.h"
#include "tests/support/plain_capture.h"
#include "ui/dialogs/bus_commands.h"
#include "ui/dialogs/file_commands.h"
#include "ui/dialogs/recording_commands.h"
#include "ui/dialogs/slave_commands.h"
#include "ui/machine_building.h"
#include "ui/main_window.h"
#include "ui/models/finding_model.h"
#include "ui/models/message_model.h"
#include "ui/panels/explorer_panel.h"
#include "ui/panels/figure_card.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/messages_panel.h"
#include "ui/panels/overview_panel.h"
#include "ui/plots/gap_item.h"
#include "ui/session/file_kind.h"
#include "ui/session/workspace.h"
#include "ui/text/event_text.h"
#include "ui/text/overview_text.h"
#include "ui/text/recorded_text.h"
#include "ui/text/units.h"
#include "ui/theme/theme.h"
#include "ui/widgets/pill.h"

namespace syncline::ui {
namespace {

using test::waitFor;

class RecordingWindow : public testing::Test {
 protected:
  RecordingWindow() : workspace_(test::virtualEnvironment()), window_(workspace_) {
    workspace_.live().setAutoAdvance(false);
    window_.show();
  }
  ~RecordingWindow() override {
    workspace_.document().undoStack().setClean();
    workspace_.live().shutDown();
  }
  void goOnline() {
    window_.bus().startDemo();
    ASSERT_TRUE(waitFor([&] { return workspace_.live().phase() != LiveSession::Phase::kOffline; }));
    advance(8);
    ASSERT_EQ(workspace_.live().phase(), LiveSession::Phase::kOnline);
  }
  void advance(int seconds) {
    for (int i = 0; i < seconds * 10; ++i) workspace_.live().advance(100 * kMillisecond);
    workspace_.runs().current().findings.refresh();
  }
  void goOffline() {
    workspace_.live().goOffline();
    ASSERT_TRUE(waitFor([&] { return workspace_.live().phase() == LiveSession::Phase::kOffline; }));
  }
  QString path(const char* name) { return folder_.filePath(QLatin1String(name)); }
  /// Seconds of the machine in a file; the run has ended then.
  void record(const char* name) {
    goOnline();
    ASSERT_TRUE(workspace_.disk().start(path(name)));
    advance(4);
    goOffline();
    ASSERT_TRUE(waitFor([&] { return ended_ > 0; }));
  }
  void open(const char* name) {
    window_.files().openAny(path(name));
    ASSERT_TRUE(waitFor([&] { return !workspace_.recording().isReading(); }));
  }
  void SetUp() override {
    QObject::connect(&workspace_.disk(), &DiskRecording::ended, &window_,
                     [this](const QString&, const QString&, const std::optional<Error>& error) {
                       ++ended_;
                       error_ = error;
                     });
  }
  QAction* action(const char* name) { return window_.findChild<QAction*>(QLatin1String(name)); }
  QString text(const char* name) { return window_.findChild<QLabel*>(QLatin1String(name))->text(); }

  QTemporaryDir folder_;
  Workspace workspace_;
  MainWindow window_;
  int ended_ = 0;
  std::optional<Error> error_;
};

std::vector<std::pair<Nanoseconds, float>> points(const MinMaxSeries& series, Nanoseconds from) {
  std::vector<std::pair<Nanoseconds, float>> all;
  series.for_each(from, INT64_MAX, [&all](Nanoseconds time, float value) {
    all.emplace_back(time, std::isnan(value) ? -1e30F : value);
  });
  return all;
}

TEST_F(RecordingWindow, WhatWasRecordedIsShownAsItWas) {
  record("run.slrec");
  EXPECT_FALSE(error_);
  const auto* live = workspace_.live().record();
  open("run.slrec");
  ASSERT_TRUE(workspace_.recording().isOpen());
  const auto& replay = *workspace_.shownRecord();
  EXPECT_EQ(window_.liveStrip().store(), &replay.samples());
  // The same samples from where the recording begins on,
  const auto begin = replay.samples().first_time();
  for (const auto signal : {Signal::kDeviation, Signal::kDcmError, Signal::kDcmErrorFiltered, Signal::kRoundTrip}) {
    EXPECT_EQ(points(replay.samples().series(signal), begin), points(live->samples().series(signal), begin));
  }
  // the same limits, findings and events.
  EXPECT_EQ(replay.limits(), live->limits());
  EXPECT_EQ(replay.findings(), live->findings());
  std::vector<std::string> was, is;
  for (const auto& event : live->events()) {
    if (event.time >= begin) was.push_back(encode_event(event.what));
  }
  for (const auto& event : replay.events()) is.push_back(encode_event(event.what));
  EXPECT_EQ(is, was);
  EXPECT_FALSE(workspace_.recording().run().only_words);
  EXPECT_EQ(replay.config().slaves.size(), live->config().slaves.size());
  EXPECT_EQ(replay.slave_name(1), live->slave_name(1));
  // Its messages stand on the clock of its plots.
  const auto& messages = workspace_.messages();
  ASSERT_GT(messages.rowCount(), 0);
  const auto newest = messages.index(0, MessageModel::kTime).data(MessageModel::kMomentRole).toLongLong();
  EXPECT_EQ(messages.index(0, MessageModel::kRunTime).data().toString(), runTimeText(newest - replay.overview().begin));
}

void expectAlike(const SyncOverview& is, const SyncOverview& was) {
  EXPECT_EQ(is.armed, was.armed);
  EXPECT_EQ(is.deviation.statistics.count(), was.deviation.statistics.count());
  EXPECT_EQ(is.deviation.statistics.rms(), was.deviation.statistics.rms());
  EXPECT_EQ(is.dcm_error.statistics.count(), was.dcm_error.statistics.count());
  ASSERT_TRUE(is.dcm_filtered.largest && was.dcm_filtered.largest);
  EXPECT_EQ(is.dcm_filtered.largest->time, was.dcm_filtered.largest->time);
  EXPECT_EQ(is.master.times_lost, was.master.times_lost);
  EXPECT_EQ(is.missed.count, was.missed.count);
  EXPECT_EQ(is.faults.count(), was.faults.count());
}

/// A log of another master is shown like a recording; what it does not hold is no zero.
TEST_F(RecordingWindow, ALogOfTheMasterSynchronisationIsShownLikeARecording) {
  QByteArray log("Time[ms];CtlErr [ns];CtlErrFilt;DCMInSync;DCInSync\n");
  for (int i = 0; i < 500; ++i) log += QByteArray::number(i) + ";-25;-20;1;1\n";
  QFile file(path("other.csv"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(log);
  file.close();
  open("other.csv");
  ASSERT_TRUE(workspace_.recording().isOpen());
  EXPECT_TRUE(window_.findChild<OverviewPanel*>()->isVisible());
  EXPECT_THAT(text("recordingBarText").toStdString(), testing::HasSubstr("an imported run on other.csv"));
  const auto* error = window_.findChild<FigureCard*>(QStringLiteral("overviewDcm"));
  EXPECT_TRUE(error->figureText(0).startsWith(signedTimeText(25))) << "with how sure that is";
  const auto* deviation = window_.findChild<FigureCard*>(QStringLiteral("overviewDeviation"));
  EXPECT_EQ(deviation->figureText(0), noText());
  EXPECT_EQ(window_.findChild<Pill*>(QStringLiteral("overviewMaster"))->text().toStdString(), "At the end: In sync");
}

TEST(RecordedText, ASpanIsToldInTheTwoLargestUnits) {
  EXPECT_EQ(spanText(59 * kSecond), QStringLiteral("59 s"));
  EXPECT_EQ(spanText(60 * kSecond), QStringLiteral("1 min 0 s"));
  EXPECT_EQ(spanText(3599 * kSecond), QStringLiteral("59 min 59 s"));
  EXPECT_EQ(spanText(3600 * kSecond), QStringLiteral("1 h 0 min"));
  EXPECT_EQ(spanText(90'061 * kSecond), QStringLiteral("25 h 1 min"));
}

/// Its recording holds what the machine was held against last, since when, and what ran.
/// A capture of any master becomes a recording on disk, and is shown.
TEST_F(RecordingWindow, ACaptureIsImportedAsARecording) {
  const test::TemporaryFolder captures;
  test::PlainCapture file;
  for (int i = 0; i < 5'000; ++i) {
    const auto sent = test::kCaptureBegin + i * 500 * kMicrosecond;
    const auto frame = test::cyclic_frame(static_cast<std::uint8_t>(i), 1002);
    file.add(sent, frame);
    file.add(sent + 28'000, test::answered(frame, static_cast<std::uint64_t>(sent + 77), -12));
  }
  const auto capture = QString::fromStdString(file.write(captures));
  auto* commands = window_.findChild<RecordingCommands*>();
  ASSERT_NE(commands, nullptr);
  EXPECT_TRUE(action("actionImportCapture")->isEnabled());
  commands->importCapture(capture, path("capture.slrec"));
  ASSERT_TRUE(waitFor([&] { return workspace_.recording().isOpen(); }));
  EXPECT_EQ(workspace_.recording().path(), path("capture.slrec"));
  EXPECT_TRUE(QFile::exists(path("capture.slrec")));
  const auto& record = *workspace_.recording().run().record;
  EXPECT_EQ(record.limits().cycle_time, 500 * kMicrosecond);
  EXPECT_EQ(record.samples().stamped_by(), StampSource::kCapture);
  EXPECT_EQ(workspace_.recording().run().info.cycles, 5'000U);
  // A part of it: half a second from the second on, and no more than so many frames of that.
  ImportLimits part;
  part.from = kSecond;
  part.until = kSecond + kSecond / 2;
  part.deviation_ns = 100;
  commands->importCapture(capture, path("part.slrec"), part);
  ASSERT_TRUE(waitFor([&] { return workspace_.recording().path() == path("part.slrec"); }));
  EXPECT_EQ(workspace_.recording().run().info.cycles, 1'000U);
  EXPECT_EQ(workspace_.recording().run().record->limits().deviation_ns, 100);
  part.most_frames = 100;
  commands->importCapture(capture, path("few.slrec"), part);
  ASSERT_TRUE(waitFor([&] { return workspace_.recording().path() == path("few.slrec"); }));
  EXPECT_EQ(workspace_.recording().run().info.cycles, 50U) << "each with its answer";
  commands->importCapture(capture, path("capture2.slrec"));
  ASSERT_TRUE(waitFor([&] { return workspace_.recording().path() == path("capture2.slrec"); }));
  // Cancelled there is no file, and what is shown stays.
  commands->importCapture(capture, path("cancelled.slrec"));
  workspace_.recording().cancel();
  ASSERT_TRUE(waitFor([&] { return !workspace_.recording().isReading(); }));
  EXPECT_FALSE(QFile::exists(path("cancelled.slrec")));
  EXPECT_EQ(workspace_.recording().path(), path("capture2.slrec"));
  // Also where it was written already, and only not yet shown.
  commands->importCapture(capture, path("late.slrec"));
  for (QElapsedTimer since; !QFile::exists(path("late.slrec"));) {
    if (!since.isValid()) since.start();
    ASSERT_LT(since.elapsed(), 20'000);
    std::this_thread::yield();
  }
  workspace_.recording().cancel();
  ASSERT_TRUE(waitFor([&] { return !workspace_.recording().isReading(); }));
  EXPECT_FALSE(QFile::exists(path("late.slrec")));
  EXPECT_EQ(workspace_.recording().path(), path("capture2.slrec"));
}

TEST_F(RecordingWindow, OfARunThatHasEndedNothingIsNow) {
  goOnline();
  advance(2);
  const auto* state = window_.findChild<QLabel*>(QStringLiteral("liveStateLabel"));
  ASSERT_NE(state, nullptr);
  EXPECT_EQ(state->text(), QString());
  EXPECT_TRUE(window_.findChild<LiveStrip*>()->timeView()->goesOn());
  goOffline();
  EXPECT_EQ(state->text(), QStringLiteral("Ended"));
  goOnline();
  EXPECT_EQ(state->text(), QString());
}

TEST_F(RecordingWindow, WhereAFileIsNothingIsImported) {
  QFile there(path("there.slrec"));
  ASSERT_TRUE(there.open(QIODevice::WriteOnly));
  there.write("mine");
  there.close();
  auto& recording = workspace_.recording();
  QString failed;
  QObject::connect(&recording, &OpenedRecording::failed, &window_, [&failed](const QString&, const Error& error) {
    failed = QString::fromStdString(error.detail.text());
  });
  bool read = false;
  recording.importCapture(QStringLiteral("long.pcapng"), path("there.slrec"), {},
                          [&read](const QString&, const ImportLimits&, const ImportProgress&) -> Result<ImportedRun> {
                            read = true;
                            return fail(ErrorCode::kCancelled);
                          });
  ASSERT_TRUE(waitFor([&] { return !recording.isReading(); }));
  EXPECT_TRUE(failed.contains(QStringLiteral("replaces nothing"))) << failed.toStdString();
  EXPECT_FALSE(read) << "what cannot be kept is not read for hours first";
  ASSERT_TRUE(there.open(QIODevice::ReadOnly));
  EXPECT_EQ(there.readAll(), QByteArray("mine"));
}

TEST_F(RecordingWindow, WhatTheTriggerFoundIsInTheRecording) {
  goOnline();
  Trigger trigger;
  trigger.kind = Trigger::Kind::kEvent;
  trigger.code = "event-state";
  workspace_.trigger().setTrigger(trigger);
  ASSERT_TRUE(workspace_.disk().start(path("run.slrec")));
  workspace_.trigger().arm();
  workspace_.live().requestState(AlState::kSafeop);
  advance(2);
  workspace_.trigger().look();
  ASSERT_FALSE(workspace_.trigger().episodes().empty());
  workspace_.trigger().setName(workspace_.trigger().episodes().front(), QStringLiteral("by hand"));
  const auto found = workspace_.trigger().episodes();
  advance(2);
  workspace_.trigger().disarm();
  goOffline();
  ASSERT_TRUE(waitFor([&] { return ended_ > 0; }));
  EXPECT_EQ(workspace_.trigger().episodes(), found) << "the run has ended, and keeps them";
  trigger.code = "event-slave-lost";
  workspace_.trigger().setTrigger(trigger);
  open("run.slrec");
  EXPECT_EQ(workspace_.trigger().episodes(), found);
  EXPECT_EQ(workspace_.trigger().name(found.front()), QStringLiteral("by hand"));
  EXPECT_EQ(workspace_.trigger().trigger().code, "event-state");
}

TEST_F(RecordingWindow, WhatWasAppliedToTheRunIsInItsRecording) {
  goOnline();
  auto& document = workspace_.document();
  ASSERT_TRUE(document.save(path("line 7.syncline")));
  ASSERT_TRUE(workspace_.disk().start(path("run.slrec")));
  advance(2);
  const auto* live = workspace_.live().record();
  const auto before = live->standing();
  ASSERT_TRUE(before.armed);
  ASSERT_TRUE(document.set(QStringLiteral("set"),
                           {{&settings::row("master.dc.in_sync_limit_ns"), {}, settings::Value{std::int64_t{2'500}}}}));
  static_cast<void>(workspace_.configuration().current());
  ASSERT_TRUE(workspace_.runDifference().applicable());
  workspace_.runDifference().apply();
  advance(8);
  EXPECT_EQ(live->limits().dcm_error_ns, 2'500);
  EXPECT_EQ(live->overview().master.times_lost, 0U) << "nothing was lost: it was set anew";
  ASSERT_TRUE(live->overview().armed);
  EXPECT_GT(live->overview().armed, before.armed);
  goOffline();
  ASSERT_TRUE(waitFor([&] { return ended_ > 0; }));
  open("run.slrec");
  ASSERT_TRUE(workspace_.recording().isOpen());
  EXPECT_EQ(workspace_.shownRecord()->standing(), live->standing());
  expectAlike(workspace_.shownRecord()->overview(), live->overview());
  const auto& documents = workspace_.recording().run().info.about.documents;
  const auto project = std::ranges::find(documents, std::string("project"), &RecordedDocument::kind);
  ASSERT_NE(project, documents.end());
  EXPECT_EQ(project->body, eni::write_project(document.project()));
}

TEST_F(RecordingWindow, ARecordingIsNamedAfterItsProject) {
  goOnline();
  goOffline();
  ASSERT_TRUE(workspace_.document().save(path("line 7.syncline")));
  window_.bus().goOnline();
  ASSERT_TRUE(waitFor([&] { return workspace_.live().phase() != LiveSession::Phase::kOffline; }));
  advance(8);
  ASSERT_TRUE(workspace_.disk().start(path("run.slrec")));
  advance(2);
  goOffline();
  ASSERT_TRUE(waitFor([&] { return ended_ > 0; }));
  open("run.slrec");
  EXPECT_THAT(text("recordingBarText").toStdString(), testing::HasSubstr("line 7.syncline on sim:"));
}

/// Begun in the midst of a run, which is armed anew meanwhile.
TEST_F(RecordingWindow, TheOverviewOfARecordingIsThatOfItsRun) {
  goOnline();
  advance(3);
  ASSERT_TRUE(workspace_.disk().start(path("run.slrec")));
  advance(1);
  workspace_.live().arm();
  advance(3);
  goOffline();
  ASSERT_TRUE(waitFor([&] { return ended_ > 0; }));
  open("run.slrec");
  ASSERT_TRUE(workspace_.recording().isOpen());
  expectAlike(workspace_.shownRecord()->overview(), workspace_.live().record()->overview());
}

TEST_F(RecordingWindow, WithoutAMachineThatRunsNothingIsRecorded) {
  EXPECT_FALSE(workspace_.disk().start(path("none.slrec")));
  goOnline();
  goOffline();
  const auto status = workspace_.disk().start(path("none.slrec"));
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kFileNotWritable);
  EXPECT_THAT(status.error().detail.text(), testing::HasSubstr("go online"));
  EXPECT_FALSE(workspace_.disk().isRecording());
  EXPECT_FALSE(QFile::exists(path("none.slrec")));
}

/// What the one tells when the next has begun is none of the next one's.
TEST_F(RecordingWindow, TheEndOfOneIsNotTheEndOfTheNext) {
  goOnline();
  ASSERT_TRUE(QDir(folder_.path()).mkdir(QStringLiteral("gone")));
  ASSERT_TRUE(workspace_.disk().start(path("gone/first.slrec")));
  advance(2);
  ASSERT_TRUE(QDir(path("gone")).removeRecursively());
  advance(2);
  workspace_.disk().stop();
  ASSERT_TRUE(workspace_.disk().start(path("second.slrec")));
  ASSERT_TRUE(waitFor([&] { return ended_ > 0; }));
  EXPECT_TRUE(error_) << "the first one has lost its file";
  EXPECT_TRUE(workspace_.disk().isRecording());
  EXPECT_EQ(workspace_.disk().path(), path("second.slrec"));
  advance(3);
  goOffline();
  ASSERT_TRUE(waitFor([&] { return ended_ > 1; }));
  EXPECT_EQ(ended_, 2);
  EXPECT_FALSE(error_);
  open("second.slrec");
  ASSERT_TRUE(workspace_.recording().isOpen());
  EXPECT_TRUE(workspace_.recording().run().info.ended);
}

/// Its slaves are its own: what is about them leads to their curves, never into the project that is open.
TEST_F(RecordingWindow, WhatARecordingTellsDoesNotLeadIntoTheProject) {
  record("run.slrec");
  window_.explorer().select(2);
  auto& messages = workspace_.messages();
  open("run.slrec");
  ASSERT_TRUE(workspace_.recording().isOpen());
  const auto& strip = window_.liveStrip();
  EXPECT_EQ(strip.panels()[0]->pickedSlave(), -1) << "the one that was picked in the project is none of it";
  for (int row = 0; row < messages.rowCount(); ++row)
    EXPECT_FALSE(messages.index(row, 0).data(MessageModel::kFindingRole).toBool()) << "of the project";
  EXPECT_FALSE(action("actionGoTo")->isEnabled());
  Message message;
  message.slave = 3;
  Q_EMIT window_.findChild<MessagesPanel*>()->activated(message);
  EXPECT_EQ(strip.panels()[0]->pickedSlave(), 3);
  EXPECT_EQ(window_.explorer().selected(), 2);
  EXPECT_TRUE(window_.findChild<OverviewPanel*>()->isVisible());
  action("actionCloseRecording")->trigger();
  EXPECT_EQ(window_.explorer().selected(), 2);
  EXPECT_TRUE(action("actionGoTo")->isEnabled());
}

TEST(Recorded, TheLatestMessagesAreKept) {
  ReplayedRun run{std::make_unique<RunRecord>(NetworkConfig{}), {}};
  for (int i = 0; i < 20; ++i) run.info.events.push_back({(i ^ 1) * kSecond, -1, "kind", std::to_string(i ^ 1)});
  run.info.notes.push_back({12 * kSecond, "note"});
  const auto all = messagesOf(run, 100);
  ASSERT_EQ(all.size(), 21U);
  EXPECT_TRUE(std::ranges::is_sorted(all, {}, &Message::moment));
  const auto latest = messagesOf(run, 5);
  ASSERT_EQ(latest.size(), 5U);
  EXPECT_EQ(latest.front().text, QStringLiteral("15"));
  EXPECT_EQ(latest.back().text, QStringLiteral("19"));
}

TEST_F(RecordingWindow, TheWindowSaysThatItIsARecordingAndOfWhat) {
  record("run.slrec");
  const auto own = workspace_.messages().rowCount();
  ASSERT_TRUE(workspace_.document().edit(QStringLiteral("name"), [](Project& project) {
    project.slaves.front().name = "Other";
    return Status{};
  }));
  open("run.slrec");
  const auto bar = text("recordingBarText");
  EXPECT_THAT(bar.toStdString(), testing::AllOf(testing::HasSubstr("run.slrec"), testing::HasSubstr("sim:"),
                                                testing::HasSubstr("up to the end of the run")));
  EXPECT_TRUE(window_.findChild<QWidget*>(QStringLiteral("recordingBar"))->isVisible());
  EXPECT_TRUE(window_.windowTitle().startsWith(QStringLiteral("Recording run.slrec")));
  for (const char* const name : {"actionOnline", "actionScan", "actionRecord", "actionClearStatistics", "actionUndo"}) {
    EXPECT_FALSE(action(name)->isEnabled()) << name;
    EXPECT_TRUE(action(name)->toolTip().contains(QStringLiteral("recording"))) << name;
  }
  EXPECT_FALSE(workspace_.goOnline());
  auto& commands = window_.building().commands();
  const auto slaves = workspace_.document().project().slaves.size();
  EXPECT_FALSE(commands.add->isEnabled());
  EXPECT_FALSE(workspace_.network().flags(workspace_.network().indexOf(0)).testFlag(Qt::ItemIsDragEnabled));
  QString told;
  QObject::connect(&commands, &SlaveCommands::told, [&](const QString& words) { told = words; });
  commands.move(2, {0});
  EXPECT_TRUE(told.contains(QStringLiteral("recording"))) << "slaves that nobody sees are not moved";
  EXPECT_EQ(workspace_.document().project().slaves.size(), slaves);
  EXPECT_EQ(window_.liveStrip().timeView()->mode(), TimeView::Mode::kHistory) << "it has no now";
  EXPECT_TRUE(window_.findChild<OverviewPanel*>()->isVisible());
  ASSERT_FALSE(workspace_.recording().run().info.events.empty());
  EXPECT_LT(workspace_.messages().rowCount(), own) << "the log is that of the recording, which began later";

  action("actionCloseRecording")->trigger();
  EXPECT_FALSE(workspace_.recording().isOpen());
  EXPECT_EQ(workspace_.messages().rowCount(), own) << "nothing of before is lost";
  EXPECT_TRUE(action("actionOnline")->isEnabled());
  EXPECT_TRUE(action("actionUndo")->isEnabled());
  EXPECT_TRUE(commands.add->isEnabled());
  EXPECT_FALSE(action("actionOnline")->toolTip().contains(QStringLiteral("recording")));
  EXPECT_EQ(window_.liveStrip().store(), &workspace_.live().record()->samples());
}

/// Of a file that was cut off what is whole is shown, and how much is lost is a finding.
TEST_F(RecordingWindow, WhatIsLeftOfOneThatWasCutOffIsShown) {
  record("run.slrec");
  QFile file(path("run.slrec"));
  ASSERT_TRUE(file.resize(file.size() * 19 / 20));
  open("run.slrec");
  ASSERT_TRUE(workspace_.recording().isOpen());
  EXPECT_FALSE(workspace_.shownRecord()->samples().empty());
  const auto& findings = workspace_.findings();
  QStringList told;
  for (int row = 0; row < findings.rowCount({}); ++row) {
    if (findings.index(row, 0).data(FindingModel::kCodeRole) == QLatin1String("recording-cut-off"))
      told << findings.index(row, FindingModel::kFinding).data().toString();
  }
  ASSERT_EQ(told.size(), 1);
  EXPECT_TRUE(told[0].startsWith(QStringLiteral("The file is cut off: "))) << told[0].toStdString();
}

/// Truncated, foreign, of the future, no file at all: explained, and everything stays as it is.
TEST_F(RecordingWindow, WhatCannotBeReadLeavesEverythingAsItWas) {
  record("run.slrec");
  QFile whole(path("run.slrec"));
  ASSERT_TRUE(whole.open(QIODevice::ReadOnly));
  auto bytes = whole.readAll();
  const auto put = [&](const char* name, const QByteArray& content) {
    QFile file(path(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(content);
  };
  put("cut.slrec", bytes.left(bytes.size() / 20));
  put("text.slrec", "these are words");
  put("empty.slrec", "");
  auto future = bytes;
  future[63] = 99;  // user_version, the last byte of four
  put("future.slrec", future);
  auto foreign = bytes;
  foreign[68] = 0;  // application_id
  put("foreign.slrec", foreign);
  const auto* before = workspace_.shownRecord();
  for (const char* const name : {"cut.slrec", "text.slrec", "empty.slrec", "future.slrec", "foreign.slrec"}) {
    const auto errors = workspace_.messages().count(Severity::kError);
    open(name);
    EXPECT_FALSE(workspace_.recording().isOpen()) << name;
    EXPECT_EQ(workspace_.shownRecord(), before) << name;
    EXPECT_EQ(workspace_.messages().count(Severity::kError), errors + 1) << name;
    const auto why =
        workspace_.messages().index(0, MessageModel::kText).data(Qt::DisplayRole).toString().toStdString() +
        workspace_.messages().index(1, MessageModel::kText).data(Qt::DisplayRole).toString().toStdString();
    if (std::string_view(name) == "future.slrec") {
      EXPECT_THAT(why, testing::HasSubstr("version 99"));
    }
    if (std::string_view(name) == "cut.slrec") {
      EXPECT_THAT(why, testing::AllOf(testing::HasSubstr("damaged or cut off (no whole cycle of it is left)"),
                                      testing::HasSubstr("cut.slrec")));
    }
    for (auto* box : window_.findChildren<QDialog*>()) box->close();
  }
  EXPECT_EQ(fileKind(path("foreign.slrec")), FileKind::kRecording) << "so that it is said whose it is";
}

TEST_F(RecordingWindow, TheLastStretchComesOutOfMemory) {
  goOnline();
  advance(5);
  EXPECT_GE(workspace_.disk().remembered(), 5 * kSecond);
  EXPECT_GT(workspace_.disk().memoryReach(), 60 * kSecond);
  bool saved = false;
  std::optional<Error> failed;
  QObject::connect(&workspace_.disk(), &DiskRecording::saved, &window_,
                   [&](const QString&, const std::optional<Error>& error) {
                     saved = true;
                     failed = error;
                   });
  const auto last = workspace_.live().record()->samples().last_time();
  ASSERT_TRUE(workspace_.disk().saveLast(3 * kSecond, path("last.slrec")));
  ASSERT_TRUE(waitFor([&] { return saved; }));
  ASSERT_FALSE(failed) << failed->detail.text();
  goOffline();
  open("last.slrec");
  ASSERT_TRUE(workspace_.recording().isOpen());
  const auto& replay = workspace_.shownRecord()->samples();
  EXPECT_EQ(replay.last_time(), last);
  EXPECT_NEAR(static_cast<double>(replay.last_time() - replay.first_time()), 3e9, 1e7);
  EXPECT_TRUE(replay.value(Signal::kAlState, 1, last)) << "states that had not changed for long are there, too";
}

TEST_F(RecordingWindow, AnEndedRecordingSaysWhy) {
  goOnline();
  ASSERT_TRUE(QDir(folder_.path()).mkdir(QStringLiteral("gone")));
  ASSERT_TRUE(workspace_.disk().start(path("gone/run.slrec")));
  EXPECT_TRUE(window_.findChild<Pill*>(QStringLiteral("statusRecording"))->isVisible());
  advance(2);
  ASSERT_TRUE(QDir(path("gone")).removeRecursively());
  for (int i = 0; i < 20 && ended_ == 0; ++i) {
    advance(2);
    QTest::qWait(5);
  }
  ASSERT_TRUE(waitFor([&] { return ended_ > 0; }));
  ASSERT_TRUE(error_);
  EXPECT_EQ(error_->code, ErrorCode::kFileNotWritable);
  EXPECT_EQ(workspace_.live().phase(), LiveSession::Phase::kOnline) << "the machine goes on";
  EXPECT_FALSE(window_.findChild<Pill*>(QStringLiteral("statusRecording"))->isVisible());
  EXPECT_GT(workspace_.messages().count(Severity::kError), 0);
  const auto refused = workspace_.disk().start(path("no/such/folder.slrec"));
  EXPECT_FALSE(refused);
  EXPECT_FALSE(workspace_.disk().isRecording());
}

TEST_F(RecordingWindow, TheOverviewIsSeenFirstAndSaysWhetherItIsInSync) {
  goOnline();
  advance(6);
  auto* panel = window_.findChild<OverviewPanel*>();
  ASSERT_TRUE(panel->isVisible());
  panel->refresh();
  EXPECT_EQ(window_.findChild<Pill*>(QStringLiteral("overviewSlaves"))->text(), QStringLiteral("In sync"));
  EXPECT_THAT(text("overviewSlavesText").toStdString(), testing::HasSubstr("not lost since armed"));
  EXPECT_THAT(text("overviewFault").toStdString(), testing::HasSubstr("No fault"));
  const auto* deviation = window_.findChild<FigureCard*>(QStringLiteral("overviewDeviation"));
  EXPECT_THAT(deviation->mainText().toStdString(), testing::HasSubstr("ns"));
  EXPECT_THAT(deviation->noteText().toStdString(), testing::HasSubstr("margin"));
  EXPECT_THAT(deviation->figureText(2).toStdString(), testing::HasSubstr("ns"));
  const auto armed = workspace_.live().record()->overview().armed;
  ASSERT_TRUE(armed);
  window_.findChild<QPushButton*>(QStringLiteral("overviewArm"))->click();
  EXPECT_GT(workspace_.live().record()->overview().armed, armed);
  window_.selectNode(1);
  EXPECT_FALSE(panel->isVisible()) << "a node that is chosen shows its pages";
  action("actionOverview")->trigger();
  EXPECT_TRUE(panel->isVisible());
  goOffline();
  panel->refresh();
  EXPECT_THAT(window_.findChild<Pill*>(QStringLiteral("overviewSlaves"))->text().toStdString(),
              testing::HasSubstr("At the end"));
  EXPECT_EQ(deviation->mainText(), QStringLiteral("\u2013")) << "what has ended is not now";
}

/// The line of another moment is a stranger.
TEST(Messages, OnlyTheLineOfTheMomentIsSelected) {
  MessageModel model;
  for (const qint64 moment : {1000, 2000}) {
    Message message{
        QDateTime::currentDateTime(), Severity::kNote, QStringLiteral("Servo"), QStringLiteral("is back"), 1, {}};
    message.moment = moment;
    model.append(message);
  }
  MessagesPanel panel(model);
  auto* table = panel.findChild<QTableView*>();
  panel.selectMoment(1000);
  ASSERT_TRUE(table->selectionModel()->hasSelection());
  EXPECT_EQ(table->currentIndex().data(MessageModel::kMomentRole).toLongLong(), 1000);
  panel.selectMoment(1999);
  EXPECT_FALSE(table->selectionModel()->hasSelection());
}

CycleSample cycle(std::uint64_t i, bool lost) {
  CycleSample s;
  s.cycle = i;
  s.send_time = 830'000'000 * kSecond + static_cast<Nanoseconds>(i) * kMillisecond;
  s.master_state = 8;
  s.slaves_sync = s.master_sync = lost ? SyncState::kUnknown : SyncState::kInSync;
  s.flags = lost ? CycleSample::kFrameLost : CycleSample::kFollowersRead;
  s.round_trip_ns = 30'000;
  s.deviation_ns = 40;
  return s;
}

/// A line among others has no room for advice.
TEST(Overview, AStateThatASlaveLeftIsToldWithoutWhatToCheck) {
  const Event fell{kSecond, 1, events::AlStatusError{0x14, 0x001A}};
  const auto whole = messageOf(fell, NetworkConfig{})->text;
  const auto brief = briefText(fell);
  EXPECT_TRUE(whole.contains(brief)) << qPrintable(whole);
  EXPECT_TRUE(brief.startsWith(QStringLiteral("SAFEOP+ERR"))) << "the slave has been named: " << qPrintable(brief);
  EXPECT_TRUE(brief.contains(QStringLiteral("0x001A"))) << qPrintable(brief);
  EXPECT_LT(brief.size(), whole.size());
}

/// A firmware that is too slow loses nothing, and is no order either.
TEST(Overview, SaysWhatWasFoundWhereNothingHappened) {
  NetworkConfig config;
  config.slaves.resize(2);
  config.slaves[1].name = "Servo";
  RunRecord record(config);
  std::vector<CycleSample> samples;
  for (std::uint64_t i = 0; i < 100; ++i) samples.push_back(cycle(i, false));
  record.add(samples);
  Finding found{code::kGatewayCycleExceeded, Severity::kWarning};
  found.place.slave = 1;
  EXPECT_EQ(worstOf({}, 0), nullptr);
  ASSERT_EQ(worstOf({&found, 1}, kSecond), &found) << "it has no time";
  found.from = kSecond;
  found.to = 2 * kSecond;
  EXPECT_EQ(worstOf({&found, 1}, 2 * kSecond), &found);
  EXPECT_EQ(worstOf({&found, 1}, 3 * kSecond), nullptr) << "it was over when the figures were armed anew";
  found.from = found.to = 0;
  const auto nothing = firstFaultText(record, {}, 0), something = firstFaultText(record, {&found, 1}, 0);
  EXPECT_NE(nothing, something);
  EXPECT_TRUE(something.contains(QStringLiteral("Servo"))) << qPrintable(something);
  found.severity = Severity::kNote;
  EXPECT_EQ(firstFaultText(record, {&found, 1}, 0), nothing) << "news is no fault";
}

/// A machine that never comes in sync is never armed: then the banner is all the more asked why.
TEST(Overview, SaysWhatArmingWaitsForAndWhatIsFound) {
  NetworkConfig config;
  config.slaves.resize(2);
  config.slaves[1].name = "Servo";
  RunRecord record(config);
  auto sample = cycle(0, false);
  sample.master_state = static_cast<std::uint8_t>(AlState::kSafeop);
  sample.slaves_sync = SyncState::kOutOfSync;
  sample.master_sync = SyncState::kInSync;
  record.add({&sample, 1});
  const auto waits = firstFaultText(record, {}, 0);
  EXPECT_TRUE(waits.contains(QStringLiteral("Now: SAFEOP; slaves: Out of sync."))) << qPrintable(waits);
  EXPECT_FALSE(waits.contains(QStringLiteral("master:"))) << qPrintable(waits);
  Finding found{code::kGatewayCycleExceeded, Severity::kError};
  found.place.slave = 1;
  const auto because = firstFaultText(record, {&found, 1}, 0);
  EXPECT_TRUE(because.contains(QStringLiteral("Found so far: <b>Servo"))) << qPrintable(because);
}

/// Drives that fall while they are brought up have missed events; nothing of that is "none".
TEST(Overview, MissedEventsAreNotCountedBeforeItIsArmed) {
  NetworkConfig config;
  config.slaves.resize(2);
  RunRecord record(config);
  OverviewPanel panel;
  panel.setRecord(&record, false);
  panel.setLive(true);
  panel.show();
  const auto text = [&](bool armed, std::uint64_t i, std::uint16_t count) {
    auto sample = cycle(i, false);
    if (!armed) sample.master_state = static_cast<std::uint8_t>(AlState::kSafeop);
    sample.sm2_position = 1;
    sample.slave_sm2_missed = count;
    record.add({&sample, 1});
    panel.refresh();
    const auto* card = panel.findChild<FigureCard*>(QStringLiteral("overviewMissed"));
    return card->mainText() + u'|' + card->noteText();
  };
  text(false, 0, 0);
  EXPECT_EQ(text(false, 1, 5), QStringLiteral("\u2013|not counted yet"));
  EXPECT_EQ(text(true, 2, 5), QStringLiteral("0|none"));
  EXPECT_TRUE(text(true, 3, 7).startsWith(QStringLiteral("2|")));
}

/// What came first is said first, and its link leads to the plots.
TEST(Overview, SaysWhatCameFirstAndLeadsThere) {
  NetworkConfig config;
  config.slaves.resize(2);
  config.slaves[1].name = "Servo";
  RunRecord record(config);
  std::vector<CycleSample> samples;
  for (std::uint64_t i = 0; i < 4000; ++i) samples.push_back(cycle(i, i >= 2000 && i < 2200));
  record.add(samples);
  const auto fault = samples[2000].send_time;
  record.add(Event{fault + 3 * kMillisecond, -1, events::WkcError{6, 3, 1}});
  record.add(Event{fault, 1, events::SlaveLost{}});
  OverviewPanel panel;
  panel.setRecord(&record, false);
  panel.setLive(true);
  auto* label = panel.findChild<QLabel*>(QStringLiteral("overviewFault"));
  const auto text = label->text().toStdString();
  const auto first = text.find("Servo"), second = text.find("Working counter 3 instead of 6");
  ASSERT_NE(first, std::string::npos) << text;
  ASSERT_NE(second, std::string::npos) << text;
  EXPECT_LT(first, second);
  EXPECT_THAT(text, testing::HasSubstr(runTimeText(2 * kSecond).toStdString()));
  qint64 wanted = 0;
  QObject::connect(&panel, &OverviewPanel::momentWanted, &panel, [&](qint64 moment) { wanted = moment; });
  Q_EMIT label->linkActivated(QString::number(fault));
  EXPECT_EQ(wanted, fault);
  LiveStrip strip;
  strip.resize(1200, 300);
  strip.setRecord(&record);
  strip.show();
  strip.refresh();
  strip.goTo(wanted);
  EXPECT_LE(strip.timeView()->begin(), fault);
  EXPECT_GE(strip.timeView()->end(), fault);
  EXPECT_EQ(strip.cursors()->at(CursorSet::kA), fault);
  strip.refresh();
  const auto mark = strip.panels()[0]->plot()->marks().nearest(fault + kMillisecond / 4, kMillisecond);
  ASSERT_TRUE(mark);
  EXPECT_EQ(mark->time, fault);
  EXPECT_TRUE(mark->fault);
}

/// The first fault is a link: it can be read after the theme was changed, too.
TEST(Overview, LinksHaveTheColourOfTheTheme) {
  theme::apply(theme::Mode::kLight);
  NetworkConfig config;
  config.slaves.resize(2);
  RunRecord record(config);
  std::vector<CycleSample> samples;
  for (std::uint64_t i = 0; i < 100; ++i) samples.push_back(cycle(i, false));
  record.add(samples);
  record.add(Event{samples[50].send_time, 1, events::SlaveLost{}});
  OverviewPanel panel;
  panel.resize(900, 200);
  panel.setRecord(&record, false);
  panel.setLive(true);
  panel.show();
  auto* label = panel.findChild<QLabel*>(QStringLiteral("overviewFault"));
  const auto has = [&](const QColor& color) {
    const auto image = label->grab().toImage();
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        if (image.pixelColor(x, y) == color) return true;
      }
    }
    return false;
  };
  const auto light = QApplication::palette().color(QPalette::Link);
  EXPECT_TRUE(has(light));
  theme::apply(theme::Mode::kDark);
  QApplication::processEvents();
  panel.refresh();
  EXPECT_TRUE(has(QApplication::palette().color(QPalette::Link)));
  EXPECT_FALSE(has(light));
  theme::apply(theme::Mode::kLight);
}

TEST(Overview, WhatIsOutOfSyncWasLostOrNeverInSync) {
  SyncOverview overview;
  overview.begin = overview.armed.emplace(kSecond);
  overview.end = 10 * kSecond;
  const auto text = [&](SyncState state, std::optional<Nanoseconds> lost) {
    return lampText({state, 2 * kSecond, lost, lost ? 1U : 0U, {}, 0, 0}, overview).toStdString();
  };
  EXPECT_THAT(text(SyncState::kInSync, {}), testing::HasSubstr("not lost since armed"));
  for (const auto state : {SyncState::kOutOfSync, SyncState::kUnknown, SyncState::kBusy}) {
    EXPECT_EQ(text(state, {}), "for 8 s");
    EXPECT_THAT(text(state, 2 * kSecond), testing::HasSubstr("last lost 8 s ago"));
  }
  overview.armed.reset();
  EXPECT_EQ(text(SyncState::kInSync, {}), "for 8 s") << "nothing is counted yet";
}

/// An outage is hatched from its first lost frame to its last, and nothing else is.
TEST(Overview, OutagesAreHatched) {
  NetworkConfig config;
  config.slaves.resize(1);
  RunRecord record(config);
  std::vector<CycleSample> samples;
  for (std::uint64_t i = 0; i < 4000; ++i) samples.push_back(cycle(i, (i >= 2000 && i < 2200) || i == 3000));
  record.add(samples);
  GapItem item;
  item.setSeries(&record.samples().series(Signal::kRoundTrip), record.samples().longest_gap(Signal::kRoundTrip));
  for (const int columns : {100, 1000, 8000}) {
    const auto grid = ColumnGrid::of(samples[1000].send_time, samples.back().send_time, columns);
    item.prepare(grid);
    ASSERT_EQ(item.stretches().size(), 1U) << columns;
    const auto& stretch = item.stretches().front();
    const auto tolerance =
        std::max<double>(1.5, static_cast<double>(2 * kMillisecond) / static_cast<double>(grid.width));
    EXPECT_NEAR(stretch.begin, grid.column_of(samples[2000].send_time), tolerance) << columns;
    EXPECT_NEAR(stretch.end, grid.column_of(samples[2200].send_time), tolerance) << columns;
  }
  QImage image(400, 100, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  QwtScaleMap x, y;
  x.setPaintInterval(0, 400);
  const auto grid = ColumnGrid::of(samples[1000].send_time, samples.back().send_time, 400);
  item.prepare(grid);
  item.setColor(Qt::black);
  item.draw(&painter, x, y, QRectF(0, 0, 400, 100));
  painter.end();
  const auto dark = [&](int column) {
    int count = 0;
    for (int row = 0; row < 100; ++row) count += image.pixel(column, row) == qRgb(0, 0, 0) ? 1 : 0;
    return count;
  };
  const int middle = static_cast<int>(grid.column_of(samples[2100].send_time));
  EXPECT_GT(dark(middle), 5);
  EXPECT_LT(dark(middle), 50);
  EXPECT_EQ(dark(middle - 40), 0);
  EXPECT_EQ(dark(middle + 40), 0);
}

}  // namespace
}  // namespace syncline::ui
