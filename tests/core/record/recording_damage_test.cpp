// SPDX-License-Identifier: Apache-2.0
// What is not as it was written is told and left out, and never shown as something else.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <random>
#include <set>

#include "record/first_columns.h"
#include "record/recorder.h"
#include "record/recording_reader.h"
#include "record/replay_run.h"
#include "record/typed_values.h"
#include "support/whole_file.h"
#include "tests/core/record/made_samples.h"
#include "tests/core/record/older_recording.h"
#include "tests/support/cases.h"
#include "tests/support/temporary_folder.h"
#include "trace/csv.h"

namespace syncline {
namespace {

using testing::HasSubstr;

/// All that is told out of a recording.
struct Content {
  std::string about;
  std::map<std::uint64_t, std::string> cycles;  // the line of each in the exported table
  std::string held, sums;
  std::vector<std::string> events;
  bool operator==(const Content&) const = default;
};

class RecordingDamage : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name = "run.slrec") const { return folder_.file(name); }

  /// Four blocks with all that a recording may hold.
  void make() {
    RecordingAbout about;
    about.program = "test 1";
    about.link = "sim:machine.toml";
    about.documents = {{"configuration", "c.xml", "<EtherCATConfig/>"}, {"project", "p.syncline", "<project/>"}};
    about.slaves = {{"Coupler", 2, 3, 1}, {"Input", 2, 3, 4}, {"Servo", 5, 5, 6}};
    about.limits = {kMillisecond, 511, 4000};
    auto recorder = Recorder::start(path(), about, {.by_clock = false}, {});
    ASSERT_TRUE(recorder);
    test::MadeSamples made(1);
    for (int i = 0; i < 40; ++i) {
      const auto samples = made.next(100);
      (*recorder)->add(samples);
      Snapshot snapshot;
      snapshot.time = samples.back().send_time;
      snapshot.online = true;
      snapshot.slaves.resize(3);
      for (auto& slave : snapshot.slaves) slave.present = true;
      snapshot.slaves[2].al_status = static_cast<std::uint16_t>(i % 3 + 1);
      snapshot.slaves[2].sm2_missed.known = true;
      snapshot.slaves[2].sm2_missed.missed = static_cast<std::uint32_t>(i);
      (*recorder)->add(snapshot);
      if (i % 8 == 0) {
        (*recorder)->add(RecordedEvent{snapshot.time, 1, "slave-lost", fmt::format("event {}", i),
                                       encode_event(events::SlaveLost{})});
      }
    }
    (*recorder)->add(RunNote{1'000'000, "a note"});
    ASSERT_TRUE(
        (*recorder)->finish("end", std::vector<RecordedFinding>{{"frames-lost-by-noise", "warning", -1, "noise"}}));
  }

  void harm(const char* sql) { ASSERT_TRUE(SqlDatabase::open(path())->execute(sql)) << sql; }

  struct Told {
    std::optional<Content> content;  // nothing: it was refused
    std::vector<Finding> damage;
  };
  [[nodiscard]] static Told read(const std::string& file) {
    auto reader = RecordingReader::open(file);
    if (!reader) return {};
    const auto info = reader->info();
    if (!info) return {};
    Content content;
    for (const auto& slave : info->about.slaves) content.about += slave.name + ' ';
    for (const auto& document : info->about.documents) content.about += document.kind + document.name + document.body;
    const auto& limits = info->about.limits;
    content.about += fmt::format("{} {} {} {} {} {} {}", info->about.program, info->about.link, limits.cycle_time,
                                 limits.deviation_ns, limits.dcm_error_ns, info->ended.value_or("-"), info->cycles);
    for (const auto& note : info->notes) content.about += note.text;
    for (const auto& event : info->events) content.events.push_back(event.text + event.details);
    for (const auto& finding : info->findings) {
      if (!finding.code.starts_with("recording-")) content.events.push_back(finding.code + finding.text);
    }
    RecordingReader::AllPoints held;
    const auto status = reader->samples(
        [&](std::span<const CycleSample> samples) {
          for (const auto& sample : samples) {
            std::string line;
            append_sample_csv(line, std::span(&sample, 1));
            content.cycles[sample.cycle] = std::move(line);
          }
          return true;
        },
        held);
    if (!status) return {};
    for (const auto& [series, points] : held) {
      content.held += fmt::format("{}:", series);
      for (std::size_t i = 0; i < points.times.size(); ++i)
        content.held += fmt::format(" {}={}", points.times[i], points.values[i]);
    }
    for (const auto& block : reader->overview(Signal::kDcmError).value_or(std::vector<BlockSummary>{}))
      content.sums += fmt::format("{} {} {} {} {};", block.begin, block.count, block.min, block.max, block.last);
    constexpr std::array kPictured{Signal::kDcmError, Signal::kRoundTrip};
    const auto width = std::max<Nanoseconds>((info->end - info->begin) / 50, 1);
    const auto columns = first_columns(*reader, kPictured, info->begin, info->end + 1, width);
    for (const auto& signal : columns.value_or(std::vector<std::vector<SeriesColumn>>{})) {
      for (const auto& column : signal)
        content.sums += column.valid ? fmt::format("{} {} {};", column.start, column.min, column.max) : "-;";
    }
    return {std::move(content), reader->damage()};
  }

