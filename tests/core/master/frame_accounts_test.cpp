// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "channels/command.h"
#include "channels/events/frame_events.h"
#include "channels/master_channels.h"
#include "channels/snapshot.h"
#include "link/fault_link.h"
#include "master/master_service.h"
#include "support/random.h"
#include "tests/support/cases.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

/// A line of terminals behind a link that loses and delays answers while the bus is in OP.
class FrameAccounts : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  VirtualClock clock;
  FaultLink* link = nullptr;
  std::unique_ptr<MasterService> service;
  Snapshot snapshot;
  std::int64_t told_lost = 0, told_late = 0, taken_back = 0;

  void SetUp() override {
    test::SimulatedNetwork network;
    for (int i = 0; i < 3; ++i) network.add(test::io8());
    auto faulty = std::make_unique<FaultLink>(network.link(clock), clock, LinkFaults{});
    link = faulty.get();
    service = std::make_unique<MasterService>(std::move(faulty), clock);
    service->channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
    (void)service->step();
    run(kSecond);
    ASSERT_EQ(snapshot.state, AlState::kOp);
    ASSERT_EQ(snapshot.lost_frames, 0U);
  }
  void run(Nanoseconds duration) {
    service->run_for(duration);
    for (const auto& event : service->channels().events.drain()) {
      if (const auto* lost = event.as<events::FramesLost>()) told_lost += lost->count;
      if (const auto* late = event.as<events::FramesLate>()) told_late += late->count, taken_back += late->told_as_lost;
    }
    service->channels().snapshot.read(snapshot);
  }
  /// Then nothing is under way any more, and all has been told.
  void finish() {
    link->set_faults({});
    run(6 * kSecond);
  }
};

TEST_P(FrameAccounts, AreTrueToTheFrame) {
  link->set_faults(
      {.lose_request = 0.01, .lose_reply = 0.02, .late = 0.03, .late_by = 3 * kMillisecond, .seed = GetParam()});
  run(3 * kSecond);
  finish();
  const auto& injected = link->injected();
  EXPECT_GT(injected.lost, 20U);
  EXPECT_GT(injected.late, 20U);
  EXPECT_EQ(snapshot.lost_frames, injected.lost);
  EXPECT_EQ(snapshot.late_frames, injected.late);
  EXPECT_EQ(told_late, static_cast<std::int64_t>(injected.late));
  EXPECT_EQ(told_lost - taken_back, static_cast<std::int64_t>(injected.lost));
}

TEST_P(FrameAccounts, AreTrueAfterAStandstillOfTheWire) {
  // Longer than the patience with frames that say nothing, shorter than their indices rest.
  link->set_faults({.late = 1, .late_by = 80 * kMillisecond, .seed = GetParam()});
  run(200 * kMillisecond);
  finish();
  EXPECT_EQ(snapshot.lost_frames, 0U);
  EXPECT_EQ(snapshot.late_frames, link->injected().late);
  EXPECT_EQ(told_late, static_cast<std::int64_t>(snapshot.late_frames));
  EXPECT_EQ(told_lost, taken_back);
  EXPECT_GT(taken_back, 0);
}

