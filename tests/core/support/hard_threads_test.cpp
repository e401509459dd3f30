// SPDX-License-Identifier: Apache-2.0
#include "support/hard_threads.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/proc_folder.h"

namespace syncline {
namespace {

using test::ProcFolder;
namespace fs = std::filesystem;

constexpr int kOther = 0, kFifo = 1, kRoundRobin = 2, kDeadline = 6;

TEST(HardThreads, AreTheKernelsAndThoseOfAtLeastThePriority) {
  const ProcFolder proc;
  proc.thread(7, 7, "kworker/0:1", true, kOther, 0, "4000000 10 2");
  proc.thread(20, 20, "program", false, kOther, 0, "9000000 0 1");
  proc.thread(20, 21, "less", false, kFifo, 79, "9000000 0 1");
  proc.thread(20, 22, "equal", false, kFifo, 80, "6000000 0 3");
  proc.thread(30, 30, "more", false, kRoundRobin, 99, "1 0 1");
  proc.thread(31, 31, "deadline", false, kDeadline, 0, "1 0 1");
  std::ofstream(proc.root() / "uptime") << "1 2\n";
  std::vector<std::string> names;
  for (const auto& thread : hard_threads(80, proc.root())) names.push_back(thread.name + (thread.kernel ? " k" : ""));
  EXPECT_THAT(names, testing::UnorderedElementsAre("kworker/0:1 k", "equal", "more", "deadline"));
}

TEST(HardThreads, ReadNamesWithParenthesesAndSpaces) {
  const ProcFolder proc;
  proc.thread(7, 7, "a) (b 1 2", true, kOther, 0, "4000000 10 2");
  const auto threads = hard_threads(80, proc.root());
  ASSERT_EQ(threads.size(), 1U);
  EXPECT_EQ(threads[0].name, "a) (b 1 2");
  EXPECT_EQ(threads[0].ran, 4 * kMillisecond);
  EXPECT_EQ(threads[0].slices, 2U);
}

TEST(HardThreads, PassOverWhatCannotBeRead) {
  const ProcFolder proc;
  proc.thread(7, 7, "ended", true, kOther, 0, "");
  proc.thread(8, 8, "whole", true, kOther, 0, "1000 0 1");
  fs::create_directories(proc.root() / "9" / "task" / "9");
  std::ofstream(proc.root() / "9" / "task" / "9" / "stat") << "9 (cut";
  ASSERT_EQ(hard_threads(80, proc.root()).size(), 1U);
  EXPECT_TRUE(hard_threads(80, proc.root() / "nowhere").empty());
}

TEST(LongestAtATime, IsOfWhatRanSinceThen) {
  const std::vector<ThreadRun> before = {{1, "old", true, 100 * kMillisecond, 2}, {2, "now", true, 0, 10}};
  const std::vector<ThreadRun> after = {{1, "old", true, 100 * kMillisecond + 50 * kMicrosecond, 3},
                                        {2, "now", true, 9 * kMillisecond, 13},
                                        {3, "new", true, 2 * kMillisecond, 1}};
  const auto longest = longest_at_a_time(before, after);
  ASSERT_TRUE(longest);
  EXPECT_EQ(longest->name, "now");
  EXPECT_EQ(longest->ran, 9 * kMillisecond);
  EXPECT_EQ(longest->slices, 3U);
}

TEST(LongestAtATime, IsNobodyWhereNobodyRanOrTheNumberIsAnothers) {
  const std::vector<ThreadRun> before = {{1, "a", true, 5 * kMillisecond, 5}, {2, "b", true, 5, 5}};
  EXPECT_FALSE(longest_at_a_time(before, before));
  EXPECT_FALSE(longest_at_a_time(before, std::vector<ThreadRun>{{1, "a", true, kMillisecond, 1}}));
  EXPECT_FALSE(longest_at_a_time(before, {}));
}

TEST(HardThreads, OfThisMachineNeverAreOurOwn) {
  for (const auto& thread : hard_threads(1)) {
    if (!thread.kernel) {
      EXPECT_NE(thread.id, ::getpid()) << thread.name;
    }
  }
}

}  // namespace
}  // namespace syncline
