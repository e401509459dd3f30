// SPDX-License-Identifier: Apache-2.0
#include "trace/setpoint_slips.h"

#include <gtest/gtest.h>

#include "channels/cycle_sample.h"
#include "channels/snapshot.h"

namespace syncline {
namespace {

using Count = SetpointSlips::Count;

constexpr Nanoseconds kSlipsCycle = kMillisecond;
constexpr Nanoseconds kSlipsEpoch = 850'000'000LL * kSecond;

/// Frames pass the reference clock 300 us before the SYNC0 of a slave that is 1 us behind, 20 us before they end.
class SetpointSlipsTest : public testing::Test {
 protected:
  void begin(const Sync0Slave& slave) {
    slaves_ = {slave};
    slips_.emplace(slaves_, kSlipsCycle);
    snapshot_.slaves.resize(1);
    auto& status = snapshot_.slaves[0];
    status.present = status.dc_enabled = true;
    status.al_status = 8;
    status.propagation_delay_ns = 1'000;
    (void)slips_->observe(snapshot_);
  }
  CycleSample frame(int cycle, Nanoseconds late = 0) {
    CycleSample s;
    s.cycle = static_cast<std::uint64_t>(cycle);
    s.reference_time = kSlipsEpoch + cycle * kSlipsCycle - 300'000 + late;
    s.send_time = s.reference_time - 77'000;
    s.sync_base = 5;
    s.flags = CycleSample::kReferenceValid | CycleSample::kSyncBaseValid;
    return s;
  }
  CycleSample lost(int cycle) {
    auto s = frame(cycle);
    s.flags = CycleSample::kFrameLost | CycleSample::kSyncBaseValid;
    s.reference_time = 0;
    return s;
  }
  void pass(int from, int to) {
    for (int cycle = from; cycle < to; ++cycle) (void)slips_->observe(frame(cycle));
  }

  const Sync0Slave every_{kSlipsCycle, 0, 20'000, 1};
  std::vector<Sync0Slave> slaves_;
  std::optional<SetpointSlips> slips_;
  Snapshot snapshot_;
};

TEST_F(SetpointSlipsTest, AFrameThatIsLostLeavesAPeriodEmpty) {
  begin(every_);
  EXPECT_EQ(slips_->count(0), std::nullopt) << "no frame yet";
  pass(0, 10);
  EXPECT_EQ(slips_->count(0), Count{});
  (void)slips_->observe(lost(10));
  (void)slips_->observe(lost(11));
  EXPECT_TRUE(slips_->observe(frame(12)));
  EXPECT_EQ(slips_->count(0), (Count{2, 0}));
  pass(15, 20);
  EXPECT_EQ(slips_->count(0), (Count{4, 0})) << "the host left out two";
}

TEST_F(SetpointSlipsTest, AFrameBehindItsSync0LeavesOneEmptyAndCrowdsTheNext) {
  begin(every_);
  pass(0, 10);
  (void)slips_->observe(frame(10, 300'000 - 21'000 + 4));
  EXPECT_EQ(slips_->count(0), Count{}) << "a nanosecond before it, with the base";
  pass(11, 15);
  (void)slips_->observe(frame(15, 300'000 - 21'000 + 5));
  EXPECT_EQ(slips_->count(0), (Count{1, 0}));
  pass(16, 30);
  EXPECT_EQ(slips_->count(0), (Count{1, 1}));
}

TEST_F(SetpointSlipsTest, WhereSync0IsSlowerAsManyFramesAreDue) {
  begin({2 * kSlipsCycle, 0, 20'000, 2});
  pass(0, 10);
  (void)slips_->observe(lost(10));
  pass(11, 20);
  EXPECT_EQ(slips_->count(0), Count{}) << "the other frame came";
  (void)slips_->observe(lost(20));
  (void)slips_->observe(lost(21));
  (void)slips_->observe(lost(22));
  pass(23, 30);
  EXPECT_EQ(slips_->count(0)->empty, 1U);
}

TEST_F(SetpointSlipsTest, WhereSync0IsFasterNothingIsCounted) {
  begin({kSlipsCycle / 2, 0, 20'000, 0});
  pass(0, 10);
  EXPECT_EQ(slips_->count(0), std::nullopt);
}

TEST_F(SetpointSlipsTest, WhatIsNotKnownEndsACount) {
  const auto slipped = [&] {
    begin(every_);
    pass(0, 10);
    pass(11, 13);
    EXPECT_EQ(slips_->count(0), (Count{1, 0}));
  };
  const auto begins_anew = [&](int next, const char* why) {
    pass(next, next + 5);
    EXPECT_EQ(slips_->count(0), Count{}) << why;
  };
  slipped();
  slips_->begin_anew();
  begins_anew(13, "a gap");

  slipped();
  auto other = frame(13);
  other.sync_base = 6;
  EXPECT_TRUE(slips_->observe(other));
  EXPECT_EQ(slips_->count(0), Count{}) << "another base";

  slipped();
  auto late = frame(13);
  late.flags |= CycleSample::kFrameLate;
  EXPECT_TRUE(slips_->observe(late));
  EXPECT_EQ(slips_->count(0), std::nullopt) << "nobody knows when that one passed";
  begins_anew(14, "behind a late frame");

  slipped();
  auto unread = frame(13);
  unread.flags = CycleSample::kSyncBaseValid;
  (void)slips_->observe(unread);
  EXPECT_EQ(slips_->count(0), std::nullopt);

  slipped();
  auto stepped = frame(13);
  stepped.reference_time += 3 * kSecond;
  (void)slips_->observe(stepped);
  EXPECT_EQ(slips_->count(0), Count{}) << "no 3000 empty periods";

  slipped();
  snapshot_.slaves[0].al_status = 4;
  EXPECT_TRUE(slips_->observe(snapshot_));
  EXPECT_EQ(slips_->count(0), std::nullopt) << "not in OP";

  slipped();
  auto old = frame(13);
  old.flags = CycleSample::kReferenceValid;
  (void)slips_->observe(old);
  EXPECT_EQ(slips_->count(0), std::nullopt) << "a recording without the base";
}

}  // namespace
}  // namespace syncline
