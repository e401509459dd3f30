// SPDX-License-Identifier: Apache-2.0
// What is said of the master synchronisation, held against machines whose clocks are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "app/cli/cli.h"
#include "app/cli/event_text.h"
#include "channels/command.h"
#include "channels/master_channels.h"
#include "channels/snapshot.h"
#include "dc/master_verdict.h"
#include "master/master_service.h"
#include "protocol/dcm_error.h"
#include "tests/support/event_match.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

/// A coupler's place is taken by a terminal with a clock; two drives behind it. Quartzes in ppm against the host.
struct Machine {
  Machine(DcmMode mode, double reference_ppm) {
    network.add(test::io8());
    network.add(test::servo(), "servo-y");
    network.add(test::servo(), "servo-y");
    const double ppm[] = {reference_ppm, 31.4, -22.8};
    for (std::size_t i = 0; i < network.sim.slaves.size(); ++i) network.sim.slaves[i].oscillator.ppm = ppm[i];
    network.project.master.dc.dcm.mode = mode;
    network.project.master.dc.sync_window.enabled = true;
  }
  void clock_step(int slave, Nanoseconds at, Nanoseconds by) {
    FaultConfig fault;
    fault.kind = FaultKind::kClockStep;
    fault.slave = slave;
    fault.at = at;
    fault.value_ns = by;
    network.sim.faults.push_back(fault);
  }
  void run(Nanoseconds duration, const std::function<void(MasterService&)>& half_way = {}) {
    clock.set_wakeup_jitter(jitter, 7);
    start = clock.now();
    auto bus = sim::SimBus::create(network.sim, start);
    ASSERT_TRUE(bus);
    auto link = make_simulated_link("sim", std::move(*bus), clock, SimulatedHost{jitter.stamp_error, 9});
    MasterService service(std::move(link), clock);
    service.channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
    service.run_for(half_way ? duration / 2 : duration);
    if (half_way) {
      half_way(service);
      service.run_for(start + duration - clock.now());
    }
    for (auto& event : service.channels().events.drain()) events.push_back(std::move(event));
    service.channels().snapshot.read(snapshot);
  }
  [[nodiscard]] std::string log() const {
    std::string text;
    for (const auto& event : events) text += cli::event_text(event, start) + "\n";
    return text;
  }

  VirtualClock clock;
  test::SimulatedNetwork network;
  JitterProfile jitter = JitterProfile::quiet();
  Nanoseconds start = 0;
  std::vector<Event> events;
  Snapshot snapshot;
};

constexpr DcmMode kShifts[] = {DcmMode::kBusShift, DcmMode::kMasterShift};

TEST(MasterSyncTruth, NoSyncBesideAnError) {
  for (const double ppm : {-731.0, 690.0}) {
    Machine machine(DcmMode::kMasterShift, ppm);
    machine.run(8 * kSecond);
    EXPECT_EQ(machine.snapshot.dcm.error_code, dc::kDcmErrorDriftTooHigh);
    EXPECT_NE(machine.snapshot.dcm.state, SyncState::kInSync);
    EXPECT_NE(machine.snapshot.state, AlState::kOp);
  }
}

