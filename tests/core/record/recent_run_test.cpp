// SPDX-License-Identifier: Apache-2.0
#include "record/recent_run.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "record/replay_run.h"
#include "support/whole_file.h"
#include "tests/core/record/made_samples.h"
#include "tests/support/temporary_folder.h"

namespace syncline {
namespace {

constexpr std::size_t kChunk = 4096 * offsetof(CycleSample, watched_known);

/// Values of variables take room only while some are watched.
TEST(RecentSamples, ReachAsFarAsTheyDidWhereNothingIsWatched) {
  RecentSamples recent(8 * kChunk);
  test::MadeSamples made(1);
  const auto plain = recent.reach(kMillisecond);
  for (int i = 0; i < 20; ++i) recent.add(made.next(4096));
  EXPECT_EQ(recent.reach(kMillisecond), plain);
  EXPECT_EQ(plain, 8 * 4096 * kMillisecond);
  auto watched = made.next(4096);
  for (auto& sample : watched) {
    sample.watch_list = 1;
    sample.watched_known = 1;
    sample.watched[0] = sample.cycle;
  }
  for (int i = 0; i < 20; ++i) recent.add(watched);
  EXPECT_LT(recent.reach(kMillisecond), plain);
  EXPECT_GT(recent.reach(kMillisecond), plain / 3);
  const auto back = recent.since(0).back()->samples();
  ASSERT_EQ(back.size(), watched.size());
  EXPECT_EQ(back[77].watched[0], watched[77].cycle);
  EXPECT_EQ(back[77].dcm_error_ns, watched[77].dcm_error_ns);
}

TEST(RecentSamples, AnotherBudgetHoldsAtOnce) {
  RecentSamples recent(8 * kChunk);
  test::MadeSamples made(1);
  for (int i = 0; i < 8; ++i) recent.add(made.next(4096));
  const auto end = recent.begin() + recent.span();
  recent.set_budget(2 * kChunk);
  EXPECT_EQ(recent.since(0).size(), 2U);
  EXPECT_EQ(recent.begin() + recent.span(), end) << "the newest stay";
  EXPECT_EQ(recent.reach(kMillisecond), 2 * 4096 * kMillisecond);
  recent.set_budget(4 * kChunk);
  for (int i = 0; i < 8; ++i) recent.add(made.next(4096));
  EXPECT_EQ(recent.since(0).size(), 4U);
}

TEST(RecentSamples, KeepsWhatTheBudgetHolds) {
  RecentSamples recent(3 * kChunk);
  test::MadeSamples made(1);
  EXPECT_EQ(recent.span(), 0);
  EXPECT_EQ(recent.reach(kMillisecond), 3 * 4096 * kMillisecond);
  Nanoseconds last = 0;
  for (int i = 0; i < 300; ++i) {
    const auto samples = made.next(100);
    last = samples.back().send_time;
    recent.add(samples);
  }
  EXPECT_EQ(recent.begin() + recent.span(), last) << "the newest is always there";
  EXPECT_GE(recent.span(), 3 * 4096 * kMillisecond);
  EXPECT_LE(recent.span(), 5 * 4096 * kMillisecond);
  const auto all = recent.since(0);
  Nanoseconds before = 0;
  for (const auto& chunk : all) {
    for (const auto& sample : chunk->samples()) {
      EXPECT_GT(sample.send_time, before);
      before = sample.send_time;
    }
  }
  EXPECT_EQ(before, last);
  EXPECT_EQ(recent.since(last).size(), 1U);
  recent.clear();
  EXPECT_TRUE(recent.empty());
}

class RecentRunFile : public testing::Test {
 protected:
  RecentRunFile() {
    config_.slaves.resize(3);
    record_ = std::make_unique<RunRecord>(config_);
  }
  void run(int batches) {
    for (int i = 0; i < batches; ++i) {
      const auto samples = made_.next(100);
      record_->add(samples);
      recent_.add(samples);
      Snapshot now;
      now.time = samples.back().send_time;
      now.online = true;
      now.lost_frames = static_cast<std::uint64_t>(i / 10);
      now.slaves.resize(3);
      for (auto& slave : now.slaves) {
        slave.present = true;
        slave.al_status = i < 20 ? 4 : 8;
      }
      record_->add(now);
    }
  }
  RecentRun taken(Nanoseconds from) {
    RecentRun run;
    run.about.slaves.resize(3);
    run.about.limits = record_->limits();
    run.from = from;
    run.samples = recent_.since(from);
    run.held = held_copy(*record_);
    return run;
  }