  test::TemporaryFolder folder_;
};

/// Flips at random places of the whole file: each is seen, or nothing that is told has changed; and what is told beside
/// a damage was recorded so.
TEST_F(RecordingDamage, OfABitIsSeenOrWithoutEffect) {
  make();
  const auto whole = *read_whole_file(path());
  const auto before = read(path());
  ASSERT_TRUE(before.content);
  ASSERT_TRUE(before.damage.empty());
  ASSERT_EQ(before.content->cycles.size(), 4000U);
  std::mt19937 random(20);
  int refused = 0, told = 0, without = 0;
  const int bits = test::cases(600);
  for (int i = 0; i < bits; ++i) {
    const auto bit = std::uniform_int_distribution<std::size_t>(0, whole.size() * 8 - 1)(random);
    auto harmed = whole;
    harmed[bit / 8] = static_cast<char>(harmed[bit / 8] ^ (1 << bit % 8));
    ASSERT_TRUE(write_whole_file(path("harmed"), harmed));
    const auto after = read(path("harmed"));
    if (!after.content) {
      ++refused;
      continue;
    }
    if (after.damage.empty()) {
      ++without;
      if (after.content == before.content) continue;
      // A level of which nothing was drawn: the picture lacks what is behind it, and verify() finds it.
      EXPECT_FALSE(RecordingReader::open(path("harmed"))->verify()) << "bit " << bit;
      auto lacking = *after.content;
      lacking.sums = before.content->sums;
      EXPECT_TRUE(lacking == before.content) << "bit " << bit;
      continue;
    }
    ++told;
    for (const auto& [cycle, line] : after.content->cycles) {
      const auto was = before.content->cycles.find(cycle);
      ASSERT_TRUE(was != before.content->cycles.end() && was->second == line) << "bit " << bit << ", cycle " << cycle;
    }
    for (const auto& event : after.content->events) EXPECT_THAT(before.content->events, testing::Contains(event));
  }
  EXPECT_GT(told, bits / 3) << refused << " refused, " << without << " without effect";
  EXPECT_LT(refused, bits / 10);
}

TEST_F(RecordingDamage, OfACellIsAGapThatNamesItsRow) {
  make();
  const auto before = read(path());
  harm("UPDATE data SET cells = zeroblob(length(cells)) WHERE id = 1048576 + 3");  // of block 1
  auto reader = RecordingReader::open(path());
  ASSERT_TRUE(reader);
  NetworkConfig config;
  config.slaves.resize(3);
  const auto run = replay_run(*reader, config);
  ASSERT_TRUE(run) << run.error().detail.text();
  ASSERT_EQ(reader->damage().size(), 1U);
  const auto text = describe(reader->damage()[0]);
  EXPECT_THAT(text, testing::AllOf(HasSubstr("1048579"), HasSubstr("table data"), HasSubstr("are a gap")));
  EXPECT_EQ(run->info.findings.back().code, "recording-damaged");
  EXPECT_EQ(run->record->findings().back().code, "recording-damaged");
  const auto blocks = reader->blocks();
  ASSERT_TRUE(blocks);
  const auto after = read(path());
  ASSERT_TRUE(after.content);
  EXPECT_EQ(after.content->cycles.size(), 4000U - static_cast<std::size_t>((*blocks)[1].cycles));
  for (const auto& [cycle, line] : after.content->cycles) EXPECT_EQ(line, before.content->cycles.at(cycle));
  EXPECT_FALSE(after.content->cycles.contains(static_cast<std::uint64_t>((*blocks)[1].first_cycle)));
  const auto verified = RecordingReader::open(path())->verify();
  ASSERT_FALSE(verified);
  EXPECT_THAT(verified.error().detail.text(), HasSubstr("1048579"));
}

