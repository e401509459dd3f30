// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/core/sim/sim_probe.h"

namespace syncline::test {
namespace {

/// A scenario of one slave and one fault in a file of its own.
Result<SimConfig> load(const std::string& device, const std::string& fault) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  const auto path = (std::filesystem::temp_directory_path() / (std::string("syncline-") + info->name() + ".toml")).string();
  std::ofstream(path) << "[[slave]]\nesi = \"" << resource("esi/" + device + ".xml") << "\"\n[[fault]]\nslave = 0\n" << fault;
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

TEST(ScenarioRules, SlowMailboxSaysHowSlow) {
  const auto config = load("SL-SV7", "kind = \"slow-mailbox\"\nvalue_ns = 5000000\n");
  ASSERT_TRUE(config);
  ASSERT_EQ(config->faults.size(), 1U);
  EXPECT_EQ(config->faults[0].kind, FaultKind::kSlowMailbox);
  EXPECT_EQ(config->faults[0].value_ns, 5 * kMillisecond);
}

}  // namespace
}  // namespace syncline::test
