// SPDX-License-Identifier: Apache-2.0
#include "record/blocks_ahead.h"

#include <gtest/gtest.h>

#include "config/network_config.h"
#include "record/recording_writer.h"
#include "record/sample_columns.h"
#include "tests/core/record/made_samples.h"
#include "tests/support/temporary_folder.h"

namespace syncline {
namespace {

constexpr std::size_t kBlocks = 20, kCycles = 100;

class BlocksAheadTest : public ::testing::Test {
 protected:
  void SetUp() override {
    NetworkConfig config;
    config.slaves.resize(3);
    auto writer = RecordingWriter::create(path_, about_run(config));
    ASSERT_TRUE(writer);
    test::MadeSamples made(2);
    for (std::size_t i = 0; i < kBlocks; ++i) {
      RecordingBatch batch;
      batch.samples = made.next(kCycles);
      ASSERT_TRUE(writer->write(batch));
    }
    ASSERT_TRUE(writer->finish("end", {}));
    reader_.emplace(*RecordingReader::open(path_));
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("run.slrec");
  std::optional<RecordingReader> reader_;
  RecordingReader::AllPoints points_;
};

TEST_F(BlocksAheadTest, AreAllOfThemInTheirOrder) {
  std::vector<std::vector<CycleSample>> expected;
  RecordingReader::AllPoints points;
  ASSERT_TRUE(reader_->samples(
      [&](std::span<const CycleSample> samples) {
        expected.emplace_back(samples.begin(), samples.end());
        return true;
      },
      points));
  ASSERT_EQ(expected.size(), kBlocks);
  BlocksAhead ahead(*reader_, points_);
  std::vector<CycleSample> samples;
  for (const auto& block : expected) {
    ASSERT_TRUE(ahead.next(samples));
    ASSERT_EQ(samples.size(), block.size());
    for (std::size_t i = 0; i < block.size(); ++i) {
      for (const auto column : sample_columns())
        EXPECT_EQ(info(column).of_cycle(samples[i]), info(column).of_cycle(block[i]));
    }
  }
  EXPECT_FALSE(ahead.next(samples));
  EXPECT_TRUE(ahead.finish());
  ASSERT_EQ(points_.size(), points.size());
  for (const auto& [series, found] : points) {
    EXPECT_EQ(points_[series].times, found.times);
    EXPECT_EQ(points_[series].values, found.values);
  }
}

TEST_F(BlocksAheadTest, AreReadNoFurtherThanSomebodyWantsThem) {
  BlocksAhead ahead(*reader_, points_);
  std::vector<CycleSample> samples;
  ASSERT_TRUE(ahead.next(samples));
  EXPECT_TRUE(ahead.finish());
  // The reader is free again.
  EXPECT_TRUE(reader_->info());
}

TEST_F(BlocksAheadTest, AreEmptyWhereOneIsDamaged) {
  auto database = SqlDatabase::open(path_);
  ASSERT_TRUE(database);
  ASSERT_TRUE(database->execute("UPDATE data SET cells = x'00' WHERE id >= 5 * 1048576 AND id < 6 * 1048576"));
  BlocksAhead ahead(*reader_, points_);
  std::vector<CycleSample> samples;
  std::size_t taken = 0;
  for (; ahead.next(samples); ++taken) EXPECT_EQ(samples.empty(), taken == 5) << taken;
  EXPECT_EQ(taken, 20U);
  EXPECT_TRUE(ahead.finish());
  EXPECT_FALSE(reader_->damage().empty());
}

TEST_F(BlocksAheadTest, EndWhereTheFileCannotBeRead) {
  auto database = SqlDatabase::open(path_);
  ASSERT_TRUE(database);
  ASSERT_TRUE(database->execute("DROP TABLE block"));
  BlocksAhead ahead(*reader_, points_);
  std::vector<CycleSample> samples;
  EXPECT_FALSE(ahead.next(samples));
  const auto status = ahead.finish();
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kFileNotReadable);
}

}  // namespace
}  // namespace syncline
