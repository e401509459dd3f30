// SPDX-License-Identifier: Apache-2.0
#include "trace/named_signal.h"

#include <gtest/gtest.h>

#include <vector>

#include "trace/sample_store.h"

namespace syncline {
namespace {

TEST(NamedSignal, IsOfTheBusOfASlaveOrAVariable) {
  SampleStore store({.slaves = 2});
  WatchedVariable position;
  position.name = "Drive.Position@1";
  position.data_type = "DINT";
  position.bit_size = 32;
  ASSERT_TRUE(store.watch(std::vector{position}));
  EXPECT_EQ(named_signal("dcm_error_ns", store), (NamedSignal{Signal::kDcmError, 0}));
  EXPECT_EQ(named_signal("deviation_ns", store), (NamedSignal{Signal::kDeviation, 0}));
  EXPECT_EQ(named_signal("deviation_ns@1", store), (NamedSignal{Signal::kSlaveDeviation, 1}));
  EXPECT_EQ(named_signal("al_status@0", store), (NamedSignal{Signal::kAlState, 0}));
  EXPECT_EQ(named_signal("Drive.Position@1", store), (NamedSignal{Signal::kVariable, 0}));
  for (const auto* none :
       {"", "@", "deviation", "deviation_ns@2", "deviation_ns@", "deviation_ns@-1", "deviation_ns@1x",
        "deviation_ns@1@1", "dcm_error_ns@0", "al_status", "flags", "variable", "Drive.Position"})
    EXPECT_FALSE(named_signal(none, store)) << none;
}

}  // namespace
}  // namespace syncline
