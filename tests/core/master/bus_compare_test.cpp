// SPDX-License-Identifier: Apache-2.0
#include "master/scan/bus_compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "channels/values/bus_scan.h"
#include "check/network_view.h"
#include "compare/compare_configs.h"
#include "compile/compile.h"
#include "tests/support/sample_devices.h"

namespace syncline {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

NetworkConfig machine() {
  return compile(sample::project({sample::coupler(), sample::digital_input(), sample::servo(), sample::servo()}))
      ->config;
}

/// The bus that a configuration describes, in INIT.
BusScan bus_of(const NetworkConfig& config) {
  BusScan scan;
  for (const auto& slave : config.slaves) {
    ScannedSlave found;
    found.position = static_cast<std::uint16_t>(scan.slaves.size());
    found.identity = slave.identity;
    found.identity.serial_no = 77;
    found.alias = 9;
    found.previous = slave.previous;
    found.dc = DcCapability::kSystemTime64;
    scan.slaves.push_back(found);
  }
  return scan;
}

/// Registers as the init commands leave them.
std::vector<std::optional<RunningRegisters>> running(const NetworkConfig& config) {
  std::vector<std::optional<RunningRegisters>> out;
  const checker::NetworkView view(config);
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    RunningRegisters registers;
    for (const auto& write : view.registers[i].managers) registers.managers.at(write.number) = write.manager;
    registers.activation = view.assign_activate(i);
    if (config.slaves[i].dc) registers.cycle_time0 = static_cast<std::uint32_t>(config.slaves[i].dc->cycle_time0);
    out.emplace_back(registers);
  }
  return out;
}

std::vector<std::string> words(const std::vector<ConfigDifference>& differences) {
  std::vector<std::string> out;
  for (const auto& difference : differences) out.push_back(describe(difference));
  return out;
}

TEST(BusCompare, TheConfiguredBusDiffersInNothing) {
  const NetworkConfig config = machine();
  EXPECT_THAT(words(compare_with_bus(config, bus_of(config))), IsEmpty());
  EXPECT_THAT(words(compare_with_bus(config, bus_of(config), running(config))), IsEmpty());
}

TEST(BusCompare, MissingExtraAndOtherDevicesAreNamed) {
  NetworkConfig config = machine();
  BusScan scan = bus_of(config);
  scan.slaves.erase(scan.slaves.begin() + 1);
  scan.slaves[1].previous = PreviousPort{0, 1};
  scan.slaves[2].previous = PreviousPort{1, 1};
  EXPECT_THAT(words(compare_with_bus(config, scan)),
              testing::Contains("slave 1 (Slave_1002 [SI1002]): device 0x000005ec:0x00001002:0x00010000 -> missing"));
  scan = bus_of(config);
  scan.slaves.push_back(scan.slaves[1]);
  EXPECT_THAT(words(compare_with_bus(config, scan)),
              ElementsAre("slave 4: device not configured -> 0x000005ec:0x00001002:0x00010000"));
  scan = bus_of(config);
  scan.slaves[1].identity.product_code = 0x1004;
  scan.slaves[2].identity.revision_no = 0x20000;
  EXPECT_THAT(words(compare_with_bus(config, scan)),
              ElementsAre("slave 1 (Slave_1002 [SI1002]): device 0x000005ec:0x00001002 -> 0x000005ec:0x00001004",
                          "slave 2 (Slave_1003 [SV402]): revision 0x00010002 -> 0x00020000"));
}

TEST(BusCompare, SerialNumberAndAliasCountWhereTheyAreConfigured) {
  NetworkConfig config = machine();
  const BusScan scan = bus_of(config);
  config.slaves[2].identity.serial_no = 5;
  config.slaves[2].alias = 3;
  EXPECT_THAT(words(compare_with_bus(config, scan)), ElementsAre("slave 2 (Slave_1003 [SV402]): serial number 5 -> 77",
                                                                 "slave 2 (Slave_1003 [SV402]): alias 3 -> 9"));
}

TEST(BusCompare, WiringAndClocksAreCompared) {
  const NetworkConfig config = machine();
  BusScan scan = bus_of(config);
  scan.slaves[3].previous = PreviousPort{0, 2};
  scan.slaves[2].dc = DcCapability::kNone;
  EXPECT_THAT(words(compare_with_bus(config, scan)),
              ElementsAre("slave 2 (Slave_1003 [SV402]): distributed clocks used -> the device has none",
                          "slave 3 (Slave_1004 [SV402]): hangs on port B of slave 2 -> port C of slave 0"));
}

TEST(BusCompare, RegistersOfRunningSlavesAreCompared) {
  const NetworkConfig config = machine();
  auto registers = running(config);
  registers[2]->managers[3].length += 2;
  registers[2]->cycle_time0 = 2'000'000;
  registers[3]->activation = 0;
  EXPECT_THAT(
      words(compare_with_bus(config, bus_of(config), registers)),
      ElementsAre(
          "slave 2 (Slave_1003 [SV402]): SM3 8 bytes at 0x1180, control 0x20 -> 10 bytes at 0x1180, control 0x20",
          "slave 2 (Slave_1003 [SV402]): SYNC0 cycle 1 ms -> 2 ms",
          "slave 3 (Slave_1004 [SV402]): activation (0x0980) 0x0300 -> 0x0000"));
}

}  // namespace
}  // namespace syncline
