// SPDX-License-Identifier: Apache-2.0
#include "trace/slave_cells.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "channels/cycle_sample.h"
#include "support/random.h"
#include "trace/sample_store.h"

namespace syncline {
namespace {

using testing::Each;
using testing::ElementsAre;

constexpr float kNothing = SlaveCells::kNoReading;
constexpr Nanoseconds kHeatStart = 830'000'000 * kSecond;

/// Cycles of 1 ms; four slaves, of which 1..3 are read in turn, each after 3 ms: a reading holds for ten cycles at
/// most.
class SlaveCellsTest : public testing::Test {
 protected:
  static constexpr Nanoseconds kHolds = 10 * kMillisecond;

  CycleSample cycle(std::uint64_t i) const {
    CycleSample sample;
    sample.cycle = i;
    sample.send_time = kHeatStart + static_cast<Nanoseconds>(i) * kMillisecond;
    sample.round_trip_ns = 20'000;
    sample.flags = CycleSample::kSlaveFollows;
    sample.slave_position = static_cast<std::int16_t>(1 + i % 3);
    sample.slave_deviation_ns = 10 * sample.slave_position;
    return sample;
  }
  using Edit = std::function<bool(CycleSample&)>;  // false: the cycle is missing
  void run(
      std::uint64_t from, std::uint64_t to, const Edit& edit = [](CycleSample&) { return true; }) {
    std::vector<CycleSample> samples;
    for (auto i = from; i < to; ++i) {
      auto sample = cycle(i);
      if (edit(sample)) samples.push_back(sample);
    }
    store.append(samples);
  }
  void show(Nanoseconds begin, Nanoseconds width, std::size_t columns) {
    cells.show(store, {kHeatStart + begin, width, columns});
  }
  std::vector<float> row(std::size_t slave) const { return {cells.row(slave).begin(), cells.row(slave).end()}; }

