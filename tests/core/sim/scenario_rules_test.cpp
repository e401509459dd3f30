// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "findings/error_text.h"
#include "sim/faults/fault_rules.h"
#include "tests/core/sim/sim_probe.h"

namespace syncline::test {
namespace {

/// A scenario of one slave and one fault in a file of its own.
Result<SimConfig> load(const std::string& device, const std::string& fault) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  const auto path =
      (std::filesystem::temp_directory_path() / (std::string("syncline-") + info->name() + ".toml")).string();
  std::ofstream(path) << "[[slave]]\nesi = \"" << resource("esi/" + device + ".xml") << "\"\n[[fault]]\nslave = 0\n"
                      << fault;
  auto config = sim::load_scenario(path, scenario_device);
  std::filesystem::remove(path);
  return config;
}

TEST(ScenarioRules, OnlyDevicesWithFirmwareCanRefuseStates) {
  const std::string fault = "kind = \"refuse-state\"\nstate = \"OP\"\ncode = 0x1A\n";
  EXPECT_TRUE(load("SL-3002", fault));
  const auto refused = load("SL-1002", fault);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kScenarioKey);
  EXPECT_EQ(refused.error().line, 5);
}

TEST(ScenarioRules, OnlyFirmwareCanHang) {
  EXPECT_TRUE(load("SL-3002", "kind = \"stop-application\"\nat_ms = 5\n"));
  EXPECT_FALSE(load("SL-1002", "kind = \"stop-application\"\n"));
}

/// A scenario that does something to the demonstration machine.
Result<SimConfig> load_beside(const std::string& text) {
  return sim::parse_scenario(text, resource("demo/beside.toml"), scenario_device);
}

/// Of one slave, as its `keys` say it.
Result<SimConfig> load_slave(const std::string& device, const std::string& keys) {
  return sim::parse_scenario("[[slave]]\nesi = \"../esi/" + device + ".xml\"\n" + keys, resource("demo/slave.toml"),
                             scenario_device);
}

TEST(ScenarioRules, SlavesOfACountAreNumberedFromOneAndDiffer) {
  const auto config = load_slave("SL-1002", "name = \"Input\"\nppm = 10\ncount = 50\nspread_ppm = 20\n");
  ASSERT_TRUE(config);
  ASSERT_EQ(config->slaves.size(), 50U);
  double least = 1e9, most = -1e9;
  for (std::size_t i = 0; i < config->slaves.size(); ++i) {
    const auto& slave = config->slaves[i];
    EXPECT_EQ(slave.name, "Input " + std::to_string(i + 1));
    least = std::min(least, slave.oscillator.ppm);
    most = std::max(most, slave.oscillator.ppm);
  }
  EXPECT_GE(least, -10);
  EXPECT_LT(least, -5);
  EXPECT_LE(most, 30);
  EXPECT_GT(most, 25);
}

TEST(ScenarioRules, WhatIsNotSaidOfAnEscsDelaysIsThatOfItsPort) {
  const auto delays = [](const char* device, const char* keys) {
    const auto config = load_slave(device, keys);
    EXPECT_TRUE(config) << keys;
    const auto& given = config->slaves.front().delays;
    return given ? std::pair(given->processing, given->forwarding) : std::pair(0U, 0U);
  };
  EXPECT_EQ(delays("SL-3002", ""), std::pair(0U, 0U)) << "as the ports have them";
  EXPECT_EQ(delays("SL-3002", "tdiff_ns = 30\n"), std::pair(165U, 135U)) << "at E-bus";
  EXPECT_EQ(delays("SL-3002", "forwarding_delay_ns = 100\n"), std::pair(155U, 100U));
  EXPECT_EQ(delays("SL-SV7", "tdiff_ns = 30\n"), std::pair(290U, 260U)) << "at a cable";
  EXPECT_EQ(delays("SL-SV7", "processing_delay_ns = 400\n"), std::pair(400U, 260U));
}

TEST(ScenarioRules, AMachineOfAnotherFileGetsFaults) {
  const auto machine = sim::load_scenario(resource("demo/machine.toml"), scenario_device);
  ASSERT_TRUE(machine);
  const auto broken = load_beside(
      "machine = \"machine.toml\"\nname = \"Broken\"\n[[fault]]\nkind = \"slave-off\"\nslave = 5\nat_ms = 8\n");
  ASSERT_TRUE(broken) << describe(broken.error());
  EXPECT_EQ(broken->name, "Broken");
  EXPECT_EQ(broken->seed, machine->seed);
  EXPECT_EQ(broken->slaves.size(), machine->slaves.size());
  EXPECT_EQ(broken->slaves[3].name, machine->slaves[3].name);
  ASSERT_EQ(broken->faults.size(), machine->faults.size() + 1);
  EXPECT_EQ(broken->faults.back().slave, 5);
  const auto reseeded = load_beside("machine = \"machine.toml\"\nseed = 7\n");
  ASSERT_TRUE(reseeded);
  EXPECT_EQ(reseeded->seed, 7U);
}

