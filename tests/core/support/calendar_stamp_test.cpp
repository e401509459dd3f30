// SPDX-License-Identifier: Apache-2.0
#include "support/calendar_stamp.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <deque>
#include <optional>
#include <utility>

#include "support/clock.h"

namespace syncline {
namespace {

TEST(CalendarStamp, StampsOfTheKernelAreTimesOfOurs) {
  const RealClock clock;
  CalendarStamp stamps(clock);
  const auto before = clock.now();
  const auto calendar = calendar_now();
  const auto after = clock.now();
  const auto stamp = stamps.to_clock(calendar, before);
  ASSERT_TRUE(stamp);
  EXPECT_GE(*stamp, before - 200);
  EXPECT_LE(*stamp, after + 200);
  EXPECT_FALSE(stamps.to_clock(calendar - kSecond, before)) << "before the frame was handed over";
  EXPECT_FALSE(stamps.to_clock(calendar + kSecond, before)) << "in the future";
}

/// Frames of a bus of 1 ms on a host whose calendar is set while they are under way.
class SetCalendar : public ::testing::Test {
 protected:
  [[nodiscard]] Nanoseconds calendar() const { return clock_.now() + ahead_; }
  /// The stamp of a frame that comes now.
  [[nodiscard]] Nanoseconds arrive() { return calendar(); }
  [[nodiscard]] Nanoseconds read(Nanoseconds stamp) { return stamps_.to_clock(stamp); }
  void pass(Nanoseconds time) { clock_.advance_to(clock_.now() + time); }

  VirtualClock clock_;
  Nanoseconds ahead_ = 7 * kSecond;
  ArrivalStamp stamps_{clock_, [this] { return calendar(); }};
};

/// Forwards by less than a second the stamp would be of a time that there was, and wrong by all of it.
TEST_F(SetCalendar, AFrameThatWasStampedBeforeIsOfItsTime) {
  for (const Nanoseconds by : {300 * kMillisecond, -300 * kMillisecond, 5 * kSecond, -3600 * kSecond}) {
    pass(kMillisecond);
    ASSERT_EQ(read(arrive()), clock_.now());
    pass(kMillisecond);
    const auto stamp = arrive();
    const auto arrived = clock_.now();
    pass(20 * kMicrosecond);
    ahead_ += by;
    pass(20 * kMicrosecond);
    EXPECT_EQ(read(stamp), arrived) << by;
    pass(kMillisecond);
    EXPECT_EQ(read(arrive()), clock_.now()) << by;
    pass(3 * kSecond);
  }
}

TEST_F(SetCalendar, FramesThatHaveWaitedSinceBeforeAreOfTheirTimes) {
  pass(kMillisecond);
  ASSERT_EQ(read(arrive()), clock_.now());
  std::deque<std::pair<Nanoseconds, Nanoseconds>> waiting;
  for (int i = 0; i < 20; ++i) {
    pass(kMillisecond);
    if (i == 12) ahead_ += 400 * kMillisecond;
    waiting.emplace_back(arrive(), clock_.now());
  }
  for (const auto& [stamp, arrived] : waiting) EXPECT_EQ(read(stamp), arrived);
}

/// Whatever is set, and when: a time is that of the frame or that of reading; this only where the calendar was set by
/// less than frames have waited, and of those that waited then or came so soon behind that their stamp may be of
/// either.
RC_GTEST_FIXTURE_PROP(SetCalendar, NoStampIsOfAnotherTime, ()) {
  const auto by = *rc::gen::oneOf(rc::gen::inRange<Nanoseconds>(-3 * kSecond, 3 * kSecond),
                                  rc::gen::inRange<Nanoseconds>(-12 * kMillisecond, 12 * kMillisecond));
  RC_PRE(std::abs(by) > 2 * kMicrosecond);  // which is not noticed
  const auto set_at = *rc::gen::inRange(0, 40);
  std::deque<std::pair<Nanoseconds, Nanoseconds>> waiting;
  std::optional<Nanoseconds> noticed;
  for (int i = 0; i < 60; ++i) {
    pass(*rc::gen::inRange<Nanoseconds>(900 * kMicrosecond, 1'100 * kMicrosecond));
    waiting.emplace_back(arrive(), clock_.now());
    if (i == set_at) ahead_ += by;
    pass(*rc::gen::inRange<Nanoseconds>(0, 400 * kMicrosecond));
    const bool busy = i > set_at - 5 && i < set_at + 3 && *rc::gen::inRange(0, 2) != 0;  // the host looks later
    if (!busy && i >= set_at && !noticed) noticed = clock_.now();
    for (; !busy && !waiting.empty(); waiting.pop_front()) {
      const auto& [stamp, arrived] = waiting.front();
      const auto read_as = read(stamp);
      if (std::abs(by) > 2 * kMicrosecond) RC_ASSERT(read_as == clock_.now() || read_as == arrived);
      constexpr Nanoseconds kLongestWait = 10 * kMillisecond;
      if (read_as == arrived) continue;
      RC_ASSERT(std::abs(by) < kLongestWait);
      RC_ASSERT(noticed.has_value());
      RC_ASSERT(arrived <= *noticed + std::abs(by));
    }
  }
}

}  // namespace
}  // namespace syncline
