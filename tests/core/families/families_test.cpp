// SPDX-License-Identifier: Apache-2.0
#include "families/families.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "config/device_description.h"
#include "config/mailbox_config.h"
#include "config/slave_config.h"
#include "families/device_family.h"

namespace syncline::families {
namespace {

Identity identity(std::uint32_t vendor, std::uint32_t product) {
  Identity identity;
  identity.vendor_id = vendor;
  identity.product_code = product;
  return identity;
}

const Identity kSigma5 = identity(0x539, 0x0220'0001), kSigma7 = identity(0x539, 0x0220'0301),
               kSigmaX = identity(0x539, 0x0220'0901), kInverter = identity(0x539, 0x0000'0001),
               kXe2 = identity(0xAB, 0x10B0), kEl6751 = identity(0x2, 0x1A5F'3052), kServo = identity(0x5C17, 0x7001),
               kDrive = identity(0x5C17, 0x7002), kGateway = identity(0x5C17, 0x6751);

std::string id_of(const Identity& device) {
  const Family* family = find(device);
  return family == nullptr ? "" : std::string(family->id);
}

DeviceDescription device(const Identity& identity) {
  DeviceDescription device;
  device.identity = identity;
  return device;
}

SlaveConfig with_limit(const Identity& device, std::vector<std::uint8_t> data) {
  SlaveConfig slave;
  slave.identity = device;
  CoeInitCmd cmd;
  cmd.command.index = 0x10F1;
  cmd.command.sub_index = 2;
  cmd.command.data = std::move(data);
  slave.mailbox.emplace().coe_commands.push_back(cmd);
  return slave;
}

TEST(Families, AreFoundByVendorAndProduct) {
  EXPECT_EQ(id_of(kSigma5), "yaskawa-sigma-5");
  EXPECT_EQ(id_of(kSigma7), "yaskawa-sigma-7");
  EXPECT_EQ(id_of(kSigmaX), "yaskawa-sigma-x");
  EXPECT_EQ(id_of(identity(0x539, 0x0220'0777)), "yaskawa-sigma");
  EXPECT_EQ(id_of(kInverter), "") << "the vendor's other devices have other habits";
  EXPECT_EQ(id_of(kXe2), "copley");
  EXPECT_EQ(id_of(kEl6751), "beckhoff-el6751");
  EXPECT_EQ(id_of(identity(0x2, 0x0AFC'3052)), "");
  EXPECT_EQ(id_of(kServo), "sl-sv7");
  EXPECT_EQ(id_of(kDrive), "sl-xe2");
  EXPECT_EQ(id_of(kGateway), "sl-6751");
}

TEST(Families, AreFoundByTheTypeWhereTheProductIsNew) {
  DeviceDescription device;
  device.identity = identity(0x539, 0x1234);
  device.type = "SGDXW-xxxxA0x EtherCAT(CoE)";
  ASSERT_NE(find(device), nullptr);
  EXPECT_EQ(find(device)->id, "yaskawa-sigma-x");
  device.type = "GA500";
  EXPECT_EQ(find(device), nullptr);
}

TEST(Families, NameASourceForEachGroupAndContradictNothing) {
  std::set<std::string_view> ids;
  for (const Family* family : all()) {
    SCOPED_TRACE(std::string(family->id));
    EXPECT_TRUE(ids.insert(family->id).second) << "twice";
    EXPECT_FALSE(family->name.empty() || family->devices.empty());
    if (family->counters) {
      EXPECT_FALSE(family->counters->source.empty());
      EXPECT_NE(family->counters->missed, family->counters->cycle_exceeded);
    }
    if (family->cycle) {
      const CycleLimits& cycle = *family->cycle;
      EXPECT_FALSE(cycle.source.empty());
      EXPECT_EQ(cycle.full_step % cycle.step, 0);
      EXPECT_EQ(cycle.full_step == cycle.step, cycle.otherwise.empty());
      EXPECT_TRUE(cycle.longest == 0 || cycle.shortest <= cycle.longest);
    }
    if (family->error_limit) {
      EXPECT_FALSE(family->error_limit->source.empty());
      EXPECT_LE(family->error_limit->usual, family->error_limit->largest);
    }
    if (family->status) {
      EXPECT_FALSE(family->status->source.empty() || family->status->bits.empty());
    }
    if (family->pins) {
      EXPECT_FALSE(family->pins->source.empty() || family->pins->functions.empty());
    }
    if (family->gateway) {
      EXPECT_FALSE(family->gateway->source.empty());
    }
    if (family->times) {
      EXPECT_FALSE(family->times->source.empty());
    }
    EXPECT_EQ(family->alarms.source.empty(), family->alarms.list.empty());
    EXPECT_EQ(family->sync_types.source.empty(), family->sync_types.outputs.empty());
    EXPECT_EQ(family->modes_need_dc.source.empty(), family->modes_need_dc.list.empty());
    EXPECT_EQ(family->objects.source.empty(), family->objects.per_direction == 0);
  }
}

TEST(Families, SimulatedDevicesHaveTheHabitsOfTheirFamily) {
  for (const auto& [behaviour, real] :
       {std::pair{"servo-y", kSigma5}, std::pair{"drive-c", kXe2}, std::pair{"can-gateway", kEl6751}}) {
    const Family* simulated = of_behaviour(behaviour);
    ASSERT_NE(simulated, nullptr) << behaviour;
    EXPECT_EQ(simulated->counters, find(real)->counters) << behaviour;
  }
  for (const auto& identity : {kSigma5, kSigma7, kSigmaX}) EXPECT_EQ(behaviour_of(device(identity)), "servo-y");
  EXPECT_EQ(behaviour_of(device(kXe2)), "drive-c");
  EXPECT_EQ(behaviour_of(device(kEl6751)), "can-gateway");
  EXPECT_EQ(behaviour_of(device(identity(1, 1))), "generic");
  EXPECT_EQ(of_behaviour("generic"), nullptr);
  EXPECT_EQ(of_behaviour(""), nullptr);
}

TEST(Families, SayWhereTheCountersStand) {
  EXPECT_EQ(sync_counters(kSigma5)->missed, 0x0C);
  EXPECT_EQ(sync_counters(kSigma5)->cycle_exceeded, 0x0B);
  EXPECT_EQ(sync_counters(kSigmaX)->missed, 0x0B);
  EXPECT_EQ(sync_counters(kSigmaX)->cycle_exceeded, 0);
  EXPECT_FALSE(sync_counters(kSigma7)) << "the sources disagree";
  EXPECT_EQ(sync_counters(kXe2)->missed, 0x0B);
  EXPECT_EQ(sync_counters(kEl6751)->missed, 0x0B) << "the ESI is right, not the text";
  EXPECT_EQ(sync_counters(kEl6751)->cycle_exceeded, 0x0C);
  EXPECT_EQ(sync_counters(kGateway), sync_counters(kEl6751));
  EXPECT_FALSE(sync_counters(identity(1, 1)));
}

TEST(Families, KnowTheErrorLimitOfASlave) {
  SlaveConfig slave;
  slave.identity = kSigma7;
  EXPECT_EQ(error_limit(slave), 9U);
  slave.identity = identity(1, 1);
  EXPECT_FALSE(error_limit(slave));
  EXPECT_EQ(error_limit(with_limit(kSigma7, {15, 0})), 15U);
  EXPECT_EQ(error_limit(with_limit(identity(1, 1), {0, 0, 0, 0})), 0U) << "some have it with 32 bits";
}

TEST(Families, HaveTheVendorsNamesOfAlarms) {
  EXPECT_EQ(alarm_text(kSigma7, 0x0A12), "A.A12 (0x0A12) EtherCAT Outputs Data Synchronization Error");
  EXPECT_EQ(alarm_text(kDrive, 0x8700), "0x8700 Sync controller");
  EXPECT_EQ(alarm_text(kSigma7, 0x1234), "0x1234");
  EXPECT_EQ(alarm_text(identity(1, 1), 0x0A12), "0x0A12");
  // Emergency of a Sigma-X: FF00h, error register, one byte reserved, the alarm.
  EXPECT_EQ(find_alarm(kSigmaX, 0xFF00, {0x00, 0x12, 0x0A}), find_alarm(kSigmaX, 0x0A12));
  EXPECT_EQ(find_alarm(kServo, 0x0A12, {}), find_alarm(kServo, 0x0A12));
  EXPECT_EQ(find_alarm(kSigmaX, 0xFF00, {}), nullptr);
}

}  // namespace
}  // namespace syncline::families