/// More of them than there are indices, within the time that the index of a frame rests that never comes.
TEST_P(FrameAccounts, AreTrueWhereEachFrameIsLate) {
  link->set_faults({.late = 1, .late_by = 1'200 * kMicrosecond, .seed = GetParam()});
  run(700 * kMillisecond);
  finish();
  EXPECT_GT(link->injected().late, 600U);
  EXPECT_EQ(snapshot.lost_frames, 0U);
  EXPECT_EQ(snapshot.late_frames, link->injected().late);
  EXPECT_EQ(told_late, static_cast<std::int64_t>(snapshot.late_frames));
}

/// What goes out and what comes back, counted by somebody who does not know the master.
class CountedLink final : public Link {
 public:
  struct Counts {
    std::int64_t sent = 0, back = 0;
  };
  CountedLink(std::unique_ptr<Link> inner, Counts& counts) : inner_(std::move(inner)), counts_(counts) {}
  Status send(std::span<const std::uint8_t> frame) override {
    ++counts_.sent;
    return inner_->send(frame);
  }
  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    auto received = inner_->receive(buffer, deadline);
    if (received && received->length > 0) ++counts_.back;
    return received;
  }
  [[nodiscard]] LinkDescription describe() const override { return inner_->describe(); }

 private:
  std::unique_ptr<Link> inner_;
  Counts& counts_;
};

FaultConfig random_fault(Random& random, std::size_t slaves, Nanoseconds at) {
  FaultConfig fault;
  fault.at = at;
  fault.slave = static_cast<int>(random.next() % (slaves + 1)) - 1;
  switch (random.next() % 4) {
    case 0:
      fault.kind = FaultKind::kLoseFrames;
      fault.count = static_cast<std::uint32_t>(1 + random.next() % 30);
      break;
    case 1:
      fault.kind = FaultKind::kBitErrors;
      fault.count = static_cast<std::uint32_t>(1 + random.next() % 5);
      fault.slave = std::max(fault.slave, 0);
      break;
    case 2:
      fault.kind = FaultKind::kCableBreak;
      fault.until = at + static_cast<Nanoseconds>(random.next() % (400 * kMillisecond));
      fault.slave = std::max(fault.slave, 1);
      break;
    default:
      fault.kind = FaultKind::kLoseFrames;
      fault.probability = random.uniform() / 10;
      fault.until = at + 300 * kMillisecond;
      fault.slave = std::max(fault.slave, 0);
      break;
  }
  return fault;
}

TEST(FrameAccountsOfABus, WhatTheEventsTellIsWhatTheBusDropped) {
  std::int64_t all = 0;
  constexpr std::uint64_t kSeeds = test::cases(25);
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Random random(seed);
    test::SimulatedNetwork network;
    const auto slaves = 2 + random.next() % 5;
    for (std::size_t i = 0; i < slaves; ++i) network.add(random.next() % 3 == 0 ? test::servo() : test::io8());
    network.sim.seed = seed;
    for (Nanoseconds at = 9 * kSecond; at < 12 * kSecond;) {
      network.sim.faults.push_back(random_fault(random, slaves, at));
      at += 450 * kMillisecond + static_cast<Nanoseconds>(random.next() % (400 * kMillisecond));
    }
    VirtualClock clock;
    CountedLink::Counts counts;
    auto line = std::make_unique<FaultLink>(network.link(clock), clock, LinkFaults{});
    auto* const faults = line.get();
    MasterService service(std::make_unique<CountedLink>(std::move(line), counts), clock);
    std::int64_t told = 0;
    Snapshot snapshot;
    const auto drain = [&] {
      service.channels().snapshot.read(snapshot);
      for (const auto& event : service.channels().events.drain()) {
        if (const auto* lost = event.as<events::FramesLost>()) told += lost->count;
        if (const auto* late = event.as<events::FramesLate>()) told -= late->told_as_lost;
      }
    };
    const auto begin = clock.now();
    service.channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
    while (clock.now() < begin + 8500 * kMillisecond && service.step()) {
    }
    drain();
    ASSERT_EQ(snapshot.state, AlState::kOp) << "seed " << seed;
    const auto before = counts;
    told = 0;
    if (seed % 3 == 0) {
      faults->set_faults(
          {.late = 0.02, .late_by = static_cast<Nanoseconds>(random.next() % (90 * kMillisecond)), .seed = seed});
    }
    service.run_for(4 * kSecond);
    faults->set_faults({});
    service.run_for(6 * kSecond);
    // Nothing is under way between two cycles, and an event may be held back for some seconds.
    drain();
    const auto truth = (counts.sent - before.sent) - (counts.back - before.back);
    EXPECT_EQ(told, truth) << "seed " << seed;
    EXPECT_EQ(static_cast<std::int64_t>(snapshot.lost_frames), truth) << "seed " << seed;
    all += truth;
  }
  EXPECT_GT(all, 20 * static_cast<std::int64_t>(kSeeds));
}

INSTANTIATE_TEST_SUITE_P(Seeds, FrameAccounts, ::testing::Values(1, 2, 3));

}  // namespace
}  // namespace syncline
