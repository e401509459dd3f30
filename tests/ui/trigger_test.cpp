// SPDX-License-Identifier: Apache-2.0
// The trigger of the window: set, armed, found, shown, kept.
#include <gtest/gtest.h>

#include <algorithm>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <memory>

#include "support/running_window.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/trigger_panel.h"
#include "ui/session/trigger_monitor.h"
#include "ui/session/window_memory.h"

namespace syncline::ui {
namespace {

constexpr Nanoseconds kTriggerRun = 830'000'000 * kSecond;

/// Errors of the master synchronisation of 10 ns; of 500 ns in cycles 1000, 1010 and 4000.
std::unique_ptr<RunRecord> triggerRecord(std::uint64_t cycles) {
  NetworkConfig config;
  config.cyclic.resize(1);
  config.cyclic.front().cycle_time = kMillisecond;
  config.slaves.emplace_back().name = "Servo";
  auto record = std::make_unique<RunRecord>(config);
  std::vector<CycleSample> samples(cycles);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].cycle = i;
    samples[i].send_time = kTriggerRun + static_cast<Nanoseconds>(i) * kMillisecond;
    samples[i].flags = CycleSample::kDcmActive | CycleSample::kReferenceValid;
    samples[i].dcm_error_ns = i == 1000 || i == 1010 || i == 4000 ? 500 : 10;
  }
  record->add(samples);
  return record;
}

Trigger errorTrigger() {
  Trigger trigger;
  trigger.signal = Signal::kDcmError;
  trigger.level = 400;
  trigger.hold_off = 100 * kMillisecond;
  trigger.pre = 50 * kMillisecond;
  trigger.post = 150 * kMillisecond;
  return trigger;
}

TEST(TriggerMonitor, ListsTheEpisodesOfARecording) {
  WindowMemory memory({});
  TriggerMonitor monitor(memory);
  TriggerPanel panel(monitor);
  const auto record = triggerRecord(5000);
  monitor.setRecord(record.get(), true);
  monitor.setTrigger(errorTrigger());
  monitor.arm();
  auto* table = panel.findChild<QTableWidget*>(QStringLiteral("triggerEpisodes"));
  ASSERT_EQ(table->rowCount(), 2);
  EXPECT_EQ(table->item(0, 1)->text(), QStringLiteral("1000"));
  EXPECT_TRUE(table->item(0, 2)->text().contains(QStringLiteral("1 more"))) << table->item(0, 2)->text().toStdString();
  EXPECT_EQ(table->item(1, 1)->text(), QStringLiteral("4000"));
  table->item(1, 4)->setText(QStringLiteral("door opened"));
  EXPECT_EQ(monitor.name(monitor.episodes()[1]), QStringLiteral("door opened"));
  EXPECT_FALSE(panel.findChild<QToolButton*>(QStringLiteral("triggerCsv"))->isEnabled()) << "none is chosen";
  table->selectRow(1);
  EXPECT_TRUE(panel.findChild<QToolButton*>(QStringLiteral("triggerCsv"))->isEnabled());
  EXPECT_FALSE(panel.findChild<QToolButton*>(QStringLiteral("triggerSave"))->isEnabled());
  std::optional<TriggerEpisode> wanted;
  QObject::connect(&panel, &TriggerPanel::episodeWanted, &panel,
                   [&wanted](const TriggerEpisode& episode) { wanted = episode; });
  Q_EMIT table->activated(table->model()->index(1, 0));
  ASSERT_TRUE(wanted);
  EXPECT_EQ(wanted->time, kTriggerRun + 4 * kSecond);
}

/// Errors that cross the level in every second cycle.
std::unique_ptr<RunRecord> restlessRecord(std::uint64_t cycles) {
  auto record = triggerRecord(0);
  std::vector<CycleSample> samples(cycles);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].cycle = i;
    samples[i].send_time = kTriggerRun + static_cast<Nanoseconds>(i) * kMillisecond;
    samples[i].flags = CycleSample::kDcmActive | CycleSample::kReferenceValid;
    samples[i].dcm_error_ns = i % 2 == 0 ? 10 : 500;
  }
  record->add(samples);
  return record;
}

