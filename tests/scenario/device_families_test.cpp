// SPDX-License-Identifier: Apache-2.0
// What the table of device families refuses is what the devices refuse on the bus, and what it sets works there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "channels/command.h"
#include "channels/master_channels.h"
#include "channels/slave_status.h"
#include "channels/snapshot.h"
#include "config/sim_config.h"
#include "families/families.h"
#include "link/simulated_link.h"
#include "master/master_service.h"
#include "settings/settings_keys.h"
#include "sim/sim_bus.h"
#include "support/clock.h"
#include "support/simulated_network.h"
#include "tests/support/own_devices.h"

namespace syncline {
namespace {

struct Kind {
  const char* type;
  const char* behaviour;
};
constexpr Kind kServo{"SL-SV7", "servo-y"}, kDrive{"SL-XE2", "drive-c"}, kGateway{"SL-6751", "can-gateway"};

test::SimulatedNetwork machine(const Kind& kind) {
  test::SimulatedNetwork network;
  network.add(sample::own("SL-1100"));
  network.add(sample::own(kind.type), kind.behaviour);
  return network;
}

bool is_refused(const Project& project) {
  const auto result = compile(project);
  return std::ranges::any_of(result->findings, [](const Finding& finding) {
    return finding.place.slave == 1 && finding.severity == Severity::kError;
  });
}

/// What becomes of the device, whatever the findings say.
SlaveStatus bring_up(const test::SimulatedNetwork& network, Nanoseconds time = 3 * kSecond / 2) {
  VirtualClock clock;
  auto link = network.link(clock);
  if (link == nullptr) return {};
  MasterService service(std::move(link), clock);
  service.channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
  service.run_for(time);
  Snapshot snapshot;
  service.channels().snapshot.read(snapshot);
  return snapshot.slaves.size() == 2 ? snapshot.slaves[1] : SlaveStatus{};
}

TEST(DeviceFamilies, ACycleIsRefusedBeforeExactlyWhenTheDeviceRefusesIt) {
  for (const auto& [kind, cycles] : std::vector<std::pair<Kind, std::vector<Nanoseconds>>>{
           {kServo, {125'000, 300'000, 375'000, 700'000, 4'000'000, 5'000'000, 8'000'000}},
           {kDrive, {250'000, 300'000, 312'500, 10'000'000, 10'250'000}},
           {kGateway, {62'500, 100'000, 700'000}}}) {
    for (const auto cycle : cycles) {
      auto network = machine(kind);
      network.project.master.cycle_time = cycle;
      network.project.master.dc.burst_total = 500;
      const bool refused = is_refused(network.project);
      const auto status = bring_up(network);
      EXPECT_EQ(refused, al_state_of(status.al_status) < AlState::kSafeop)
          << kind.type << " " << cycle << " ns: " << status.al_status;
    }
  }
}

TEST(DeviceFamilies, TheGatewayComesToOpWithSync1) {
  auto network = machine(kGateway);
  ASSERT_TRUE(set_setting(network.project, "slave.1.dc.op_mode", "DC Sync01"));
  for (const Nanoseconds cycle : {250'000, 1'000'000, 4'000'000}) {
    network.project.master.cycle_time = cycle;
    EXPECT_FALSE(is_refused(network.project)) << cycle;
    const auto config = network.compiled();
    EXPECT_EQ(config.slaves[1].dc->cycle_time0, cycle);
    EXPECT_EQ(config.slaves[1].dc->cycle_time1, 100'000) << "SYNC1 comes so long behind SYNC0";
  }
  network.project.master.cycle_time = kMillisecond;
  EXPECT_EQ(al_state_of(bring_up(network).al_status), AlState::kOp);
}

TEST(DeviceFamilies, SettingsAreTakenOnTheBus) {
  auto servo = machine(kServo);
  ASSERT_TRUE(set_setting(servo.project, "slave.1.sync.error_limit", "15"));
  const auto status = bring_up(servo, 5 * kSecond);
  EXPECT_EQ(al_state_of(status.al_status), AlState::kOp);
  EXPECT_EQ(status.sm2_missed.limit, 15U);
  EXPECT_EQ(families::error_limit(servo.compiled().slaves[1]), 15U);

  auto drive = machine(kDrive);
  ASSERT_TRUE(set_setting(drive.project, "slave.1.sync.type", "free-run"));
  ASSERT_TRUE(set_setting(drive.project, "slave.1.output_pin.2", "frames"));
  EXPECT_EQ(al_state_of(bring_up(drive, 5 * kSecond).al_status), AlState::kOp);

  auto gateway = machine(kGateway);
  ASSERT_TRUE(set_setting(gateway.project, "slave.1.can.cycle_us", "4000"));
  ASSERT_TRUE(set_setting(gateway.project, "slave.1.can.tx_delay_percent", "5"));
  EXPECT_EQ(al_state_of(bring_up(gateway).al_status), AlState::kOp);
  ASSERT_TRUE(set_setting(gateway.project, "slave.1.dc.op_mode", "SM Sync"));
  EXPECT_EQ(al_state_of(bring_up(gateway).al_status), AlState::kOp);
  ASSERT_TRUE(set_setting(gateway.project, "slave.1.can.cycle_us", "1500"));
  EXPECT_TRUE(is_refused(gateway.project));
  EXPECT_LT(al_state_of(bring_up(gateway).al_status), AlState::kSafeop) << "and the device refuses it";
}

}  // namespace
}  // namespace syncline
