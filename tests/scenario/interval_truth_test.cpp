// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/types.h"
#include "tests/scenario/interval_machine.h"

namespace syncline {
namespace {

/// The thousand runs of docs/distributed-clocks.md are those of scripts/soak; so few are right within five of a
/// hundred.
TEST(IntervalTruth, IsInsideInNearly95OfAHundredMachines) {
  for (const auto& found : test::interval_coverage(200, 12 * kSecond, 1)) {
    EXPECT_EQ(found.stated, found.runs) << found.what;
    EXPECT_GE(found.held, 0.91) << found.what;
    EXPECT_LE(found.held, 0.99) << found.what;
    EXPECT_GT(found.mean_width, 0) << found.what;
  }
}

}  // namespace
}  // namespace syncline
