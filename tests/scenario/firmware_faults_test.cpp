// SPDX-License-Identifier: Apache-2.0
// Firmware that hangs or is slow, injected at random into random machines: each must give a finding that names the
// slave, one that hangs or is slow an event, too.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "app/cli/event_text.h"
#include "support/random.h"
#include "tests/support/cases.h"
#include "tests/support/diagnosed_run.h"
#include "tests/support/event_match.h"
#include "tests/support/own_devices.h"

namespace syncline {
namespace {

constexpr int kInjections = test::cases(17);

struct FirmwareKind {
  FaultKind fault;
  Nanoseconds least, most;  // value, where the kind has one
  bool lasts;               // for good, else for some seconds
};

/// Has no inputs by which one could tell that it works.
DeviceDescription out8(bool with_dc) {
  auto device = test::io8();
  device.type = device.name = "out8";
  device.identity.product_code = 0x0110;
  device.fmmus.pop_back();
  device.sync_managers.pop_back();
  device.tx_pdos.clear();
  if (!with_dc) device.dc.reset();
  return device;
}

class FirmwareFaults : public ::testing::TestWithParam<FirmwareKind> {};

TEST_P(FirmwareFaults, AreToldByNameOfTheSlave) {
  const auto kind = GetParam();
  int silent = 0;
  for (int i = 0; i < kInjections; ++i) {
    Random random(static_cast<std::uint64_t>(1000 + i));
    test::DiagnosedRun machine;
    machine.network.sim.seed = random.next();
    const auto count = 2 + random.next() % 5;
    for (std::size_t slave = 0; slave < count; ++slave) {
      switch (random.next() % 5) {
        case 0:
          machine.network.add(sample::own("SL-XE2"), "drive-c");
          break;
        case 1:
          machine.network.add(sample::own("SL-6751"), "can-gateway");
          break;
        case 2:
          machine.network.add(test::io8());
          break;
        case 3:
          machine.network.add(out8(random.next() % 2 == 0));
          break;
        default:
          machine.network.add(test::servo(), "servo-y");
          break;
      }
    }
    const bool needs_mailbox = kind.fault == FaultKind::kMailboxSilence || kind.fault == FaultKind::kSlowMailbox;
    std::vector<int> able;
    for (std::size_t slave = 0; slave < count; ++slave) {
      const auto& config = machine.network.sim.slaves[slave].device;
      if (!config.device_emulation() && (!needs_mailbox || config.mailbox)) able.push_back(static_cast<int>(slave));
    }
    if (able.empty()) {
      able.push_back(static_cast<int>(count));
      machine.network.add(test::servo(), "servo-y");
    }
    const int victim = able[random.next() % able.size()];
    const auto at = 6 * kSecond + static_cast<Nanoseconds>(random.next() % (2 * kSecond));
    auto& fault = machine.fault(kind.fault, at, victim);
    if (kind.most > 0)
      fault.value_ns =
          kind.least + static_cast<Nanoseconds>(random.next() % static_cast<std::uint64_t>(kind.most - kind.least));
    // A mailbox is asked again when the request before has timed out: some of them must pass.
    const auto shortest = needs_mailbox ? 24 * kSecond : 2 * kSecond;
    if (!kind.lasts) fault.until = at + shortest + static_cast<Nanoseconds>(random.next() % (2 * kSecond));
    machine.run(kind.lasts || !needs_mailbox ? 16 * kSecond : 40 * kSecond);
    const bool event =
        needs_mailbox || std::ranges::any_of(machine.events, [&](const Event& e) {
          const bool wanted = kind.fault != FaultKind::kSlowApplication ||
                              test::with(&events::StaleProcessData::begun, true)(e) ||
                              test::with(&events::LongCycles::begun, true)(e);
          return wanted && e.slave == victim && e.time > 0 && e.time - machine.report.history.begin > 5 * kSecond;
        });
    const bool finding = std::ranges::any_of(
        machine.findings, [&](const Finding& f) { return f.place.slave == victim && f.severity != Severity::kNote; });
    if (event && finding) continue;
    ++silent;
    std::string events;
    for (const auto& e : machine.events) {
      if (e.time - machine.report.history.begin > 5 * kSecond)
        events += cli::event_text(e, machine.report.history.begin) + "\n";
    }
    ADD_FAILURE() << "injection " << i << " into slave " << victim << " ("
                  << machine.network.sim.slaves[static_cast<std::size_t>(victim)].device.type << "), value "
                  << fault.value_ns << " ns: event " << event << ", finding " << finding << "\n"
                  << events << machine.said();
  }
  EXPECT_EQ(silent, 0) << "of " << kInjections;
}

TEST(SlowFirmware, ATerminalWithoutMailboxIsNamedWithWhenItBeganAndEnded) {
  test::DiagnosedRun machine;
  for (int i = 0; i < 3; ++i) machine.network.add(test::io8());
  auto& fault = machine.fault(FaultKind::kSlowApplication, 6 * kSecond, 1);
  fault.value_ns = 2'500'000;
  fault.until = 8 * kSecond;
  machine.run(12 * kSecond);
  std::vector<std::pair<int, bool>> told;
  for (const auto& event : machine.events) {
    if (const auto* inputs = event.as<events::StaleProcessData>()) told.emplace_back(event.slave, inputs->begun);
  }
  EXPECT_EQ(told, (std::vector<std::pair<int, bool>>{{1, true}, {1, false}})) << machine.said();
  EXPECT_TRUE(machine.found(code::kInputsLate, 1)) << machine.said();
}

TEST(SlowFirmware, ATerminalWithOutputsAloneIsNamedByTheOutputsThatItLeaves) {
  for (const bool with_dc : {true, false}) {
    test::DiagnosedRun machine;
    machine.network.add(test::io8());
    for (int i = 0; i < 2; ++i) machine.network.add(out8(with_dc));
    auto& fault = machine.fault(FaultKind::kSlowApplication, 6 * kSecond, 1);
    fault.value_ns = 2'500'000;
    fault.until = 8 * kSecond;
    machine.run(12 * kSecond);
    std::vector<std::pair<int, bool>> told;
    for (const auto& event : machine.events) {
      if (const auto* stale = event.as<events::StaleProcessData>()) {
        EXPECT_TRUE(stale->outputs);
        told.emplace_back(event.slave, stale->begun);
      }
    }
    EXPECT_EQ(told, (std::vector<std::pair<int, bool>>{{1, true}, {1, false}})) << machine.said();
    EXPECT_TRUE(machine.found(code::kOutputsLate, 1)) << machine.said();
  }
}

/// Once all are in OP, for four seconds; the run ends as long behind it.
void run_with_slow(test::DiagnosedRun& machine, int slave) {
  auto& fault = machine.fault(FaultKind::kSlowApplication, 6 * kSecond, slave);
  fault.value_ns = 2'500'000;
  fault.until = 10 * kSecond;
  machine.run(14 * kSecond);
}

/// Three terminals, the second of which becomes slow.
class SlowTerminal : public ::testing::Test {
 protected:
  SlowTerminal() {
    for (int i = 0; i < 3; ++i) machine.network.add(test::io8());
  }
  void expect_it_alone_is_named() {
    run_with_slow(machine, 1);
    EXPECT_TRUE(machine.found(code::kInputsLate, 1)) << machine.said();
    EXPECT_FALSE(machine.found(code::kInputsLate, 0) || machine.found(code::kInputsLate, 2)) << machine.said();
  }
  test::DiagnosedRun machine;
};

/// A datagram more makes the frame 1 us longer: outputs that come shortly before SYNC0 bear that, unless their slave
/// says that it needs that time itself.
TEST_F(SlowTerminal, IsNamedWhereFramesComeShortlyBeforeSync0) {
  const auto slow = machine;
  for (const int us : {150, 100, 70}) {
    SCOPED_TRACE(us);
    machine = slow;
    machine.network.project.master.dc.dcm.set_value = us * kMicrosecond;
    expect_it_alone_is_named();
  }
}

/// It begins its cycles with the process data, or by itself.
TEST(SlowFirmware, IsNamedOfSlavesWithoutSync0) {
  struct SlowKind {
    DeviceDescription device;
    const char* behaviour;
    std::string_view found;
  };
  for (const auto& kind : {SlowKind{sample::own("SL-6751"), "can-gateway", code::kGatewayCycleExceeded},
                           SlowKind{test::servo(), "servo-y", code::kInputsLate},
                           SlowKind{sample::own("SL-XE2"), "drive-c", code::kInputsLate}}) {
    test::DiagnosedRun machine;
    machine.network.add(test::io8());
    machine.network.add(kind.device, kind.behaviour);
    machine.network.add(test::servo(), "servo-y");
    machine.network.project.slaves[1].dc.op_mode.clear();
    run_with_slow(machine, 1);
    EXPECT_TRUE(machine.found(kind.found, 1)) << kind.behaviour << "\n" << machine.said();
    const auto told = std::ranges::count_if(machine.events, [](const Event& event) {
      const auto* stale = event.as<events::StaleProcessData>();
      const auto* longer = event.as<events::LongCycles>();
      return event.slave == 1 && ((stale != nullptr && stale->begun) || (longer != nullptr && longer->begun));
    });
    EXPECT_GE(told, 1) << kind.behaviour << "\n" << machine.said();
    EXPECT_FALSE(machine.found(code::kInputsLate, 0) || machine.found(code::kFirmwareSlow, 2)) << machine.said();
  }
}

TEST(SlowFirmware, IsNamedOfEachSlaveWhereNobodyHasSync0) {
  for (const int slow : {0, 1, 2}) {
    test::DiagnosedRun machine;
    for (int i = 0; i < 3; ++i) {
      machine.network.add(sample::own("SL-6751"), "can-gateway");
      machine.network.project.slaves.back().dc.op_mode.clear();
    }
    run_with_slow(machine, slow);
    for (const int slave : {0, 1, 2})
      EXPECT_EQ(machine.found(code::kGatewayCycleExceeded, slave), slave == slow) << machine.said();
  }
}

/// Whose process data come in each cycle, beside others whose task is slower.
TEST_F(SlowTerminal, IsNamedBesideASlowerTask) {
  auto& project = machine.network.project;
  project.master.tasks.push_back({.name = "slow", .multiple = 4});
  project.master.sync_units.push_back({.name = "slow", .task = "slow"});
  project.slaves[2].output_unit = project.slaves[2].input_unit = "slow";
  project.slaves[2].dc.op_mode.clear();
  expect_it_alone_is_named();
}

TEST_F(SlowTerminal, IsNamedWithoutSync0BesideASlowerTask) {
  auto& project = machine.network.project;
  project.master.tasks.push_back({.name = "slow", .multiple = 4});
  project.master.sync_units.push_back({.name = "slow", .task = "slow"});
  project.slaves[2].output_unit = project.slaves[2].input_unit = "slow";
  for (auto& slave : project.slaves) slave.dc.op_mode.clear();
  expect_it_alone_is_named();
}

/// A quarter of a cycle, and hardly more: not enough for all that may go with the process data.
TEST_F(SlowTerminal, IsNamedWhereSync0IsCloseBehindTheFrames) {
  machine.network.project.master.dc.dcm.set_value = machine.network.project.master.cycle_time / 4 + 25 * kMicrosecond;
  expect_it_alone_is_named();
}

/// Each is read in turn, and two seconds are few turns.
TEST(SlowFirmware, IsNamedOnAMachineOfManySlavesToo) {
  test::DiagnosedRun machine;
  machine.jitter = JitterProfile::desktop();
  machine.network.project.master.cycle_time = 2 * kMillisecond;
  for (int i = 0; i < 40; ++i) {
    machine.network.add(test::io8());
    machine.network.project.slaves.back().dc.op_mode.clear();
  }
  auto& fault = machine.fault(FaultKind::kSlowApplication, 40 * kSecond, 30);
  fault.value_ns = 5 * kMillisecond;
  fault.until = 44 * kSecond;
  machine.run(48 * kSecond);
  EXPECT_TRUE(machine.found(code::kInputsLate, 30)) << machine.said();
  EXPECT_FALSE(machine.found(code::kInputsLate, 29) || machine.found(code::kInputsLate, 31)) << machine.said();
}

/// By the frame that brings its own process data, whichever of several that is.
TEST(SlowFirmware, IsNamedOfTheSlavesOfEachFrame) {
  for (const int slow : {0, 1}) {
    test::DiagnosedRun machine;
    for (int i = 0; i < 2; ++i) machine.network.add(test::large_io());
    for (auto& slave : machine.network.project.slaves) slave.dc.op_mode.clear();
    ASSERT_EQ(machine.network.compiled().cyclic.front().frames.size(), 2U);
    run_with_slow(machine, slow);
    for (const int slave : {0, 1})
      EXPECT_EQ(machine.found(code::kInputsLate, slave), slave == slow) << slow << "\n" << machine.said();
  }
}

TEST(SlowFirmware, NobodyIsAccusedOfItWithoutIt) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    test::DiagnosedRun machine;
    machine.network.sim.seed = seed;
    machine.network.sim.bus.loss = seed % 3 == 0 ? 0.002 : 0;
    machine.jitter = std::array{JitterProfile::none(), JitterProfile::quiet(), JitterProfile::desktop(),
                                JitterProfile::bad()}[seed % 4];
    machine.network.add(test::io8());
    machine.network.add(sample::own("SL-3002"), "analog-input");
    machine.network.add(out8(seed % 2 == 0));
    if (seed % 2 == 0) machine.network.add(sample::own("SL-XE2"), "drive-c");
    if (seed % 3 == 0) machine.network.add(sample::own("SL-6751"), "can-gateway");
    machine.network.add(test::servo(), "servo-y");
    for (auto& slave : machine.network.sim.slaves) slave.oscillator.ppm = random.uniform(-45, 45);
    // A terminal that hangs is no slow one, and one that is off is none either.
    if (seed % 4 == 1) machine.fault(FaultKind::kStopApplication, 7 * kSecond, 0).until = 9 * kSecond;
    if (seed % 4 == 2) machine.fault(FaultKind::kSlaveOff, 7 * kSecond, 0).until = 8 * kSecond;
    machine.run(14 * kSecond);
    for (const auto& event : machine.events) {
      EXPECT_FALSE(event.is<events::StaleProcessData>()) << "seed " << seed << ", slave " << event.slave << "\n"
                                                         << machine.said();
    }
    EXPECT_FALSE(machine.found(code::kInputsLate) || machine.found(code::kOutputsLate)) << seed;
  }
}

