// SPDX-License-Identifier: Apache-2.0
// A recording that is played in the window: each moment is what was live then.
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QTemporaryDir>
#include <QToolButton>
#include <cmath>
#include <map>
#include <set>

#include "record/typed_values.h"
#include "support/running_window.h"
#include "support/whole_file.h"
#include "tests/support/same_overview.h"
#include "trace/csv.h"
#include "ui/dialogs/file_commands.h"
#include "ui/models/finding_model.h"
#include "ui/panels/figure_card.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/replay_slider.h"
#include "ui/session/recording_replay.h"
#include "ui/widgets/pill.h"

namespace syncline::ui {
namespace {

using test::waitFor;

/// What was live at the end of a tick.
struct Live {
  SyncOverview overview;
  std::vector<std::string> events;
  std::vector<std::pair<Nanoseconds, float>> errors;
};

class ReplayTest : public test::RunningWindow {
 protected:
  ReplayTest() {
    replay().setClock([this] { return clock_; });
  }
  RecordingReplay& replay() { return workspace_.replay(); }
  const RunRecord& shown() { return *workspace_.shownRecord(); }
  static Live stateOf(const RunRecord& record) {
    Live live{record.overview(), {}, {}};
    for (const auto& event : record.events()) live.events.push_back(encode_event(event.what));
    record.samples().series(Signal::kDcmError).for_each(INT64_MIN, INT64_MAX, [&live](Nanoseconds time, float value) {
      if (!std::isnan(value)) live.errors.emplace_back(time, value);
    });
    return live;
  }
  QString path(const char* name = "run.slrec") const { return folder_.filePath(QLatin1String(name)); }
  /// The machine from its first cycle on, recorded and looked at now and then, and opened.
  void makeAndOpen() {
    window_.bus().startDemo();
    ASSERT_TRUE(waitFor([this] { return workspace_.live().phase() != LiveSession::Phase::kOffline; }));
    bool ended = false;
    const auto told = QObject::connect(&workspace_.disk(), &DiskRecording::ended, &window_, [&ended] { ended = true; });
    ASSERT_TRUE(workspace_.disk().start(path()));
    for (int i = 0; i < 40; ++i) {
      run((i < 25 ? 100 : 500) * kMillisecond);
      const auto& record = *workspace_.live().record();
      if (record.samples().empty()) continue;
      live_[record.samples().last_time()] = stateOf(record);
      if (i == 12) workspace_.live().arm();
    }
    ASSERT_EQ(workspace_.live().snapshot().state, AlState::kOp);
    workspace_.document().undoStack().setClean();
    workspace_.runs().shutDown();
    ASSERT_TRUE(waitFor([&ended] { return ended; }));
    QObject::disconnect(told);
    open(path());
  }
  void open(const QString& file) {
    window_.files().openAny(file);
    ASSERT_TRUE(waitFor([this] { return !workspace_.recording().isReading(); }));
    ASSERT_EQ(workspace_.recording().path(), file);
  }
  void pass(Nanoseconds time) {
    clock_ += time;
    replay().tick();
  }
  QAction* action(const char* name) { return window_.findChild<QAction*>(QLatin1String(name)); }
  QString text(const char* name) { return window_.findChild<QLabel*>(QLatin1String(name))->text(); }
  void press(const char* name) { test::find<QToolButton>(window_, name)->click(); }