/// What was found is the run's: it is there again when the run is shown again, with its names.
TEST(TriggerMonitor, WhatWasFoundStaysWithTheRun) {
  WindowMemory memory({});
  TriggerMonitor monitor(memory);
  auto record = triggerRecord(1);
  QObject::connect(&monitor, &TriggerMonitor::found, &monitor,
                   [&record](const KeptTrigger& kept) { record->keep(kept); });
  monitor.setTrigger(errorTrigger());
  monitor.setRecord(record.get(), false);
  monitor.arm();
  const auto whole = triggerRecord(5000);
  std::vector<CycleSample> samples(4999);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].cycle = i + 1;
    samples[i].send_time = kTriggerRun + static_cast<Nanoseconds>(i + 1) * kMillisecond;
    samples[i].flags = CycleSample::kDcmActive | CycleSample::kReferenceValid;
    samples[i].dcm_error_ns = i + 1 == 1000 || i + 1 == 4000 ? 500 : 10;
  }
  record->add(samples);
  monitor.look();
  ASSERT_EQ(monitor.episodes().size(), 2U);
  monitor.setName(monitor.episodes()[1], QStringLiteral("door opened"));
  monitor.disarm();
  monitor.setRecord(whole.get(), false);
  EXPECT_TRUE(monitor.episodes().empty()) << "another run";
  monitor.setRecord(record.get(), false);
  ASSERT_EQ(monitor.episodes().size(), 2U);
  EXPECT_EQ(monitor.name(monitor.episodes()[1]), QStringLiteral("door opened"));
  auto other = errorTrigger();
  other.level = 450;
  monitor.setTrigger(other);
  EXPECT_TRUE(monitor.episodes().empty()) << "found with another one";
}

/// Armed again, or in another mode, it goes on: what it found stays listed, with its names.
TEST(TriggerMonitor, WhatWasFoundStaysListedWhenItIsArmedAgain) {
  WindowMemory memory({});
  TriggerMonitor monitor(memory);
  const auto record = triggerRecord(1);
  QObject::connect(&monitor, &TriggerMonitor::found, &monitor,
                   [&record](const KeptTrigger& kept) { record->keep(kept); });
  monitor.setTrigger(errorTrigger());
  monitor.setRecord(record.get(), false);
  monitor.arm();
  std::uint64_t cycle = 1;
  const auto goOn = [&](std::uint64_t fires_at) {
    std::vector<CycleSample> samples(2000);
    for (auto& sample : samples) {
      sample.cycle = cycle;
      sample.send_time = kTriggerRun + static_cast<Nanoseconds>(cycle) * kMillisecond;
      sample.flags = CycleSample::kDcmActive | CycleSample::kReferenceValid;
      sample.dcm_error_ns = cycle == fires_at ? 500 : 10;
      ++cycle;
    }
    record->add(samples);
    monitor.look();
  };
  goOn(1000);
  ASSERT_EQ(monitor.episodes().size(), 1U);
  monitor.setName(monitor.episodes()[0], QStringLiteral("door opened"));
  monitor.arm();
  ASSERT_EQ(monitor.episodes().size(), 1U);
  EXPECT_EQ(monitor.name(monitor.episodes()[0]), QStringLiteral("door opened"));
  auto single = errorTrigger();
  single.mode = Trigger::Mode::kSingle;
  monitor.setTrigger(single);
  goOn(3000);
  ASSERT_EQ(monitor.episodes().size(), 2U);
  EXPECT_EQ(monitor.episodes()[1].cycle, 3000U);
  EXPECT_EQ(monitor.name(monitor.episodes()[0]), QStringLiteral("door opened"));
  monitor.setName(monitor.episodes()[1], QStringLiteral("again"));
  ASSERT_EQ(record->triggers().size(), 1U);
  EXPECT_EQ(record->triggers()[0].episodes.size(), 2U);
  EXPECT_EQ(record->triggers()[0].names.size(), 2U);
  // Another one, and back.
  auto other = errorTrigger();
  other.level = 450;
  monitor.setTrigger(other);
  EXPECT_TRUE(monitor.episodes().empty());
  monitor.disarm();
  monitor.setTrigger(errorTrigger());
  EXPECT_EQ(monitor.episodes().size(), 2U);
}

