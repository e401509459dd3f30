// SPDX-License-Identifier: Apache-2.0
// Recordings of variables of the process image.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>

#include "record/recent_run.h"
#include "record/recorder.h"
#include "record/recording_reader.h"
#include "record/replay_run.h"
#include "tests/core/record/made_samples.h"
#include "tests/core/record/older_recording.h"
#include "tests/support/temporary_folder.h"

namespace syncline {
namespace {

using testing::HasSubstr;

/// One of each type, the widest and the narrowest among them.
std::vector<WatchedVariable> variables() {
  return {{"Servo.Ready", "BOOL", false, 0, 1, 2},
          {"Servo.Mode", "BIT3", false, 1, 3, 2},
          {"Servo.Torque", "SINT", false, 8, 8, 2},
          {"Servo.Statusword", "UINT", false, 16, 16, 2},
          {"Servo.Position", "DINT", false, 32, 32, 2},
          {"Servo.Time", "ULINT", false, 64, 64, 2},
          {"Servo.Long position", "LINT", false, 128, 64, 2},
          {"Input.Speed", "REAL", false, 192, 32, 1},
          {"Input.Power", "LREAL", false, 224, 64, 1},
          {"Lamp", "BOOL", true, 3, 1, -1},
          {"Servo.Own", "DT55", false, 300, 12, 2}};
}

class WatchedRecording : public testing::Test {
 protected:
  WatchedRecording() {
    config_.slaves.resize(3);
    for (const auto* name : {"Coupler", "Input", "Servo"}) about_.slaves.push_back({name, 2, 3, 4});
    about_.limits = {kMillisecond, 511, 4000};
  }
  [[nodiscard]] std::string path() const { return folder_.file("run.slrec"); }
  /// Values at the limits of the types, and any; one in seven is not known.
  void fill(std::span<CycleSample> samples, const WatchLists& lists) {
    const auto& list = lists.lists().back();
    for (auto& sample : samples) {
      sample.watch_list = list.number;
      for (std::size_t place = 0; place < list.places.size(); ++place) {
        if (random_.next() % 7 == 0) continue;
        const auto size = lists.variables()[list.places[place]].bit_size;
        const auto mask = size == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << size) - 1;
        const std::uint64_t edges[] = {0, ~std::uint64_t{0}, std::uint64_t{1} << (size - 1), random_.next()};
        sample.watched[place] = edges[random_.next() % 4] & mask;
        sample.watched_known = static_cast<std::uint16_t>(sample.watched_known | 1U << place);
      }
    }
  }
  static void expect_same(std::span<const CycleSample> a, std::span<const CycleSample> b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      ASSERT_EQ(a[i].watch_list, b[i].watch_list) << i;
      ASSERT_EQ(a[i].watched_known, b[i].watched_known) << i;
      ASSERT_EQ(a[i].watched, b[i].watched) << i;
    }
  }
  static std::vector<CycleSample> read(RecordingReader& reader) {
    std::vector<CycleSample> all;
    const auto status = reader.samples([&](std::span<const CycleSample> samples) {
      all.insert(all.end(), samples.begin(), samples.end());
      return true;
    });
    EXPECT_TRUE(status) << status.error().detail.text();
    return all;
  }

  NetworkConfig config_;
  RecordingAbout about_;
  test::TemporaryFolder folder_;
  Random random_{5};
};

