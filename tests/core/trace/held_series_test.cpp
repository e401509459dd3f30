// SPDX-License-Identifier: Apache-2.0
#include "trace/held_series.h"

#include <gtest/gtest.h>

namespace syncline {
namespace {

constexpr Nanoseconds kHeldFrom = 830'000'000 * kSecond;

/// The moments are looked at in a quarter of a second, as the store does; whether it was known throughout.
bool known_throughout(HeldSeries& held, Nanoseconds from, Nanoseconds to) {
  bool known = true;
  for (auto now = from; now < to; now += kSecond / 4) {
    held.expire(now);
    known = known && held.is_known();
  }
  return known;
}

/// So are the counts in the objects of a hundred drives: each is read through its mailbox once in half a minute.
TEST(HeldSeries, WhatIsReadSeldomIsKnownFromItsThirdReadingOn) {
  HeldSeries held(1024);
  constexpr Nanoseconds kEvery = 30 * kSecond;
  for (int reading = 0; reading < 10; ++reading) {
    const auto time = kHeldFrom + reading * kEvery;
    held.hear(time, static_cast<float>(reading / 4));
    EXPECT_EQ(known_throughout(held, time, time + kEvery), reading >= 2) << reading;
    if (reading == 0) continue;
    EXPECT_NEAR(static_cast<double>(held.interval().value()), static_cast<double>(kEvery), 1);
  }
}

TEST(HeldSeries, WhatIsNoLongerReadEnds) {
  HeldSeries held(1024);
  constexpr Nanoseconds kEvery = 30 * kSecond;
  for (int reading = 0; reading < 5; ++reading) {
    held.hear(kHeldFrom + reading * kEvery, 7);
    (void)known_throughout(held, kHeldFrom + reading * kEvery, kHeldFrom + (reading + 1) * kEvery);
  }
  const auto last = kHeldFrom + 4 * kEvery;
  EXPECT_TRUE(known_throughout(held, last + kEvery, last + 4 * kEvery));
  EXPECT_FALSE(known_throughout(held, last + 4 * kEvery, last + 5 * kEvery));
  EXPECT_NEAR(static_cast<double>(held.heard() - last), 0, 1) << "until then it was known, and no longer";
}

/// A pause, a file transfer through the same mailbox for one, is not how often it is read.
TEST(HeldSeries, APauseMakesNobodyMorePatient) {
  HeldSeries held(1024);
  auto time = kHeldFrom;
  for (int reading = 0; reading < 5; ++reading) held.hear(time += kSecond, 7);
  EXPECT_FALSE(known_throughout(held, time, time + 600 * kSecond));
  for (int reading = 0; reading < 5; ++reading) held.hear(time += reading == 0 ? 600 * kSecond : kSecond, 7);
  EXPECT_TRUE(known_throughout(held, time, time + 5 * kSecond));
  EXPECT_FALSE(known_throughout(held, time + 5 * kSecond, time + 6 * kSecond));
}

/// Who was away tells nothing of how often he is read.
/// While the mailbox of another slave was slow it was read every four seconds, and long since as often as before.
TEST(HeldSeries, ATimeOfSeldomReadingsIsForgotten) {
  HeldSeries held(1024);
  auto time = kHeldFrom;
  for (const auto every : {kSecond, 4 * kSecond, kSecond}) {
    for (int reading = 0; reading < 40; ++reading) held.hear(time += every, 0);
  }
  EXPECT_TRUE(known_throughout(held, time, time + 5 * kSecond));
  EXPECT_FALSE(known_throughout(held, time, time + 6 * kSecond)) << "nothing has come for five seconds";
}

TEST(HeldSeries, AnAbsenceIsNoInterval) {
  HeldSeries held(1024);
  auto time = kHeldFrom;
  for (int round = 0; round < 3; ++round) {
    held.hear(time += 60 * kSecond, 7);
    held.lose(time + kSecond);
  }
  EXPECT_FALSE(held.interval());
  held.hear(time += 60 * kSecond, 7);
  EXPECT_FALSE(known_throughout(held, time, time + 6 * kSecond));
}

}  // namespace
}  // namespace syncline