/// A recording brings the trigger that was set; the window's own comes back when it is closed.
TEST(TriggerMonitor, ARecordingShowsTheEpisodesThatItKeeps) {
  WindowMemory memory({});
  TriggerMonitor monitor(memory);
  TriggerPanel panel(monitor);
  auto own = errorTrigger();
  own.level = 123;
  monitor.setTrigger(own);
  const auto record = triggerRecord(5000);
  TriggerEpisode episode;
  episode.time = kTriggerRun + 4 * kSecond;
  episode.cycle = 4000;
  episode.value = 500;
  record->keep({errorTrigger(), {episode}, {{episode.time, "door opened"}}});
  monitor.setRecord(record.get(), true);
  auto* table = panel.findChild<QTableWidget*>(QStringLiteral("triggerEpisodes"));
  ASSERT_EQ(table->rowCount(), 1);
  EXPECT_EQ(table->item(0, 1)->text(), QStringLiteral("4000"));
  EXPECT_EQ(table->item(0, 4)->text(), QStringLiteral("door opened"));
  EXPECT_EQ(panel.findChild<QDoubleSpinBox*>(QStringLiteral("triggerLevel"))->value(), 400);
  monitor.arm();
  ASSERT_EQ(table->rowCount(), 2) << "all cycles are looked at";
  EXPECT_EQ(table->item(1, 4)->text(), QStringLiteral("door opened")) << "it is the same moment";
  monitor.disarm();
  monitor.setRecord(nullptr, false);
  EXPECT_EQ(monitor.trigger(), own);
}

TEST(TriggerPanel, WhatIsChosenStaysWhileEpisodesCome) {
  WindowMemory memory({});
  TriggerMonitor monitor(memory);
  TriggerPanel panel(monitor);
  auto record = restlessRecord(400);
  monitor.setRecord(record.get(), true);
  auto trigger = errorTrigger();
  trigger.hold_off = 0;
  monitor.setTrigger(trigger);
  monitor.arm();
  auto* table = panel.findChild<QTableWidget*>(QStringLiteral("triggerEpisodes"));
  ASSERT_EQ(table->rowCount(), 200);
  table->selectRow(180);
  const auto cycle = table->item(180, 1)->text();
  QSignalSpy refilled(panel.findChild<QComboBox*>(QStringLiteral("triggerSlave"))->model(),
                      &QAbstractItemModel::rowsRemoved);
  std::vector<CycleSample> more(200);
  for (std::size_t i = 0; i < more.size(); ++i) {
    more[i].cycle = 400 + i;
    more[i].send_time = kTriggerRun + static_cast<Nanoseconds>(400 + i) * kMillisecond;
    more[i].flags = CycleSample::kDcmActive | CycleSample::kReferenceValid;
    more[i].dcm_error_ns = i % 2 == 0 ? 10 : 500;
  }
  record->add(more);
  monitor.look();
  EXPECT_EQ(monitor.episodes().size(), 172U) << "half of 256 went";
  EXPECT_EQ(refilled.count(), 0) << "a list that is open would be emptied under the pointer";
  ASSERT_GE(table->currentRow(), 0);
  EXPECT_EQ(table->item(table->currentRow(), 1)->text(), cycle);
}

TEST(TriggerMonitor, IsRememberedAsItWasSet) {
  QTemporaryDir folder;
  const auto file = folder.filePath(QStringLiteral("window.ini"));
  auto trigger = errorTrigger();
  trigger.kind = Trigger::Kind::kWindow;
  trigger.low = -20;
  trigger.code = "event-slave-lost";
  {
    WindowMemory memory(file);
    TriggerMonitor(memory).setTrigger(trigger);
  }
  WindowMemory memory(file);
  const TriggerMonitor monitor(memory);
  EXPECT_EQ(monitor.trigger(), trigger);
  EXPECT_FALSE(monitor.isArmed());
}