/// A count of a slave that is not there makes no gap of the cycles, as one that is damaged does not.
TEST_F(RecordingDamage, OfAMissingCountIsToldAndTheCyclesStay) {
  make();
  const auto before = read(path());
  harm("DELETE FROM data WHERE id = (SELECT min(id) FROM data WHERE id > 1048576 AND codec = 0)");
  const auto after = read(path());
  ASSERT_TRUE(before.content && after.content);
  EXPECT_EQ(after.content->cycles, before.content->cycles);
  EXPECT_NE(after.content->held, before.content->held);
  ASSERT_EQ(after.damage.size(), 1U);
  EXPECT_THAT(describe(after.damage[0]), HasSubstr("1 row of the table data is missing. "));
  EXPECT_FALSE(RecordingReader::open(path())->verify());
}

TEST_F(RecordingDamage, OfSmallRowsLeavesThemOut) {
  make();
  harm("UPDATE event SET text = 'else' WHERE id = 2; UPDATE slave SET name = 'X' WHERE position = 1");
  harm("UPDATE meta SET value = 'x' WHERE key = 'link'; DELETE FROM note");
  auto reader = RecordingReader::open(path());
  const auto info = reader->info();
  ASSERT_TRUE(info) << info.error().detail.text();
  EXPECT_EQ(info->events.size(), 4U);
  ASSERT_EQ(info->about.slaves.size(), 3U);
  EXPECT_EQ(info->about.slaves[1].name, "?");
  EXPECT_EQ(info->about.slaves[2].name, "Servo");
  EXPECT_EQ(info->about.link, "");
  ASSERT_EQ(reader->damage().size(), 4U);
  std::string all;
  for (const auto& finding : reader->damage()) all += describe(finding) + '\n';
  EXPECT_THAT(all, testing::AllOf(HasSubstr("Row 2 of the table event"), HasSubstr("Row 1 of the table slave"),
                                  HasSubstr("Row link of the table meta"), HasSubstr("1 row of the table note is")));
  EXPECT_FALSE(reader->verify());
}

TEST_F(RecordingDamage, OfBlocksThatAreNotThereIsTold) {
  for (const auto* sql : {"DELETE FROM block WHERE number = 1", "DELETE FROM block WHERE number = 3",
                          "UPDATE block SET end_ns = end_ns + 1 WHERE number = 1"}) {
    std::filesystem::remove(path());
    make();
    harm(sql);
    const auto after = read(path());
    ASSERT_TRUE(after.content) << sql;
    EXPECT_EQ(after.damage.size(), 1U) << sql;
    EXPECT_LT(after.content->cycles.size(), 4000U) << sql;
  }
}

/// The picture before the samples are read shows no block that is a gap when they are.
TEST_F(RecordingDamage, OfASumIsNothingInTheFirstPicture) {
  make();
  harm("UPDATE summary SET max = max + 1e9 WHERE id > 1048576 AND id < 2097152");
  auto reader = RecordingReader::open(path());
  const auto info = reader->info();
  constexpr std::array kErrors{Signal::kDcmError};
  const auto columns = first_columns(*reader, kErrors, info->begin, info->end, kSecond / 10);
  ASSERT_TRUE(columns);
  for (const auto& column : columns->front()) {
    EXPECT_TRUE(!column.valid || column.max < 1e8);
  }
  EXPECT_FALSE(reader->damage().empty());
}

