// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/standstill_search.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sched.h>
#include <thread>

#include "channels/processor_holder.h"
#include "tests/support/proc_folder.h"

namespace syncline {
namespace {

/// The search has a thread of its own, which counts when it pleases: every look finds the thread having run 3 ms more.
class Standstill : public testing::Test {
 protected:
  Standstill() { run_once_more(); }
  void run_once_more() {
    ++slices_;
    proc_.thread(7, 7, "a name of more than thirty-one letters", true, SCHED_OTHER, 0,
                 fmt::format("{} 0 {}", slices_ * 3 * kMillisecond, slices_));
  }
  /// Looks as often as `looks`, each time after the thread has run once more.
  bool found(StandstillSearch& search, ProcessorHolder& holder, bool noted, int looks) {
    for (int i = 0; i < looks; ++i) {
      run_once_more();
      if (noted) search.note_standstill();
      if (search.read(holder)) return true;
      std::this_thread::yield();
    }
    return false;
  }

  test::ProcFolder proc_;
  std::int64_t slices_ = 0;
  StandstillSearch::Options options_{.priority = 80, .period = std::chrono::milliseconds(1), .proc = proc_.root()};
};

TEST_F(Standstill, FindsWhoKeepsAProcessorLongest) {
  StandstillSearch search(options_);
  ProcessorHolder holder;
  ASSERT_TRUE(found(search, holder, true, 2000));
  EXPECT_TRUE(holder.known());
  EXPECT_EQ(holder.name_text(), "a name of more than thirty-one ");
  EXPECT_TRUE(holder.kernel);
  EXPECT_EQ(holder.at_a_time, 3 * kMillisecond);
  EXPECT_GE(holder.times, 1U);
}

TEST_F(Standstill, LooksForNobodyBeforeThereWasOne) {
  StandstillSearch search(options_);
  ProcessorHolder holder;
  EXPECT_FALSE(found(search, holder, false, 100));
  EXPECT_FALSE(holder.known());
}

TEST(NextSearch, ComesLaterAndLaterWhereTheAnswerStaysTheSame) {
  using std::chrono::seconds;
  std::chrono::milliseconds after = next_search_after(seconds(1), true, seconds(1));
  EXPECT_EQ(after, seconds(1));
  for (const int wanted : {2, 4, 8, 16, 32, 32}) {
    after = next_search_after(after, false, seconds(1));
    EXPECT_EQ(after, seconds(wanted));
  }
  EXPECT_EQ(next_search_after(after, true, seconds(1)), seconds(1));
}

TEST_F(Standstill, EndsAtOnceWhereItsPeriodIsLong) {
  options_.period = std::chrono::hours(1);
  StandstillSearch search(options_);
  search.note_standstill();
}

}  // namespace
}  // namespace syncline
