// SPDX-License-Identifier: Apache-2.0
#include "dc/sync_event_account.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace syncline::dc {
namespace {

constexpr Nanoseconds kPeriod = kMillisecond;
constexpr Nanoseconds kFirst = 700'000;

/// What happened to a frame on its way to the slave.
enum class Fate { kGood, kLost, kLate, kLeftOut };

/// A drive that counts as its manual says, and the account that follows it from the master's side.
class Bench {
 public:
  explicit Bench(std::uint32_t limit = 0) : limit_(limit) {
    account.set_limit(limit);
    cycle(Fate::kGood);
    account.read(0);
  }

  /// SYNC0 comes 700 us behind the frame, or 100 us in front of a late one.
  void cycle(Fate fate) {
    const Nanoseconds time = ++number_ * kPeriod;
    fresh_ = fresh_ || fate == Fate::kGood;
    at_sync0(std::exchange(fresh_, fate == Fate::kLate));
    if (fate == Fate::kLeftOut) {
      ++left_out_;
    } else {
      account.observe({time + (fate == Fate::kLate ? 800'000 : 0), fate != Fate::kLost, std::exchange(left_out_, 0)});
    }
  }
  void good(int cycles) {
    for (int i = 0; i < cycles; ++i) cycle(Fate::kGood);
  }
  void read() {
    account.read(counter & 0xFFFF);
    if (!fallen) account.confirm_op();
  }

  SyncEventAccount account{{kFirst, kPeriod}};
  std::uint32_t counter = 0, integrator = 0, highest = 0;
  bool fallen = false;

 private:
  void at_sync0(bool served) {
    if (fallen) return;
    if (served) {
      integrator -= std::min(integrator, 1U);
    } else {
      ++counter;
      integrator += 3;
    }
    highest = std::max(highest, integrator);
    if (limit_ > 0 && integrator >= limit_) {
      fallen = true;
      counter = 0;  // this one's counter ends with OP
    }
  }

  std::uint32_t limit_;
  std::int64_t number_ = 0;
  std::uint32_t left_out_ = 0;
  bool fresh_ = false;
};

std::uint32_t of(const SyncEventAccount& account, MissCause cause) {
  return account.by_cause()[static_cast<std::size_t>(cause)];
}

/// 100 us before SYNC0, where the drive needs 150 us at most.
class TightBench : public ::testing::Test {
 protected:
  TightBench() {
    account.set_limit(9);
    cycle(400'000);
    account.read(0);
  }
  void cycle(Nanoseconds margin) { account.observe({kFirst + ++number_ * kPeriod - margin, true, 0, 150'000}); }
  SyncEventAccount account{{kFirst, kPeriod}};

 private:
  std::int64_t number_ = 0;
};

/// The account begins with the first outputs: what the host left out before them explains no miss behind them.
TEST(SyncEventAccount, WhatWasLeftOutBeforeTheFirstOutputsIsNoCause) {
  SyncEventAccount account{{kFirst, kPeriod}};
  account.observe({kPeriod, true, 7});
  account.read(0);
  account.observe({2 * kPeriod + 800'000, true});  // behind its SYNC0
  account.observe({4 * kPeriod, true});
  account.read(1);
  EXPECT_EQ(account.missed(), 1U);
  EXPECT_EQ(of(account, MissCause::kFrameLate), 1U);
  EXPECT_EQ(of(account, MissCause::kCyclesLeftOut), 0U);
  // One late frame explains one miss: the next one is nobody's.
  std::int64_t number = 4;
  for (const std::uint32_t counter : {2U, 2U}) {
    account.observe({++number * kPeriod, true});
    account.read(counter);
  }
  EXPECT_EQ(of(account, MissCause::kFrameLate), 1U);
  EXPECT_EQ(of(account, MissCause::kUnknown), 1U);
}

/// Outputs that may have been late before it fell explain nothing of what it misses when it is back.
TEST_F(TightBench, DoubtEndsWithOp) {
  cycle(100'000);
  account.left_op();
  account.entered_op({kFirst, kPeriod});
  cycle(400'000);
  account.read(0);
  for (int reading = 0; reading < 3; ++reading) {
    cycle(400'000);
    account.read(1);
  }
  EXPECT_EQ(account.missed(), 1U);
  EXPECT_EQ(of(account, MissCause::kFrameLate), 0U);
  EXPECT_EQ(of(account, MissCause::kUnknown), 1U);
}

/// Of three replies that are lost one after the other the outputs of the second had come: 3, 2, 5, not 3, 6, 9.
TEST(SyncEventAccount, AMissThatWasNoneIsTakenBackFromThePeakWithTheGoodPeriodThatItWas) {
  SyncEventAccount account{{kFirst, kPeriod}};
  account.observe({kPeriod, true});
  account.read(0);
  for (std::int64_t n = 2; n <= 4; ++n) account.observe({n * kPeriod, false});
  account.observe({5 * kPeriod, true});
  account.read(2);
  account.observe({6 * kPeriod, true});
  account.read(2);
  account.observe({7 * kPeriod, true});
  account.read(2);
  EXPECT_EQ(account.missed(), 2U);
  EXPECT_EQ(account.integrator_highest(), 5U);
}

/// `late` cycles after the loss: before its period has ended, before the reading that tells it, and behind that.
TEST(SyncEventAccount, CallsALossHeldUpWhenTheFrameComesAfterAll) {
  for (const int late : {0, 2, 30}) {
    Bench bench;
    bench.good(3);
    bench.cycle(Fate::kLost);
    bench.cycle(Fate::kLost);
    for (int i = 0; i < 40; ++i) {
      if (i == late) bench.account.came_late(1);
      bench.cycle(Fate::kGood);
      if (i % 10 == 5) bench.read();
    }
    EXPECT_EQ(bench.account.missed(), bench.counter) << late;
    EXPECT_EQ(of(bench.account, MissCause::kFrameLost), 1U) << late;
    EXPECT_EQ(of(bench.account, MissCause::kFrameHeldUp), 1U) << late;
  }
}

TEST_F(TightBench, BlamesOutputsThatLeftLessThanTheSlaveNeeds) {
  for (int i = 0; i < 20; ++i) cycle(i == 5 || i == 6 ? 100'000 : 400'000);
  account.read(2);
  account.read(2);
  EXPECT_EQ(of(account, MissCause::kFrameLate), 2U);
  EXPECT_EQ(of(account, MissCause::kUnknown), 0U);
  account.confirm_op();
  EXPECT_EQ(account.integrator_highest(), 6U)
      << "three for each, and no good period between them had anything to take off";
}

TEST_F(TightBench, GoesByTheSync0OfThisStart) {
  account.left_op();
  account.entered_op({kFirst + 300'000, kPeriod});
  for (int i = 0; i < 20; ++i) cycle(100'000);  // 400 us before SYNC0 now
  account.read(1);
  cycle(100'000);
  account.read(1);
  account.read(3);
  cycle(100'000);
  account.read(3);
  EXPECT_EQ(of(account, MissCause::kFrameLate), 0U);
  EXPECT_GT(of(account, MissCause::kUnknown), 0U);
}

TEST_F(TightBench, CountsNoMissThatTheSlaveDoesNotTell) {
  for (int i = 0; i < 20; ++i) cycle(100'000);
  account.read(0);
  account.confirm_op();
  EXPECT_EQ(account.missed(), 0U);
  EXPECT_EQ(account.integrator_highest(), 0U);
}

TEST_F(TightBench, LeavesToTheFirmwareWhatWasInTime) {
  for (int i = 0; i < 20; ++i) cycle(i == 5 ? 100'000 : 400'000);
  account.read(3);
  account.read(3);
  EXPECT_EQ(of(account, MissCause::kFrameLate), 1U);
  EXPECT_EQ(of(account, MissCause::kUnknown), 2U);
}

TEST_F(TightBench, NeverReachesMoreThanTheLimitAtWhichTheSlaveGivesUp) {
  for (int i = 0; i < 60; ++i) cycle(400'000);
  account.read(40);
  cycle(400'000);
  account.read(40);
  account.left_op();
  EXPECT_GE(account.integrator_highest(), 9U);
  EXPECT_LE(account.integrator_highest(), 11U) << "the last miss adds three";
}

TEST(SyncEventAccount, BlamesLostFramesForTheMissesThatTheyCause) {
  Bench bench;
  bench.good(10);
  bench.cycle(Fate::kLost);
  bench.cycle(Fate::kLost);
  bench.good(10);
  bench.read();
  EXPECT_EQ(bench.account.missed(), 2U);
  EXPECT_EQ(bench.account.computed(), 0U);
  EXPECT_EQ(of(bench.account, MissCause::kFrameLost), 2U);
  EXPECT_EQ(bench.account.integrator_highest(), 6U);
  EXPECT_EQ(bench.account.integrator(), 0U);
}

TEST(SyncEventAccount, BlamesTheHostForCyclesThatItLeftOut) {
  Bench bench;
  bench.good(5);
  for (int i = 0; i < 20; ++i) bench.cycle(Fate::kLeftOut);
  bench.good(5);
  bench.read();
  EXPECT_EQ(bench.account.missed(), 20U);
  EXPECT_EQ(of(bench.account, MissCause::kCyclesLeftOut), 20U);
}

TEST(SyncEventAccount, BlamesLatenessForFramesBehindTheirSync0) {
  Bench bench;
  bench.good(5);
  bench.cycle(Fate::kLate);
  bench.good(5);
  bench.read();
  EXPECT_EQ(of(bench.account, MissCause::kFrameLate), 1U);
}

TEST(SyncEventAccount, SaysThatItDoesNotKnowWhereNothingWasSeen) {
  Bench bench;
  bench.good(5);
  bench.counter += 3;  // its firmware lost them
  bench.read();
  bench.good(5);
  bench.read();
  EXPECT_EQ(bench.account.missed(), 3U);
  EXPECT_EQ(of(bench.account, MissCause::kUnknown), 3U);
}

TEST(SyncEventAccount, ForgetsWhatTheSlaveDidNotMiss) {
  Bench bench(9);
  bench.good(5);
  // The answer was lost on its way back: the slave had its outputs.
  for (int i = 0; i < 8; ++i) bench.account.observe({(100 + i) * kPeriod, false, 0});
  bench.account.observe({108 * kPeriod, true, 0});
  bench.read();
  bench.account.observe({109 * kPeriod, true, 0});
  bench.read();
  EXPECT_EQ(bench.account.missed(), 0U);
  EXPECT_EQ(bench.account.integrator_highest(), 0U);
  EXPECT_EQ(bench.account.integrator(), 0U);
}

/// Counters of many slaves are read one after the other, the first time perhaps a second after OP.
TEST(SyncEventAccount, TakesFromTheFirstReadingWhatTheSlaveMissedBefore) {
  for (const std::uint32_t counter : {0U, 1U, 2U, 9U}) {
    SyncEventAccount account({kFirst, kPeriod});
    account.set_limit(9);
    auto cycles = [&, number = 0](int count, bool delivered) mutable {
      for (int i = 0; i < count; ++i) {
        account.observe({number++ * kPeriod, delivered, 0});
        account.confirm_op();
      }
    };
    cycles(5, true);
    cycles(2, false);
    cycles(20, true);
    EXPECT_EQ(account.missed(), 2U) << "nobody has asked the slave";
    EXPECT_EQ(account.integrator_highest(), 6U);
    for (int reading = 0; reading < 3; ++reading) {
      account.read(counter);
      cycles(20, true);
      EXPECT_EQ(account.missed(), std::min(counter, 2U));
    }
    EXPECT_LE(account.integrator_highest(), 3 * account.missed());
    EXPECT_EQ(account.integrator_highest() == 0, account.missed() == 0);
  }
}

/// Answers that were lost behind the slave, which had its outputs: in each cycle it is known to be in OP.
TEST(SyncEventAccount, SaysOfNoErrorCounterThatItReachedWhatTheReadingsTakeBack) {
  Bench bench(9);
  std::int64_t number = 100;
  const auto cycles = [&](int count, bool delivered) {
    for (int i = 0; i < count; ++i) {
      bench.account.observe({number++ * kPeriod, delivered, 0});
      bench.account.confirm_op();
    }
  };
  cycles(5, true);
  bench.read();
  for (int spell = 0; spell < 3; ++spell) {
    cycles(2, false);
    cycles(20, true);
    EXPECT_EQ(bench.account.integrator_highest(), 0U) << "nobody knows yet";
    bench.read();
  }
  cycles(20, true);
  bench.read();
  EXPECT_EQ(bench.account.missed(), 0U);
  EXPECT_EQ(bench.account.integrator_highest(), 0U);
  cycles(1, false);
  cycles(5, true);
  ++bench.counter;
  bench.read();
  EXPECT_EQ(bench.account.missed(), 1U);
  EXPECT_EQ(bench.account.integrator_highest(), 3U);
}

TEST(SyncEventAccount, KeepsWhatMadeTheSlaveFall) {
  Bench bench(9);
  bench.good(50);
  for (int i = 0; i < 6; ++i) bench.cycle(Fate::kLost);
  bench.good(3);
  ASSERT_TRUE(bench.fallen);
  bench.account.left_op();
  bench.read();  // its counter is 0 again
  EXPECT_GE(bench.account.missed(), 3U);
  EXPECT_EQ(bench.account.computed(), bench.account.missed());
  EXPECT_GE(bench.account.integrator_highest(), 9U);
  EXPECT_EQ(of(bench.account, MissCause::kFrameLost), bench.account.missed());
}

TEST(SyncEventAccount, TakesTheCounterOfASlaveThatKeepsItBehindTheFall) {
  Bench bench;
  bench.good(50);
  for (int i = 0; i < 6; ++i) bench.cycle(Fate::kLost);
  bench.good(3);
  bench.account.left_op();
  EXPECT_EQ(bench.account.computed(), 6U);
  bench.account.read(4);
  EXPECT_EQ(bench.account.missed(), 6U) << "two more may have come behind its fall";
  EXPECT_EQ(bench.account.computed(), 2U);
}

TEST(SyncEventAccount, CountsPeriodsNotFramesWhereSync0IsSlower) {
  SyncEventAccount account({kFirst, 4 * kPeriod});
  for (int i = 0; i < 40; ++i) account.observe({i * kPeriod, i % 4 != 2, 0});
  account.read(0);
  EXPECT_EQ(account.missed(), 0U) << "three of four frames are enough";
  EXPECT_EQ(account.integrator(), 0U);
}

TEST(SyncEventAccount, ComputesForASlaveWithoutACounter) {
  SyncEventAccount account({kFirst, kPeriod});
  for (int i = 0; i < 10; ++i) account.observe({i * kPeriod, i != 4, 0});
  EXPECT_EQ(account.missed(), 1U);
  EXPECT_EQ(account.computed(), 1U);
  EXPECT_EQ(account.by_cause()[0], 1U);
}

TEST(SyncEventAccount, ReadingsWithoutACycleBetweenThemWaitForTheirExplanation) {
  Bench bench(9);
  for (int i = 0; i < 2; ++i) {
    bench.cycle(Fate::kLeftOut);
    bench.read();
  }
  bench.good(2);
  EXPECT_FALSE(bench.account.at_limit()) << "each of the two is counted once";
  bench.read();
  EXPECT_EQ(bench.account.missed(), 2U);
  EXPECT_EQ(of(bench.account, MissCause::kCyclesLeftOut), 2U);
}

TEST(SyncEventAccount, FollowsADriveThroughAnyDisturbance) {
  EXPECT_TRUE(rc::check("misses, causes and error counter", [](const std::vector<std::uint8_t>& fates) {
    Bench bench(9);
    std::uint32_t told = 0;
    for (std::size_t i = 0; i < fates.size() && !bench.fallen; ++i) {
      const auto fate = fates[i] % 16;
      bench.cycle(fate < 4 ? static_cast<Fate>(fate) : Fate::kGood);
      if (fates[i] >= 192 && !bench.fallen) {
        bench.read();
        told = bench.counter;
      }
      if (!bench.fallen) RC_ASSERT(bench.account.integrator() <= bench.integrator + 4);
    }
    const bool fallen = bench.fallen;
    if (fallen) {
      bench.good(2);
      bench.account.left_op();
    } else {
      bench.good(2);
      bench.read();
      bench.good(1);
      bench.read();
      told = bench.counter;
    }
    const auto causes = bench.account.by_cause();
    const auto missed = bench.account.missed();
    RC_ASSERT(std::accumulate(causes.begin(), causes.end(), 0U) == missed);
    RC_ASSERT(missed >= told);
    RC_ASSERT(fallen || missed == told);
    RC_ASSERT(fallen || bench.account.integrator_highest() <= 3 * missed);
    RC_ASSERT(fallen || bench.account.integrator_highest() < 9U);
    RC_ASSERT(!fallen || bench.account.integrator_highest() >= 9U);
  }));
}

TEST(SyncEventAccount, CountingRegularCyclesAtOnceIsObservingEach) {
  EXPECT_TRUE(rc::check([] {
    SyncEventAccount each{{kFirst, kPeriod}}, at_once{{kFirst, kPeriod}};
    for (auto* account : {&each, &at_once}) account->set_limit(9);
    Nanoseconds time = 0;
    constexpr Nanoseconds kNone = -1;
    Nanoseconds next = kNone;
    std::int64_t regular = 0;
    const auto settle = [&] { at_once.pass_regular(std::exchange(regular, 0)); };
    for (int i = *rc::gen::inRange(5, 80); i > 0; --i) {
      const bool usual = *rc::gen::inRange(0, 6) != 0;
      time += usual ? kPeriod : *rc::gen::inRange<Nanoseconds>(kPeriod / 10, 3 * kPeriod);
      const SyncEventAccount::Cycle cycle{time, usual || *rc::gen::inRange(0, 2) != 0,
                                          usual ? 0U : *rc::gen::inRange(0U, 2U)};
      each.observe(cycle);
      each.confirm_op();
      const bool quiet =
          cycle.delivered && cycle.left_out == 0 && next != kNone && cycle.time >= next && cycle.time < next + kPeriod;
      if (quiet) {
        next += kPeriod;
        ++regular;
      } else {
        if (regular > 0) settle();
        at_once.observe(cycle);
        at_once.confirm_op();
        next = at_once.regular_until().value_or(kNone);
      }
      if (*rc::gen::inRange(0, 10) == 0) {
        if (regular > 0) settle();
        next = kNone;
        const auto counter = *rc::gen::inRange(0U, 5U);
        for (auto* account : {&each, &at_once}) account->read(counter);
      }
      RC_ASSERT(at_once.missed() == each.missed());
      RC_ASSERT(at_once.by_cause() == each.by_cause());
      RC_ASSERT(at_once.integrator() == each.integrator());
      RC_ASSERT(at_once.integrator_highest() == each.integrator_highest());
    }
  }));
}

/// Nobody has read its counter, and it clears it: its limit proves what it missed at least.
TEST(SyncEventAccount, WhoGivesUpLateHasMissedWhatItsLimitProves) {
  SyncEventAccount account({kFirst, kPeriod});
  account.set_limit(9);
  account.observe({kPeriod, true, 0});
  account.left_op();
  account.gave_up_late();
  EXPECT_EQ(account.missed(), 3U);
  EXPECT_TRUE(account.at_least());
  EXPECT_GE(account.integrator_highest(), 9U);
  EXPECT_EQ(account.by_cause()[static_cast<std::size_t>(MissCause::kFrameLate)], 3U);
  // What was computed up to the limit is enough.
  SyncEventAccount counted({kFirst, kPeriod});
  counted.set_limit(3);
  counted.observe({kPeriod, true, 0});
  counted.observe({3 * kPeriod, true, 1});
  counted.left_op();
  const auto missed = counted.missed();
  ASSERT_GE(missed, 1U);
  counted.gave_up_late();
  EXPECT_EQ(counted.missed(), missed);
  EXPECT_FALSE(counted.at_least());
}

/// Frames that slide through SYNC0 leave less and less: which of them came in time only the drive knows, and it has
/// given up.
TEST(SyncEventAccount, WhoGivesUpWhileItsOutputsWereInDoubtHasMissedSomeOfThem) {
  constexpr Nanoseconds kNeed = 30 * kMicrosecond;
  for (const int doubtful : {2, 3, 5}) {
    SyncEventAccount account({kFirst, kPeriod});
    account.set_limit(9);
    Nanoseconds time = kFirst + kPeriod / 2;
    for (int i = 0; i < 10; ++i, time += kPeriod) account.observe({.time = time, .delivered = true, .need = kNeed});
    account.read(0);
    time += kPeriod / 2 - kNeed / 2;
    for (int i = 0; i < doubtful; ++i, time += kPeriod)
      account.observe({.time = time, .delivered = true, .need = kNeed});
    account.left_op();
    EXPECT_EQ(account.missed(), 0U);
    EXPECT_EQ(account.gave_up_in_doubt(), doubtful >= 3) << doubtful;
    EXPECT_EQ(account.missed(), doubtful >= 3 ? 3U : 0U) << doubtful;
    EXPECT_EQ(account.at_least(), doubtful >= 3) << doubtful;
    EXPECT_EQ(account.integrator_highest(), doubtful >= 3 ? 9U : 0U) << doubtful;
    EXPECT_EQ(account.by_cause()[static_cast<std::size_t>(MissCause::kFrameLate)], doubtful >= 3 ? 3U : 0U);
    // The drive's own counter, when it is read after all, adds only what is more.
    account.read(4);
    EXPECT_EQ(account.missed(), 4U) << doubtful;
  }
}

}  // namespace
}  // namespace syncline::dc