TEST(ScenarioRules, AMachineOfAnotherFileHasItsSlavesAndNoMachineOfItsOwn) {
  for (const char* text :
       {"machine = \"nowhere.toml\"\n", "machine = \"machine.toml\"\n[[slave]]\nesi = \"../esi/SL-1002.xml\"\n",
        "machine = \"machine.toml\"\n[host]\nppm = 3\n",
        "machine = \"machine.toml\"\n[[fault]]\nkind = \"slave-off\"\nslave = 9\n"}) {
    const auto refused = load_beside(text);
    ASSERT_FALSE(refused) << text;
    EXPECT_FALSE(refused.error().file.empty()) << text;
  }
  const auto nested = sim::parse_scenario("machine = \"cable-break.toml\"\n", resource("scenarios/faults/nested.toml"),
                                          scenario_device);
  ASSERT_FALSE(nested) << "and so no file is its own machine";
  EXPECT_NE(nested.error().file.find("cable-break.toml"), std::string::npos);
}

/// The same with a [[latch]] behind.
Result<SimConfig> load_latch(const std::string& latch) {
  return load("SL-SV7", "kind = \"slow-mailbox\"\nvalue_ns = 1\n[[latch]]\n" + latch);
}

TEST(ScenarioRules, LatchPulsesHaveAPlaceAndAShape) {
  const auto config = load_latch("slave = 0\ninput = 1\nat_ms = 2\nwidth_ms = 0.25\nperiod_ms = 3\ncount = 4\n");
  ASSERT_TRUE(config) << describe(config.error());
  ASSERT_EQ(config->latch_pulses.size(), 1U);
  const auto& pulses = config->latch_pulses[0];
  EXPECT_EQ(pulses.input, 1);
  EXPECT_EQ(pulses.at, 2 * kMillisecond);
  EXPECT_EQ(pulses.width, 250 * kMicrosecond);
  EXPECT_EQ(pulses.period, 3 * kMillisecond);
  EXPECT_EQ(pulses.count, 4U);
  for (const auto* wrong :
       {"slave = 1\n", "slave = -1\n", "slave = 0\ninput = 2\n", "slave = 0\nwidth_ms = 1\n",
        "slave = 0\nwidth_ms = -0.1\n", "slave = 0\nwidth_ms = 0\n", "slave = 0\ncount = 0\n",
        "slave = 0\nat_ms = nan\n", "slave = 0\nperiod_ms = 86400000\ncount = 2\n", "slave = 0\nlevel = 1\n"}) {
    EXPECT_FALSE(load_latch(wrong)) << wrong;
  }
}

TEST(ScenarioRules, SlowMailboxSaysHowSlow) {
  const auto config = load("SL-SV7", "kind = \"slow-mailbox\"\nvalue_ns = 5000000\n");
  ASSERT_TRUE(config);
  ASSERT_EQ(config->faults.size(), 1U);
  EXPECT_EQ(config->faults[0].kind, FaultKind::kSlowMailbox);
  EXPECT_EQ(config->faults[0].value_ns, 5 * kMillisecond);
}

TEST(ScenarioRules, AStallIsTheHostsAndHasALength) {
  const auto load_alone = [](const std::string& keys) {
    return load("SL-SV7", "kind = \"slow-mailbox\"\nvalue_ns = 1\n[[fault]]\nkind = \"host-stall\"\n" + keys);
  };
  const auto config = load_alone("at_ms = 8000\nvalue_ns = 30000000\n");
  ASSERT_TRUE(config) << describe(config.error());
  EXPECT_EQ(config->faults[1].kind, FaultKind::kHostStall);
  EXPECT_EQ(config->faults[1].value_ns, 30 * kMillisecond);
  EXPECT_FALSE(load_alone("at_ms = 8000\n"));
  EXPECT_FALSE(load_alone("value_ns = -1\n"));
  EXPECT_FALSE(load_alone("slave = 0\nvalue_ns = 30000000\n"));
}

/// Of a scenario that is served to somebody else's host.
TEST(ScenarioRules, WhatTheAdapterDoesIsTheHostsAsItsStallsAre) {
  SimConfig config;
  EXPECT_THAT(sim::host_faults(config), testing::IsEmpty());
  for (const auto kind : {FaultKind::kHostStall, FaultKind::kHoldFrames, FaultKind::kClockSlew, FaultKind::kHoldFrames,
                          FaultKind::kLoseFrames}) {
    config.faults.emplace_back().kind = kind;
  }
  EXPECT_THAT(sim::host_faults(config), testing::ElementsAre("hold-frames", "host-stall"));
}

}  // namespace
}  // namespace syncline::test