  NetworkConfig config_;
  std::unique_ptr<RunRecord> record_;
  RecentSamples recent_{100 * kChunk};
  test::MadeSamples made_{4};
  test::TemporaryFolder folder_;
};

/// The file has the stretch as if it had been recorded: the samples, and what counts and states were then.
TEST_F(RecentRunFile, HoldsTheLastStretchAsItWas) {
  run(200);
  const auto from = record_->samples().last_time() - 7 * kSecond;
  const auto path = folder_.file("last.slrec");
  const auto status = save_recent(path, taken(from));
  ASSERT_TRUE(status) << status.error().detail.text();
  auto reader = RecordingReader::open(path);
  ASSERT_TRUE(reader) << reader.error().detail.text();
  EXPECT_TRUE(reader->verify());
  const auto replayed = replay_run(*reader, config_);
  ASSERT_TRUE(replayed) << replayed.error().detail.text();
  const auto &was = record_->samples(), &is = replayed->record->samples();
  EXPECT_GE(is.first_time(), from);
  EXPECT_LE(is.first_time(), from + 30 * kMillisecond);
  EXPECT_EQ(is.last_time(), was.last_time());
  for (auto time = from + kSecond; time < was.last_time(); time += 77 * kMillisecond) {
    for (const auto signal : {Signal::kAlState, Signal::kSm2Missed, Signal::kSlaveDeviation}) {
      for (std::size_t slave = 0; slave < 3; ++slave) {
        const auto before = was.value(signal, slave, time), after = is.value(signal, slave, time);
        ASSERT_EQ(before.has_value(), after.has_value()) << info(signal).key << slave;
        if (before) {
          EXPECT_EQ(before->value, after->value) << info(signal).key << slave;
        }
      }
    }
    const auto lost = was.value(Signal::kLostFrames, time);
    ASSERT_EQ(is.value(Signal::kLostFrames, time).has_value(), lost.has_value());
    if (lost) {
      EXPECT_EQ(is.value(Signal::kLostFrames, time)->value, lost->value);
    }
  }
}

/// A slave that was lost long before has nothing in the stretch, however many blocks it is written in.
TEST_F(RecentRunFile, HoldsNothingOfBefore) {
  run(100);
  constexpr std::size_t kLost = 1;
  for (int i = 0; i < 300; ++i) {
    const auto samples = made_.next(100);
    record_->add(samples);
    recent_.add(samples);
    Snapshot now;
    now.time = samples.back().send_time;
    now.online = true;
    now.slaves.resize(3);
    for (auto& slave : now.slaves) slave.present = true;
    now.slaves[kLost].present = false;
    record_->add(now);
  }
  const auto from = record_->samples().last_time() - 15 * kSecond;
  const auto path = folder_.file("lost.slrec");
  ASSERT_TRUE(save_recent(path, taken(from)));
  auto reader = RecordingReader::open(path);
  ASSERT_TRUE(reader);
  ASSERT_GT(reader->info()->blocks, 2U);
  RecordingReader::AllPoints all;
  ASSERT_TRUE(reader->samples([](std::span<const CycleSample>) { return true; }, all));
  ASSERT_FALSE(record_->samples().series(Signal::kAlState, kLost).empty()) << "it has a past";
  EXPECT_FALSE(all.empty());
  for (const auto& [number, points] : all) {
    EXPECT_NE(number / 256 - 1, static_cast<std::int64_t>(kLost)) << "series " << number;
    // The first value may be older: it is what holds when the stretch begins.
    for (std::size_t i = 1; i < points.times.size(); ++i) EXPECT_GE(points.times[i], from) << "series " << number;
  }
}

TEST_F(RecentRunFile, ReplacesNothing) {
  run(10);
  const auto path = folder_.file("there");
  ASSERT_TRUE(write_whole_file(path, "something of somebody"));
  const auto status = save_recent(path, taken(0));
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kFileNotWritable);
  EXPECT_EQ(*read_whole_file(path), "something of somebody");
  EXPECT_FALSE(save_recent(folder_.file("no/such/folder/run.slrec"), taken(0)));
}

}  // namespace
}  // namespace syncline