/// As soon as the samples are read, which tell of it; its sums, which have checks of their own, are drawn until then.
TEST_F(RecordingDamage, OfACellIsAGapInTheFirstPictureOnceItIsRead) {
  make();
  harm("UPDATE data SET cells = zeroblob(length(cells)) WHERE id = 1048576 + 3");  // of block 1
  auto reader = RecordingReader::open(path());
  const auto info = reader->info();
  const auto blocks = reader->blocks();
  ASSERT_TRUE(info && blocks);
  std::set<std::size_t> gaps;
  ReplayOptions options;
  options.gap = [&gaps](std::size_t block) { gaps.insert(block); };
  NetworkConfig config;
  config.slaves.resize(info->about.slaves.size());
  ASSERT_TRUE(replay_run(*reader, config, options));
  EXPECT_EQ(gaps, std::set<std::size_t>{1});
  constexpr std::array kErrors{Signal::kDcmError};
  const auto columns = first_columns(*reader, kErrors, info->begin, info->end, kSecond / 10, gaps);
  ASSERT_TRUE(columns);
  int drawn = 0, within = 0;
  for (const auto& column : columns->front()) {
    drawn += column.valid ? 1 : 0;
    const bool inside = column.start > (*blocks)[1].begin && column.start + kSecond / 10 < (*blocks)[1].end;
    within += inside && column.valid ? 1 : 0;
  }
  EXPECT_GT(drawn, 20);
  EXPECT_EQ(within, 0);
}

TEST_F(RecordingDamage, OfAnOlderVersionMayNotBeSeenWhichIsSaid) {
  make();
  ASSERT_TRUE(test::make_older(path(), 4));
  auto reader = RecordingReader::open(path());
  ASSERT_TRUE(reader) << reader.error().detail.text();
  EXPECT_FALSE(reader->is_checked());
  const auto info = reader->info();
  ASSERT_TRUE(info);
  EXPECT_EQ(info->cycles, 4000U);
  EXPECT_EQ(info->findings.back().code, "recording-unchecked");
  EXPECT_THAT(info->findings.back().text, HasSubstr("version 4"));
  EXPECT_TRUE(reader->verify());
  EXPECT_EQ(read(path()).content->cycles.size(), 4000U);
}

TEST_F(RecordingDamage, OfTheVersionIsSeen) {
  make();
  harm("PRAGMA user_version = 4");
  const auto reader = RecordingReader::open(path());
  ASSERT_FALSE(reader);
  EXPECT_THAT(reader.error().detail.text(), HasSubstr("version 4"));
}

/// Of a run that was killed only the file was copied, without the log beside it.
TEST_F(RecordingDamage, OfALogThatIsMissingIsTold) {
  RecordingAbout about;
  about.program = "test 1";
  about.slaves = {{"Coupler", 2, 3, 1}};
  about.limits = {kMillisecond, 511, 4000};
  auto recorder = Recorder::start(path(), about, {.by_clock = false}, {});
  ASSERT_TRUE(recorder);
  std::filesystem::copy_file(path(), path("copied"));
  std::filesystem::copy_file(path() + "-wal", path("both-wal"));
  std::filesystem::copy_file(path(), path("both"));
  auto reader = RecordingReader::open(path("copied"));
  ASSERT_TRUE(reader) << reader.error().detail.text();
  const auto info = reader->info();
  ASSERT_TRUE(info) << info.error().detail.text();
  EXPECT_EQ(info->cycles, 0U);
  EXPECT_EQ(info->about.slaves.size(), 1U);
  ASSERT_EQ(info->findings.size(), 1U);
  EXPECT_EQ(info->findings[0].code, "recording-log-missing");
  EXPECT_THAT(info->findings[0].text, HasSubstr("copied-wal"));
  NetworkConfig config;
  config.slaves.resize(1);
  EXPECT_TRUE(replay_run(*reader, config)) << "without cycles it opens, too";
  auto with_log = RecordingReader::open(path("both"));
  ASSERT_TRUE(with_log) << with_log.error().detail.text();
  EXPECT_TRUE(with_log->info()->findings.empty());
  ASSERT_TRUE((*recorder)->finish());
  EXPECT_TRUE(RecordingReader::open(path())->info()->findings.empty());
}

}  // namespace
}  // namespace syncline
