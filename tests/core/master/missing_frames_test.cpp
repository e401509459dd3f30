// SPDX-License-Identifier: Apache-2.0
#include "master/exchange/missing_frames.h"

#include <gtest/gtest.h>

#include "master/exchange/tally.h"
#include "protocol/datagram.h"

namespace syncline {
namespace {

MissingFrames::Frame frame(std::uint64_t sequence, Nanoseconds send_time) {
  return {sequence, send_time, send_time + 800'000, Command::kLrw, 0x10000, 20};
}

DatagramHeader answer(std::uint8_t index) {
  DatagramHeader header;
  header.command = Command::kLrw;
  header.index = index;
  header.address = 0x10000;
  header.length = 20;
  return header;
}

TEST(MissingFrames, AreLostWhenALaterFrameIsBack) {
  MissingFrames missing;
  missing.miss(1, frame(1, 0));
  missing.miss(2, frame(2, kMillisecond));
  EXPECT_EQ(missing.take_news().lost, 0U);
  missing.returned(3);
  const auto news = missing.take_news();
  EXPECT_EQ(news.lost, 2U);
  EXPECT_EQ(news.first_lost, 0);
  EXPECT_EQ(missing.take_news().lost, 0U);  // once
}

TEST(MissingFrames, AreLostWhenNothingComesBackForLong) {
  MissingFrames missing;
  missing.miss(1, frame(1, 0));
  missing.expire(10 * kMillisecond);
  EXPECT_EQ(missing.take_news().lost, 0U);
  missing.expire(21 * kMillisecond);
  EXPECT_EQ(missing.take_news().lost, 1U);
}

TEST(MissingFrames, TellEachCycleOnceWhoseProcessDataCameLate) {
  MissingFrames missing;
  auto process_data = frame(1, 0);
  process_data.cyclic = true;
  missing.miss(1, process_data);
  process_data.sequence = 2;
  missing.miss(2, process_data);  // the second frame of that cycle
  missing.miss(3, frame(3, 0));   // of no cycle
  for (std::uint8_t index = 1; index <= 3; ++index) EXPECT_TRUE(missing.take_late(answer(index), 2 * kMillisecond));
  const auto news = missing.take_news();
  EXPECT_EQ(news.late, 3U);
  EXPECT_EQ(news.late_cycles, 1U);
}

TEST(MissingFrames, AreLateWhenTheyComeAfterAll) {
  MissingFrames missing;
  missing.miss(1, frame(1, 0));
  missing.miss(2, frame(2, kMillisecond));
  EXPECT_TRUE(missing.take_late(answer(2), 2 * kMillisecond));
  auto news = missing.take_news();
  EXPECT_EQ(news.late, 1U);
  EXPECT_EQ(news.late_by, 200'000);
  EXPECT_EQ(news.lost, 1U);  // the one before it
  // Against all order the other one comes as well: told as lost, and late.
  EXPECT_TRUE(missing.take_late(answer(1), 3 * kMillisecond));
  news = missing.take_news();
  EXPECT_EQ(news.late, 1U);
  EXPECT_EQ(news.late_after_lost, 1U);
  EXPECT_EQ(news.late_by, 2'200'000);
  EXPECT_FALSE(missing.take_late(answer(1), 4 * kMillisecond));  // a copy
}

TEST(MissingFrames, AreKnownByMoreThanTheIndex) {
  MissingFrames missing;
  missing.miss(1, frame(1, 0));
  auto other = answer(1);
  other.length = 8;
  EXPECT_FALSE(missing.take_late(other, kMillisecond));
  other = answer(1);
  other.address ^= 1;
  EXPECT_FALSE(missing.take_late(other, kMillisecond));
  EXPECT_EQ(missing.take_news().late, 0U);
}

TEST(MissingFrames, EndWithTheirIndexAndWithTheCycle) {
  MissingFrames missing;
  missing.miss(1, frame(1, 0));
  missing.forget(1);
  EXPECT_FALSE(missing.take_late(answer(1), kMillisecond));
  missing.miss(2, frame(2, 0));
  missing.give_up();
  EXPECT_EQ(missing.take_news().lost, 2U);
}

TEST(Tally, TellsEachThingOnceAndSeldomWhenThereAreMany) {
  Tally tally;
  std::int64_t sum = 0;
  int reports = 0;
  for (Nanoseconds now = 0; now < 10 * kSecond; now += kMillisecond) {
    tally.add(1, now, now);
    if (const auto report = tally.due(now)) {
      sum += report->count;
      ++reports;
    }
  }
  EXPECT_LT(reports, 10);
  sum += tally.rest()->count;
  EXPECT_EQ(sum, 10'000);
  EXPECT_FALSE(tally.rest());
}

TEST(Tally, TellsTheFirstOneAtOnce) {
  Tally tally;
  tally.add(2, 7, 5);
  const auto report = tally.due(5);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->count, 2);
  EXPECT_EQ(report->largest, 7);
  EXPECT_EQ(report->time, 5);
  // The second one waits for what may follow, and is told with the time of its first.
  tally.add(1, 3, 10 * kMillisecond);
  EXPECT_FALSE(tally.due(10 * kMillisecond));
  tally.add(1, 9, 20 * kMillisecond);
  const auto second = tally.due(100 * kMillisecond + 5);
  ASSERT_TRUE(second);
  EXPECT_EQ(second->count, 2);
  EXPECT_EQ(second->largest, 9);
  EXPECT_EQ(second->time, 10 * kMillisecond);
}

}  // namespace
}  // namespace syncline
