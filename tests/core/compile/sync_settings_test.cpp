// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "compile/compile.h"
#include "settings/settings_keys.h"
#include "tests/support/sample_devices.h"

namespace syncline {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

DeviceDescription device(std::uint32_t vendor, std::uint32_t product) {
  auto device = sample::servo();
  device.identity.vendor_id = vendor;
  device.identity.product_code = product;
  return device;
}
DeviceDescription yaskawa() { return device(0x539, 0x0220'0301); }
DeviceDescription copley() { return device(0xAB, 0x10B0); }
DeviceDescription can_gateway() { return device(0x2, 0x1A5F'3052); }

using Objects = std::map<std::pair<int, int>, std::vector<std::uint8_t>>;

/// What the last slave is told at start-up, the last write of each object.
Objects written(const Project& project) {
  Objects objects;
  const auto result = compile(project);
  for (const auto& cmd : result->config.slaves.back().mailbox->coe_commands) {
    objects[{cmd.command.index, cmd.command.sub_index}] = cmd.command.data;
  }
  return objects;
}

std::vector<std::string> errors(const Project& project) {
  std::vector<std::string> keys;
  const auto result = compile(project);
  for (const auto& finding : result->findings) {
    if (finding.severity == Severity::kError) keys.push_back(finding.place.key);
  }
  return keys;
}

TEST(SyncSettings, BecomeStartupCommands) {
  Project project = sample::project({copley()});
  ASSERT_TRUE(set_setting(project, "slave.0.sync.error_limit", "12"));
  ASSERT_TRUE(set_setting(project, "slave.0.sync.type", "sync0"));
  ASSERT_TRUE(set_setting(project, "slave.0.sync.input_shift_us", "62.5"));
  ASSERT_TRUE(set_setting(project, "slave.0.output_pin.3", "servo-period"));
  ASSERT_TRUE(set_setting(project, "slave.0.output_pin.1", "sync0"));
  auto objects = written(project);
  EXPECT_THAT((objects[{0x10F1, 2}]), ElementsAre(12, 0));
  EXPECT_THAT((objects[{0x1C32, 1}]), ElementsAre(2, 0));
  EXPECT_THAT((objects[{0x1C33, 1}]), ElementsAre(2, 0));
  EXPECT_THAT((objects[{0x1C33, 3}]), ElementsAre(0x24, 0xF4, 0, 0));
  EXPECT_THAT((objects[{0x2193, 1}]), ElementsAre(11, 0, 0, 0, 0, 0, 0, 0, 0, 0));
  EXPECT_THAT((objects[{0x2193, 3}]), ElementsAre(0, 2, 0, 0, 0, 0, 0, 0, 0, 0));
  EXPECT_EQ(get_setting(project, "slave.0.output_pin.2").value(), "auto");
  EXPECT_TRUE(errors(project).empty());
  ASSERT_TRUE(set_setting(project, "slave.0.output_pin.1", "auto"));
  EXPECT_EQ(project.slaves[0].output_pins.size(), 1U);
}

TEST(SyncSettings, TheLimitHasTheWidthOfTheDevice) {
  auto wide = device(0x9A, 0x30924);
  wide.dictionary = {{0x10F1, "Error settings", {{2, "Sync error counter limit", "UDINT", 32, true, true, {}}}}};
  Project project = sample::project({wide});
  ASSERT_TRUE(set_setting(project, "slave.0.sync.error_limit", "4"));
  EXPECT_THAT((written(project)[{0x10F1, 2}]), ElementsAre(4, 0, 0, 0));
}

TEST(SyncSettings, AGatewayIsToldItsBusCycleWithoutSync0) {
  Project project = sample::project({can_gateway()});
  ASSERT_TRUE(set_setting(project, "slave.0.can.cycle_us", "4000"));
  ASSERT_TRUE(set_setting(project, "slave.0.can.tx_delay_percent", "10"));
  auto objects = written(project);
  EXPECT_THAT((objects[{0xF800, 4}]), ElementsAre(0x00, 0x09, 0x3D, 0x00));
  EXPECT_THAT((objects[{0xF800, 0x0E}]), ElementsAre(10));
  EXPECT_FALSE(objects.contains({0x1C32, 2})) << "SYNC0 says it";
  project.slaves[0].dc.op_mode.clear();
  EXPECT_THAT((written(project)[{0x1C32, 2}]), ElementsAre(0x40, 0x42, 0x0F, 0x00));
  EXPECT_TRUE(errors(project).empty());
  ASSERT_TRUE(set_setting(project, "slave.0.can.cycle_us", "1500"));
  EXPECT_THAT(errors(project), ElementsAre("slave.0.can.cycle_us"));
}

TEST(SyncSettings, WhatTheDeviceDoesNotTakeIsRefused) {
  Project project = sample::project({yaskawa(), copley(), can_gateway(), sample::digital_input()});
  const Project before = project;
  const auto refused = [&](const char* key, const char* value) {
    const auto status = set_setting(project, key, value);
    EXPECT_FALSE(status) << key;
    EXPECT_TRUE(project == before) << key;
    return status ? std::string() : status.error().subject + ": " + status.error().detail.text();
  };
  EXPECT_THAT(refused("slave.0.sync.error_limit", "16"), HasSubstr("Sigma-7 drives take: 0 to 15"));
  EXPECT_THAT(refused("slave.0.sync.type", "sync0"), HasSubstr("by the SYNC signals"));
  EXPECT_THAT(refused("slave.1.sync.type", "sync1"), HasSubstr("do not have sync1"));
  EXPECT_THAT(refused("slave.1.sync.type", "sync9"), HasSubstr("none of"));
  EXPECT_THAT(refused("slave.1.can.cycle_us", "1000"), HasSubstr("slave.1.can.cycle_us: the device is no CAN gateway"));
  EXPECT_THAT(refused("slave.2.can.tx_delay_percent", "101"), HasSubstr("outside 0..100"));
  EXPECT_THAT(refused("slave.1.output_pin.1", "sinus"), HasSubstr("none of auto, nothing, sync0"));
  EXPECT_THAT(refused("slave.1.output_pin.8", "sync0"), HasSubstr("no such item"));
  EXPECT_THAT(refused("slave.0.output_pin.1", "sync0"), HasSubstr("no such item"));
  EXPECT_THAT(refused("slave.3.sync.error_limit", "3"), HasSubstr("no CoE mailbox"));
}

TEST(SyncSettings, AStartupCommandThatSaysOtherwiseIsAContradiction) {
  Project project = sample::project({yaskawa()});
  ASSERT_TRUE(set_setting(project, "slave.0.sync.error_limit", "12"));
  ASSERT_TRUE(set_setting(project, "slave.0.startup.1", "PS 0x10F1:02=0f00"));
  EXPECT_THAT(errors(project), ElementsAre("slave.0.startup.1"));
  ASSERT_TRUE(set_setting(project, "slave.0.startup.1", "PS 0x10F1:02=0c00"));
  EXPECT_TRUE(errors(project).empty());
}

TEST(SyncSettings, AnotherDeviceInItsPlaceIsToldAsAFinding) {
  Project project = sample::project({copley()});
  ASSERT_TRUE(set_setting(project, "slave.0.sync.error_limit", "100"));
  project.slaves[0].device.identity = yaskawa().identity;
  EXPECT_THAT(errors(project), ElementsAre("slave.0.sync.error_limit"));
  EXPECT_FALSE(written(project).contains({0x10F1, 2}));
}

TEST(SyncSettings, RefusedCyclesAreErrorsThatNameTheSlave) {
  Project project = sample::project({sample::coupler(), yaskawa(), copley()});
  for (const int us : {300, 700, 5000, 8000}) {
    project.master.cycle_time = us * kMicrosecond;
    std::vector<int> slaves;
    const auto result = compile(project);
    for (const auto& finding : result->findings) {
      if (finding.severity == Severity::kError) slaves.push_back(finding.place.slave);
    }
    EXPECT_THAT(slaves, testing::Contains(1)) << us;
  }
  project.master.cycle_time = 250 * kMicrosecond;
  EXPECT_TRUE(errors(project).empty());
}

}  // namespace
}  // namespace syncline
