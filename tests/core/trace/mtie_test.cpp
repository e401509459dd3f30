// SPDX-License-Identifier: Apache-2.0
#include "trace/mtie.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace syncline {
namespace {

double mtie(const std::vector<double>& x, std::size_t intervals) {
  const std::span<const double> stretch(x);
  const auto octave = static_cast<std::size_t>(std::countr_zero(intervals));
  return mtie_octaves<double>(std::span(&stretch, 1), octave + 1, nullptr).back();
}

/// A window of so many intervals holds both ends of them, and nothing beyond: wherever in a block it begins.
TEST(Mtie, TwoSpikesAreInOneWindowWhereTheyAreNoFurtherApart) {
  for (const std::size_t window : {1U, 2U, 16U, 32U, 64U, 128U, 256U, 512U}) {
    for (std::size_t first = 0; first < 70; first += 3) {
      for (const int more : {-1, 0, 1, 2, 5, 7, 8, 9}) {
        const auto apart = static_cast<std::size_t>(static_cast<int>(window) + more);
        if (apart == 0) continue;
        std::vector<double> x(first + apart + 150, 1);
        x[first] = 11;
        x[first + apart] = -9;
        ASSERT_EQ(mtie(x, window), more <= 0 ? 20 : 10) << window << " at " << first << ", apart " << apart;
      }
    }
  }
}

TEST(Mtie, IsNoNumberBeyondTheStretch) {
  const std::vector<double> x(65, 3);
  EXPECT_EQ(mtie(x, 64), 0);
  EXPECT_TRUE(std::isnan(mtie(x, 128)));
  EXPECT_TRUE(std::isnan(mtie({1}, 1)));
}

}  // namespace
}  // namespace syncline
