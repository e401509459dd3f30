// SPDX-License-Identifier: Apache-2.0
#include "settings/dc_check.h"

#include <gtest/gtest.h>

#include <functional>

#include "config/dc_settings.h"
#include "config/network_config.h"

namespace syncline {
namespace {

NetworkConfig two_slaves() {
  NetworkConfig config;
  config.slaves.resize(2);
  return config;
}

TEST(DcCheck, DefaultsAreFine) { EXPECT_TRUE(check_dc(two_slaves())); }

TEST(DcCheck, NamesTheSettingItsValueAndTheRange) {
  struct Case {
    const char* key;
    const char* words;
    std::function<void(DcMasterSettings&)> break_it;
  };
  const Case cases[] = {
      {"master.dc.delay_rounds", "0 is outside 1..100", [](auto& dc) { dc.delay_rounds = 0; }},
      {"master.dc.delay_difference_ns", "5000 ns is outside 0..1000 ns", [](auto& dc) { dc.delay_difference = 5000; }},
      {"master.dc.burst_bulk", "0 frames is outside 1..1000 frames", [](auto& dc) { dc.burst_bulk = 0; }},
      {"master.dc.sync_window_exponent", "31 is outside 1..30", [](auto& dc) { dc.sync_window.exponent = 31; }},
      {"master.dc.start_time_safety_us", "-1000 us is outside 0..10000000 us",
       [](auto& dc) { dc.start_time_safety = -kMillisecond; }},
      {"master.dc.start_time_grid_us", "2000000 us is outside 0..1000000 us",
       [](auto& dc) { dc.start_time_grid = 2 * kSecond; }},
      {"master.dc.loop.speed_counter_start", "127 is outside 128..16383",
       [](auto& dc) { dc.loop.speed_counter_start = 0x7F; }},
      {"master.dc.loop.filter_depth_difference", "16 is outside 0..15",
       [](auto& dc) { dc.loop.filter_depth_difference = 16; }},
      {"master.dc.reference_clock", "there is no slave at position 2, the last one is at 1",
       [](auto& dc) { dc.reference_clock = 2; }},
  };
  for (const auto& [key, words, break_it] : cases) {
    auto config = two_slaves();
    break_it(config.dc);
    const auto status = check_dc(config);
    ASSERT_FALSE(status) << key;
    EXPECT_EQ(status.error().code, ErrorCode::kBadValue) << key;
    EXPECT_EQ(status.error().subject, key);
    EXPECT_EQ(status.error().detail.text(), words) << key;
    config.dc.enabled = false;
    EXPECT_TRUE(check_dc(config)) << key;
  }
}

}  // namespace
}  // namespace syncline
