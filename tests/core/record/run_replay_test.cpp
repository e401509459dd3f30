// SPDX-License-Identifier: Apache-2.0
// A recorded run at its moments: what somebody saw who stopped the running machine there.
#include "record/run_replay.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include "config/sync_grid.h"
#include "record/recorder.h"
#include "record/replay_run.h"
#include "record/typed_values.h"
#include "tests/core/record/made_samples.h"
#include "tests/support/same_overview.h"
#include "tests/support/temporary_folder.h"

namespace syncline {
namespace {

constexpr int kBatches = 300, kBatch = 100;

NetworkConfig replayed_machine() {
  CyclicCmd command;
  command.command = Command::kLrw;
  command.data_length = 64;
  NetworkConfig config;
  config.cyclic.resize(1);
  config.cyclic[0].cycle_time = kMillisecond;
  config.cyclic[0].frames.resize(1);
  config.cyclic[0].frames[0].commands = {command};
  config.slaves.resize(3);
  config.slaves[2].dc = SlaveDcConfig{true, false, kMillisecond, 0, 40 * kMicrosecond, 0x0300};
  config.slaves[2].send = ImageRange{0, 64};
  return config;
}

/// What is drained at once.
struct Drained {
  std::vector<CycleSample> samples;
  Snapshot snapshot;
  std::optional<Event> event;
};

/// A run of half a minute that meets everything: slaves come and go, frames and cycles are lost, events of all kinds.
std::vector<Drained> replayed_run() {
  test::MadeSamples made(11);
  std::vector<Drained> run;
  for (int i = 0; i < kBatches; ++i) {
    auto& now = run.emplace_back(Drained{made.next(kBatch), {}, {}});
    now.snapshot.time = now.samples.back().send_time;
    now.snapshot.online = true;
    now.snapshot.lost_frames = static_cast<std::uint64_t>(i) / 18;
    now.snapshot.slaves.resize(3);
    for (auto& slave : now.snapshot.slaves) {
      slave.present = true;
      slave.al_status = 8;
    }
    now.snapshot.slaves[2].dc_enabled = true;
    now.snapshot.slaves[2].propagation_delay_ns = 1'300;
    now.snapshot.slaves[1].evidence.ports[0].lost_links = static_cast<std::uint32_t>(i) / 20;
    now.snapshot.slaves[1].evidence.ports_time = now.snapshot.time;
    now.snapshot.slaves[0].present = i % 40 < 30;
    now.snapshot.slaves[0].absent_since = now.snapshot.time - kMillisecond / 2;
    if (i % 7 == 3) {
      now.event = Event{now.samples[50].send_time, i % 3, events::SlaveLost{}};
      if (i % 2 == 0) now.event->what = events::SlaveFound{};
    }
  }
  return run;
}

void take(RunRecord& live, const Drained& drained) {
  live.add(drained.samples);
  if (drained.event) live.add(*drained.event);
  live.add(drained.snapshot);
}

std::vector<std::pair<Nanoseconds, std::uint32_t>> bits_of(const MinMaxSeries& series) {
  std::vector<std::pair<Nanoseconds, std::uint32_t>> all;
  series.for_each(INT64_MIN, INT64_MAX, [&all](Nanoseconds time, float value) {
    all.emplace_back(time, std::isnan(value) ? 0xFFFF'FFFFU : std::bit_cast<std::uint32_t>(value));
  });
  return all;
}

class RunReplayTest : public testing::Test {
 protected:
  RunReplayTest() {
    about_.program = "test 1";
    about_.slaves = {{"Coupler", 2, 0x44C2C52, 1}, {"Input", 2, 3, 4}, {"Servo", 0x539, 5, 6}};
    about_.limits = {kMillisecond, 511, 4000};
    about_.sync0 = sync0_slaves(config_);
  }
  /// The run as it stood after so many batches, armed by hand after `armed` of them.
  std::unique_ptr<RunRecord> stopped(int batches, int armed = -1) {
    auto live = std::make_unique<RunRecord>(config_, kBatches * kBatch, about_.limits, 0x1000);
    for (int i = 0; i < batches; ++i) {
      take(*live, run_[static_cast<std::size_t>(i)]);
      if (i == armed) live->arm();
    }
    return live;
  }
  void record(int armed = -1) {
    auto recorder = Recorder::start(path(), about_, {.by_clock = false}, {});
    ASSERT_TRUE(recorder);
    auto live = stopped(0);
    for (int i = 0; i < kBatches; ++i) {
      const auto& drained = run_[static_cast<std::size_t>(i)];
      (*recorder)->add(drained.samples);
      (*recorder)->add(drained.snapshot);
      if (const auto& event = drained.event)
        (*recorder)->add(RecordedEvent{event->time, event->slave, "kind", "words", encode_event(event->what)});
      take(*live, drained);
      if (i == armed) live->arm();
      (*recorder)->tell(live->standing());
    }
    ASSERT_TRUE((*recorder)->finish());
  }
  void open() {
    auto reader = RecordingReader::open(path());
    ASSERT_TRUE(reader);
    auto run = replay_run(*reader, config_);
    ASSERT_TRUE(run) << run.error().detail.text();
    replayed_.emplace(std::move(*run));
    auto replay = RunReplay::open(std::move(*reader), *replayed_);
    ASSERT_TRUE(replay);
    replay_.emplace(std::move(*replay));
  }
  [[nodiscard]] Nanoseconds end_of(int batches) const {
    return run_[static_cast<std::size_t>(batches) - 1].samples.back().send_time;
  }
  [[nodiscard]] const RunRecord& shown() const { return *replayed_->record; }
  [[nodiscard]] std::string path() const { return folder_.file("run.slrec"); }

  /// Verdicts, figures, faults, events and every sample.
  void expect_as_live(const RunRecord& live) {
    test::expect_same(shown().overview(), live.overview());
    ASSERT_EQ(shown().events().size(), live.events().size());
    for (std::size_t i = 0; i < live.events().size(); ++i) {
      EXPECT_EQ(shown().events()[i].time, live.events()[i].time);
      EXPECT_EQ(encode_event(shown().events()[i].what), encode_event(live.events()[i].what));
    }
    const auto &is = shown().samples(), &was = live.samples();
    EXPECT_EQ(is.last_time(), was.last_time());
    EXPECT_EQ(is.cycle_at(is.last_time()), was.cycle_at(was.last_time()));
    EXPECT_EQ(is.cycle_at(is.last_time() - 3 * kSecond), was.cycle_at(was.last_time() - 3 * kSecond));
    for (const auto& signal : signals()) {
      if (signal.form == SignalInfo::Form::kCell || signal.form == SignalInfo::Form::kWatched) continue;
      const bool of_slaves = signal.scope == SignalInfo::Scope::kSlave;
      for (std::size_t slave = 0; slave < (of_slaves ? 3U : 1U); ++slave) {
        const auto &mine = is.series(signal.id, slave), &his = was.series(signal.id, slave);
        EXPECT_TRUE(bits_of(mine) == bits_of(his))
            << signal.key << " of " << slave << ": " << mine.size() << " and " << his.size();
        const auto at = was.last_time();
        const auto mine_now = is.value(signal.id, slave, at), his_now = was.value(signal.id, slave, at);
        ASSERT_EQ(mine_now.has_value(), his_now.has_value()) << signal.key;
        if (mine_now) {
          EXPECT_EQ(mine_now->value, his_now->value) << signal.key;
        }
        const auto a = mine.extent(INT64_MIN + 1, INT64_MAX), b = his.extent(INT64_MIN + 1, INT64_MAX);
        ASSERT_EQ(a.has_value(), b.has_value()) << signal.key;
        if (a) {
          EXPECT_EQ(std::pair(a->min, a->max), std::pair(b->min, b->max)) << signal.key;
        }
      }
    }
  }

  NetworkConfig config_ = replayed_machine();
  RecordingAbout about_;
  test::TemporaryFolder folder_;
  std::vector<Drained> run_ = replayed_run();
  std::optional<ReplayedRun> replayed_;
  std::optional<RunReplay> replay_;
};

TEST_F(RunReplayTest, AMomentIsTheRunThatWasStoppedThere) {
  record();
  open();
  // Forward, far ahead, back by one, to the begin, to the end.
  for (const int batches : {40, 41, 42, 250, 249, 90, 1, 2, 300, 299, 133}) {
    SCOPED_TRACE(batches);
    ASSERT_TRUE(replay_->show(end_of(batches)));
    const auto live = stopped(batches);
    ASSERT_TRUE(batches < 3 || live->overview().armed);
    expect_as_live(*live);
  }
}

/// Between two cycles it is that of the earlier one; a cycle further one sample more.
TEST_F(RunReplayTest, ACycleFurtherIsACycleMore) {
  record();
  open();
  auto time = end_of(77);
  ASSERT_TRUE(replay_->show(time));
  for (int i = 0; i < 250; ++i) {
    const auto count = shown().samples().series(Signal::kDcmAdjust).count(0, INT64_MAX);
    const auto next = shown().samples().next_cycle_time(time);
    ASSERT_TRUE(next);
    ASSERT_TRUE(replay_->show(*next - 1));
    EXPECT_EQ(shown().overview().end, time);
    ASSERT_TRUE(replay_->show(*next));
    EXPECT_EQ(shown().overview().end, *next);
    EXPECT_EQ(shown().samples().cycle_time_at(*next - 1), time);
    // Where cycles are missing a gap stands between.
    EXPECT_GE(shown().samples().series(Signal::kDcmAdjust).count(0, INT64_MAX), count + 1);
    EXPECT_LE(shown().samples().series(Signal::kDcmAdjust).count(0, INT64_MAX), count + 2);
    time = *next;
  }
}

/// Of arming by hand the file knows the last one: before it the run stood armed by itself.
TEST_F(RunReplayTest, BeforeItWasArmedByHandItStoodArmedByItself) {
  record(180);
  open();
  EXPECT_EQ(shown().overview().armed, end_of(181) + 1);
  for (const int batches : {60, 181, 182, 180, 250, 5}) {
    SCOPED_TRACE(batches);
    ASSERT_TRUE(replay_->show(end_of(batches)));
    if (batches == 181) {
      // Armed is it with the next cycle.
      EXPECT_LT(*shown().overview().armed, end_of(1));
      continue;
    }
    expect_as_live(*stopped(batches, 180));
  }
}

TEST_F(RunReplayTest, LeftItIsWholeAgain) {
  record();
  open();
  const auto whole = stopped(kBatches);
  ASSERT_TRUE(replay_->show(end_of(17)));
  EXPECT_EQ(shown().shown_at(), end_of(17));
  replay_->leave();
  EXPECT_FALSE(shown().shown_at());
  expect_as_live(*whole);
  // The last moment is all of it, too.
  ASSERT_TRUE(replay_->show(INT64_MAX));
  EXPECT_EQ(shown().shown_at(), replay_->end());
  expect_as_live(*whole);
  ASSERT_TRUE(replay_->show(INT64_MIN));
  EXPECT_EQ(shown().samples().last_time(), replay_->begin());
}

/// Findings are judged of a whole run; of moments before its end none are known.
TEST_F(RunReplayTest, WhatWasFoundIsToldAtTheEnd) {
  record();
  open();
  replayed_->record->restore(std::vector<Finding>(2));
  ASSERT_TRUE(replay_->show(end_of(200)));
  EXPECT_TRUE(shown().findings().empty());
  ASSERT_TRUE(replay_->show(replay_->end()));
  EXPECT_EQ(shown().findings().size(), 2U);
}

TEST_F(RunReplayTest, ADamagedFileIsToldAndAllIsShown) {
  record();
  open();
  ASSERT_TRUE(replay_->show(end_of(20)));
  ASSERT_TRUE(SqlDatabase::open(path())->execute("DELETE FROM data WHERE id < 20 * 1048576"));
  const auto status = replay_->show(end_of(30));
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kFileNotReadable);
  EXPECT_FALSE(shown().shown_at());
}

}  // namespace
}  // namespace syncline
