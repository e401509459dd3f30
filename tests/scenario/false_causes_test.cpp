// SPDX-License-Identifier: Apache-2.0
// What one thing that is wrong makes others look like: nobody else is given the blame, and all come back.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "protocol/dcm_error.h"
#include "protocol/frame.h"
#include "protocol/registers.h"
#include "support/byte_order.h"
#include "support/random.h"
#include "tests/support/diagnosed_run.h"
#include "tests/support/machine_devices.h"
#include "tests/support/own_devices.h"
#include "tests/support/small_machines.h"

namespace syncline {
namespace {

constexpr int kBringUp = 10'000;  // frames, of the 12 s before anything is wrong

class FalseCauses : public ::testing::Test {
 protected:
  test::DiagnosedRun machine;
  void SetUp() override {
    machine.network = test::two_axes();
    machine.jitter = JitterProfile::quiet();
  }
  DcMasterSettings& dc() { return machine.network.project.master.dc; }
  [[nodiscard]] bool all_in_op() const {
    return machine.report.state == AlState::kOp &&
           std::ranges::all_of(machine.report.slaves, [](const auto& slave) { return slave.al_status == 8; });
  }
  /// Two drives in front of the one that leads, and one behind it.
  void lead_in_the_middle() {
    const auto settings = machine.network.project.master;
    machine.network = {};
    machine.network.add(sample::own("SL-XE2"), "drive-c");
    machine.network.add(test::io8());
    machine.network.add(sample::own("SL-XE2"), "drive-c");
    machine.network.add(test::servo(), "servo-y");
    machine.network.add(test::servo(), "servo-y");
    machine.network.project.master = settings;
    machine.network.project.master.dc.reference_clock = 3;
    machine.network.project.master.dc.dcm.mode = DcmMode::kMasterShift;
    machine.network.sim.host_jitter = machine.jitter = JitterProfile::desktop();
    Random random(5);
    test::give_random_clocks(machine.network, random);
  }
};

/// A frame with an APWR of 0 to 0x0010.
bool clears_station_address(std::span<const std::uint8_t> frame) {
  constexpr std::size_t kFirst = 16, kHeader = 10, kCounter = 2;
  for (auto at = kFirst; at + kHeader + kCounter <= frame.size();) {
    const auto ado = load_le<std::uint16_t>(frame.subspan(at + 4));
    const auto more = load_le<std::uint16_t>(frame.subspan(at + 6));
    const auto length = static_cast<std::size_t>(more & 0x07FFU);
    const bool writes = frame[at] == static_cast<std::uint8_t>(Command::kApwr) && ado == reg::kStationAddress;
    if (writes && load_le<std::uint16_t>(frame.subspan(at + kHeader)) == 0) return true;
    if ((more & 0x8000U) == 0) return false;
    at += kHeader + length + kCounter;
  }
  return false;
}

/// Nobody leads those in front meanwhile, and they run away: they are set up anew when the clock is back, whether they
/// were away with it, or fell because it was.
TEST_F(FalseCauses, WhoIsInFrontOfTheReferenceClockComesBackWithIt) {
  for (const bool cable : {true, false}) {
    SetUp();
    machine.events.clear();
    lead_in_the_middle();
    auto& fault = machine.fault(cable ? FaultKind::kCableBreak : FaultKind::kAdapterOff, 12 * kSecond, cable ? 2 : -1);
    fault.until = 30 * kSecond;
    int sent = 0, cleared = 0;
    machine.loses = [&](std::span<const std::uint8_t> frame) {
      cleared += ++sent > kBringUp && clears_station_address(frame) ? 1 : 0;
      return false;
    };
    machine.run(40 * kSecond);
    EXPECT_TRUE(all_in_op()) << machine.said();
    EXPECT_EQ(machine.report.dc.state, SyncState::kInSync);
    EXPECT_FALSE(machine.found(code::kOutputsWatchdog)) << machine.said();
    EXPECT_FALSE(machine.found(code::kSlaveRefused)) << machine.said();
    EXPECT_EQ(cleared, 0) << "who is set up anew keeps its station address: it would be missed without";
  }
}

/// They are told what the master believes, and a stamp is some ten microseconds off: a clock that followed each message
/// would be shaken by more than a drive's control loop bears, and OP refused.
TEST_F(FalseCauses, WhoIsInFrontOfTheReferenceClockIsNotShakenByTheHost) {
  lead_in_the_middle();
  machine.network.project.master.cycle_time = 4 * kMillisecond;
  auto& off = machine.fault(FaultKind::kSlaveOff, 12 * kSecond, 2);
  off.until = 13 * kSecond;
  machine.run(30 * kSecond);
  EXPECT_TRUE(all_in_op()) << machine.said();
  EXPECT_FALSE(machine.found(code::kSlaveRefused)) << machine.said();
}

/// What a drive misses while nobody leads is not its firmware's.
TEST_F(FalseCauses, WhoMissesEventsWhileNobodyLeadsIsNotBlamed) {
  lead_in_the_middle();
  machine.change = [](NetworkConfig& config) { config.dc.loop.filter_depth_difference = 0; };  // or they stay near
  machine.fault(FaultKind::kCableBreak, 12 * kSecond, 2);
  machine.run(40 * kSecond);
  const auto fell = std::ranges::find(machine.findings, code::kSlaveFellByMisses, &Finding::code);
  ASSERT_NE(fell, machine.findings.end()) << machine.said();
  const auto cause = std::ranges::find(fell->figures, "cause", &Figure::name);
  ASSERT_NE(cause, fell->figures.end());
  EXPECT_NE(cause->text.find("not locked"), std::string::npos) << cause->text;
}

/// Stamps of a quiet host are wrong by up to 72 us, of one frame in a hundred thousand; frames of other things have
/// stamps of their own.
TEST_F(FalseCauses, AStampThatIsWrongLeadsNoClockAwayThatIsToldNominalTimes) {
  machine.network.sim.host_jitter = machine.jitter;
  dc().dcm.mode = DcmMode::kMasterRefClock;
  machine.network.project.master.cycle_time = 2 * kMillisecond;
  Random random(5);
  test::give_random_clocks(machine.network, random);
  for (const unsigned seed : {1U, 2U, 3U}) {
    machine.network.sim.seed = seed;
    machine.run(60 * kSecond);
    EXPECT_LT(machine.report.deviation_max_ns.value_or(INT32_MAX), 127);
    EXPECT_FALSE(machine.accuses()) << machine.said();
  }
}

/// The first frame behind a standstill, which is told the nominal time of its cycle, would lead all away.
TEST_F(FalseCauses, AStandstillOfTheHostMovesNoClockThatIsToldNominalTimes) {
  dc().dcm.mode = DcmMode::kMasterRefClock;
  dc().sync_window.exponent = 8;
  for (const int us : {3300, 3500, 3700, 3900}) {
    auto run = machine;
    run.fault(FaultKind::kHostStall, 8 * kSecond).value_ns = us * kMicrosecond;
    run.run(12 * kSecond);
    EXPECT_FALSE(run.found(code::kWindowLeft)) << us << " us:\n" << run.said();
    EXPECT_FALSE(run.found(code::kJitterReachesClock)) << us << " us:\n" << run.said();
  }
}

/// One alone cannot be compared with others; what the master saw of the reference clock says who it was.
TEST_F(FalseCauses, AReferenceClockThatStepsIsNotTheOnlySlaveThatFollowsIt) {
  for (const auto mode : {DcmMode::kLinkLayerRefClock, DcmMode::kMasterShift, DcmMode::kBusShift}) {
    for (const int who : {0, 1}) {
      SetUp();
      machine.network = {};
      for (int i = 0; i < 2; ++i) machine.network.add(test::io8());
      dc().sync_window.enabled = true;
      dc().dcm.mode = mode;
      machine.fault(FaultKind::kClockStep, 8 * kSecond, who).value_ns = 500 * kMicrosecond;
      machine.run(16 * kSecond);
      EXPECT_TRUE(machine.found(code::kWindowLeft, who)) << machine.said();
      EXPECT_FALSE(machine.found(code::kWindowLeft, 1 - who)) << machine.said();
    }
  }
}

/// Frames are off their place in the grid of a clock that has stepped, and none of them is late.
TEST_F(FalseCauses, AReferenceClockThatStepsMakesNoSync0TooTight) {
  dc().dcm.mode = DcmMode::kLinkLayerRefClock;
  machine.network.project.master.cycle_time = kMillisecond / 2;
  dc().dcm.set_value = 150 * kMicrosecond;
  machine.fault(FaultKind::kClockStep, 8 * kSecond, 0).value_ns = 918'187;
  machine.run(20 * kSecond);
  EXPECT_FALSE(machine.found(code::kSync0TooTight)) << machine.said();
  EXPECT_TRUE(machine.accuses());
}

/// The frame behind one that was held up comes sooner after it.
TEST_F(FalseCauses, HeldFramesAreNoSlowFirmwareOfAGateway) {
  dc().dcm.mode = DcmMode::kMasterShift;
  machine.network.add(sample::own("SL-6751"), "can-gateway");
  machine.network.project.slaves[3].dc.op_mode.clear();
  machine.hold_frames(8 * kSecond, 8 * kSecond + 40 * kMillisecond, 740 * kMicrosecond);
  machine.run(14 * kSecond);
  EXPECT_FALSE(machine.found(code::kGatewayCycleExceeded)) << machine.said();
  EXPECT_GT(machine.report.slaves[3].evidence.outputs.exceeded.total +
                machine.report.slaves[3].evidence.inputs.exceeded.total,
            0U);
  EXPECT_TRUE(machine.found(code::kExceededByHost, 3)) << machine.said();
}

/// It lengthens the way of those behind it long before it is found, where it is found by its alias in cycles of 4 ms.
TEST_F(FalseCauses, ANewcomerThatIsFoundLateIsNoClockThatSteps) {
  machine.network = {};
  machine.network.add(test::io8());
  machine.network.add(sample::own("SL-XE2"), "drive-c");
  machine.network.add(test::io8());
  auto& project = machine.network.project;
  project.master.cycle_time = 4 * kMillisecond;
  project.master.dc.sync_window.enabled = true;
  project.master.dc.dcm.mode = DcmMode::kLinkLayerRefClock;
  project.slaves[1].dc.op_mode.clear();
  project.slaves[1].hot_connect = "branch";
  project.slaves[1].alias = machine.network.sim.slaves[1].alias = 1000;
  machine.network.sim.slaves[1].dc.system_time = false;
  machine.network.sim.slaves[2].parent = 0;
  machine.network.sim.slaves[2].parent_port = 2;
  project.slaves[2].previous = PreviousPort{0, 2};
  for (auto& slave : machine.network.sim.slaves) slave.cable_m = 60;
  machine.fault(FaultKind::kSlaveOff, 15 * kSecond, 1).until = 25 * kSecond;
  machine.run(35 * kSecond);
  EXPECT_TRUE(machine.found(code::kFramesWayChanged, 1)) << machine.said();
  EXPECT_FALSE(machine.found(code::kWindowLeft)) << machine.said();
}

/// All of them are down, and none was led up again; the host says why.
TEST_F(FalseCauses, AStandstillThatIsLongerThanTheWatchdogIsWhyAllFell) {
  machine.network.project.master.cycle_time = 4 * kMillisecond;
  machine.fault(FaultKind::kHostStall, 8 * kSecond).value_ns = 130 * kMillisecond;
  machine.run(12 * kSecond);
  EXPECT_FALSE(machine.found(code::kSlaveHadFallen)) << machine.said();
  EXPECT_FALSE(machine.found(code::kDcmError)) << machine.said();
  const auto fell = std::ranges::find_if(
      machine.findings, [](const Finding& f) { return f.code == code::kSlaveFell && f.place.slave == 0; });
  ASSERT_NE(fell, machine.findings.end()) << machine.said();
  EXPECT_NE(describe(*fell).find("the host left cycles out"), std::string::npos) << describe(*fell);
  const auto wrong = [](const Event& event) {
    const auto* error = event.as<events::DcmError>();
    return error != nullptr && error->code == dc::kDcmErrorBusCycleWrong;
  };
  EXPECT_FALSE(std::ranges::any_of(machine.events, wrong));
}

}  // namespace
}  // namespace syncline
