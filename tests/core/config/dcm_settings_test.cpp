// SPDX-License-Identifier: Apache-2.0
#include "config/dcm_settings.h"

#include <gtest/gtest.h>

namespace syncline {
namespace {

TEST(DcmSettings, ZerosOfAChangeLeaveWhatIs) {
  DcmSettings current, change;
  current.gain_ppt = 11;
  current.drift_error_gain = 12;
  current.max_valid_value = 13;
  current.in_sync_limit = 14;
  current.in_sync_settle_time_ms = 15;
  change.gain_ppt = change.drift_error_gain = 0;
  change.max_valid_value = change.in_sync_limit = 0;
  change.in_sync_settle_time_ms = 0;
  change.mode = DcmMode::kMasterShift;
  const auto kept = merge_dcm_settings(current, change);
  EXPECT_EQ(kept.gain_ppt, 11U);
  EXPECT_EQ(kept.drift_error_gain, 12U);
  EXPECT_EQ(kept.max_valid_value, 13);
  EXPECT_EQ(kept.in_sync_limit, 14);
  EXPECT_EQ(kept.in_sync_settle_time_ms, 15U);
  EXPECT_EQ(kept.mode, DcmMode::kMasterShift);
  change.in_sync_limit = 99;
  EXPECT_EQ(merge_dcm_settings(current, change).in_sync_limit, 99);
  EXPECT_EQ(effective_dcm_settings(change).gain_ppt, DcmSettings{}.gain_ppt) << "nothing was set before";
}

/// Two thirds of the cycle; where the outputs come nearer than a tenth in front of that, half of what is left behind
/// them.
TEST(DcmSettings, TheUsualSetValueMakesRoomForTheOutputs) {
  const DcmSettings settings;
  EXPECT_EQ(effective_set_value(settings, 900'000, 0), 600'000);
  EXPECT_EQ(effective_set_value(settings, 900'000, 510'000), 600'000);
  EXPECT_EQ(effective_set_value(settings, 900'000, 510'002), 705'001);
  EXPECT_EQ(effective_set_value(settings, 900'000, 900'000), 600'000) << "no place in the cycle is any better";
  DcmSettings chosen;
  chosen.set_value = 1;
  EXPECT_EQ(effective_set_value(chosen, 900'000, 800'000), 1);
}

}  // namespace
}  // namespace syncline
