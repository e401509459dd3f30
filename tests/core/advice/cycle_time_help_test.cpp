// SPDX-License-Identifier: Apache-2.0
#include "advice/cycle_time_help.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/byte_order.h"
#include "tests/support/sample_devices.h"

namespace syncline {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

DeviceDescription family(std::uint32_t vendor, const char* type) {
  auto device = sample::servo();
  device.identity.vendor_id = vendor;
  device.type = type;
  return device;
}

const CycleCandidate& candidate(const CycleTimeHelp& help, Nanoseconds cycle) {
  for (const auto& c : help.candidates) {
    if (c.cycle == cycle) return c;
  }
  ADD_FAILURE() << cycle;
  return help.current;
}

TEST(CycleTimeHelp, CommonMultipleOfTwoFamilies) {
  const auto help = cycle_time_help(sample::project({family(0x539, "SGD7S"), family(0xAB, "XE2")})).value();
  EXPECT_EQ(help.step, 250 * kMicrosecond);  // of 125 and 250
  EXPECT_EQ(help.shortest, 250 * kMicrosecond);
  EXPECT_EQ(help.longest, 4 * kMillisecond);
  EXPECT_TRUE(help.current.accepted());
  EXPECT_TRUE(candidate(help, 250 * kMicrosecond).accepted());
  const auto& short_cycle = candidate(help, 125 * kMicrosecond);
  ASSERT_EQ(short_cycle.refusals.size(), 1U);
  EXPECT_EQ(short_cycle.refusals[0].slave, 1);
  EXPECT_THAT(short_cycle.refusals[0].reason.text(), HasSubstr("multiples of 250 us"));
  const auto& long_cycle = candidate(help, 5 * kMillisecond);
  ASSERT_EQ(long_cycle.refusals.size(), 1U);
  EXPECT_EQ(long_cycle.refusals[0].slave, 0);
}

TEST(CycleTimeHelp, ASlowerTaskMultipliesTheBusCycle) {
  Project project = sample::project({sample::coupler(), family(0xAB, "XE2")});
  project.master.tasks = {{"Slow", 2}};
  project.master.sync_units = {{"Drives", "Slow"}};
  project.slaves[1].output_unit = project.slaves[1].input_unit = "Drives";
  const auto help = cycle_time_help(project).value();
  EXPECT_EQ(help.step, 125 * kMicrosecond);
  EXPECT_TRUE(candidate(help, 125 * kMicrosecond).accepted());
  EXPECT_FALSE(candidate(help, 10 * kMillisecond).accepted());
}

TEST(CycleTimeHelp, AFixedSyncCycleAndTheDictionary) {
  auto fixed = sample::servo();
  fixed.dc->op_modes[0].cycle_time_sync0 = {250'000, std::nullopt, false, {}, {}};
  auto slow = sample::servo();
  slow.dictionary = {
      {0x1C32, "SM 2", {{5, "Minimum cycle time", "UDINT", 32, true, false, le_bytes<std::uint32_t>(400'000)}}}};
  Project project = sample::project({fixed, slow});
  project.master.cycle_time = 300 * kMicrosecond;
  const auto help = cycle_time_help(project).value();
  ASSERT_EQ(help.current.refusals.size(), 2U);
  EXPECT_THAT(help.current.refusals[0].reason.text(), HasSubstr("SYNC0 every 250 us"));
  EXPECT_THAT(help.current.refusals[1].reason.text(), HasSubstr("0x1C32:05"));
  EXPECT_TRUE(candidate(help, 500 * kMicrosecond).accepted());
  project.master.dc.enabled = false;  // no SYNC signals, no rule about them
  EXPECT_EQ(cycle_time_help(project).value().current.refusals.size(), 1U);
}

TEST(CycleTimeHelp, InterpolationTimeAndWireTime) {
  Project project = sample::project({sample::servo()});
  project.master.cycle_time = 31'250;
  const auto help = cycle_time_help(project).value();
  ASSERT_EQ(help.current.refusals.size(), 1U);
  EXPECT_THAT(help.current.refusals[0].reason.text(), HasSubstr("0x60C2"));
  std::vector<DeviceDescription> many(200, sample::digital_output());
  for (auto& device : many) device.rx_pdos[0].entries[0].bit_length = 800;
  const auto busy = cycle_time_help(sample::project(many)).value();
  const auto& refused = candidate(busy, 500 * kMicrosecond);
  ASSERT_FALSE(refused.accepted());
  EXPECT_EQ(refused.refusals[0].slave, -1);
  EXPECT_THAT(refused.refusals[0].reason.text(), HasSubstr("wire time"));
}

TEST(CycleTimeHelp, NothingIsKnownNothingIsRefused) {
  const auto help = cycle_time_help(sample::project({sample::digital_input()})).value();
  for (const auto& c : help.candidates) EXPECT_THAT(c.refusals, IsEmpty());
  EXPECT_FALSE(help.shortest);
  EXPECT_FALSE(help.longest);
}

}  // namespace
}  // namespace syncline
