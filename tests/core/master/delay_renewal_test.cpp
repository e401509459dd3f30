// SPDX-License-Identifier: Apache-2.0
#include "master/recovery/delay_renewal.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "channels/command.h"
#include "channels/event.h"
#include "channels/events/clock_events.h"
#include "channels/master_channels.h"
#include "channels/snapshot.h"
#include "master/master_service.h"
#include "tests/support/sample_devices.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

/// A terminal with a branch of one and, behind it, two more: frames pass the branch before they come to those.
class DelayRenewal : public ::testing::Test {
 protected:
  static constexpr std::size_t kSlaves = 4, kBranch = 1;
  VirtualClock clock;
  test::SimulatedNetwork network;
  std::unique_ptr<MasterService> service;
  sim::SimBus* bus = nullptr;
  Snapshot snapshot;
  std::vector<Event> events;

  void SetUp() override {
    for (std::size_t i = 0; i < kSlaves; ++i) {
      network.add(test::io8());
      network.sim.slaves.back().oscillator.ppm = 20.0 * static_cast<double>(i);
    }
    network.sim.slaves[kBranch].cable_m = 60;
    network.sim.slaves[2].parent = 0;
    network.sim.slaves[2].parent_port = 2;
    network.project.slaves[2].previous = PreviousPort{0, 2};
    network.project.master.dc.sync_window.enabled = true;
  }
  void fault(FaultKind kind, int slave, Nanoseconds at, Nanoseconds until) {
    FaultConfig fault;
    fault.kind = kind;
    fault.slave = slave;
    fault.at = at;
    fault.until = until;
    network.sim.faults.push_back(fault);
  }
  void go_online() {
    auto made = sim::SimBus::create(network.sim, clock.now());
    ASSERT_TRUE(made);
    bus = made->get();
    service = std::make_unique<MasterService>(make_simulated_link("sim", std::move(*made), clock), clock);
    service->channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
  }
  /// Since the start.
  void run_until(Nanoseconds time) {
    service->run_for(VirtualClock::kDefaultStart + time - clock.now());
    for (auto& event : service->channels().events.drain()) events.push_back(std::move(event));
    service->channels().snapshot.read(snapshot);
  }
  /// What the clocks really differ by from the first one's, which no register says.
  [[nodiscard]] Nanoseconds truly_off(std::size_t slave) {
    bus->advance_to(clock.now());
    return static_cast<Nanoseconds>(bus->system_time(slave)) - static_cast<Nanoseconds>(bus->system_time(0));
  }
  [[nodiscard]] std::vector<std::size_t> measured() const {
    std::vector<std::size_t> corrected;
    for (const auto& event : events) {
      if (const auto* told = event.as<events::DelaysMeasured>()) corrected.push_back(told->corrected);
    }
    return corrected;
  }
};

TEST_F(DelayRenewal, ThoseBehindABranchThatWentAreRightAgain) {
  fault(FaultKind::kSlaveOff, kBranch, 5 * kSecond, 20 * kSecond);
  go_online();
  run_until(4 * kSecond);
  EXPECT_LT(std::abs(truly_off(3)), 60);
  run_until(6 * kSecond - 100 * kMillisecond);
  EXPECT_GT(std::abs(truly_off(3)), 500);
  EXPECT_LT(std::abs(snapshot.slaves[3].deviation_ns), 60) << "its own reading does not show it";
  run_until(12 * kSecond);
  EXPECT_LT(std::abs(truly_off(2)), 60);
  EXPECT_LT(std::abs(truly_off(3)), 60);
  EXPECT_EQ(measured(), std::vector<std::size_t>{2});
}

TEST_F(DelayRenewal, AndWhenItIsBack) {
  fault(FaultKind::kSlaveOff, kBranch, 5 * kSecond, 12 * kSecond);
  go_online();
  run_until(24 * kSecond);
  EXPECT_EQ(snapshot.state, AlState::kOp);
  for (std::size_t i = 1; i < kSlaves; ++i) EXPECT_LT(std::abs(truly_off(i)), 60) << i;
  EXPECT_EQ(measured().size(), 2U);
}

/// Steps of 0x0928 stay so small that nobody leaves the window for them.
TEST_F(DelayRenewal, NobodyLeavesTheWindowForIt) {
  fault(FaultKind::kSlaveOff, kBranch, 5 * kSecond, 0);
  go_online();
  run_until(6 * kSecond);
  events.clear();
  run_until(14 * kSecond);
  EXPECT_EQ(measured().size(), 1U);
  EXPECT_TRUE(std::ranges::none_of(events, [](const Event& e) { return e.is<events::SlavesOutOfSync>(); }));
}

/// Neither for a branch of some microseconds, nor does it take for ever.
TEST_F(DelayRenewal, NobodyLeavesTheWindowForALongBranch) {
  network.sim.slaves[kBranch].cable_m = 500;
  fault(FaultKind::kSlaveOff, kBranch, 5 * kSecond, 0);
  go_online();
  run_until(6 * kSecond);
  EXPECT_GT(std::abs(truly_off(3)), 4'000);
  std::int32_t furthest = 0;
  for (auto time = 6 * kSecond; time < 10 * kSecond; time += 2 * kMillisecond) {
    run_until(time);
    for (const std::size_t slave : {2U, 3U})
      furthest = std::max(furthest, std::abs(snapshot.slaves[slave].deviation_ns));
  }
  EXPECT_EQ(measured().size(), 1U);
  EXPECT_LE(furthest, 127);
  EXPECT_LT(std::abs(truly_off(3)), 60);
}

/// Where the branch itself is behind all others nothing is to correct, and that is said.
TEST_F(DelayRenewal, TheLastOneChangesNobodysWay) {
  fault(FaultKind::kSlaveOff, 3, 5 * kSecond, 0);
  go_online();
  run_until(12 * kSecond);
  EXPECT_EQ(measured(), std::vector<std::size_t>{0});
  EXPECT_LT(std::abs(truly_off(2)), 60);
}

/// The next one leads, and the others stay where they are by the delays that all have.
TEST_F(DelayRenewal, WhenTheReferenceClockWentTheNextOneCounts) {
  network.project.slaves[0].dc.op_mode.clear();
  network.sim.slaves[0].dc.system_time = false;
  network.sim.slaves[0].device.dc.reset();
  fault(FaultKind::kSlaveOff, kBranch, 5 * kSecond, 0);
  go_online();
  run_until(14 * kSecond);
  ASSERT_EQ(snapshot.dc.reference_clock, 2);
  bus->advance_to(clock.now());
  const auto apart = static_cast<Nanoseconds>(bus->system_time(3) - bus->system_time(2));
  EXPECT_LT(std::abs(apart), 60);
}

TEST_F(DelayRenewal, OneWhoJoinsLaterIsMeasuredAndNotEstimated) {
  network.project.master.recovery.start_incomplete = true;
  network.sim.slaves[3].cable_m = 90;
  fault(FaultKind::kSlaveOff, 3, 0, 6 * kSecond);
  go_online();
  run_until(20 * kSecond);
  ASSERT_EQ(snapshot.state, AlState::kOp);
  EXPECT_LT(std::abs(truly_off(3)), 60);
}

}  // namespace
}  // namespace syncline
