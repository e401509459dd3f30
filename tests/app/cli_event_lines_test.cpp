// SPDX-License-Identifier: Apache-2.0
#include "app/cli/event_lines.h"

#include <gtest/gtest.h>

namespace syncline::cli {
namespace {

class EventLinesTest : public ::testing::Test {
 protected:
  std::vector<std::string> told;
  EventLines lines{[this](const std::string& line) { told.push_back(line); }, true};
  void state(int slave, Nanoseconds time, AlState from = AlState::kInit, AlState to = AlState::kPreop) {
    lines.add({time, slave, events::StateChanged{from, to}});
  }
};

TEST_F(EventLinesTest, WhatHappensToManySlavesAtOneTimeIsOneLine) {
  for (int slave = 1; slave < 100; ++slave) state(slave, kSecond + slave * kMillisecond);
  state(-1, kSecond + 100 * kMillisecond);
  lines.tell_until(2 * kSecond);
  EXPECT_EQ(told, (std::vector<std::string>{"     0.000 s  slaves 1 to 99: INIT -> PREOP",
                                            "     0.099 s  master: INIT -> PREOP"}));
}

TEST_F(EventLinesTest, DifferentThingsAndDifferentTimesAreDifferentLines) {
  state(0, 0);
  state(1, 0, AlState::kPreop, AlState::kSafeop);
  state(2, 10 * kMillisecond);
  state(4, 20 * kMillisecond);
  state(7, kSecond);
  lines.tell_all();
  EXPECT_EQ(told, (std::vector<std::string>{"     0.000 s  slaves 0, 2 and 4: INIT -> PREOP",
                                            "     0.000 s  slave 1: PREOP -> SAFEOP",
                                            "     1.000 s  slave 7: INIT -> PREOP"}));
}

TEST_F(EventLinesTest, ALineWaitsForWhatBelongsToIt) {
  state(0, 0);
  lines.tell_until(50 * kMillisecond);
  EXPECT_TRUE(told.empty());
  state(1, 60 * kMillisecond);
  lines.tell_until(300 * kMillisecond);
  EXPECT_EQ(told.size(), 1U);
}

TEST_F(EventLinesTest, TheSameSlaveTwiceIsTwoLines) {
  state(3, 0);
  state(3, kMillisecond);
  lines.tell_all();
  EXPECT_EQ(told.size(), 2U);
}

TEST_F(EventLinesTest, NoTimeRunsBackwardsUnsaid) {
  state(0, 0);
  state(1, kSecond + 50 * kMillisecond);
  lines.add({kSecond, -1, events::FramesLost{3}});  // counted from then on, told now
  lines.tell_until(2 * kSecond);
  lines.add({kSecond + 10 * kMillisecond, -1, events::FramesLost{2}});
  lines.tell_all();
  EXPECT_EQ(told, (std::vector<std::string>{"     0.000 s  slave 0: INIT -> PREOP", "     1.000 s  3 frames lost",
                                            "     1.050 s  slave 1: INIT -> PREOP",
                                            "     1.010 s  2 frames lost (told afterwards)"}));
}

TEST_F(EventLinesTest, VerbsFollowTheirNumber) {
  for (int slave = 3; slave < 6; ++slave) lines.add({0, slave, events::SlaveLost{}});
  lines.tell_all();
  EXPECT_EQ(told.front(), "     0.000 s  slaves 3 to 5 do not answer");
}

TEST(EventLines, UnfoldedEveryEventIsALineAtOnce) {
  std::vector<std::string> told;
  EventLines lines([&](const std::string& line) { told.push_back(line); }, false);
  for (int slave = 0; slave < 3; ++slave) lines.add({0, slave, events::SlaveLost{}});
  EXPECT_EQ(told,
            (std::vector<std::string>{"     0.000 s  slave 0 does not answer", "     0.000 s  slave 1 does not answer",
                                      "     0.000 s  slave 2 does not answer"}));
}

TEST(SlavesText, NamesRunsAndSingles) {
  EXPECT_EQ(slaves_text({5}), "slave 5");
  EXPECT_EQ(slaves_text({2, 1}), "slaves 1 and 2");
  EXPECT_EQ(slaves_text({9, 1, 4, 8, 7}), "slaves 1, 4 and 7 to 9");
}

}  // namespace
}  // namespace syncline::cli