TEST(MasterSyncTruth, AStepOfTheReferenceClockIsToldWithinMillisecondsAndSpoilsNoDrift) {
  for (const auto mode : kShifts) {
    for (const Nanoseconds step : {Nanoseconds{-43'210}, Nanoseconds{20'500}, 2 * kMillisecond}) {
      Machine machine(mode, 31);
      machine.clock_step(0, 9'123 * kMillisecond, step);
      machine.run(14 * kSecond);
      const auto out = std::ranges::find_if(machine.events, [](const Event& e) {
        return test::with(&events::MasterOutOfSync::obstacle, dc::SyncObstacle::kClockStep)(e);
      });
      ASSERT_NE(out, machine.events.end()) << machine.log();
      EXPECT_NEAR(static_cast<double>(out->time - machine.start - 9'123 * kMillisecond), 3e6, 3e6) << machine.log();
      EXPECT_NEAR(static_cast<double>(out->as<events::MasterOutOfSync>()->error), static_cast<double>(step), 1'000);
      EXPECT_NEAR(machine.snapshot.dcm.drift_ppm, mode == DcmMode::kMasterShift ? 31 : 0, 1);
      EXPECT_EQ(machine.snapshot.dcm.state, SyncState::kInSync) << machine.log();
    }
  }
}

TEST(MasterSyncTruth, NaturalDriftWithControlOffInEveryMode) {
  for (const auto mode : {DcmMode::kBusShift, DcmMode::kMasterShift, DcmMode::kMasterRefClock}) {
    for (const double ppm : {-97.3, 41.9}) {
      Machine machine(mode, ppm);
      machine.network.project.master.dc.dcm.control_off = true;
      machine.run(10 * kSecond);
      EXPECT_NEAR(machine.snapshot.dcm.drift_ppm, ppm, 0.5) << dcm_mode_name(mode);
    }
  }
}

TEST(MasterSyncTruth, NaturalDriftWhenControlIsSwitchedOffWhileItRuns) {
  for (const auto mode : {DcmMode::kBusShift, DcmMode::kMasterShift}) {
    Machine machine(mode, -64.2);
    machine.run(16 * kSecond, [mode](MasterService& service) {
      DcmSettings change;
      change.mode = mode;
      change.control_off = true;
      service.channels().commands.push(ConfigureDcmCommand{change});
    });
    // What the time control loop had been told before is rounded to its counts, of some 0.01 ppm.
    EXPECT_NEAR(machine.snapshot.dcm.drift_ppm, -64.2, 1) << dcm_mode_name(mode);
  }
}

TEST(MasterSyncTruth, DriftIsTrueAfterHalfAMinuteWithAHostsJitter) {
  for (const auto& jitter : {JitterProfile::quiet(), JitterProfile::desktop()}) {
    for (const double ppm : {-71.83, 24.46}) {
      Machine machine(DcmMode::kMasterShift, ppm);
      machine.jitter = jitter;
      machine.run(30 * kSecond);
      EXPECT_NEAR(machine.snapshot.dcm.drift_ppm, ppm, 0.5);
    }
  }
}

TEST(MasterSyncTruth, TheClockThatIsSaidToLeadLeads) {
  Machine machine(DcmMode::kMasterShift, 12);
  machine.run(6 * kSecond);
  EXPECT_NEAR(machine.snapshot.dcm.drift_ppm, 12, 1);
  // Frames and commands of a file in which the first clock leads, and the user's wish on top of it.
  Machine other(DcmMode::kMasterShift, 12);
  auto file = other.network.compiled();
  file.dc.reference_clock = 1;
  auto bus = sim::SimBus::create(other.network.sim, other.clock.now());
  MasterService service(make_simulated_link("sim", std::move(*bus), other.clock), other.clock);
  service.channels().commands.push(GoOnlineCommand{file, AlState::kOp});
  service.run_for(6 * kSecond);
  service.channels().snapshot.read(other.snapshot);
  EXPECT_EQ(other.snapshot.dc.reference_clock, 1);
  EXPECT_NEAR(other.snapshot.dcm.drift_ppm, 31.4, 1) << "the quartz of the slave that leads";
}

TEST(MasterSyncTruth, HealthyOnADesktop) {
  for (const auto mode : kShifts) {
    Machine machine(mode, -17);
    machine.jitter = JitterProfile::desktop();
    machine.run(12 * kSecond);
    EXPECT_EQ(machine.snapshot.state, AlState::kOp) << machine.log();
    EXPECT_EQ(machine.snapshot.dc.state, SyncState::kInSync) << machine.log();
    EXPECT_EQ(machine.snapshot.dcm.state, SyncState::kInSync) << machine.log();
  }
}

}  // namespace
}  // namespace syncline