  Nanoseconds clock_ = 5 * kSecond;
  std::map<Nanoseconds, Live> live_;
  QTemporaryDir folder_;
};

TEST_F(ReplayTest, AMomentIsWhatWasLiveThen) {
  makeAndOpen();
  ASSERT_GT(live_.size(), 10U);
  std::vector<Nanoseconds> moments;
  for (const auto& [time, state] : live_) moments.push_back(time);
  // Forward, back, here and there.
  std::vector<Nanoseconds> order = moments;
  order.insert(order.end(), moments.rbegin(), moments.rend());
  order.push_back(moments[moments.size() / 2]);
  std::set<Nanoseconds> armed;
  for (const auto moment : order) {
    SCOPED_TRACE(moment);
    replay().seek(moment);
    ASSERT_EQ(shown().shown_at(), moment);
    const auto is = stateOf(shown());
    const auto& was = live_.at(moment);
    test::expect_same(is.overview, was.overview);
    EXPECT_EQ(is.events, was.events);
    EXPECT_TRUE(is.errors == was.errors) << is.errors.size() << " and " << was.errors.size();
    if (is.overview.armed) armed.insert(*is.overview.armed);
  }
  EXPECT_EQ(armed.size(), 2U) << "by itself, and by hand";
}

TEST_F(ReplayTest, ItIsPlayedWithTheClockAtItsSpeed) {
  makeAndOpen();
  EXPECT_TRUE(field("replayBar").isVisible());
  EXPECT_FALSE(replay().isActive());
  action("actionReplayPlay")->trigger();
  EXPECT_TRUE(replay().isPlaying());
  EXPECT_EQ(replay().moment(), replay().begin());
  pass(250 * kMillisecond);
  EXPECT_EQ(replay().moment(), replay().begin() + 250 * kMillisecond);
  EXPECT_LE(shown().samples().last_time(), replay().moment());
  EXPECT_GT(shown().samples().last_time(), replay().moment() - 2 * kMillisecond);
  // A hundredth: so many nanoseconds, whatever the ticks are.
  replay().setSpeed(0);
  for (int i = 0; i < 333; ++i) pass(33'333'333);
  EXPECT_EQ(replay().moment(), replay().begin() + 250 * kMillisecond + Nanoseconds{333} * 33'333'333 / 100);
  replay().setSpeed(5);
  EXPECT_EQ(field<QComboBox>("replaySpeed").currentIndex(), 5);
  const auto before = replay().moment();
  pass(100 * kMillisecond);
  EXPECT_EQ(replay().moment(), before + kSecond);
  action("actionReplayPlay")->trigger();
  EXPECT_FALSE(replay().isPlaying());
  pass(kSecond);
  EXPECT_EQ(replay().moment(), before + kSecond) << "it pauses";
  // It ends by itself, also where the computer has slept, and begins anew.
  action("actionReplayPlay")->trigger();
  pass(INT64_MAX / 4);
  EXPECT_EQ(replay().moment(), replay().end());
  EXPECT_FALSE(replay().isPlaying());
  EXPECT_TRUE(replay().isActive());
  action("actionReplayPlay")->trigger();
  EXPECT_EQ(replay().moment(), replay().begin());
}

TEST_F(ReplayTest, StepsAreCyclesAndEvents) {
  makeAndOpen();
  EXPECT_FALSE(action("actionReplayNextCycle")->isEnabled()) << "all is shown";
  press("replayLastCycle");
  const auto last = replay().moment();
  EXPECT_EQ(shown().samples().next_cycle_time(last), replay().end());
  press("replayNextCycle");
  EXPECT_EQ(replay().moment(), replay().end());
  EXPECT_FALSE(action("actionReplayNextEvent")->isEnabled());
  press("replayBegin");
  EXPECT_EQ(replay().moment(), replay().begin());
  EXPECT_FALSE(action("actionReplayLastCycle")->isEnabled());
  ASSERT_FALSE(replay().marks().empty());
  auto reached = replay().moment();
  for (const auto& mark : replay().marks()) {
    if (mark.time <= reached || mark.time > replay().end()) continue;
    press("replayNextEvent");
    EXPECT_EQ(replay().moment(), mark.time);
    EXPECT_EQ(shown().events().back().time, mark.time);
    reached = mark.time;
  }
  press("replayEnd");
  press("replayLastEvent");
  EXPECT_EQ(replay().moment(), reached);
}

TEST_F(ReplayTest, PlotsFiguresMessagesAndFindingsAreThoseOfTheMoment) {
  makeAndOpen();
  const auto all = workspace_.messages().rowCount();
  const auto found = workspace_.findings().rowCount();
  const auto moment = std::next(live_.begin(), static_cast<std::ptrdiff_t>(live_.size()) - 4)->first;
  replay().seek(moment);
  auto& strip = window_.liveStrip();
  EXPECT_EQ(strip.timeView()->mode(), TimeView::Mode::kLive);
  EXPECT_EQ(strip.timeView()->end(), shown().samples().last_time());
  EXPECT_EQ(text("liveStateLabel"), QLatin1String("Replay"));
  EXPECT_EQ(field<QToolButton>("liveButton").text(), QLatin1String("Now"));
  EXPECT_NE(field<FigureCard>("overviewDcm").lines().front().section(u'\t', 1), QStringLiteral("–")) << "it has a now";
  EXPECT_EQ(field<Pill>("overviewMaster").text(), QLatin1String("In sync"));
  EXPECT_FALSE(field("overviewArm").isEnabled());
  const auto few = workspace_.messages().rowCount();
  EXPECT_LE(few, all);
  for (int row = 0; row < few; ++row) EXPECT_LE(workspace_.messages().message(row).moment, moment);
  EXPECT_EQ(workspace_.findings().rowCount(), 0);
  EXPECT_TRUE(text("noFindings").startsWith(QLatin1String("A moment of a recording")));
  replay().seek(replay().begin());
  EXPECT_LT(workspace_.messages().rowCount(), few);
  EXPECT_EQ(strip.timeView()->end(), replay().begin());
  replay().seek(replay().end());
  EXPECT_EQ(workspace_.messages().rowCount(), all);
  EXPECT_EQ(workspace_.findings().rowCount(), found);
  // Whole again, as it was opened.
  press("replayLeave");
  EXPECT_FALSE(shown().shown_at());
  EXPECT_EQ(strip.timeView()->mode(), TimeView::Mode::kHistory);
  EXPECT_EQ(strip.timeView()->span(), replay().end() - replay().begin());
  EXPECT_TRUE(field<Pill>("overviewMaster").text().startsWith(QLatin1String("At the end")));
  EXPECT_EQ(text("liveStateLabel"), QLatin1String("Recording"));
  EXPECT_EQ(workspace_.messages().rowCount(), all);
}

TEST_F(ReplayTest, TheSliderSeeksAndEscLeaves) {
  makeAndOpen();
  auto& slider = field<ReplaySlider>("replayPlace");
  EXPECT_EQ(slider.value(), slider.maximum());
  QTest::mouseClick(&slider, Qt::LeftButton, {}, QPoint(slider.width() / 2, slider.height() / 2));
  ASSERT_TRUE(replay().isActive());
  const auto middle = (replay().begin() + replay().end()) / 2;
  EXPECT_NEAR(static_cast<double>(replay().moment() - middle), 0,
              static_cast<double>(replay().end() - replay().begin()) / 50);
  const auto before = replay().moment();
  slider.setFocus();
  QTest::keyClick(&slider, Qt::Key_Right);
  EXPECT_GT(replay().moment(), before);
  EXPECT_LT(replay().moment(), before + (replay().end() - replay().begin()) / 500);
  QTest::keyClick(&slider, Qt::Key_Home);
  EXPECT_EQ(replay().moment(), replay().begin());
  QTest::keyClick(&slider, Qt::Key_Escape);
  EXPECT_FALSE(replay().isActive());
  // In the plots Esc takes the cursors first.
  replay().seek(middle);
  auto& strip = window_.liveStrip();
  QTest::keyClick(&strip, Qt::Key_A);
  QTest::keyClick(&strip, Qt::Key_Escape);
  EXPECT_TRUE(replay().isActive());
  QTest::keyClick(&strip, Qt::Key_Escape);
  EXPECT_FALSE(replay().isActive());
}

TEST_F(ReplayTest, NotesOfLaterAreKept) {
  makeAndOpen();
  const auto late = replay().end() - kSecond, early = replay().begin() + kSecond;
  const auto put = workspace_.putNote({late, "late"});
  ASSERT_TRUE(put) << put.error().detail.text();
  EXPECT_TRUE(replay().marks().back().note || replay().marks().back().time > late);
  replay().seek(early + kSecond);
  ASSERT_TRUE(workspace_.putNote({early, "early"}));
  const auto notes = RecordingReader::open(path().toStdString())->info()->notes;
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes.front().text, "early");
  EXPECT_EQ(notes.back().text, "late");
  const auto& messages = workspace_.messages();
  int seen = 0;
  for (int row = 0; row < messages.rowCount(); ++row)
    seen += messages.message(row).source == QLatin1String("Note") ? 1 : 0;
  EXPECT_EQ(seen, 1) << "the other one has not been written yet";
}

TEST_F(ReplayTest, AnArmedTriggerFindsWhatWasUntilThen) {
  makeAndOpen();
  Trigger trigger;
  trigger.signal = Signal::kDcmError;
  trigger.magnitude = true;
  trigger.level = 300;
  trigger.hold_off = 100 * kMillisecond;
  trigger.mode = Trigger::Mode::kAutomatic;
  workspace_.trigger().setTrigger(trigger);
  workspace_.trigger().arm();
  while (workspace_.trigger().stateText() == QLatin1String("looks through the recording")) workspace_.trigger().look();
  const auto all = workspace_.trigger().episodes();
  ASSERT_GT(all.size(), 2U);
  replay().seek(all[1].time);
  workspace_.trigger().look();
  EXPECT_EQ(workspace_.trigger().episodes().size(), 2U);
  replay().seek(all[0].time - 1);
  workspace_.trigger().look();
  EXPECT_TRUE(workspace_.trigger().episodes().empty());
  replay().leave();
  workspace_.trigger().look();
  EXPECT_EQ(workspace_.trigger().episodes().size(), all.size());
}

/// What accumulates as time goes on begins anew where time went back.
TEST_F(ReplayTest, ADistributionIsThatOfItsMomentAlsoAfterGoingBack) {
  makeAndOpen();
  auto& strip = window_.liveStrip();
  press("distributionButton");
  const auto moment = replay().begin() + (replay().end() - replay().begin()) * 3 / 4;
  replay().seek(moment);
  strip.refresh();
  const auto was = strip.csv();
  replay().seek(replay().end());
  strip.refresh();
  EXPECT_NE(strip.csv(), was);
  replay().seek(moment);
  strip.refresh();
  EXPECT_EQ(strip.csv(), was);
}

TEST_F(ReplayTest, ATableThatIsShownIsPlayedToo) {
  makeAndOpen();
  auto reader = RecordingReader::open(path().toStdString());
  ASSERT_TRUE(reader);
  auto csv = sample_csv_header();
  ASSERT_TRUE(reader->samples([&csv](std::span<const CycleSample> samples) {
    append_sample_csv(csv, samples);
    return true;
  }));
  ASSERT_TRUE(write_whole_file(path("run.csv").toStdString(), csv));
  open(path("run.csv"));
  ASSERT_TRUE(replay().isPossible());
  const auto moment = std::next(live_.begin(), static_cast<std::ptrdiff_t>(live_.size()) - 3)->first;
  replay().seek(moment);
  EXPECT_EQ(shown().overview().end, moment);
  EXPECT_EQ(shown().overview().dcm_error.now->value, live_.at(moment).overview.dcm_error.now->value);
}

/// The moment is gone with the recording that it was of; nothing plays where nothing is open.
TEST_F(ReplayTest, AnotherRecordingBeginsWhole) {
  makeAndOpen();
  action("actionReplayPlay")->trigger();
  ASSERT_TRUE(QFile::copy(path(), path("other.slrec")));
  open(path("other.slrec"));
  EXPECT_FALSE(replay().isPlaying());
  EXPECT_FALSE(replay().isActive());
  EXPECT_FALSE(shown().shown_at());
  replay().seek(replay().begin() + kSecond);
  workspace_.recording().close();
  EXPECT_FALSE(field("replayBar").isVisible());
  EXPECT_FALSE(action("actionReplayPlay")->isEnabled());
  action("actionReplayPlay")->trigger();
  replay().stepMark(1);
  EXPECT_FALSE(replay().isActive());
}

}  // namespace
}  // namespace syncline::ui