TEST(TriggerPanel, TakesWhatItsFieldsSay) {
  WindowMemory memory({});
  TriggerMonitor monitor(memory);
  TriggerPanel panel(monitor);
  auto* source = panel.findChild<QComboBox*>(QStringLiteral("triggerSource"));
  const auto before = monitor.trigger();
  source->setCurrentIndex(source->findData(static_cast<int>(Signal::kRoundTrip)));
  Q_EMIT source->activated(source->currentIndex());
  panel.findChild<QDoubleSpinBox*>(QStringLiteral("triggerLevel"))->setValue(12'345);
  panel.findChild<QDoubleSpinBox*>(QStringLiteral("triggerPre"))->setValue(2.5);
  EXPECT_EQ(monitor.trigger().signal, Signal::kRoundTrip);
  EXPECT_EQ(monitor.trigger().level, 12'345);
  EXPECT_EQ(monitor.trigger().pre, 2'500'000);
  EXPECT_EQ(monitor.trigger().post, before.post);
  source->setCurrentIndex(source->findText(QStringLiteral("An event")));
  Q_EMIT source->activated(source->currentIndex());
  EXPECT_EQ(monitor.trigger().kind, Trigger::Kind::kEvent);
  EXPECT_FALSE(panel.findChild<QDoubleSpinBox*>(QStringLiteral("triggerLevel"))->isVisibleTo(&panel));
}

/// What is taken is what is shown: the list of events becomes one of findings, and back.
TEST(TriggerPanel, ListsEventsOrFindings) {
  WindowMemory memory({});
  TriggerMonitor monitor(memory);
  TriggerPanel panel(monitor);
  auto* source = panel.findChild<QComboBox*>(QStringLiteral("triggerSource"));
  auto* code = panel.findChild<QComboBox*>(QStringLiteral("triggerEvent"));
  const auto choose = [&](const QString& text) {
    source->setCurrentIndex(source->findText(text));
    Q_EMIT source->activated(source->currentIndex());
  };
  choose(QStringLiteral("A finding"));
  EXPECT_EQ(monitor.trigger().kind, Trigger::Kind::kFinding);
  EXPECT_GE(code->findData(QStringLiteral("frames-lost")), 0);
  EXPECT_EQ(code->currentData().toString().toStdString(), monitor.trigger().code);
  code->setCurrentIndex(code->findData(QStringLiteral("frames-lost")));
  Q_EMIT code->activated(code->currentIndex());
  EXPECT_EQ(monitor.trigger().code, "frames-lost");
  choose(QStringLiteral("An event"));
  EXPECT_EQ(monitor.trigger().kind, Trigger::Kind::kEvent);
  EXPECT_EQ(code->findData(QStringLiteral("frames-lost")), -1);
  EXPECT_EQ(code->currentData().toString().toStdString(), monitor.trigger().code);
}

TEST(LiveStripTrigger, TheLevelIsDrawnWhereItsSignalIsAndCanBeDragged) {
  const auto record = triggerRecord(5000);
  LiveStrip strip;
  strip.resize(1280, 230);
  strip.setRecord(record.get());
  strip.show();
  strip.setTriggerLevel({Signal::kDcmError, 0, 12.0});
  strip.refresh();
  EXPECT_FALSE(strip.panels()[0]->plot()->triggerLevel());
  auto* plot = strip.panels()[2]->plot();
  ASSERT_EQ(plot->triggerLevel(), 12.0);
  std::optional<double> dragged;
  QObject::connect(&strip, &LiveStrip::triggerLevelDragged, &strip, [&dragged](double level) { dragged = level; });
  const QPoint place(40, static_cast<int>(plot->transform(QwtPlot::yLeft, 12.0)));
  QTest::mousePress(plot->canvas(), Qt::LeftButton, {}, place);
  QTest::mouseMove(plot->canvas(), place - QPoint(0, 20));
  QTest::mouseRelease(plot->canvas(), Qt::LeftButton, {}, place - QPoint(0, 20));
  ASSERT_TRUE(dragged);
  EXPECT_NEAR(*dragged, plot->invTransform(QwtPlot::yLeft, place.y() - 20), 1);
  strip.setTriggerLevel({});
  EXPECT_FALSE(plot->triggerLevel());
}

TEST(LiveStripTrigger, AnEpisodeIsShownInThePlotsWhateverStoodInTheirPlace) {
  const auto record = triggerRecord(5000);
  LiveStrip strip;
  strip.resize(1280, 230);
  strip.setRecord(record.get());
  strip.show();
  for (const auto body : {LiveStrip::Body::kDistribution, LiveStrip::Body::kStability}) {
    strip.showBody(body);
    EXPECT_FALSE(strip.panels()[0]->isVisible());
    strip.showRange(kTriggerRun + kSecond, kTriggerRun + 2 * kSecond, kTriggerRun + kSecond, false);
    EXPECT_TRUE(strip.panels()[0]->isVisible());
    strip.showBody(body);
    strip.goTo(kTriggerRun + kSecond);
    EXPECT_TRUE(strip.panels()[0]->isVisible());
  }
}

class TriggerInWindow : public test::RunningWindow {};

TEST_F(TriggerInWindow, ASingleOneStopsThePlotsAtItsEpisode) {
  goOnline();
  auto& monitor = workspace_.trigger();
  Trigger trigger;
  trigger.edge = Trigger::Edge::kEither;
  trigger.level = 0;
  trigger.mode = Trigger::Mode::kSingle;
  trigger.signal = Signal::kDcmError;
  trigger.pre = trigger.post = 100 * kMillisecond;
  monitor.setTrigger(trigger);
  field<QPushButton>("triggerArm").click();
  ASSERT_TRUE(monitor.isArmed());
  for (int i = 0; i < 100 && window_.liveStrip().timeView()->mode() != TimeView::Mode::kFrozen; ++i) {
    run(200 * kMillisecond);
    monitor.look();
  }
  ASSERT_EQ(monitor.episodes().size(), 1U);
  const auto& episode = monitor.episodes().front();
  auto* view = window_.liveStrip().timeView();
  EXPECT_EQ(view->mode(), TimeView::Mode::kFrozen);
  EXPECT_EQ(view->span(), 200 * kMillisecond);
  EXPECT_LE(view->begin(), episode.time);
  EXPECT_GE(view->end(), episode.time);
  EXPECT_EQ(window_.liveStrip().cursors()->at(CursorSet::kA), episode.time);
  QTemporaryDir folder;
  const auto path = folder.filePath(QStringLiteral("episode.slrec"));
  bool saved = false;
  QObject::connect(&workspace_.disk(), &DiskRecording::saved, &window_,
                   [&](const QString&, const std::optional<Error>& error) { saved = !error; });
  ASSERT_TRUE(workspace_.disk().saveRange(episode.from, episode.to, path));
  ASSERT_TRUE(test::waitFor([&] { return saved; }));
  OpenedRecording opened;
  opened.read(path);
  ASSERT_TRUE(test::waitFor([&] { return !opened.isReading(); }));
  opened.show();
  ASSERT_TRUE(opened.isOpen());
  const auto& samples = opened.run().record->samples();
  EXPECT_GE(samples.first_time(), episode.from);
  EXPECT_LE(samples.last_time(), episode.to);
  // The recording begins before the trigger was armed: what was crossed until then it has, too.
  auto every = trigger;
  every.mode = Trigger::Mode::kNormal;
  every.hold_off = 0;
  TriggerWatch again(every);
  again.look(samples);
  const auto same = std::ranges::find(again.episodes(), episode.time, &TriggerEpisode::time);
  ASSERT_NE(same, again.episodes().end()) << "the recording has the same";
  EXPECT_EQ(same->cycle, episode.cycle);
}

}  // namespace
}  // namespace syncline::ui
