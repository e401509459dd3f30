// SPDX-License-Identifier: Apache-2.0
// A recording that was cut off, or whose pages SQLite refuses: what is whole is read, the rest is told and a gap.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>

#include "findings/error_text.h"
#include "record/recorder.h"
#include "record/recording_reader.h"
#include "record/replay_run.h"
#include "record/typed_values.h"
#include "support/whole_file.h"
#include "tests/core/record/made_samples.h"
#include "tests/support/temporary_folder.h"
#include "trace/csv.h"

namespace syncline {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

class RecordingSalvage : public testing::Test {
 protected:
  using Cycles = std::map<std::uint64_t, std::string>;  // the line of each in the exported table

  [[nodiscard]] std::string path(const std::string& name = "run.slrec") const { return folder_.file(name); }

  static RecordingAbout about() {
    RecordingAbout about;
    about.program = "test 1";
    about.documents = {{"configuration", "c.xml", std::string(30'000, 'c')}};
    about.slaves = {{"Coupler", 2, 3, 1}, {"Input", 2, 3, 4}, {"Servo", 5, 5, 6}};
    about.limits = {kMillisecond, 511, 4000};
    return about;
  }

  /// So many blocks of a second with what a recording may hold; the document is longer than a page.
  void make(int seconds = 12) {
    auto recorder = Recorder::start(path(), about(), {.by_clock = false}, {});
    ASSERT_TRUE(recorder);
    test::MadeSamples made(1);
    for (int i = 0; i < 10 * seconds; ++i) {
      const auto samples = made.next(100);
      (*recorder)->add(samples);
      (*recorder)->add(
          RecordedEvent{samples.back().send_time, 1, "slave-lost", "event", encode_event(events::SlaveLost{})});
    }
    ASSERT_TRUE((*recorder)->finish("end"));
    whole_ = *read_whole_file(path());
    cycles_ = cycles_of(path());
    ASSERT_EQ(cycles_.size(), static_cast<std::size_t>(seconds) * 1000);
  }

  /// Of all that can be read; nothing where it is refused.
  static Cycles cycles_of(const std::string& file) {
    Cycles cycles;
    auto reader = RecordingReader::open(file);
    if (!reader || !reader->info()) return cycles;
    EXPECT_TRUE(reader->samples([&cycles](std::span<const CycleSample> samples) {
      for (const auto& sample : samples) append_sample_csv(cycles[sample.cycle], std::span(&sample, 1));
      return true;
    }));
    return cycles;
  }

  /// What is told of the first so many bytes was recorded so, and that there are no more is said. Cycles that are
  /// there.
  std::size_t look_at_cut(std::size_t size) {
    EXPECT_TRUE(write_whole_file(path("cut"), whole_.substr(0, size)));
    auto reader = RecordingReader::open(path("cut"));
    if (!reader) {
      EXPECT_EQ(reader.error().file, path("cut")) << size;
      return 0;
    }
    const auto info = reader->info();
    if (!info) {
      EXPECT_THAT(describe(info.error()), AllOf(HasSubstr(path("cut")), HasSubstr("no whole cycle"))) << size;
      EXPECT_TRUE(cycles_of(path("cut")).empty()) << size;
      return 0;
    }
    EXPECT_FALSE(RecordingReader::open(path("cut"))->verify()) << size;
    const auto cycles = cycles_of(path("cut"));
    for (const auto& [cycle, line] : cycles) {
      const auto was = cycles_.find(cycle);
      EXPECT_TRUE(was != cycles_.end() && was->second == line) << size << ", cycle " << cycle;
    }
    EXPECT_FALSE(cycles.empty()) << size;
    return cycles.size();
  }

  test::TemporaryFolder folder_;
  std::string whole_;
  Cycles cycles_;
};

TEST_F(RecordingSalvage, HalfAFileGivesItsHalf) {
  make();
  ASSERT_TRUE(write_whole_file(path("cut"), whole_.substr(0, whole_.size() / 2)));
  auto reader = RecordingReader::open(path("cut"));
  ASSERT_TRUE(reader) << reader.error().detail.text();
  const auto info = reader->info();
  ASSERT_TRUE(info) << info.error().detail.text();
  EXPECT_EQ(info->about.slaves.size(), 3U);
  EXPECT_EQ(info->about.documents.size(), 1U);
  EXPECT_FALSE(info->events.empty());
  EXPECT_GE(info->blocks, 4U);
  EXPECT_LT(info->blocks, 12U);
  ASSERT_FALSE(reader->damage().empty());
  EXPECT_EQ(reader->damage()[0].code, "recording-cut-off");
  EXPECT_THAT(describe(reader->damage()[0]), AllOf(HasSubstr(std::to_string(whole_.size() / 2 / 1024)),
                                                   HasSubstr(std::to_string(whole_.size() / 1024) + " KiB"),
                                                   HasSubstr("blocks of values, about a second each, are lost")));
  EXPECT_EQ(info->findings.front().code, "recording-cut-off");
  NetworkConfig config;
  config.slaves.resize(3);
  const auto run = replay_run(*reader, config);
  ASSERT_TRUE(run) << run.error().detail.text();
  EXPECT_EQ(run->record->findings().front().code, "recording-cut-off");
  const auto cycles = cycles_of(path("cut"));
  EXPECT_GE(cycles.size(), 3500U);
  EXPECT_LT(cycles.size(), 8000U);
  const auto verified = RecordingReader::open(path("cut"))->verify();
  ASSERT_FALSE(verified);
  EXPECT_THAT(describe(verified.error()), AllOf(HasSubstr("The file is cut off: "), EndsWith("lost.")));
  EXPECT_THAT(describe(verified.error()), Not(HasSubstr("..")));
}

/// What is left may be one cycle, and then it is shown; where none is, nothing is opened, and it is said.
TEST_F(RecordingSalvage, OneCycleIsEnoughAndNoneIsRefused) {
  auto recorder = Recorder::start(path(), about(), {.by_clock = false}, {});
  ASSERT_TRUE(recorder);
  test::MadeSamples made(1);
  (*recorder)->add(made.next(1));
  ASSERT_TRUE((*recorder)->finish("end"));
  whole_ = *read_whole_file(path());
  cycles_ = cycles_of(path());
  ASSERT_EQ(cycles_.size(), 1U);
  std::map<std::size_t, int> found;
  int refused = 0;
  for (std::size_t size = 4096; size < whole_.size(); size += 4096) {
    const auto there = look_at_cut(size);
    ++found[there];
    if (there > 0) continue;
    const auto reader = RecordingReader::open(path("cut"));
    if (reader) continue;
    EXPECT_THAT(describe(reader.error()), AllOf(HasSubstr("damaged or cut off"), Not(HasSubstr("..")))) << size;
    refused += describe(reader.error()).find("no whole cycle of it is left") != std::string::npos ? 1 : 0;
  }
  EXPECT_GE(found[1], 1) << "cut behind what the cycle needs";
  EXPECT_GE(refused, 1) << "cut before it";
  EXPECT_EQ(found.size(), 2U);
}

/// Nothing was cut off, but of each block a row is not as it was written.
TEST_F(RecordingSalvage, ARunOfWhichNothingIsLeftIsRefused) {
  make(3);
  auto database = SqlDatabase::open(path());
  ASSERT_TRUE(database->execute("UPDATE data SET crc = crc + 1 WHERE codec > 0 AND id >= 1048576"));
  NetworkConfig config;
  config.slaves.resize(3);
  auto reader = RecordingReader::open(path());
  ASSERT_TRUE(reader);
  const auto one = replay_run(*reader, config);
  ASSERT_TRUE(one) << describe(one.error());
  EXPECT_FALSE(one->record->samples().empty());
  ASSERT_TRUE(database->execute("UPDATE data SET crc = crc + 1 WHERE codec > 0 AND id < 1048576"));
  const auto none = replay_run(*reader, config);
  ASSERT_FALSE(none);
  EXPECT_THAT(describe(none.error()), AllOf(HasSubstr(path()), HasSubstr("no whole cycle of it is left")));
}

/// At each 4096 bytes and at random places: never another value, never more of a shorter file, and most of a long one.
TEST_F(RecordingSalvage, WhereverItIsCut) {
  make(6);
  std::size_t before = 0;
  for (std::size_t size = 0; size < whole_.size(); size += 4096) {
    const auto there = look_at_cut(size);
    EXPECT_GE(there, before) << size;
    before = there;
  }
  EXPECT_GE(before, 4500U);
  std::mt19937 random(7);
  for (int i = 0; i < 40; ++i) look_at_cut(std::uniform_int_distribution<std::size_t>(0, whole_.size() - 1)(random));
}

/// A longer file's tree has inner pages at its end, and what they lead to is found all the same.
TEST_F(RecordingSalvage, WithoutThePagesThatLeadToTheRows) {
  make(150);
  // Rows of blocks lie on a page that was moved to what was the end after 80 of them.
  EXPECT_GT(look_at_cut(whole_.size() / 5), 150'000U * 3 / 20);
  EXPECT_GT(look_at_cut(whole_.size() * 2 / 5), 150'000U * 3 / 10);
}

/// A page in the middle that is the root of a table, or an inner one: SQLite stops there.
TEST_F(RecordingSalvage, OfADamagedRoot) {
  make();
  auto database = SqlDatabase::open(path());
  const auto root = database->number("SELECT rootpage FROM sqlite_schema WHERE name = 'block'");
  ASSERT_TRUE(root && *root > 1);
  auto harmed = whole_;
  // The number of its cells: 12 at first.
  harmed[static_cast<std::size_t>(*root - 1) * 8192 + 3] = '\x7F';
  ASSERT_TRUE(write_whole_file(path("cut"), harmed));
  auto reader = RecordingReader::open(path("cut"));
  ASSERT_TRUE(reader);
  const auto info = reader->info();
  ASSERT_TRUE(info) << info.error().detail.text();
  EXPECT_EQ(reader->damage()[0].code, "recording-cut-off");
  EXPECT_THAT(describe(reader->damage()[0]), HasSubstr("page by page"));
  EXPECT_EQ(cycles_of(path("cut")), cycles_);
}

/// What was killed lies in the log: of a file that was cut besides, both are read.
TEST_F(RecordingSalvage, WithItsLog) {
  RecordingAbout about;
  about.slaves = {{"Coupler", 2, 3, 1}};
  about.limits = {kMillisecond, 511, 4000};
  auto recorder = Recorder::start(path(), about, {.by_clock = false}, {});
  ASSERT_TRUE(recorder);
  test::MadeSamples made(1);
  for (int i = 0; i < 60; ++i) (*recorder)->add(made.next(100));
  ASSERT_TRUE((*recorder)->finish("end"));
  whole_ = *read_whole_file(path());
  auto database = SqlDatabase::open(path());
  ASSERT_TRUE(database->execute(
      "PRAGMA journal_mode=WAL; PRAGMA wal_autocheckpoint=0; UPDATE document SET name = name; DELETE FROM note;"
      "INSERT INTO note VALUES(1, 5, 'of the log', 0)"));
  ASSERT_TRUE(database->execute("UPDATE note SET crc = row_crc('note', id, time_ns, text)"));
  ASSERT_TRUE(write_whole_file(path("cut"), whole_.substr(0, whole_.size() * 2 / 3)));
  const auto log = read_whole_file(path() + "-wal");
  ASSERT_TRUE(log);
  ASSERT_TRUE(write_whole_file(path("cut-wal"), *log));
  auto salvaged = salvage_recording(path("cut"));
  ASSERT_TRUE(salvaged);
  EXPECT_EQ(salvaged->database.number("SELECT count(*) FROM note WHERE text = 'of the log'").value_or(0), 1);
  EXPECT_GE(salvaged->database.number("SELECT count(*) FROM block").value_or(0), 3);
}

TEST_F(RecordingSalvage, OfNoRecordingIsRefused) {
  ASSERT_TRUE(write_whole_file(path("cut"), std::string("SQLite format 3\0", 16) + std::string(5000, '\0')));
  const auto reader = RecordingReader::open(path("cut"));
  ASSERT_FALSE(reader);
  EXPECT_EQ(reader.error().file, path("cut"));
}

}  // namespace
}  // namespace syncline
