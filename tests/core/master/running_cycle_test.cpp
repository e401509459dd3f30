// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <vector>

#include "channels/command.h"
#include "channels/cycle_sample.h"
#include "channels/event.h"
#include "channels/frame_ring.h"
#include "channels/image_contents.h"
#include "channels/master_channels.h"
#include "channels/snapshot.h"
#include "cycle_hooks.h"
#include "master/master_service.h"
#include "tests/support/simulated_network.h"
#include "tests/support/small_machines.h"

namespace syncline {
namespace {

/// On the channels, a cycle a step; what the onlooker does between the steps is not counted.
class RunningCycle : public ::testing::Test {
 protected:
  void go_online(const test::SimulatedNetwork& network) {
    service = std::make_unique<MasterService>(std::make_unique<test::UncountedLink>(network.link(clock)), clock);
    service->channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
    service->run_for(5 * kSecond);
    look();
    events.clear();
    ASSERT_EQ(snapshot.state, AlState::kOp);
  }
  void count_for(Nanoseconds duration) {
    const auto end = clock.now() + duration;
    for (int step = 0; clock.now() < end; ++step) {
      {
        const test::CountingCycle counting(counts);
        service->step();
      }
      if (step % 30 == 0) look();
    }
    look();
  }
  void look() {
    auto& channels = service->channels();
    for (auto& event : channels.events.drain()) events.push_back(std::move(event));
    channels.snapshot.read(snapshot);
    samples.clear();
    channels.samples.pop(samples);
  }
  template <class What>
  [[nodiscard]] bool told() const {
    return std::ranges::any_of(events, [](const Event& event) { return event.is<What>(); });
  }

  VirtualClock clock;
  std::unique_ptr<MasterService> service;
  std::vector<Event> events;
  Snapshot snapshot;
  ImageContents image;
  std::vector<CycleSample> samples;
  test::CycleCounts counts;
};

TEST_F(RunningCycle, NeitherAllocatesNorLocks) {
  go_online(test::two_axes());
  count_for(3 * kSecond);
  EXPECT_EQ(counts.allocations, 0U);
  EXPECT_EQ(counts.locks, 0U);
  EXPECT_TRUE(snapshot.slaves[1].sm2_missed.valid) << "mailboxes were asked";
  EXPECT_EQ(snapshot.dc.state, SyncState::kInSync);
}

TEST_F(RunningCycle, NeitherAllocatesNorLocksWhenItHasBadNews) {
  auto network = test::two_axes();
  const auto fault = [&](FaultKind kind, int slave, Nanoseconds at, std::uint32_t count) {
    network.sim.faults.push_back({.kind = kind, .slave = slave, .at = at, .count = count});
  };
  fault(FaultKind::kLoseFrames, -1, 6 * kSecond, 2);
  fault(FaultKind::kBitErrors, 1, 7 * kSecond, 1);
  network.sim.faults.push_back(
      {.kind = FaultKind::kClockStep, .slave = 2, .at = 8 * kSecond, .value_ns = 100 * kMicrosecond});
  go_online(network);
  count_for(6 * kSecond);
  EXPECT_EQ(counts.allocations, 0U);
  EXPECT_EQ(counts.locks, 0U);
  EXPECT_TRUE(told<events::FramesLost>());
  EXPECT_TRUE(told<events::PortErrors>());
  EXPECT_TRUE(told<events::SlavesOutOfSync>());
}

/// Every frame into the ring, also one that is full; who reads it allocates for himself.
TEST_F(RunningCycle, NeitherAllocatesNorLocksWhenItsFramesAreKept) {
  go_online(test::two_axes());
  auto& frames = *service->channels().frames;
  frames.open(FrameRing::WhenFull::kLose, 1U << 16);
  count_for(kSecond);
  EXPECT_GT(frames.lost(), 0U);
  std::uint64_t sent = 0, received = 0;
  const auto count = [&](const RingFrame& frame) { ++(frame.direction == FrameDirection::kSent ? sent : received); };
  frames.read(count);
  const auto lost = frames.lost();
  for (int i = 0; i < 100; ++i) {
    count_for(10 * kMillisecond);
    frames.read(count);
  }
  EXPECT_EQ(frames.lost(), lost);
  EXPECT_GT(sent, 1'000U);
  EXPECT_GT(received, 1'000U);
  EXPECT_EQ(counts.allocations, 0U);
  EXPECT_EQ(counts.locks, 0U);
}

/// What is forced and released by hand, too, and the image that somebody reads.
TEST_F(RunningCycle, NeitherAllocatesNorLocksWhenOutputsAreForced) {
  go_online(test::two_axes());
  for (const MasterCommand& command :
       {MasterCommand(ForceOutputCommand{3, 9, 0x155}), MasterCommand(ReleaseOutputCommand{3, 2}),
        MasterCommand(ReleaseAllOutputsCommand{})}) {
    EXPECT_TRUE(service->channels().commands.ask(command));
    count_for(100 * kMillisecond);
    EXPECT_TRUE(service->channels().commands.take_answer());
    EXPECT_TRUE(service->channels().image.read(image));
    EXPECT_TRUE(told<events::OutputsForced>());
    events.clear();
  }
  EXPECT_EQ(counts.allocations, 0U);
  EXPECT_EQ(counts.locks, 0U);
}

/// Other variables each 0.1 s, in the middle of the cycles.
TEST_F(RunningCycle, NeitherAllocatesNorLocksWhenVariablesAreWatched) {
  go_online(test::two_axes());
  for (std::uint32_t list = 1; list <= 5; ++list) {
    WatchCommand command{list, kMostWatched, {}};
    for (std::uint32_t i = 0; i < kMostWatched; ++i) command.places[i] = {i % 3 == 0, i * 7 + list, 8 + i, 1};
    service->channels().commands.push(command);
    count_for(100 * kMillisecond);
  }
  EXPECT_EQ(counts.allocations, 0U);
  EXPECT_EQ(counts.locks, 0U);
  ASSERT_FALSE(samples.empty());
  EXPECT_EQ(samples.back().watch_list, 5U);
  EXPECT_NE(samples.back().watched_known, 0);
}

/// A slave that is gone, told by its cable, its presence, its state and the working counter. What is done about it a
/// second later, once and between two cycles, is another matter: delays are measured anew.
TEST_F(RunningCycle, NeitherAllocatesNorLocksWhenASlaveGoes) {
  auto network = test::two_axes();
  network.project.master.recovery.automatic = false;
  const auto gone = 6 * kSecond;
  network.sim.faults.push_back({.kind = FaultKind::kSlaveOff, .slave = 2, .at = gone, .until = 100 * kSecond});
  go_online(network);
  count_for(VirtualClock::kDefaultStart + gone + 900 * kMillisecond - clock.now());
  EXPECT_EQ(counts.allocations, 0U);
  EXPECT_EQ(counts.locks, 0U);
  EXPECT_TRUE(told<events::SlaveLost>());
}

TEST(CycleHooks, TheCountingCounts) {
  test::CycleCounts counts;
  std::mutex mutex;
  {
    const test::CountingCycle counting(counts);
    const std::scoped_lock lock(mutex);
    const std::vector<int> memory(100);
    EXPECT_EQ(memory.size(), 100U);
    void* volatile plain = std::malloc(10);
    std::free(plain);
  }
#if !defined(SYNCLINE_SANITIZED)
  EXPECT_EQ(counts.locks, 1U);
  EXPECT_EQ(counts.allocations, 2U);
#else
  EXPECT_EQ(counts.allocations, 1U);
#endif
}

}  // namespace
}  // namespace syncline
