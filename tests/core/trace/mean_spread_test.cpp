// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "support/random.h"
#include "trace/statistics.h"

namespace syncline {
namespace {

constexpr int kRuns = 1'000;

struct Coverage {
  double held = 0;    // of the runs that state an interval
  double stated = 0;  // of all runs
};

/// `next`: one reading after the other of a run whose mean, if it went on, is `truth`.
Coverage coverage(int readings, double truth, const std::function<std::function<double()>(Random&)>& begin) {
  Random random(static_cast<std::uint64_t>(readings) + 7);
  int held = 0, stated = 0;
  for (int run = 0; run < kRuns; ++run) {
    const auto next = begin(random);
    Statistics statistics;
    for (int i = 0; i < readings; ++i) statistics.add(next());
    const auto interval = statistics.mean_interval();
    if (!interval) continue;
    ++stated;
    if (interval->holds(truth)) ++held;
  }
  return {static_cast<double>(held) / std::max(stated, 1), static_cast<double>(stated) / kRuns};
}

/// Whole numbers about 3.3 that resemble their neighbours for about `lasting` readings; 0: not at all.
auto alike(double lasting) {
  return [lasting](Random& random) {
    const double keep = lasting > 0 ? std::exp(-1 / lasting) : 0;
    return [&random, keep, rest = 5 * random.normal()]() mutable {
      const double value = std::round(3.3 + rest);
      rest = keep * rest + std::sqrt(1 - keep * keep) * 5 * random.normal();
      return value;
    };
  };
}

TEST(MeanInterval, HoldsTheTruthIn93To97OfAHundredRunsHoweverAlikeNeighboursAre) {
  for (const int readings : {200, 1'000, 3'000}) {
    for (const double times : {1e9, 1'000.0, 100.0, 50.0}) {
      const auto found = coverage(readings, 3.3, alike(readings / times));
      EXPECT_NEAR(found.held, 0.95, 0.02) << readings << " readings, alike for 1 in " << times;
      EXPECT_GT(found.stated, 0.98) << readings << " readings, alike for 1 in " << times;
    }
  }
}

TEST(MeanInterval, HoldsTheTruthOfLopsidedReadings) {
  const auto found = coverage(2'000, 200, [](Random& random) {
    return [&random] {
      const double waiting = -std::log(1 - random.uniform());
      return std::round(100 * waiting * waiting);
    };
  });
  EXPECT_NEAR(found.held, 0.95, 0.02);
}

/// As stamps are: one in a thousand is late by up to a hundred times what the others are.
TEST(MeanInterval, HoldsTheTruthWhereRareReadingsDecideTheMean) {
  constexpr double kRare = 0.002, kFar = 20'000;
  const auto found = coverage(3'000, 200 + kRare * kFar / 2, [](Random& random) {
    return [&random] {
      const double usual = 200 * (1 + random.normal());
      return std::round(random.uniform() < kRare ? usual + random.uniform(0, kFar) : usual);
    };
  });
  EXPECT_NEAR(found.held, 0.95, 0.02);
}

TEST(MeanInterval, IsNoNarrowerThanTheTruthAllowsWhereReadingsSwing) {
  const auto found = coverage(3'000, 2, [](Random& random) {
    return [&random, turn = random.uniform(0, 6.28)]() mutable {
      turn += 0.019;
      return std::round(2 + 5 * random.normal() + 4 * std::sin(turn));
    };
  });
  EXPECT_GT(found.held, 0.93);
}

TEST(MeanInterval, RoundingThatTheReadingsDoNotSmoothOutIsInIt) {
  for (const double noise : {0.0, 0.1, 0.3, 0.4}) {
    const auto found = coverage(2'000, 0.25, [noise](Random& random) {
      return [&random, noise] { return std::round(0.25 + noise * random.normal()); };
    });
    EXPECT_GE(found.held, 0.93) << noise;
  }
  Statistics still;
  for (int i = 0; i < 100; ++i) still.add(7);
  EXPECT_EQ(still.mean_interval(), (Interval{6.5, 7.5}));
  Statistics real;
  for (int i = 0; i < 100; ++i) real.add(7.25);
  EXPECT_EQ(real.mean_interval(), (Interval{7.25, 7.25}));
}

TEST(MeanInterval, IsNotStatedOfFewReadingsOrOfOneSlowMovement) {
  Statistics statistics;
  for (int i = 0; i < 15; ++i) statistics.add(i % 2);
  EXPECT_FALSE(statistics.mean_interval());
  statistics.add(1);
  EXPECT_TRUE(statistics.mean_interval());
  statistics.clear();
  EXPECT_FALSE(statistics.mean_interval());
  for (int i = 0; i < 100'000; ++i) statistics.add(i);
  EXPECT_FALSE(statistics.mean_interval());
  const auto hardly = coverage(1'000, 3.3, alike(1'000));
  EXPECT_LT(hardly.stated, 0.25) << "readings that are alike all the time";
}

TEST(MeanInterval, HalvesWithFourTimesAsManyReadings) {
  Random random(1);
  Statistics few, many;
  for (int i = 0; i < 100'000; ++i) (i < 25'000 ? few : many).add(random.normal() * 20);
  for (int i = 0; i < 25'000; ++i) many.add(random.normal() * 20);
  const auto width = [](const Statistics& of) { return of.mean_interval()->high - of.mean_interval()->low; };
  EXPECT_NEAR(width(few), 2 * 2.12 * 20 / std::sqrt(25'000.0), 0.25);
  EXPECT_NEAR(width(many), width(few) / 2, 0.12);
}

}  // namespace
}  // namespace syncline
