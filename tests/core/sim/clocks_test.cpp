// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "protocol/speed_counter.h"
#include "protocol/system_time_difference.h"
#include "tests/core/sim/sim_probe.h"

namespace syncline::test {
namespace {

SimConfig two_clocks(double ppm, bool wide) {
  auto config = line({sim_slave("SL-1100"), sim_slave("SL-SV7", "servo-y")});
  config.slaves[1].oscillator.ppm = ppm;
  config.slaves[1].oscillator.start_offset = 4'294'960'000;  // wraps 32 bit 7 us after power-on
  config.slaves[1].dc.is_64bit = wide;
  config.slaves[1].cable_m = 100;
  return config;
}

class SimClockWidths : public testing::TestWithParam<bool> {};

TEST_P(SimClockWidths, LatchShowsTheRoundTripWhateverTheClocksShow) {
  SimProbe probe(two_clocks(0, GetParam()));
  EXPECT_EQ(probe.send(Command::kBwr, device_address(0, reg::kReceiveTimePort0), {0, 0, 0, 0}).wkc, 2);
  const auto times = probe.read(0, reg::kReceiveTimePort0, 16).data;
  const auto port0 = load_le<std::uint32_t>(std::span(times));
  const auto port1 = load_le<std::uint32_t>(std::span(times).subspan(4));
  // 300 processing + 500 cable + 300 processing of the last + 500 cable; stamps have 10 ns steps.
  EXPECT_NEAR(static_cast<double>(port1 - port0), 1'600, 20);
  EXPECT_NEAR(probe.bus->true_delay_ns(1), 800, 1);
  EXPECT_NE(load_le<std::uint32_t>(std::span(times).subspan(8)), 0U) << "unused ports show garbage, not zero";
}

TEST_P(SimClockWidths, ControlLoopFollowsTheReferenceAndLearnsTheDrift) {
  SimProbe probe(two_clocks(50, GetParam()));
  // Offset: both show the same time at the latch, the second one 800 ns later.
  probe.send(Command::kBwr, device_address(0, reg::kReceiveTimePort0), {0, 0, 0, 0});
  const auto first = probe.read(0, reg::kReceiveTimeProcessingUnit, 8).value<std::uint64_t>();
  const auto second = probe.read(1, reg::kReceiveTimeProcessingUnit, 8).value<std::uint64_t>();
  probe.write(1, reg::kSystemTimeDelay, le_bytes(std::uint32_t{800}));
  const auto offset = first + 800 - second;
  probe.write(1, reg::kSystemTimeOffset, GetParam() ? le_bytes(offset) : le_bytes(static_cast<std::uint32_t>(offset)));
  probe.write(1, reg::kSpeedCounterStart, le_bytes(std::uint16_t{0x1000}));
  probe.write(1, reg::kFilterDepthDifference, {0x00, 0x0C});
  const auto deviation = [&probe] {
    return SystemTimeDifference{probe.read(1, reg::kSystemTimeDifference, 4).value<std::uint32_t>()}.magnitude();
  };
  std::uint32_t largest = 0;
  for (int ms = 0; ms < 25'000; ++ms) {
    EXPECT_EQ(probe.send(Command::kArmw, device_address(0, reg::kSystemTime), {0, 0, 0, 0}).wkc, 2);
    if (ms < 5'000) largest = std::max(largest, deviation());
    probe.pass(kMillisecond - 40 * kMicrosecond);
  }
  EXPECT_GT(largest, 1'000U) << "the loop must err before it has learned";
  EXPECT_LT(deviation(), 50U);
  const auto diff = static_cast<std::int16_t>(probe.read(1, reg::kSpeedCounterDiff, 2).value<std::uint16_t>());
  EXPECT_NEAR(speed_counter_rate(0x1000, diff) * 1e6, 50, 1.0) << "0x0932 tells the learned drift";
  const auto difference = static_cast<std::int32_t>(static_cast<std::uint32_t>(probe.bus->system_time(1)) -
                                                    static_cast<std::uint32_t>(probe.bus->system_time(0)));
  EXPECT_LT(std::abs(difference), 100);
}

INSTANTIATE_TEST_SUITE_P(Widths, SimClockWidths, testing::Bool());

TEST(SimClocks, ReadingSubtractsTheDelay) {
  SimProbe probe(line({sim_slave("SL-1100")}));
  const auto read = [&probe] { return probe.read(0, reg::kSystemTime, 8).value<std::uint64_t>(); };
  const auto before = read();
  probe.write(0, reg::kSystemTimeDelay, le_bytes(std::uint32_t{5'000}));
  const auto after = read();
  EXPECT_NEAR(static_cast<double>(after - before), 40'000 - 5'000, 20);
}

TEST(SimScenario, DemonstrationMachineHasItsBranchesInFrameOrder) {
  const auto config = sim::load_scenario(resource("demo/machine.toml"), scenario_device);
  ASSERT_TRUE(config) << config.error().file << config.error().line << config.error().detail.text();
  ASSERT_EQ(config->slaves.size(), 9U);
  SimProbe probe(*config);
  EXPECT_EQ(probe.send(Command::kBrd, device_address(0, reg::kType), {0}).wkc, 9);
  for (std::size_t i = 1; i < 9; ++i) EXPECT_GT(probe.bus->true_delay_ns(i), 0);
}

struct BadScenario {
  const char* text;
  const char* key;
  int line;
};
class SimScenarioErrors : public testing::TestWithParam<BadScenario> {};

TEST_P(SimScenarioErrors, NameFileLineAndKey) {
  const auto path = testing::TempDir() + "scenario.toml";
  std::ofstream(path) << GetParam().text;
  const auto config = sim::load_scenario(path, [](sim::DeviceQuery query) {
    query.path = resource("esi/SL-1100.xml");
    return scenario_device(query);
  });
  ASSERT_FALSE(config);
  EXPECT_EQ(config.error().file, path);
  EXPECT_EQ(config.error().line, GetParam().line);
  EXPECT_EQ(config.error().subject, GetParam().key);
}

INSTANTIATE_TEST_SUITE_P(
    Texts, SimScenarioErrors,
    testing::Values(BadScenario{"name = \"x\"\nspeed = 3\n[[slave]]\nesi = \"a\"\n", "speed", 2},
                    BadScenario{"[[slave]]\nesi = \"a\"\nppm = \"fast\"\n", "ppm", 3},
                    BadScenario{"[[slave]]\nesi = \"a\"\n[[slave]]\nesi = \"a\"\nparent = 7\n", "parent", 5},
                    BadScenario{"[[slave]]\nesi = \"a\"\n[[slave]]\nesi = \"a\"\nport = \"A\"\n", "port", 5},
                    BadScenario{"[[slave]]\nesi = \"a\"\n[[fault]]\nkind = \"flood\"\n", "kind", 4},
                    BadScenario{"[host]\njitter = \"some\"\n[[slave]]\nesi = \"a\"\n", "jitter", 2},
                    BadScenario{"[[slave]]\nname = \"x\"\nesi = \"a\"\ncable_m = -1\n", "cable_m", 4}));

TEST(SimScenario, MalformedTomlNamesTheLineAndAMissingFileItsName) {
  const auto path = testing::TempDir() + "broken.toml";
  std::ofstream(path) << "name = \"x\"\nseed = = 3\n";
  const auto broken = sim::load_scenario(path, scenario_device);
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.error().code, ErrorCode::kTomlMalformed);
  EXPECT_EQ(broken.error().line, 2);
  const auto missing = sim::load_scenario("/nowhere/x.toml", scenario_device);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kFileNotFound);
}

TEST(SimFaults, FramesCablesAndPowerGoAndComeBack) {
  auto config = line({sim_slave("SL-1100"), sim_slave("SL-2002"), sim_slave("SL-1002")});
  config.faults.push_back({FaultKind::kLoseFrames, -1, 10 * kMillisecond, 0, 2});
  config.faults.push_back({FaultKind::kCableBreak, 1, 20 * kMillisecond, 30 * kMillisecond});
  config.faults.push_back({FaultKind::kSlaveOff, 2, 40 * kMillisecond, 50 * kMillisecond});
  SimProbe probe(config);
  const auto start = probe.now;
  const auto count = [&](Nanoseconds at) {
    probe.pass(start + at - probe.now);
    return probe.send(Command::kBrd, device_address(0, reg::kType), {0});
  };
  EXPECT_EQ(count(kMillisecond).wkc, 3);
  probe.write(2, reg::kStationAddress, {7, 0});
  EXPECT_TRUE(count(10 * kMillisecond).lost);
  EXPECT_TRUE(count(11 * kMillisecond).lost);
  EXPECT_EQ(count(12 * kMillisecond).wkc, 3);
  EXPECT_EQ(count(21 * kMillisecond).wkc, 1);
  EXPECT_EQ(count(31 * kMillisecond).wkc, 3);
  EXPECT_EQ(probe.read(2, reg::kStationAddress, 2).data[0], 7) << "a cut cable loses no state";
  EXPECT_EQ(count(41 * kMillisecond).wkc, 2);
  EXPECT_EQ(count(51 * kMillisecond).wkc, 3);
  EXPECT_EQ(probe.read(2, reg::kStationAddress, 2).data[0], 0) << "power-on resets the registers";
}

TEST(SimBusDeterminism, SameSeedSameBytes) {
  const auto run = [](std::uint64_t seed) {
    auto config = sim::load_scenario(resource("demo/machine.toml"), scenario_device).value();
    config.seed = seed;
    SimProbe probe(config);
    std::vector<std::uint8_t> all;
    for (int i = 0; i < 3'000; ++i) {
      const auto reply = probe.send(Command::kArmw, device_address(0, reg::kSystemTime), std::vector<std::uint8_t>(8));
      all.insert(all.end(), reply.data.begin(), reply.data.end());
      const auto deviation = probe.read(3, reg::kSystemTimeDifference, 4).data;
      all.insert(all.end(), deviation.begin(), deviation.end());
      probe.pass(kMillisecond);
    }
    return all;
  };
  EXPECT_EQ(run(1), run(1));
  EXPECT_NE(run(1), run(2));
}

}  // namespace
}  // namespace syncline::test
