// SPDX-License-Identifier: Apache-2.0
#include "support/counter_total.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace syncline {
namespace {

using End = CounterTotal::End;

TEST(CounterTotal, CountsFromItsFirstReading) {
  CounterTotal counter(8, End::kSaturates);
  EXPECT_EQ(counter.read(7), 0U);
  EXPECT_EQ(counter.read(9), 2U);
  EXPECT_EQ(counter.read(9), 0U);
  EXPECT_EQ(counter.total(), 2U);
  EXPECT_FALSE(counter.at_least());
}

TEST(CounterTotal, SaysAtLeastAtItsEndStop) {
  CounterTotal counter(8, End::kSaturates);
  counter.read(0xF0);
  EXPECT_EQ(counter.read(0xFF), 0xFU);
  EXPECT_TRUE(counter.at_least());
}

TEST(CounterTotal, GoesOnFromItsEndStopWhenItIsCleared) {
  CounterTotal counter(8, End::kSaturates), wraps(8, End::kWraps);
  EXPECT_FALSE(counter.at_end_stop());
  counter.read(0xFF);
  wraps.read(0xFF);
  EXPECT_TRUE(counter.at_end_stop());
  EXPECT_FALSE(wraps.at_end_stop()) << "it has none";
  counter.cleared();
  EXPECT_FALSE(counter.at_end_stop());
  EXPECT_EQ(counter.read(3), 3U);
  EXPECT_EQ(counter.total(), 3U);
  EXPECT_TRUE(counter.at_least());
}

TEST(CounterTotal, GoesOnWhenItWraps) {
  CounterTotal counter(16, End::kWraps);
  counter.read(0xFFFE);
  EXPECT_EQ(counter.read(3), 5U);
  EXPECT_FALSE(counter.at_least());
}

TEST(CounterTotal, TakesAJumpBackAsARestart) {
  CounterTotal counter(16, End::kWraps);
  counter.read(10);
  counter.read(500);
  EXPECT_EQ(counter.read(3), 3U);
  EXPECT_EQ(counter.total(), 493U);
  EXPECT_TRUE(counter.at_least()) << "what it counted before the restart, unread, is lost";
}

TEST(CounterTotal, NeverBecomesNegativeOrHuge) {
  EXPECT_TRUE(rc::check("whatever is read", [](const std::vector<std::uint32_t>& readings) {
    for (const auto end : {End::kSaturates, End::kWraps}) {
      CounterTotal counter(8, end);
      std::uint64_t most = 0;
      for (const auto reading : readings) {
        RC_ASSERT(counter.read(reading) <= 0xFFU);
        most += 0xFF;
        RC_ASSERT(counter.total() <= most);
      }
    }
  }));
}

}  // namespace
}  // namespace syncline