/// Whatever is watched when, and changed in the middle of a block, is read back bit for bit and drawn as it was.
TEST_F(WatchedRecording, HoldsEveryBitOfEveryList) {
  RunRecord live(config_);
  ASSERT_TRUE(live.watch(variables()));
  about_.watched = live.watched();
  auto recorder = Recorder::start(path(), about_, {.by_clock = false}, {});
  ASSERT_TRUE(recorder) << recorder.error().detail.text();
  test::MadeSamples made(3);
  std::vector<CycleSample> all;
  const auto add = [&](std::size_t count) {
    auto samples = made.next(count);
    fill(samples, live.watched());
    live.add(samples);
    (*recorder)->add(samples);
    all.insert(all.end(), samples.begin(), samples.end());
  };
  const auto watch = [&](std::vector<WatchedVariable> list) {
    ASSERT_TRUE(live.watch(list));
    (*recorder)->tell(std::move(list));
  };
  add(1'500);
  auto other = variables();
  std::ranges::reverse(other);
  other.resize(6);
  other.push_back({"Coupler.New", "UDINT", true, 64, 32, 0});
  watch(other);
  add(700);
  watch({});
  add(400);
  watch({variables()[4]});
  add(900);
  ASSERT_TRUE((*recorder)->finish());

  auto reader = RecordingReader::open(path());
  ASSERT_TRUE(reader) << reader.error().detail.text();
  const auto info = reader->info();
  ASSERT_TRUE(info) << info.error().detail.text();
  EXPECT_EQ(info->about.watched, live.watched());
  expect_same(all, read(*reader));
  const auto blocks = reader->verify();
  EXPECT_TRUE(blocks) << blocks.error().detail.text();
  const auto replayed = replay_run(*reader, config_);
  ASSERT_TRUE(replayed) << replayed.error().detail.text();
  const auto& store = replayed->record->samples();
  ASSERT_EQ(store.watched(), live.watched());
  std::size_t values = 0;
  for (std::size_t i = 0; i < live.watched().variables().size(); ++i) {
    const auto points = [&](const SampleStore& from) {
      std::vector<std::pair<Nanoseconds, std::uint32_t>> found;
      from.series(Signal::kVariable, i).for_each(INT64_MIN, INT64_MAX, [&](Nanoseconds time, float value) {
        if (!std::isnan(value)) found.emplace_back(time, std::bit_cast<std::uint32_t>(value));
      });
      return found;
    };
    EXPECT_EQ(points(live.samples()), points(store)) << live.watched().variables()[i].name;
    values += points(store).size();
    EXPECT_EQ(reader->overview(Signal::kVariable, static_cast<int>(i))->empty(), points(store).empty());
  }
  EXPECT_GT(values, 10'000U);
}

TEST_F(WatchedRecording, OutOfMemoryHoldsThemToo) {
  RunRecord live(config_);
  ASSERT_TRUE(live.watch(variables()));
  RecentSamples recent(64U << 20);
  test::MadeSamples made(4);
  auto samples = made.next(6'000);
  fill(samples, live.watched());
  live.add(samples);
  recent.add(samples);
  RecentRun run;
  run.about = about_run(live);
  run.samples = recent.since(0);
  run.held = held_copy(live);
  ASSERT_TRUE(save_recent(path(), run));
  auto reader = RecordingReader::open(path());
  ASSERT_TRUE(reader);
  expect_same(samples, read(*reader));
  EXPECT_TRUE(reader->verify());
}

TEST_F(WatchedRecording, OfAnOlderVersionHasNone) {
  auto recorder = Recorder::start(path(), about_, {.by_clock = false}, {});
  ASSERT_TRUE(recorder);
  test::MadeSamples made(1);
  const auto samples = made.next(300);
  (*recorder)->add(samples);
  ASSERT_TRUE((*recorder)->finish());
  ASSERT_TRUE(test::make_older(path(), 3));
  ASSERT_TRUE(SqlDatabase::open(path())->execute("DROP TABLE variable; DROP TABLE watch_list"));
  auto reader = RecordingReader::open(path());
  ASSERT_TRUE(reader) << reader.error().detail.text();
  ASSERT_TRUE(reader->info());
  EXPECT_TRUE(reader->info()->about.watched.variables().empty());
  EXPECT_EQ(read(*reader).size(), samples.size());
  EXPECT_TRUE(reader->verify());
  const auto replayed = replay_run(*reader, config_);
  ASSERT_TRUE(replayed);
  EXPECT_TRUE(replayed->record->watched().variables().empty());
}

TEST_F(WatchedRecording, ListsThatContradictThemselvesAreFound) {
  about_.watched.add(variables());
  for (const auto* damage :
       {"UPDATE variable SET bit_size = 65 WHERE id = 3", "UPDATE variable SET id = 77 WHERE id = 3",
        "UPDATE watch_list SET variable = 4 WHERE place = 3", "UPDATE watch_list SET place = 40 WHERE place = 3",
        "UPDATE watch_list SET number = 99999999", "DELETE FROM watch_list"}) {
    auto recorder = Recorder::start(path(), about_, {.by_clock = false}, {});
    ASSERT_TRUE(recorder);
    test::MadeSamples made(1);
    auto samples = made.next(300);
    fill(samples, about_.watched);
    (*recorder)->add(samples);
    ASSERT_TRUE((*recorder)->finish());
    ASSERT_TRUE(SqlDatabase::open(path())->execute(damage));
    auto reader = RecordingReader::open(path());
    ASSERT_TRUE(reader);
    const auto verified = reader->verify();
    ASSERT_FALSE(verified) << damage;
    EXPECT_THAT(verified.error().detail.text(), HasSubstr("damaged")) << damage;
    std::filesystem::remove(path());
  }
}

}  // namespace
}  // namespace syncline