  SampleStore store{{.slaves = 4}};
  SlaveCells cells;
};

TEST_F(SlaveCellsTest, AReadingHoldsUntilTheNextOne) {
  run(0, 30, [](CycleSample& sample) {
    if (sample.cycle == 4) sample.slave_deviation_ns = -77;  // of slave 2
    return true;
  });
  show(0, kMillisecond, 12);
  EXPECT_EQ(row(2), (std::vector<float>{kNothing, 20, 20, 20, 77, 77, 77, 20, 20, 20, 20, 20}));
  EXPECT_EQ(store.longest_gap(Signal::kSlaveDeviation), kHolds);
}

TEST_F(SlaveCellsTest, NoColumnIsWiderThanItsReadingsAndNoneIsLeftOut) {
  run(0, 30);
  show(0, kMillisecond / 4, 16);
  EXPECT_EQ(row(1), std::vector<float>(16, 10));
  show(-4 * kMillisecond, kMillisecond, 6);
  EXPECT_EQ(row(1), (std::vector<float>{kNothing, kNothing, kNothing, kNothing, 10, 10})) << "no run before it";
}

TEST_F(SlaveCellsTest, OneSpikeIsSeenAtEveryZoomAndInOneColumn) {
  constexpr std::uint64_t kSpike = 25'000;  // of slave 2
  run(0, 60'000, [](CycleSample& sample) {
    if (sample.cycle == kSpike) sample.slave_deviation_ns = -5000;
    return true;
  });
  ASSERT_EQ(kSpike % 3, 1U);
  for (const Nanoseconds width : {kMillisecond / 10, kMillisecond, 7 * kMillisecond, 50 * kMillisecond,
                                  500 * kMillisecond, 6 * kSecond, 60 * kSecond}) {
    const auto middle = (kHeatStart + static_cast<Nanoseconds>(kSpike) * kMillisecond) / width * width;
    cells.show(store, {middle - 5 * width, width, 11});
    const auto seen = cells.row(2);
    EXPECT_EQ(seen[5], 5000) << width;
    if (width < 3 * kMillisecond) continue;
    EXPECT_EQ(std::ranges::count(seen, 5000.F), 1) << width;
    EXPECT_EQ(*std::ranges::max_element(cells.row(1)), 10) << width;
  }
}

TEST_F(SlaveCellsTest, AnAbsentSlaveHasNoReadingFromItsLastOneOn) {
  // Slave 3 does not answer from 20 to 100 ms, which is longer than a reading holds; 2 not from 20 to 27 ms.
  run(0, 200, [](CycleSample& sample) {
    const bool silent = (sample.slave_position == 3 && sample.cycle >= 20 && sample.cycle < 100) ||
                        (sample.slave_position == 2 && sample.cycle >= 20 && sample.cycle < 27);
    if (silent) sample.slave_position = -1;
    return true;
  });
  for (const auto width : {kMillisecond, 2 * kMillisecond, 5 * kMillisecond}) {
    const auto columns = static_cast<std::size_t>(200 * kMillisecond / width);
    show(0, width, columns);
    for (std::size_t i = 1; i < columns; ++i) {
      const auto time = static_cast<Nanoseconds>(i) * width / kMillisecond;
      if (time < 2) continue;  // before the first one of slave 3
      // Its last reading is of 17 ms, the next one of 101 ms.
      const bool known = time <= 17 || time + width / kMillisecond > 101;
      EXPECT_EQ(cells.row(3)[i], known ? 30 : kNothing) << time << " " << width;
      EXPECT_EQ(cells.row(2)[i], 20) << time;
    }
  }
}

TEST_F(SlaveCellsTest, TheNewestReadingHoldsUntilItIsTooOld) {
  const auto without_three = [](CycleSample& sample) {
    if (sample.slave_position == 3) sample.slave_position = -1;
    return true;
  };
  run(0, 30);  // slave 3 last at 29 ms
  run(30, 35, without_three);
  show(0, kMillisecond, 120);
  EXPECT_EQ(cells.row(3)[34], 30);
  EXPECT_EQ(cells.row(3)[35], kNothing) << "later than the newest cycle";
  run(35, 40, without_three);
  show(0, kMillisecond, 120);
  EXPECT_EQ(cells.row(3)[39], 30) << "10 ms old";
  run(40, 41, without_three);
  show(0, kMillisecond, 120);
  EXPECT_EQ(cells.row(3)[29], 30);
  EXPECT_EQ(cells.row(3)[30], kNothing) << "nothing stale is left of what held before";
  EXPECT_EQ(cells.row(2)[39], 20);
}

TEST_F(SlaveCellsTest, NothingHoldsOverAnOutage) {
  // Frames are lost from 31 to 36 ms, cycles are missing from 61 to 66 ms: less than a reading would hold.
  run(0, 120, [](CycleSample& sample) {
    if (sample.cycle > 60 && sample.cycle <= 66) return false;
    if (sample.cycle <= 30 || sample.cycle > 36) return true;
    sample.flags = CycleSample::kFrameLost;
    sample.slave_position = -1;
    return true;
  });
  show(0, kMillisecond, 120);
  const auto& seen = cells.row(1);  // read at 27, 30, 39, 60, 69 ms
  EXPECT_EQ(seen[30], 10);
  for (std::size_t i = 31; i < 39; ++i) EXPECT_EQ(seen[i], kNothing) << i;
  EXPECT_EQ(seen[39], 10);
  EXPECT_EQ(seen[60], 10);
  for (std::size_t i = 61; i < 69; ++i) EXPECT_EQ(seen[i], kNothing) << i;
  EXPECT_EQ(seen[69], 10);
  EXPECT_EQ(cells.row(2)[28], 20) << "until then it holds";
  EXPECT_EQ(cells.row(2)[29], 20);
  show(35 * kMillisecond, kMillisecond, 20);
  EXPECT_EQ(cells.row(1)[0], kNothing) << "where the outage began is not shown";
}

TEST_F(SlaveCellsTest, ALostFrameIsNoOutage) {
  run(0, 60, [](CycleSample& sample) {
    if (sample.cycle != 30) return true;
    sample.flags = CycleSample::kFrameLost;
    sample.slave_position = -1;
    return true;
  });
  show(20 * kMillisecond, kMillisecond, 20);
  EXPECT_THAT(row(1), Each(10.F));
}

TEST_F(SlaveCellsTest, WhatDoesNotFollowHasNoReading) {
  run(0, 60, [](CycleSample& sample) {
    if (sample.slave_position == 1) sample.slave_position = 0;
    if (sample.slave_position == 0) sample.flags = 0;  // the reference clock
    return true;
  });
  show(0, kMillisecond, 40);
  EXPECT_THAT(row(0), Each(kNothing)) << "what a reference clock shows is no deviation";
  EXPECT_THAT(row(1), Each(kNothing));
}

TEST_F(SlaveCellsTest, WhatIsKeptIsWhatIsMadeAnew) {
  Random random(7);
  const auto below = [&random](std::uint64_t most) { return random.next() % most; };
  const auto noise = [&below](CycleSample& sample) {
    sample.slave_deviation_ns = static_cast<std::int32_t>(below(2000)) - 1000;
    if (below(40) == 0) sample.slave_position = -1;
    return below(100) != 0;
  };
  std::uint64_t now = 0;
  Nanoseconds width = kMillisecond;
  Nanoseconds begin = 0;
  for (int step = 0; step < 300; ++step) {
    const auto more = below(60);
    const bool silence = below(6) == 0;
    run(now, now + more, [&](CycleSample& sample) { return !silence && noise(sample); });
    now += more;
    if (below(20) == 0) width = static_cast<Nanoseconds>(1 + below(12'000)) * kMicrosecond;
    // It follows, stands, or goes back.
    if (below(3) == 0) begin = (static_cast<Nanoseconds>(now) * kMillisecond) - 90 * width;
    if (below(5) == 0) begin -= static_cast<Nanoseconds>(below(60)) * width;
    const SlaveCells::Grid grid{(kHeatStart + begin) / width * width, width, 100};
    cells.show(store, grid);
    SlaveCells anew;
    anew.show(store, grid);
    for (std::size_t slave = 0; slave < 4; ++slave) {
      ASSERT_TRUE(std::ranges::equal(cells.row(slave), anew.row(slave))) << step << " " << slave;
    }
  }
}

/// Rows are made anew when the store forgets: with the outages of all that is shown.
TEST_F(SlaveCellsTest, AFullStoreKeepsItsOutages) {
  store = SampleStore({.slaves = 4, .cycle_capacity = 8192});
  std::uint64_t now = 36'500;  // soon the oldest part of each slave's readings goes at once
  run(0, now);
  for (int step = 0; step < 40; ++step) {
    run(now, now + 40);
    now += 40 + 7;  // longer than cycles are apart, shorter than a reading holds
    const SlaveCells::Grid grid{kHeatStart + static_cast<Nanoseconds>(now - 400) * kMillisecond, kMillisecond, 400};
    cells.show(store, grid);
    SlaveCells anew;
    anew.show(store, grid);
    for (std::size_t slave = 1; slave < 4; ++slave)
      ASSERT_TRUE(std::ranges::equal(cells.row(slave), anew.row(slave))) << step << " " << slave;
  }
  EXPECT_GT(std::ranges::count(row(2), kNothing), 50);
}

TEST_F(SlaveCellsTest, AnotherNumberOfColumnsOrNoRunIsNoProblem) {
  show(0, kMillisecond, 10);
  EXPECT_THAT(row(3), Each(kNothing));
  run(0, 40);
  show(0, kMillisecond, 30);
  show(0, kMillisecond, 5);
  EXPECT_EQ(row(1), std::vector<float>(5, 10));
  show(0, kMillisecond, 0);
  EXPECT_TRUE(row(1).empty());
}

TEST(Outages, BeginWithTheLastFrameThatCameBack) {
  SampleStore store({.slaves = 1});
  std::vector<CycleSample> samples;
  for (std::uint64_t i = 0; i < 50; ++i) {
    CycleSample sample;
    sample.cycle = i;
    sample.send_time = kHeatStart + static_cast<Nanoseconds>(i) * kMillisecond;
    if (i > 10 && i < 20) sample.flags = CycleSample::kFrameLost;
    if (i == 30 || i > 44) sample.flags = CycleSample::kFrameLost;
    samples.push_back(sample);
  }
  store.append(samples);
  const auto at = [](Nanoseconds cycle) { return kHeatStart + cycle * kMillisecond; };
  EXPECT_THAT(outages(store, at(0), at(100), kMillisecond),
              ElementsAre(Outage{at(10), at(20)}, Outage{at(44), at(49) + 1}));
  EXPECT_THAT(outages(store, at(12), at(16), kMillisecond), ElementsAre(Outage{at(12), at(16)}));
  EXPECT_TRUE(outages(store, at(20), at(40), kMillisecond).empty());
}

}  // namespace
}  // namespace syncline
