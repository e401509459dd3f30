// SPDX-License-Identifier: Apache-2.0
#include "master/clocks/told_time.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "support/random.h"

namespace syncline {
namespace {

/// What is believed of a clock, by how much it is wrong, and what is told then.
struct Talk {
  ToldTime told;
  Nanoseconds time = kSecond;
  Nanoseconds say(Nanoseconds error, bool answered = true) {
    time += kMillisecond;
    const auto said = told.tell(time + error) - time;
    told.observe(answered ? std::optional(time) : std::nullopt);
    return said;
  }
};

TEST(ToldTime, TheNextFrameMakesGoodWhatOneHasToldTooMuch) {
  Talk talk;
  EXPECT_EQ(talk.say(700), 700);
  EXPECT_EQ(talk.say(0), -700);
  EXPECT_EQ(talk.say(0), 0);
}

TEST(ToldTime, WhatIsAlwaysWrongIsToldOnce) {
  Talk talk;
  EXPECT_EQ(talk.say(-12'000), -12'000);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(talk.say(-12'000), 0);
  EXPECT_NEAR(static_cast<double>(talk.told.tell_between(0)), 12'000.0, 100.0);
}

TEST(ToldTime, InTheSumOnlyTheLastErrorRemains) {
  Talk talk;
  Random random(3);
  Nanoseconds sum = 0, last = 0;
  for (int i = 0; i < 1'000; ++i) {
    last = static_cast<Nanoseconds>(random.normal() * 2'000);
    sum += talk.say(last);
    ASSERT_EQ(sum, last);
  }
}

TEST(ToldTime, NobodyWhoAnswersIsOwedAnything) {
  Talk talk;
  talk.say(700);
  talk.say(900, false);
  EXPECT_EQ(talk.say(0), 0);
}

TEST(ToldTime, AClockThatStepsIsNotAnsweredBySeconds) {
  Talk talk;
  talk.say(5 * kSecond);
  EXPECT_EQ(talk.say(0), -100 * kMicrosecond);
  EXPECT_EQ(talk.say(0), 0);
}

}  // namespace
}  // namespace syncline
