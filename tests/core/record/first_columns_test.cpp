// SPDX-License-Identifier: Apache-2.0
// The first picture of a recording against that of all its samples.
#include "record/first_columns.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "record/recording_writer.h"
#include "record/replay_run.h"
#include "tests/core/record/made_samples.h"
#include "tests/support/temporary_folder.h"

namespace syncline {
namespace {

constexpr std::array kDrawn{Signal::kRoundTrip, Signal::kDcmError, Signal::kDcmErrorFiltered, Signal::kDrift,
                            Signal::kDeviation};

NetworkConfig pictured_machine() {
  NetworkConfig config;
  config.slaves.resize(3);
  return config;
}

class FirstColumnsTest : public ::testing::Test {
 protected:
  /// So many blocks of so many cycles.
  void write(std::size_t blocks, std::size_t cycles) {
    test::MadeSamples made(5);
    for (std::size_t i = 0; i < blocks; ++i) batches_.push_back(made.next(cycles));
    write();
  }
  void write() {
    auto writer = RecordingWriter::create(path_, about_run(pictured_machine()));
    ASSERT_TRUE(writer);
    for (const auto& samples : batches_) {
      RecordingBatch batch;
      batch.samples = samples;
      ASSERT_TRUE(writer->write(batch));
    }
    ASSERT_TRUE(writer->finish("end", {}));
    reader_.emplace(*RecordingReader::open(path_));
    run_.emplace(*replay_run(*reader_, pictured_machine()));
  }
  [[nodiscard]] const SampleStore& store() const { return run_->record->samples(); }

