// SPDX-License-Identifier: Apache-2.0
#include "support/processor_wait.h"

#include <gtest/gtest.h>

namespace syncline {
namespace {

TEST(ProcessorWait, IsTheSecondNumberOfTheLine) {
  EXPECT_EQ(wait_of_schedstat("9038471 310022 512\n"), 310'022);
  EXPECT_EQ(wait_of_schedstat("0 0 0"), 0);
}

TEST(ProcessorWait, IsUnknownWhereTheKernelSaysSomethingElse) {
  for (const char* line : {"", " ", "12", "12 ", "x 1", "12  3", "12 -3 4", "1 99999999999999999999 2"}) {
    EXPECT_EQ(wait_of_schedstat(line), std::nullopt) << line;
  }
}

TEST(ProcessorWait, NeverFalls) {
  ProcessorWait wait;
  const auto first = wait.take();
  if (!first) GTEST_SKIP() << "this kernel does not count how long a thread waits";
  for (int i = 0; i < 100; ++i) EXPECT_GE(wait.take(), first);
}

}  // namespace
}  // namespace syncline
