// SPDX-License-Identifier: Apache-2.0
#include "engine/run_network.h"

#include <gtest/gtest.h>

#include "channels/event.h"
#include "channels/request_desk.h"
#include "engine/opened_link.h"
#include "findings/error_text.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

/// A bring-up on the virtual clock is one step of the master, in which nobody else could take what it measures.
TEST(RunNetwork, KeepsEachCycleOfALongBringUp) {
  test::SimulatedNetwork network;
  network.add(test::io8());
  network.add(test::io8());
  network.project.master.cycle_time = 250 * kMicrosecond;
  network.project.master.dc.dcm.start_delay_ms = 20'000;
  OpenedLink opened;
  opened.clock = std::make_unique<VirtualClock>();
  opened.link = network.link(*opened.clock);
  ASSERT_TRUE(opened.link);
  std::uint64_t next = 0, gaps = 0;
  RunRequest request;
  request.duration = 22 * kSecond;
  request.on_samples = [&](std::span<const CycleSample> samples) {
    for (const auto& sample : samples) {
      gaps += sample.cycle != next ? 1 : 0;
      next = sample.cycle + 1;
    }
  };
  const auto outcome = run_network(network.compiled(), std::move(opened), request);
  ASSERT_TRUE(outcome);
  EXPECT_FALSE(outcome->error);
  EXPECT_EQ(outcome->report.state, AlState::kOp);
  EXPECT_GT(next, 20'000U * 4);
  EXPECT_EQ(next, outcome->report.cycles);
  EXPECT_EQ(gaps, 0U);
}

/// The bus is there, and in the end so is the slave.
TEST(RunNetwork, ATryThatFailsBeforeASlaveIsBackIsNoFailureOfTheRun) {
  test::SimulatedNetwork network;
  for (int i = 0; i < 3; ++i) network.add(test::servo(), "servo-y");
  FaultConfig fault{.kind = FaultKind::kSlaveOff, .slave = 2, .at = 6 * kSecond, .until = 8 * kSecond};
  network.sim.faults.push_back(fault);
  fault = {.kind = FaultKind::kRefuseState, .slave = 2, .at = 7 * kSecond, .until = 11 * kSecond};
  fault.state = AlState::kOp;
  fault.code = 0x0032;
  network.sim.faults.push_back(fault);
  OpenedLink opened;
  opened.clock = std::make_unique<VirtualClock>();
  opened.link = network.link(*opened.clock);
  ASSERT_TRUE(opened.link);
  RunRequest request;
  request.duration = 15 * kSecond;
  std::size_t failures = 0;
  request.on_event = [&](const Event& event) { failures += event.is<events::Failure>() ? 1 : 0; };
  const auto outcome = run_network(network.compiled(), std::move(opened), request);
  ASSERT_TRUE(outcome);
  EXPECT_GT(failures, 0U);
  EXPECT_EQ(outcome->report.state, AlState::kOp);
  EXPECT_FALSE(outcome->error) << describe(*outcome->error);
}

/// There is no number of them that it refuses, and each is answered once, also where the run is over before its turn.
TEST(RunNetwork, AnswersMoreRequestsThanAreUnderWayAtOnce) {
  constexpr std::size_t kMany = 3 * RequestDesk::kCapacity;
  for (const auto duration : {3 * kSecond, 5 * kMillisecond}) {
    test::SimulatedNetwork network;
    network.add(test::io8());
    OpenedLink opened;
    opened.clock = std::make_unique<VirtualClock>();
    opened.link = network.link(*opened.clock);
    ASSERT_TRUE(opened.link);
    std::size_t answered = 0, ended = 0;
    RunRequest request;
    request.duration = duration;
    request.requests.assign(kMany, requests::RegisterRead{0, 0x0130, 2});
    request.on_answer = [&](const SlaveRequest&, const SlaveAnswer& answer) {
      ++(answer.error ? ended : answered);
      if (answer.error) {
        EXPECT_EQ(answer.error->code, ErrorCode::kCancelled) << describe(*answer.error);
      }
    };
    ASSERT_TRUE(run_network(network.compiled(), std::move(opened), request));
    EXPECT_EQ(answered + ended, kMany);
    if (duration == 3 * kSecond) {
      EXPECT_EQ(ended, 0U);
    }
  }
}

}  // namespace
}  // namespace syncline