  void expect_same(Nanoseconds begin, Nanoseconds end, Nanoseconds width) {
    const auto drawn = first_columns(*reader_, kDrawn, begin, end, width);
    ASSERT_TRUE(drawn);
    ASSERT_EQ(drawn->size(), kDrawn.size());
    for (std::size_t signal = 0; signal < kDrawn.size(); ++signal) {
      std::vector<SeriesColumn> all;
      store().series(kDrawn[signal]).columns(begin, end, width, all);
      const auto& columns = (*drawn)[signal];
      ASSERT_EQ(columns.size(), all.size());
      for (std::size_t i = 0; i < all.size(); ++i) {
        SCOPED_TRACE(info(kDrawn[signal]).key);
        SCOPED_TRACE(i);
        ASSERT_EQ(columns[i].start, all[i].start);
        ASSERT_EQ(columns[i].valid, all[i].valid);
        ASSERT_EQ(columns[i].min, all[i].min);
        ASSERT_EQ(columns[i].max, all[i].max);
        ASSERT_TRUE(std::isnan(columns[i].last));
      }
    }
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("run.slrec");
  std::vector<std::vector<CycleSample>> batches_;
  std::optional<RecordingReader> reader_;
  std::optional<ReplayedRun> run_;
};

TEST_F(FirstColumnsTest, AreThoseOfAllSamplesWhateverTheWindow) {
  write(60, 1000);
  const auto first = store().first_time();
  const auto whole = store().last_time() + 1 - first;
  for (const Nanoseconds columns : {1, 2, 7, 59, 60, 61, 300, 997}) expect_same(first, first + whole, whole / columns);
  Random random(3);
  for (int i = 0; i < 40; ++i) {
    const auto begin = first - whole / 4 + static_cast<Nanoseconds>(random.next() % static_cast<std::uint64_t>(whole));
    const auto span = 1 + static_cast<Nanoseconds>(random.next() % static_cast<std::uint64_t>(whole));
    expect_same(begin, begin + span, 1 + span / static_cast<Nanoseconds>(1 + random.next() % 400));
  }
}

TEST_F(FirstColumnsTest, AreThoseOfAllSamplesOfLongBlocks) {
  write(3, 20'000);
  const auto first = store().first_time();
  const auto whole = store().last_time() + 1 - first;
  for (const Nanoseconds columns : {2, 50, 500, 4000}) expect_same(first, first + whole, whole / columns);
}

TEST_F(FirstColumnsTest, LeaveOutWhatIsEarlierThanTheNewest) {
  test::MadeSamples made(5);
  for (int i = 0; i < 8; ++i) batches_.push_back(made.next(1000));
  // The clock goes back by more than a block, and by less within one.
  for (auto& sample : batches_[4]) sample.send_time -= 2300 * kMillisecond;
  for (std::size_t i = 500; i < 700; ++i) batches_[6][i].send_time -= 90 * kMillisecond;
  // Far from all others, so that it would be seen.
  batches_[4][1].dcm_error_ns = 1'000'000;
  batches_[6][520].dcm_error_ns = -1'000'000;
  write();
  const auto first = store().first_time();
  const auto whole = store().last_time() + 1 - first;
  for (const Nanoseconds columns : {31, 200}) expect_same(first, first + whole, whole / columns);
}

TEST_F(FirstColumnsTest, HaveNoValueWhereNothingIsTold) {
  test::MadeSamples made(5);
  for (int i = 0; i < 6; ++i) {
    batches_.push_back(made.next(1000));
    if (i < 2 || i == 4) continue;
    for (auto& sample : batches_.back()) sample.flags = CycleSample::kFrameLost;
  }
  write();
  const auto first = store().first_time();
  const auto whole = store().last_time() + 1 - first;
  for (const Nanoseconds columns : {3, 40, 400}) expect_same(first, first + whole, whole / columns);
}

TEST_F(FirstColumnsTest, LeaveOutWhatIsDamaged) {
  write(6, 1000);
  const auto first = store().first_time();
  const auto whole = store().last_time() + 1 - first;
  auto database = SqlDatabase::open(path_);
  ASSERT_TRUE(database);
  for (const auto* harm : {"UPDATE data SET levels = x'00'", "DELETE FROM data", "UPDATE summary SET crc = crc + 1"}) {
    ASSERT_TRUE(database->execute(harm));
    const auto drawn = first_columns(*reader_, kDrawn, first, first + whole, whole / 100);
    ASSERT_TRUE(drawn) << harm;
    for (const auto& columns : *drawn) {
      for (const auto& column : columns) EXPECT_FALSE(column.valid) << harm;
    }
  }
  ASSERT_TRUE(database->execute("DROP TABLE block"));
  EXPECT_FALSE(first_columns(*reader_, kDrawn, first, first + whole, whole / 100));
}

TEST_F(FirstColumnsTest, AreMadeOfWhatVerifyingHoldsAgainstTheSamples) {
  write(4, 1000);
  ASSERT_TRUE(reader_->verify());
  auto database = SqlDatabase::open(path_);
  ASSERT_TRUE(database);
  const auto where = std::to_string(2 * kSeriesPerBlock + series_number(Signal::kDcmError));
  const auto sql = "UPDATE data SET levels = (SELECT levels FROM data WHERE id = " +
                   std::to_string(kSeriesPerBlock + series_number(Signal::kDcmError)) + ") WHERE id = " + where;
  ASSERT_TRUE(database->execute(sql.c_str()));
  const auto verified = reader_->verify();
  ASSERT_FALSE(verified);
  EXPECT_EQ(verified.error().code, ErrorCode::kFileNotReadable);
}

TEST_F(FirstColumnsTest, PassOverTimesThatADamagedFileHasFarAway) {
  write(6, 1000);
  const auto first = store().first_time();
  const auto whole = store().last_time() + 1 - first;
  auto database = SqlDatabase::open(path_);
  ASSERT_TRUE(database);
  ASSERT_TRUE(database->execute(
      "UPDATE block SET begin_ns = -9223372036854775807, end_ns = 9223372036854775807 WHERE number = 3"));
  const auto drawn = first_columns(*reader_, kDrawn, first, first + whole, whole / 100);
  ASSERT_TRUE(drawn);
  EXPECT_GE(drawn->front().size(), 100U);
}

TEST_F(FirstColumnsTest, AreNoneOfNothing) {
  write(2, 1000);
  const auto first = store().first_time();
  for (const auto& [end, width] : {std::pair{first, Nanoseconds{10}}, std::pair{first + 10, Nanoseconds{0}},
                                   std::pair{Nanoseconds{INT64_MAX}, Nanoseconds{INT64_MAX / 8}}}) {
    const auto drawn = first_columns(*reader_, kDrawn, first, end, width);
    ASSERT_TRUE(drawn);
    for (const auto& columns : *drawn) EXPECT_TRUE(columns.empty());
  }
}

}  // namespace
}  // namespace syncline