/// Terminals that do not say how long they take for their outputs.
TEST_F(SlowTerminal, IsNamedWhereSync0IsHalfACycleBehindTheFrames) {
  machine.network.project.master.dc.dcm.set_value = machine.network.project.master.cycle_time / 2;
  expect_it_alone_is_named();
}

/// Of two frames the later one is before its SYNC0, and there is as much room for readings as with the others.
TEST_F(SlowTerminal, IsNamedBesideASlaveWhoseSync0ComesEverySecondCycle) {
  machine.network.project.slaves[2].dc.sync0.cycle_factor = 2;
  expect_it_alone_is_named();
}

/// Two frames that come close one behind the other leave it less than a cycle.
TEST(SlowFirmware, IsNotBlamedForFramesOfALateHost) {
  int counted = 0;
  for (const auto& host : {JitterProfile::quiet(), JitterProfile::desktop(), JitterProfile::bad()}) {
    for (const bool stalls : {false, true}) {
      test::DiagnosedRun machine;
      machine.jitter = host;
      machine.network.add(test::io8());
      machine.network.add(sample::own("SL-6751"), "can-gateway");
      machine.network.project.master.cycle_time = 550 * kMicrosecond;  // 500 us are the gateway's
      machine.network.project.slaves[1].dc.op_mode.clear();
      if (stalls) machine.fault(FaultKind::kHostStall, 8 * kSecond, -1).value_ns = 20 * kMillisecond;
      machine.run(20 * kSecond);
      counted += machine.report.slaves[1].evidence.outputs.exceeded.total > 0 ? 1 : 0;
      EXPECT_FALSE(machine.found(code::kGatewayCycleExceeded)) << machine.said();
    }
  }
  EXPECT_GT(counted, 0) << "nothing is shown by it";
}

