// SPDX-License-Identifier: Apache-2.0
#include "dc/sync_verdict.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <vector>

#include "config/dc_settings.h"

namespace syncline::dc {
namespace {

using State = SyncVerdict::State;
using Edge = SyncVerdict::Edge;

constexpr Nanoseconds kVerdictStart = 820'000'000 * kSecond;
constexpr Nanoseconds kStale = 500 * kMillisecond;

/// Three slaves behind a reference clock at position 0, a cycle of 1 ms.
class SyncVerdictTest : public ::testing::Test {
 protected:
  void SetUp() override {
    readings.resize(4);
    for (std::size_t i = 1; i < 4; ++i) readings[i] = {true, false, kVerdictStart, 0};
  }
  [[nodiscard]] static Nanoseconds at(int ms) { return kVerdictStart + ms * kMillisecond; }
  void read(std::size_t slave, int ms, std::int32_t deviation) {
    readings[slave].read = true;
    readings[slave].time = at(ms);
    readings[slave].deviation_ns = deviation;
  }
  Edge cycle(int ms, std::optional<OredReading> ored = {}, bool led = true) {
    return verdict.observe({at(ms), led, readings, ored});
  }
  /// Or-ed values of the followers alone in [from, to) ms; the last edge that was told.
  Edge ored(int from, int to, std::uint32_t magnitude) {
    Edge last = Edge::kNone;
    for (int ms = from; ms < to; ++ms) {
      const auto edge = cycle(ms, OredReading{magnitude, true, true});
      if (edge != Edge::kNone) last = edge;
    }
    return last;
  }
  /// One reading a millisecond, in turn, beside an or-ed value that ors more than the followers.
  Edge in_turn(int from, int to, std::int32_t deviation, std::uint32_t noise = 30'000) {
    Edge last = Edge::kNone;
    for (int ms = from; ms < to; ++ms) {
      read(1 + static_cast<std::size_t>(ms % 3), ms, deviation);
      const auto edge = cycle(ms, OredReading{noise, true, false});
      if (edge != Edge::kNone) last = edge;
    }
    return last;
  }
  SyncWindowSettings settings{true, 7, 1500};
  std::vector<ClockReading> readings;
  SyncVerdict verdict{settings, true, kStale, kVerdictStart};
};

/// Each figure by its own definition, one after the other.
SlavesEvidence weigh_plainly(std::span<const ClockReading> readings, std::uint32_t limit_ns,
                             std::optional<Nanoseconds> within) {
  SlavesEvidence evidence;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const auto& reading = readings[i];
    if (!reading.follows) continue;
    const bool proven_later = within && *within > reading.time, proven = within && *within >= reading.time;
    const auto heard = proven ? *within : reading.time;
    evidence.oldest = evidence.followers == 0 ? heard : std::min(evidence.oldest, heard);
    ++evidence.followers;
    if (!reading.read && !proven) ++evidence.unread;
    if (!reading.read) continue;
    evidence.newest = std::max(evidence.newest, reading.time);
    const bool over = reading.magnitude() > limit_ns;
    if (over && !proven_later) ++evidence.over;
    if (over && proven_later) continue;
    if (evidence.worst >= 0 && reading.magnitude() <= evidence.worst_ns) continue;
    evidence.worst = static_cast<int>(i);
    evidence.worst_ns = reading.magnitude();
  }
  for (const auto& reading : readings) {
    if (evidence.over == 0 || !reading.follows || !reading.read) continue;
    const bool ahead = readings[static_cast<std::size_t>(evidence.worst)].deviation_ns > 0;
    const bool far = reading.magnitude() >= (evidence.worst_ns + 1) / 2;
    if (far && (reading.deviation_ns > 0) == ahead) ++evidence.alike;
  }
  std::size_t as_far = 0;
  for (const auto& reading : readings) {
    if (reading.follows && reading.read && reading.magnitude() >= 0.75 * evidence.worst_ns) ++as_far;
  }
  if (evidence.over > 0 && evidence.over == evidence.followers && as_far == evidence.followers)
    evidence.alike = evidence.followers;
  return evidence;
}

TEST(SyncEvidenceProperty, IsWhatEachFiguresDefinitionSays) {
  EXPECT_TRUE(rc::check("weighed at once and figure by figure", [] {
    const auto small = [](std::int64_t low, std::int64_t high) { return *rc::gen::inRange<std::int64_t>(low, high); };
    std::vector<ClockReading> readings;
    for (auto left = small(0, 8); left > 0; --left) {
      const auto deviation = static_cast<std::int32_t>(*rc::gen::elementOf(
          std::vector<std::int64_t>{0, 20, -20, 127, -127, 128, -128, 3'000, -3'000, INT32_MIN, INT32_MAX}));
      readings.push_back({small(0, 4) > 0, small(0, 4) > 0, small(0, 5), deviation});
    }
    const auto within = small(0, 3) == 0 ? std::nullopt : std::optional<Nanoseconds>(small(0, 5));
    const auto a = weigh(readings, 127, within), b = weigh_plainly(readings, 127, within);
    RC_ASSERT(a == b);
  }));
}

TEST(SyncEvidenceProperty, IsTheSameOutOfWhatHasChangedAsOutOfAll) {
  EXPECT_TRUE(rc::check("changes told, and all looked at", [] {
    const auto small = [](std::int64_t low, std::int64_t high) { return *rc::gen::inRange<std::int64_t>(low, high); };
    const SyncWindowSettings window{true, 7, 3};
    std::vector<ClockReading> readings(static_cast<std::size_t>(small(1, 6)));
    for (auto& reading : readings) reading = {small(0, 4) > 0, false, 0, 0};
    SyncVerdict told(window, true, 10, 0), plain(window, true, 10, 0);
    for (Nanoseconds now = 1; now < 40; ++now) {
      std::vector<std::uint16_t> changed;
      for (std::uint16_t i = 0; i < readings.size(); ++i) {
        if (small(0, 3) > 0) continue;
        changed.push_back(i);
        if (small(0, 8) == 0) continue;  // named, and yet as it was
        const auto deviation = *rc::gen::elementOf(std::vector<std::int32_t>{0, 20, -20, 60, -60, 127, -127, 128});
        readings[i] = {readings[i].follows, true, now, small(0, 6) == 0 ? deviation : deviation / 4};
      }
      const bool others = small(0, 12) == 0;
      if (others) readings.back() = {!readings.back().follows, false, now, 0};
      SyncVerdict::Input input{now, true, readings, {}, {}};
      if (small(0, 6) > 0) input.ored = OredReading{small(0, 9) == 0 ? 128U : 60U, small(0, 9) > 0, small(0, 2) == 0};
      const auto edge = plain.observe(input);
      if (!others) input.changed = changed;
      RC_ASSERT(told.observe(input) == edge && told.state() == plain.state());
      RC_ASSERT(told.evidence() == plain.evidence());
    }
  }));
}

TEST_F(SyncVerdictTest, LimitIsAPowerOfTwoLessOne) { EXPECT_EQ(verdict.limit_ns(), 127U); }

TEST_F(SyncVerdictTest, InSyncAfterTheWholeSettleTime) {
  EXPECT_EQ(ored(0, 100, 5000), Edge::kNone);
  EXPECT_EQ(ored(100, 1600, 127), Edge::kNone);
  EXPECT_EQ(verdict.state(), State::kSettling);
  EXPECT_EQ(ored(1600, 1601, 127), Edge::kInSync);
  EXPECT_EQ(verdict.state(), State::kInSync);
  EXPECT_EQ(verdict.since(), at(1600));
  EXPECT_EQ(verdict.settled_after(), 100 * kMillisecond);
}

TEST_F(SyncVerdictTest, OneReadingBeyondTheLimitStartsTheSettleTimeAgain) {
  ored(0, 1400, 10);
  ored(1400, 1401, 128);
  EXPECT_EQ(ored(1401, 2901, 10), Edge::kNone);
  EXPECT_EQ(ored(2901, 2902, 10), Edge::kInSync);
  EXPECT_EQ(verdict.settled_after(), 1401 * kMillisecond);
}

TEST_F(SyncVerdictTest, OutOfSyncAtOnceAndToldOnce) {
  ored(0, 2000, 10);
  EXPECT_EQ(ored(2000, 2001, 128), Edge::kOutOfSync);
  EXPECT_EQ(verdict.state(), State::kOutOfSync);
  EXPECT_EQ(verdict.since(), at(2000));
  EXPECT_EQ(ored(2001, 2100, 128), Edge::kNone);
  EXPECT_EQ(ored(2100, 3600, 0), Edge::kNone);
  EXPECT_EQ(ored(3600, 3601, 0), Edge::kInSync);
  EXPECT_EQ(verdict.since(), at(3600));
  EXPECT_EQ(verdict.settled_after(), 0);  // of the start
}

TEST_F(SyncVerdictTest, WithoutSettleTimeTheFirstGoodReadingIsEnough) {
  settings.settle_time_ms = 0;
  verdict = SyncVerdict(settings, true, kStale, kVerdictStart);
  EXPECT_EQ(ored(0, 1, 127), Edge::kInSync);
}

TEST_F(SyncVerdictTest, NothingIsSaidWhereNothingIsMonitored) {
  verdict = SyncVerdict(settings, false, kStale, kVerdictStart);
  EXPECT_EQ(in_turn(0, 3000, 900'000), Edge::kNone);
  EXPECT_EQ(verdict.state(), State::kNotMonitored);
  EXPECT_EQ(verdict.evidence().worst_ns, 900'000U);  // though it is seen
}

TEST_F(SyncVerdictTest, WhatIsOredFromOthersAccusesNobody) {
  // Bus shift on a bad host: 30 us of the reference clock against the host are in the or-ed value.
  EXPECT_EQ(in_turn(0, 1600, 40), Edge::kInSync);
  EXPECT_TRUE(verdict.undecided());
  EXPECT_EQ(in_turn(1600, 5000, -90, 400'000), Edge::kNone);
  EXPECT_EQ(verdict.state(), State::kInSync);
}

TEST_F(SyncVerdictTest, AnOwnReadingOverTheLimitDecidesThere) {
  in_turn(0, 1600, 40);
  read(2, 1600, -200);
  EXPECT_EQ(cycle(1600, OredReading{30'000, true, false}), Edge::kOutOfSync);
  EXPECT_EQ(verdict.evidence().over, 1U);
  EXPECT_EQ(verdict.evidence().worst, 2);
  EXPECT_EQ(verdict.evidence().worst_ns, 200U);
}

TEST_F(SyncVerdictTest, AnOredValueWithinTheLimitSaysSoOfAllInEveryMode) {
  in_turn(0, 1600, 40);
  read(2, 1600, 200);
  cycle(1600);
  EXPECT_EQ(verdict.evidence().over, 1U);
  cycle(1601, OredReading{100, true, false});
  EXPECT_EQ(verdict.evidence().over, 0U);
  EXPECT_NE(verdict.evidence().worst_ns, 200U);
  // But not when a follower did not answer it.
  read(2, 1602, 200);
  cycle(1602);
  cycle(1603, OredReading{100, false, false});
  EXPECT_EQ(verdict.evidence().over, 1U);
}

TEST_F(SyncVerdictTest, TheReferenceClockAndThoseInFrontOfItDoNotCount) {
  readings[1].follows = false;
  in_turn(0, 2000, 40);
  readings[0] = {false, true, at(2000), 400'000};
  readings[1] = {false, true, at(2000), -70'000};
  cycle(2000);
  EXPECT_EQ(verdict.state(), State::kInSync);
  EXPECT_EQ(verdict.evidence().followers, 2U);
  EXPECT_EQ(verdict.evidence().worst_ns, 40U);
}

TEST_F(SyncVerdictTest, AllAtOnceToTheSameSideIsTheReferenceClock) {
  in_turn(0, 1600, 40);
  for (std::size_t i = 1; i < 4; ++i) read(i, 1600, 30'000 - static_cast<std::int32_t>(i) * 5'000);
  EXPECT_EQ(cycle(1600), Edge::kOutOfSync);
  EXPECT_TRUE(verdict.evidence().all_alike());
  read(2, 1601, -30'000);
  cycle(1601);
  EXPECT_FALSE(verdict.evidence().all_alike());
  read(2, 1602, 100);
  cycle(1602);
  EXPECT_FALSE(verdict.evidence().all_alike());
}

/// A reference clock that swings: the first one that is over the limit has moved no more than the others.
TEST_F(SyncVerdictTest, OneOfManyThatAreAsFarAwayIsNotToBlame) {
  in_turn(0, 1600, 40);
  const auto limit = static_cast<std::int32_t>(verdict.limit_ns());
  for (std::size_t i = 1; i < 4; ++i) read(i, 1600, i == 2 ? limit + 4 : limit * 3 / 5);
  EXPECT_EQ(cycle(1600), Edge::kOutOfSync);
  EXPECT_EQ(verdict.evidence().over, 1U);
  EXPECT_TRUE(verdict.evidence().all_alike());
  read(3, 1601, limit / 3);
  cycle(1601);
  EXPECT_FALSE(verdict.evidence().all_alike()) << "that one stayed";
}

/// With one over a small window the other is to its side half of the time, and nothing has moved.
TEST(SyncEvidence, OfTwoTheSecondMayBeThereByChance) {
  const std::vector<ClockReading> one_over{{true, true, 1, 16}, {true, true, 1, 9}},
      both{{true, true, 1, 16}, {true, true, 1, 17}};
  EXPECT_FALSE(weigh(one_over, 15, std::nullopt).all_alike());
  EXPECT_EQ(weigh(one_over, 15, std::nullopt).worst, 0);
  EXPECT_TRUE(weigh(both, 15, std::nullopt).all_alike());
}

/// ESCs of both editions of the data sheet on one bus: the same step has two signs.
TEST_F(SyncVerdictTest, TheReferenceClockIsKnownAlsoWhereSignsMeanTwoThings) {
  in_turn(0, 1600, 40);
  for (std::size_t i = 1; i < 4; ++i) read(i, 1600, i == 2 ? -784'000 : 785'000);
  EXPECT_EQ(cycle(1600), Edge::kOutOfSync);
  EXPECT_TRUE(verdict.evidence().all_alike());
}

TEST_F(SyncVerdictTest, EveryFollowerIsHeardBeforeTheSettleTimeBegins) {
  for (int ms = 0; ms < 400; ++ms) {
    read(1 + static_cast<std::size_t>(ms % 2), ms, 10);
    cycle(ms, OredReading{30'000, true, false});
  }
  EXPECT_EQ(verdict.evidence().unread, 1U);
  EXPECT_EQ(in_turn(400, 1890, 10), Edge::kNone);
  EXPECT_EQ(in_turn(1890, 1910, 10), Edge::kInSync);
}

TEST_F(SyncVerdictTest, OldReadingsClaimNothing) {
  in_turn(0, 1600, 10);
  Edge told = Edge::kNone;
  for (int ms = 1600; ms < 2200; ++ms) {
    read(1 + static_cast<std::size_t>(ms % 2), ms, 10);  // slave 3 is silent
    if (const auto edge = cycle(ms); edge != Edge::kNone) told = edge;
  }
  EXPECT_EQ(told, Edge::kUnknown);
  EXPECT_EQ(verdict.state(), State::kUnknown);
  EXPECT_GT(at(2200) - verdict.evidence().oldest, kStale);
  EXPECT_EQ(in_turn(2200, 4000, 10), Edge::kInSync);
}

TEST_F(SyncVerdictTest, NobodyIsInSyncWithAClockThatIsLost) {
  in_turn(0, 1600, 10);
  EXPECT_EQ(cycle(1600, std::nullopt, false), Edge::kUnknown);
  EXPECT_EQ(verdict.state(), State::kUnknown);
  in_turn(1601, 1700, 10);
  EXPECT_EQ(verdict.state(), State::kSettling);
}

TEST_F(SyncVerdictTest, WithoutFollowersThereIsNothingToMonitor) {
  in_turn(0, 1600, 10);
  for (auto& reading : readings) reading.follows = false;
  EXPECT_EQ(cycle(1600), Edge::kNone);
  EXPECT_EQ(verdict.state(), State::kNotMonitored);
}

TEST_F(SyncVerdictTest, BeforeTheFirstTimeInSyncNobodyFallsOutOfIt) {
  EXPECT_EQ(in_turn(0, 1000, 5000), Edge::kNone);
  EXPECT_EQ(verdict.state(), State::kSettling);
}

}  // namespace
}  // namespace syncline::dc
