// SPDX-License-Identifier: Apache-2.0
#include "advice/clock_candidates.h"

#include <gtest/gtest.h>

#include "tests/support/sample_devices.h"

namespace syncline {
namespace {

TEST(ClockCandidates, SayWhatSpeaksAgainstASlave) {
  auto machine = sample::project({sample::digital_input(), sample::servo(), sample::servo(), sample::servo()});
  machine.slaves[0].device.dc.reset();
  machine.slaves[3].optional = true;
  const auto candidates = clock_candidates(machine);
  ASSERT_EQ(candidates.size(), 4U);
  EXPECT_EQ(candidates[0].concern, ClockConcern::kNoClock);
  EXPECT_FALSE(candidates[0].capable());
  EXPECT_EQ(candidates[1], ClockCandidate{});
  EXPECT_EQ(candidates[2], (ClockCandidate{ClockConcern::kBehindFollower, 1}));
  EXPECT_TRUE(candidates[2].capable()) << "it can, unwise as it is";
  EXPECT_EQ(candidates[3].concern, ClockConcern::kMayBeMissing);
}

TEST(ClockCandidates, OnlyThoseWithSyncSignalsAreFollowers) {
  auto machine = sample::project({sample::servo(), sample::servo()});
  machine.slaves[0].dc.op_mode.clear();
  EXPECT_EQ(clock_candidates(machine)[1], ClockCandidate{});
}

}  // namespace
}  // namespace syncline