TEST(FirmwareFault, AMailboxThatWasSilentAnswersAgainAndIsToldAllTheSame) {
  for (const auto kind : {FaultKind::kMailboxSilence, FaultKind::kSlowMailbox}) {
    test::DiagnosedRun machine;
    machine.network.add(test::io8());
    machine.network.add(test::servo(), "servo-y");
    auto& fault = machine.fault(kind, 6 * kSecond, 1);
    fault.until = 36 * kSecond;
    fault.value_ns = 2500 * kMillisecond;
    machine.run(60 * kSecond);
    EXPECT_TRUE(machine.found(code::kMailboxSilent, 1)) << machine.said();
    EXPECT_EQ(machine.report.slaves[1].evidence.mailbox_silences, 0U) << "it answers again";
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, FirmwareFaults,
    ::testing::Values(FirmwareKind{FaultKind::kStopApplication, 0, 0, true},
                      FirmwareKind{FaultKind::kStopApplication, 0, 0, false},
                      FirmwareKind{FaultKind::kSlowApplication, 2 * kMillisecond, 8 * kMillisecond, true},
                      FirmwareKind{FaultKind::kSlowApplication, 2 * kMillisecond, 8 * kMillisecond, false},
                      FirmwareKind{FaultKind::kMailboxSilence, 0, 0, true},
                      FirmwareKind{FaultKind::kMailboxSilence, 0, 0, false},
                      FirmwareKind{FaultKind::kSlowMailbox, 2200 * kMillisecond, 4 * kSecond, true}));

}  // namespace
}  // namespace syncline
