// SPDX-License-Identifier: Apache-2.0
#include "trace/slaves_standing.h"

#include <gtest/gtest.h>

#include <span>

#include "channels/cycle_sample.h"
#include "channels/snapshot.h"
#include "config/network_config.h"
#include "protocol/al_state.h"
#include "trace/sample_store.h"
#include "trace/sync_overview.h"

namespace syncline {
namespace {

constexpr Nanoseconds kStanding = 830'000'000 * kSecond;

CycleSample follower_read(std::int64_t ms, std::int16_t slave) {
  CycleSample sample;
  sample.cycle = static_cast<std::uint64_t>(ms);
  sample.send_time = kStanding + ms * kMillisecond;
  sample.master_state = static_cast<std::uint8_t>(AlState::kOp);
  sample.slaves_sync = SyncState::kInSync;
  sample.slave_position = slave;
  sample.flags = CycleSample::kSlaveFollows;
  return sample;
}

TEST(SlavesStanding, SaysWhoWorksAndWhoIsMissingInTheVerdict) {
  NetworkConfig config;
  config.slaves.resize(4);
  SampleStore store({.slaves = 4});
  OverviewRecorder recorder(4);
  const auto go = [&](std::int64_t ms, std::initializer_list<std::uint16_t> states) {
    const auto one = follower_read(ms, static_cast<std::int16_t>(1 + ms % 2));
    store.append(std::span(&one, 1));
    recorder.add(std::span(&one, 1));
    Snapshot snapshot;
    snapshot.time = one.send_time;
    snapshot.online = true;
    for (const auto state : states) {
      auto& slave = snapshot.slaves.emplace_back();
      slave.present = state != 0;
      slave.al_status = state;
      slave.absent_since = state != 0 ? 0 : one.send_time;
    }
    store.append(snapshot);
  };
  const auto standing = [&] { return slaves_standing(config, store, recorder.overview()); };
  EXPECT_FALSE(standing()) << "nobody has told of a slave";
  for (int ms = 1; ms < 10; ++ms) go(ms, {8, 8, 8, 8});
  ASSERT_TRUE(standing());
  EXPECT_EQ(standing()->in_op, 4U);
  EXPECT_EQ(standing()->silent, 0U);
  EXPECT_EQ(standing()->followers, 2U);
  for (int ms = 10; ms < 20; ++ms) go(ms, {8, 8, 0, 0x14});
  EXPECT_EQ(standing()->slaves, 4U);
  EXPECT_EQ(standing()->in_op, 2U);
  EXPECT_EQ(standing()->silent, 1U);
  EXPECT_EQ(standing()->silent_followers, 1U);
  config.slaves[2].hot_connect.emplace().member_count = 1;
  EXPECT_EQ(standing()->silent, 0U) << "it may be away";
}

}  // namespace
}  // namespace syncline
