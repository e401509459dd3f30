// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/wait_until.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QTimer>

namespace syncline::ui {
namespace {

constexpr qint64 kLong = 60'000;

TEST(WaitUntil, SleepsWhileNothingHappens) {
  bool done = false;
  QTimer::singleShot(200, [&done] { done = true; });
  int asked = 0;
  EXPECT_TRUE(waitUntil(
      [&] {
        ++asked;
        return done;
      },
      kLong));
  // Every 10 ms, and after the few events that an application has of its own; without sleep it is thousands of times.
  EXPECT_LT(asked, 200);
}

TEST(WaitUntil, SeesWhatChangesWithoutAnEvent) {
  int asked = 0;
  QElapsedTimer waiting;
  waiting.start();
  EXPECT_TRUE(waitUntil([&] { return ++asked == 3; }, kLong));
  EXPECT_LT(waiting.elapsed(), kLong / 2);
}

TEST(WaitUntil, GivesUpAfterItsTime) {
  EXPECT_FALSE(waitUntil([] { return false; }, 20));
  EXPECT_TRUE(waitUntil([] { return true; }, 0));
}

}  // namespace
}  // namespace syncline::ui
