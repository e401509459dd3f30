// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <pthread.h>

#include <vector>

#include "config/sim_config.h"
#include "sim/segment/segment.h"

namespace syncline::sim {
namespace {

struct Work {
  std::vector<SimSlaveConfig> slaves;
  SegmentPath path;
};

void* walk(void* argument) {
  auto& work = *static_cast<Work*>(argument);
  const Wiring wiring(work.slaves);
  work.path = segment_path(work.slaves, wiring, all_connected(work.slaves, wiring));
  return nullptr;
}

/// On a stack of 128 KB, which some thousand calls inside one another do not find room on.
TEST(LongLine, TakesNoStack) {
  constexpr std::size_t kSlaves = 4'000;
  Work work;
  for (std::size_t i = 0; i < kSlaves; ++i) {
    SimSlaveConfig slave;
    if (i > 0) slave.parent = static_cast<std::uint16_t>(i - 1);
    slave.parent_port = 1;
    slave.cable_m = 1;
    work.slaves.push_back(slave);
  }
  pthread_attr_t attributes;
  ASSERT_EQ(::pthread_attr_init(&attributes), 0);
  ASSERT_EQ(::pthread_attr_setstacksize(&attributes, 128 * 1024), 0);
  pthread_t thread{};
  ASSERT_EQ(::pthread_create(&thread, &attributes, walk, &work), 0);
  ::pthread_join(thread, nullptr);
  ::pthread_attr_destroy(&attributes);

  const auto& path = work.path;
  ASSERT_EQ(path.passages.size(), 2 * kSlaves - 1);  // the last one is passed once
  EXPECT_FALSE(path.swallowed);
  EXPECT_EQ(path.passages[kSlaves - 1].slave, kSlaves - 1);
  EXPECT_EQ(path.passages.back().slave, 0);
  const double there = 5.0 + kCableDelays.processing, back = 5.0 + kCableDelays.forwarding;
  EXPECT_NEAR(path.return_ns, static_cast<double>(kSlaves) * (there + back) - kCableDelays.forwarding, 1);
}

}  // namespace
}  // namespace syncline::sim
