// SPDX-License-Identifier: Apache-2.0
#include "trace/statistics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <vector>

#include "channels/cycle_sample.h"
#include "trace/csv.h"
#include "trace/histogram.h"

namespace syncline {
namespace {

TEST(SampleCsv, HasAsManyFieldsAsTheHeaderAndNoDecimalComma) {
  const auto* previous = std::setlocale(LC_ALL, "de_DE.UTF-8");
  CycleSample s;
  s.flags = CycleSample::kDcmActive | CycleSample::kReferenceValid;
  s.drift_ppm = 1.5F;
  std::string text;
  append_sample_csv(text, std::vector<CycleSample>{s});
  if (previous != nullptr) std::setlocale(LC_ALL, "C");
  const auto commas = [](const std::string& t) { return std::count(t.begin(), t.end(), ','); };
  EXPECT_EQ(commas(text), commas(sample_csv_header()));
  EXPECT_THAT(text, testing::HasSubstr(",1.5,"));
}

TEST(Statistics, MatchesTheDefinitions) {
  Statistics statistics;
  for (const double value : {3.0, -4.0, 1.0, 4.0}) statistics.add(value);
  EXPECT_DOUBLE_EQ(statistics.mean(), 1.0);
  EXPECT_DOUBLE_EQ(statistics.rms(), std::sqrt((9.0 + 16 + 1 + 16) / 4));
  EXPECT_EQ(statistics.min(), -4.0);
  EXPECT_EQ(statistics.max_magnitude(), 4.0);
}

TEST(Histogram, PercentilesAreWithinABinAndTheMaximumIsExact) {
  Histogram histogram;
  for (std::int64_t value = 1; value <= 100'000; ++value) histogram.add(value);
  EXPECT_EQ(histogram.max(), 100'000);
  EXPECT_EQ(histogram.percentile(1.0), 100'000);
  EXPECT_NEAR(static_cast<double>(histogram.percentile(0.5)), 50'000, 50'000 / 32.0);
  EXPECT_NEAR(static_cast<double>(histogram.percentile(0.999)), 99'900, 100'000 / 32.0);
  std::uint64_t total = 0;
  for (const auto& bin : histogram.bins()) {
    EXPECT_LT(bin.low, bin.high);
    total += bin.count;
  }
  EXPECT_EQ(total, histogram.count());
}

}  // namespace
}  // namespace syncline
