// SPDX-License-Identifier: Apache-2.0
#include "config/dcm_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config/project.h"
#include "settings/dc_check.h"
#include "settings/settings_keys.h"

namespace syncline {
namespace {

using ::testing::HasSubstr;

constexpr DcmMode kModes[] = {DcmMode::kOff,
                              DcmMode::kBusShift,
                              DcmMode::kMasterShift,
                              DcmMode::kMasterRefClock,
                              DcmMode::kLinkLayerRefClock,
                              DcmMode::kDcx,
                              DcmMode::kMasterShiftByApp};

TEST(DcmSettings, HaveTheDefaultsOfTheManual) {
  const DcmSettings settings;
  EXPECT_EQ(settings.gain_ppt, 2U);
  EXPECT_EQ(settings.drift_error_gain, 3U);
  EXPECT_EQ(settings.max_valid_value, 3'000);
  EXPECT_EQ(settings.in_sync_limit, 4'000);
  EXPECT_EQ(settings.in_sync_settle_time_ms, 1'500U);
  EXPECT_EQ(effective_set_value(settings, 900'000), 600'000);
}

TEST(DcmSettings, ZerosLeaveWhatIs) {
  DcmSettings current;
  current.gain_ppt = 7;
  current.max_valid_value = 9'000;
  DcmSettings change;
  change.gain_ppt = 0;
  change.drift_error_gain = 5;
  change.max_valid_value = change.in_sync_limit = 0;
  change.in_sync_settle_time_ms = 0;
  const auto merged = merge_dcm_settings(current, change);
  EXPECT_EQ(merged.gain_ppt, 7U);
  EXPECT_EQ(merged.drift_error_gain, 5U);
  EXPECT_EQ(merged.max_valid_value, 9'000);
  EXPECT_EQ(merged.in_sync_limit, 4'000);
  EXPECT_EQ(merged.in_sync_settle_time_ms, 1'500U);
  EXPECT_EQ(effective_dcm_settings(change).gain_ppt, 2U);
}

TEST(DcmSettings, EveryModeHasAName) {
  for (const auto mode : kModes) {
    EXPECT_FALSE(dcm_mode_name(mode).empty());
    EXPECT_EQ(dcm_mode_from_name(dcm_mode_name(mode)), mode);
  }
}

TEST(DcmSettings, OutsideTheirRangesAreRefusedByName) {
  const auto detail_of = [](auto change) {
    DcmSettings settings;
    change(settings);
    const auto status = check_dcm_settings(settings, kMillisecond);
    return status ? std::string() : status.error().subject + ": " + status.error().detail.text();
  };
  EXPECT_EQ(detail_of([](auto&) {}), "");
  EXPECT_EQ(detail_of([](auto& s) { s.gain_ppt = 501; }), "master.dc.gain_ppt: 501 ppt is outside 0..500 ppt");
  EXPECT_EQ(detail_of([](auto& s) { s.set_value = kMillisecond; }),
            "master.dc.set_value_us: 1000 us is outside 0.001..999.999 us");
  EXPECT_THAT(detail_of([](auto& s) { s.set_value = 0; }), HasSubstr("set_value"));
  EXPECT_THAT(detail_of([](auto& s) { s.drift_error_gain = 17; }), HasSubstr("master.dc.drift_error_gain: 17"));
  EXPECT_THAT(detail_of([](auto& s) { s.max_valid_value = -1; }), HasSubstr("master.dc.max_valid_ns: -1 ns"));
  EXPECT_THAT(detail_of([](auto& s) { s.in_sync_limit = 2 * kSecond; }), HasSubstr("in_sync_limit"));
  EXPECT_THAT(detail_of([](auto& s) { s.in_sync_settle_time_ms = 60'001; }), HasSubstr("in_sync_settle"));
  EXPECT_THAT(detail_of([](auto& s) { s.start_delay_ms = 600'001; }), HasSubstr("start_delay"));
}

TEST(DcmSettings, AreSettingsOfTheProject) {
  Project project;
  for (const auto& [key, value] :
       std::initializer_list<std::pair<const char*, const char*>>{{"master.dc.mode", "master-ref-clock"},
                                                                  {"master.dc.gain_ppt", "5"},
                                                                  {"master.dc.drift_error_gain", "1"},
                                                                  {"master.dc.max_valid_ns", "2500"},
                                                                  {"master.dc.control_off", "on"},
                                                                  {"master.dc.standard_loop_values", "on"},
                                                                  {"master.dc.log", "on"}}) {
    const auto status = set_setting(project, key, value);
    ASSERT_TRUE(status) << key << ": " << status.error().detail.text();
  }
  const auto& dcm = project.master.dc.dcm;
  EXPECT_EQ(dcm.mode, DcmMode::kMasterRefClock);
  EXPECT_EQ(dcm.gain_ppt, 5U);
  EXPECT_EQ(dcm.drift_error_gain, 1U);
  EXPECT_EQ(dcm.max_valid_value, 2'500);
  EXPECT_TRUE(dcm.control_off && dcm.standard_loop_values && dcm.log);
  EXPECT_FALSE(set_setting(project, "master.dc.gain_ppt", "501"));
}

TEST(DcmSettings, OnlyModesThatSteerWriteTheReferenceClockInEachCycle) {
  for (const auto mode : kModes) {
    const bool steers = mode != DcmMode::kOff && mode != DcmMode::kMasterShift && mode != DcmMode::kMasterShiftByApp;
    EXPECT_EQ(steers_reference_clock(mode), steers) << dcm_mode_name(mode);
  }
}

}  // namespace
}  // namespace syncline
