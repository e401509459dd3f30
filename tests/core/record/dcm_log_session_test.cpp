// SPDX-License-Identifier: Apache-2.0
#include "record/dcm_log_session.h"

#include <gtest/gtest.h>

#include <vector>

#include "channels/cycle_sample.h"
#include "channels/snapshot.h"
#include "config/network_config.h"

namespace syncline {
namespace {

NetworkConfig config_of(Nanoseconds cycle, Nanoseconds set_value) {
  NetworkConfig config;
  config.cyclic.emplace_back().cycle_time = cycle;
  config.dc.dcm.set_value = set_value;
  return config;
}

CycleSample read_at(Nanoseconds time) {
  CycleSample sample;
  sample.flags = CycleSample::kReferenceValid | CycleSample::kDcmActive;
  sample.send_time = sample.reference_time = time;
  return sample;
}

TEST(DcmLogSession, HoldsWhatTheRunShowedInTheOrderInWhichItWasDrained) {
  std::string text;
  const auto config = config_of(kMillisecond, 400 * kMicrosecond);
  DcmLogSession log(config, [&text](std::string_view more) { text += more; });
  EXPECT_EQ(text, dcm_log_header()) << "before the first cycle";
  log.add(std::vector{read_at(kSecond)});
  Snapshot snapshot;
  snapshot.online = true;
  snapshot.dc.start_time = 5 * kSecond;
  log.add(snapshot);
  log.add(std::vector{read_at(kSecond + kMillisecond)});
  log.add(Snapshot{});  // of a master that is silent
  log.add(std::vector{read_at(kSecond + 2 * kMillisecond)});
  const auto rows = read_dcm_log(text);
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows->size(), 3U);
  EXPECT_EQ((*rows)[0].set_value_ns, 400 * kMicrosecond);
  EXPECT_EQ((*rows)[0].dc_start_time_ns, 0);
  EXPECT_EQ((*rows)[1].dc_start_time_ns, 5 * kSecond);
  EXPECT_EQ((*rows)[2].dc_start_time_ns, 5 * kSecond);
}

TEST(DcmLogSession, GoesOnWhereWhatItIsMadeWithIsTheSame) {
  const DcmLogSession log(config_of(kMillisecond, 400 * kMicrosecond), [](std::string_view) {});
  auto config = config_of(kMillisecond, 400 * kMicrosecond);
  config.dc.dcm.gain_ppt = 7;
  EXPECT_TRUE(log.suits(config));
  EXPECT_FALSE(log.suits(config_of(kMillisecond, 300 * kMicrosecond)));
  EXPECT_FALSE(log.suits(config_of(2 * kMillisecond, 400 * kMicrosecond)));
}

}  // namespace
}  // namespace syncline
