// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "channels/command.h"
#include "channels/master_channels.h"
#include "channels/sm2_missed_status.h"
#include "channels/snapshot.h"
#include "master/master_service.h"
#include "tests/support/own_devices.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

/// A drive that loses ten frames while it runs; what the master knows of its counters then.
Sm2MissedStatus counters_of(const DeviceDescription& device, const std::string& behaviour, std::uint8_t limit = 0) {
  test::SimulatedNetwork network;
  network.add(device, behaviour);
  StartupCommand alarm;
  alarm.index = 0x10F1;
  alarm.sub_index = 2;
  alarm.data = {limit, 0};
  network.project.slaves[0].startup.push_back(alarm);
  for (int i = 0; i < 10; ++i) {
    FaultConfig loss;
    loss.kind = FaultKind::kLoseFrames;
    loss.at = (6000 + 50 * i) * kMillisecond;
    network.sim.faults.push_back(loss);
  }
  VirtualClock clock;
  auto link = network.link(clock);
  if (link == nullptr) return {};
  MasterService service(std::move(link), clock);
  service.channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
  service.run_for(8 * kSecond);
  Snapshot snapshot;
  service.channels().snapshot.read(snapshot);
  return snapshot.slaves.empty() ? Sm2MissedStatus{} : snapshot.slaves[0].sm2_missed;
}

TEST(SyncCounters, OfADeviceThatNobodyKnowsBothAreRead) {
  for (const auto& [type, behaviour] : {std::pair{"SL-SV7", "servo-y"}, std::pair{"SL-XE2", "drive-c"}}) {
    auto device = sample::own(type);
    device.identity.product_code = 0x7777'0001;
    device.mailbox->coe->sdo_info = false;
    const auto status = counters_of(device, behaviour);
    ASSERT_TRUE(status.valid) << type;
    EXPECT_EQ(status.sub_index, 0x0B) << type;
    EXPECT_EQ(status.other_sub_index, 0x0C) << type;
    const bool old_layout = std::string(type) == "SL-SV7";
    const auto missed = old_layout ? status.other_value : status.value;
    const auto exceeded = old_layout ? status.value : status.other_value;
    EXPECT_GE(missed, 8U) << type << ": the one that rises with lost frames is the one";
    EXPECT_EQ(exceeded, 0U) << type;
  }
}

TEST(SyncCounters, OfAKnownDeviceOneIsRead) {
  auto device = sample::own("SL-SV7");
  device.mailbox->coe->sdo_info = false;
  const auto status = counters_of(device, "servo-y");
  EXPECT_EQ(status.sub_index, 0x0C);
  EXPECT_EQ(status.other_sub_index, 0);
  EXPECT_GE(status.value, 8U);
  EXPECT_EQ(status.limit, 0U);
  EXPECT_EQ(status.integrator_highest, 3U) << "single misses";
  EXPECT_EQ(status.integrator, 0U) << "long ago";
  EXPECT_EQ(counters_of(device, "servo-y", 12).limit, 12U);
}

}  // namespace
}  // namespace syncline
