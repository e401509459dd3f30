// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "app/cli/cli.h"
#include "tests/scenario/machine_run.h"
#include "tests/support/event_match.h"

namespace syncline {
namespace {

using Stage = events::RecoveryStep::Stage;
test::EventMatch recovery(Stage stage) { return test::with(&events::RecoveryStep::stage, stage); }
test::EventMatch group(events::HotConnect::What what) { return test::with(&events::HotConnect::what, what); }

/// A line of drives and terminals on the simulated bus, disturbed while it runs.
class Disturbance : public test::MachineRun {
 protected:
  void SetUp() override {
    network.add(test::servo(), "servo-y");
    network.add(test::io8());
    network.add(test::servo(), "servo-y");
    network.add(test::io8());
  }
  /// Index of the first such event; behind the last one when there is none.
  [[nodiscard]] std::size_t first(const test::EventMatch& match, int slave) const {
    const auto found = std::ranges::find_if(events, [&](const Event& e) { return e.slave == slave && match(e); });
    return static_cast<std::size_t>(found - events.begin());
  }
  [[nodiscard]] std::size_t first(EventKind kind, int slave) const {
    return first([kind](const Event& e) { return e.kind() == kind; }, slave);
  }
  [[nodiscard]] const events::CableChanged& cable_of(std::size_t event) const {
    return *events[event].as<events::CableChanged>();
  }
  /// No cycle was left out and no frame sent twice.
  void expect_steady_cycle() const {
    for (std::size_t i = 1; i < samples.size(); ++i) {
      ASSERT_EQ(samples[i].cycle, samples[i - 1].cycle + 1);
      ASSERT_LT(samples[i].send_time - samples[i - 1].send_time, 1'200'000) << "cycle " << i;
      ASSERT_GT(samples[i].send_time - samples[i - 1].send_time, 800'000) << "cycle " << i;
    }
  }
};

TEST_F(Disturbance, APowerCycledSlaveIsSetUpAnewWhileTheOthersStayInOp) {
  fault(FaultKind::kSlaveOff, 3, 6 * kSecond, 7 * kSecond);
  go_online();
  ASSERT_EQ(snapshot.state, AlState::kOp) << log();
  events.clear();
  run_until(20 * kSecond);
  EXPECT_EQ(snapshot.state, AlState::kOp) << log();
  EXPECT_EQ(snapshot.slaves[3].al_status, 8) << log();
  // What happened, in its order.
  const auto cable = first(kind_of<events::CableChanged>, 2), lost = first(kind_of<events::SlaveLost>, 3),
             less = first(kind_of<events::WkcExpected>, -1), begun = first(recovery(Stage::kBegun), 3),
             found = first(kind_of<events::SlaveFound>, 3), done = first(recovery(Stage::kDone), 3);
  ASSERT_LT(done, events.size()) << log();
  EXPECT_EQ(cable_of(cable).far_slave, 3);
  EXPECT_LT(cable, lost) << log();
  EXPECT_LT(lost, less) << log();
  EXPECT_LT(less, begun) << log();
  EXPECT_LT(begun, found) << log();
  EXPECT_LT(found, done) << log();
  for (int slave = 0; slave < 3; ++slave) EXPECT_EQ(count(kind_of<events::StateChanged>, slave), 0U) << log();
  expect_steady_cycle();
  EXPECT_EQ(samples.back().wkc_received, 12);
  EXPECT_LT(std::abs(snapshot.slaves[3].deviation_ns), 1000);
}

TEST_F(Disturbance, APulledCableIsNamedAndHealsByItself) {
  fault(FaultKind::kCableBreak, 2, 6 * kSecond, 8 * kSecond);
  go_online();
  ASSERT_EQ(snapshot.state, AlState::kOp) << log();
  events.clear();
  run_until(7 * kSecond);
  const auto cable = first(kind_of<events::CableChanged>, 1);
  ASSERT_LT(cable, events.size()) << log();
  EXPECT_EQ(cable_of(cable).port, 1);
  EXPECT_EQ(cable_of(cable).far_slave, 2);
  EXPECT_EQ(count(kind_of<events::CableChanged>), 1U) << log();
  EXPECT_LT(cable, first(kind_of<events::SlaveLost>, 2));
  EXPECT_LT(first(kind_of<events::SlaveLost>, 2), first(kind_of<events::SlaveLost>, 3));
  EXPECT_EQ(snapshot.state, AlState::kNone) << log();  // nobody knows what those are in that are gone
  EXPECT_EQ(snapshot.slaves[1].al_status, 8) << log();
  EXPECT_FALSE(snapshot.slaves[2].present);
  EXPECT_EQ(snapshot.slaves[2].al_status, 0);
  EXPECT_TRUE(snapshot.slaves[2].cable_broken);
  EXPECT_FALSE(snapshot.slaves[3].cable_broken);
  EXPECT_EQ(samples.back().wkc_received, samples.back().wkc_expected);
  run_until(20 * kSecond);
  EXPECT_EQ(snapshot.state, AlState::kOp) << log();
  for (const auto& slave : snapshot.slaves) EXPECT_EQ(slave.al_status, 8) << log();
  EXPECT_EQ(count(kind_of<events::CableChanged>), 2U) << log();
  EXPECT_LT(first(kind_of<events::SlaveFound>, 2), first(recovery(Stage::kDone), 2)) << log();
  expect_steady_cycle();
}

TEST_F(Disturbance, WithoutAutomaticRecoverySlavesWaitForTheCommand) {
  network.project.master.recovery.automatic = false;
  fault(FaultKind::kSlaveOff, 3, 6 * kSecond, 7 * kSecond);
  go_online();
  events.clear();
  run_until(10 * kSecond);
  EXPECT_EQ(count(kind_of<events::RecoveryStep>), 0U) << log();
  EXPECT_FALSE(snapshot.slaves[3].present);
  service->channels().commands.push(RequestStateCommand{AlState::kOp});
  run_until(20 * kSecond);
  EXPECT_EQ(snapshot.slaves[3].al_status, 8) << log();
  EXPECT_EQ(count(kind_of<events::RecoveryStep>, 3), 2U) << log();
}

/// Behind a cable that was pulled it has kept its station address, so that nobody has to look for it.
TEST_F(Disturbance, TheCommandSetsUpAnewWhatWasCutOffWithoutAutomaticRecovery) {
  network.project.master.recovery.automatic = false;
  fault(FaultKind::kCableBreak, 3, 6 * kSecond, 7 * kSecond);
  go_online();
  events.clear();
  run_until(10 * kSecond);
  EXPECT_TRUE(snapshot.slaves[3].present) << log();
  EXPECT_EQ(count(kind_of<events::RecoveryStep>), 0U) << log();
  EXPECT_NE(snapshot.slaves[3].al_status, 8) << log();
  service->channels().commands.push(RequestStateCommand{AlState::kOp});
  run_until(20 * kSecond);
  EXPECT_EQ(snapshot.slaves[3].al_status, 8) << log();
  EXPECT_EQ(count(kind_of<events::RecoveryStep>, 3), 2U) << log();
}

TEST_F(Disturbance, ABurstOfLostFramesLosesNoSlave) {
  fault(FaultKind::kLoseFrames, -1, 6 * kSecond, 0, 2);
  go_online();
  events.clear();
  run_until(8 * kSecond);
  EXPECT_EQ(count(kind_of<events::SlaveLost>), 0U) << log();
  EXPECT_GE(count(kind_of<events::FramesLost>), 1U);
  EXPECT_EQ(snapshot.state, AlState::kOp) << log();
  expect_steady_cycle();
}

TEST_F(Disturbance, AnErrorStateIsLeftAsOftenAsTheSettingSays) {
  fault(FaultKind::kLoseFrames, -1, 6 * kSecond, 0, 40);  // the drives give up: 0x001A
  go_online();
  events.clear();
  run_until(8 * kSecond);
  EXPECT_EQ(snapshot.slaves[0].al_status, 0x14) << log();
  EXPECT_EQ(count(kind_of<events::RecoveryStep>), 0U);
  service->channels().commands.push(RequestStateCommand{AlState::kOp});  // on command
  run_until(10 * kSecond);
  EXPECT_EQ(snapshot.state, AlState::kOp) << log();

  events.clear();
  network.project.master.recovery.error_tries = 2;
  go_online();
  run_until(12 * kSecond);
  EXPECT_EQ(snapshot.state, AlState::kOp) << log();
  EXPECT_EQ(count(kind_of<events::RecoveryStep>, 0), 2U) << log();
  EXPECT_EQ(count(kind_of<events::StateChanged>, 1), 3U) << log();  // the terminal was never touched after its bring-up
}

TEST_F(Disturbance, ABusThatIsNotTheConfiguredOneIsExplained) {
  const auto errors_of_start = [this] {
    events.clear();
    go_online();
    std::vector<ErrorCode> codes;
    for (const auto& event : events) {
      if (const auto* failure = event.as<events::Failure>()) codes.push_back(failure->error.code);
    }
    return codes;
  };
  const auto configured = network;
  // Missing: the drive in the middle.
  network.sim.slaves.erase(network.sim.slaves.begin() + 2);
  network.sim.slaves[2].parent = 1;
  EXPECT_THAT(errors_of_start(), ::testing::ElementsAre(ErrorCode::kSlaveMissing, ErrorCode::kSlaveCount)) << log();
  EXPECT_NE(log().find("slave 2"), std::string::npos) << log();
  EXPECT_FALSE(service->online());
  service->channels().snapshot.read(snapshot);
  for (std::size_t i = 0; i < snapshot.slaves.size(); ++i)
    EXPECT_EQ(snapshot.slaves[i].present, i != 2) << i << ": only that one is missing";
  // One too many.
  network = configured;
  network.project.slaves.pop_back();
  EXPECT_THAT(errors_of_start(), ::testing::ElementsAre(ErrorCode::kSlaveExtra, ErrorCode::kSlaveCount)) << log();
  // Swapped: the identity check of both slaves fails, and both are named together.
  network = configured;
  std::swap(network.sim.slaves[1].device, network.sim.slaves[2].device);
  const auto swapped = errors_of_start();
  EXPECT_THAT(swapped, ::testing::Contains(ErrorCode::kSlavesSwapped)) << log();
  EXPECT_THAT(swapped, ::testing::Contains(ErrorCode::kIdentityMismatch).Times(3)) << log();
  // Another device.
  network = configured;
  network.sim.slaves[3].device.identity.product_code = 0x4711;
  const auto wrong = errors_of_start();
  EXPECT_THAT(wrong, ::testing::Each(ErrorCode::kIdentityMismatch)) << log();
  EXPECT_NE(log().find("0x00004711"), std::string::npos) << log();
}

TEST_F(Disturbance, ABusMayStartWithoutSlavesThatJoinLater) {
  network.project.master.recovery.start_incomplete = true;
  fault(FaultKind::kCableBreak, 2, 0, 6 * kSecond);  // two slaves are not there yet
  go_online();
  ASSERT_TRUE(service->online()) << log();
  EXPECT_EQ(snapshot.state, AlState::kNone) << log();  // the machine is not in OP, only a part of it
  EXPECT_EQ(snapshot.slaves[1].al_status, 8) << log();
  EXPECT_FALSE(snapshot.slaves[2].present);
  run_until(4 * kSecond);
  EXPECT_EQ(samples.back().wkc_received, 6) << log();
  EXPECT_EQ(samples.back().wkc_expected, 6) << log();
  EXPECT_EQ(snapshot.wkc_errors, 0U) << log();
  events.clear();
  run_until(20 * kSecond);
  for (const auto& slave : snapshot.slaves) EXPECT_EQ(slave.al_status, 8) << log();
  EXPECT_EQ(count(kind_of<events::StateChanged>, 0) + count(kind_of<events::StateChanged>, 1), 0U) << log();
  EXPECT_EQ(samples.back().wkc_received, 12) << log();
}

/// Slaves 3 and 4 form a group that is plugged into the last port of the line at 6 s and pulled at 12 s.
TEST_F(Disturbance, AHotConnectGroupComesAndGoesWithoutAnError) {
  ASSERT_GE(network.project.slaves.size(), 4U);
  const auto head = network.project.slaves.size() - 2;
  network.project.slaves[head].alias = 77;
  network.project.slaves[head].hot_connect = "Trolley";
  network.sim.slaves[head].alias = 77;
  fault(FaultKind::kCableBreak, static_cast<int>(head), 0, 6 * kSecond);
  fault(FaultKind::kCableBreak, static_cast<int>(head), 15 * kSecond, 60 * kSecond);
  go_online();
  ASSERT_TRUE(service->online()) << log();
  EXPECT_EQ(snapshot.state, AlState::kOp) << log();
  EXPECT_FALSE(snapshot.slaves[head].present);
  EXPECT_EQ(count(kind_of<events::HotConnect>), 2U) << log();
  EXPECT_EQ(count(kind_of<events::Failure>), 0U) << log();
  run_until(5 * kSecond);
  EXPECT_EQ(samples.back().wkc_received, samples.back().wkc_expected) << log();
  events.clear();
  run_until(14 * kSecond);
  for (const auto& slave : snapshot.slaves) EXPECT_EQ(slave.al_status, 8) << log();
  EXPECT_LT(first(group(events::HotConnect::What::kConnected), static_cast<int>(head)), events.size()) << log();
  EXPECT_EQ(snapshot.wkc_errors, 0U) << log();
  events.clear();
  run_until(20 * kSecond);
  EXPECT_LT(first(group(events::HotConnect::What::kDisconnected), static_cast<int>(head)), events.size()) << log();
  EXPECT_EQ(
      count(kind_of<events::SlaveLost>) + count(kind_of<events::Failure>) + count(kind_of<events::StateChanged>, 0), 0U)
      << log();
  EXPECT_EQ(snapshot.slaves[0].al_status, 8) << log();
}

/// Its members lose their power, and their station addresses with it, one after the other.
TEST_F(Disturbance, AMemberOfAHotConnectGroupComesBackWhileItsHeadIsThere) {
  network.add(test::io8());
  const std::size_t head = 2, members = 3;
  network.project.slaves[head].alias = 77;
  network.project.slaves[head].hot_connect = "Trolley";
  network.sim.slaves[head].alias = 77;
  for (std::size_t n = 0; n < members; ++n) {
    const auto begin = static_cast<Nanoseconds>(10 * (n + 1)) * kSecond;
    fault(FaultKind::kSlaveOff, static_cast<int>(head + n), begin, begin + 2 * kSecond);
  }
  go_online();
  for (std::size_t n = 0; n < members; ++n) {
    run_until(static_cast<Nanoseconds>(10 * (n + 1) + 1) * kSecond);
    EXPECT_FALSE(snapshot.slaves[head + n].present) << n;
    EXPECT_FALSE(snapshot.slaves[head + members - 1].present) << "whoever hangs behind it " << n;
    run_until(static_cast<Nanoseconds>(10 * (n + 1) + 8) * kSecond);
    for (const auto& slave : snapshot.slaves) EXPECT_EQ(slave.al_status, 8) << log();
  }
  EXPECT_EQ(count(kind_of<events::UnknownSlave>), 0U) << log();
  EXPECT_EQ(samples.back().wkc_received, samples.back().wkc_expected) << log();
}

/// The group is plugged in behind another slave than the one behind which it was configured.
TEST_F(Disturbance, AHotConnectGroupIsKnownByItsAliasWhereverItStands) {
  const auto head = network.project.slaves.size() - 1;
  network.project.slaves[head].alias = 77;
  network.project.slaves[head].hot_connect = "Trolley";
  network.sim.slaves[head].alias = 77;
  network.sim.slaves[head].parent = 0;  // at port D of the first, in front of the others
  network.sim.slaves[head].parent_port = 3;
  auto moved = std::move(network.sim.slaves.back());
  network.sim.slaves.pop_back();
  for (auto& slave : network.sim.slaves) {
    if (slave.parent && *slave.parent >= 1) ++*slave.parent;
  }
  network.sim.slaves.insert(network.sim.slaves.begin() + 1, std::move(moved));
  fault(FaultKind::kCableBreak, 1, 0, 6 * kSecond);
  go_online();
  ASSERT_TRUE(service->online()) << log();
  EXPECT_FALSE(snapshot.slaves[head].present);
  run_until(20 * kSecond);
  for (const auto& slave : snapshot.slaves) EXPECT_EQ(slave.al_status, 8) << log();
  EXPECT_TRUE(snapshot.slaves[head].present);
  EXPECT_EQ(count(kind_of<events::Failure>), 0U) << log();
  EXPECT_EQ(samples.back().wkc_received, samples.back().wkc_expected) << log();
}

TEST_F(Disturbance, ALostReferenceClockIsNeverInSync) {
  fault(FaultKind::kSlaveOff, 0, 6 * kSecond, 8 * kSecond);
  go_online();
  ASSERT_EQ(snapshot.dcm.state, SyncState::kInSync);
  events.clear();
  run_until(7 * kSecond);
  EXPECT_EQ(count(kind_of<events::ReferenceClockChanged>), 1U) << log();
  EXPECT_EQ(snapshot.dcm.state, SyncState::kOutOfSync) << log();
  EXPECT_NE(samples.back().master_sync, SyncState::kInSync);
  run_until(40 * kSecond);
  EXPECT_EQ(snapshot.dcm.state, SyncState::kInSync) << log();
  EXPECT_EQ(snapshot.state, AlState::kOp) << log();
  for (const auto& slave : snapshot.slaves) EXPECT_EQ(slave.al_status, 8) << log();
}

TEST_F(Disturbance, AnotherClockTakesOverWhenTheReferenceHangsInABranch) {
  // A coupler with the reference clock in one branch and a drive in the other.
  network = {};
  network.add(test::io8());
  network.add(test::servo(), "servo-y");
  network.add(test::servo(), "servo-y");
  network.sim.slaves[1].parent_port = 3;
  network.project.slaves[1].previous = PreviousPort{0, 3};
  network.sim.slaves[2].parent = 0;
  network.project.slaves[2].previous = PreviousPort{0, 1};
  network.project.slaves[0].dc.op_mode = "";
  network.project.master.dc.reference_clock = 1;
  fault(FaultKind::kSlaveOff, 1, 6 * kSecond, 9 * kSecond);
  go_online();
  ASSERT_EQ(snapshot.state, AlState::kOp) << log();
  events.clear();
  run_until(7 * kSecond);
  using What = events::ReferenceClockChanged::What;
  EXPECT_LT(first(test::with(&events::ReferenceClockChanged::what, What::kLost), 1),
            first(test::with(&events::ReferenceClockChanged::what, What::kTookOver), 2))
      << log();
  EXPECT_EQ(snapshot.dc.reference_clock, 2);
  EXPECT_TRUE(snapshot.slaves[2].is_reference_clock);
  EXPECT_EQ(snapshot.dcm.state, SyncState::kOutOfSync);
  run_until(30 * kSecond);
  EXPECT_EQ(snapshot.dc.reference_clock, 1) << log();
  EXPECT_EQ(snapshot.state, AlState::kOp) << log();
  EXPECT_EQ(count(kind_of<events::StateChanged>, 2), 0U) << log();
  EXPECT_EQ(snapshot.dcm.state, SyncState::kInSync) << log();
}

}  // namespace
}  // namespace syncline
