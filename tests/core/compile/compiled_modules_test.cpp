// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compile/compile.h"
#include "config/module_slots.h"
#include "findings/finding.h"
#include "tests/support/modular_device.h"

namespace syncline {
namespace {

using sample::gateway;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(CompiledModules, HaveTheIndicesOfTheirPlaces) {
  Project project;
  project.slaves = {default_slave(gateway(), 0)};
  const auto result = compile(project).value();
  EXPECT_THAT(result.findings, IsEmpty());
  const SlaveConfig& slave = result.config.slaves[0];
  EXPECT_EQ(slave.send->bit_length, 3 * 16U);
  EXPECT_EQ(slave.pdos.back().pdo.index, 0x1620);
  EXPECT_EQ(slave.pdos.back().pdo.entries[0].index, 0x7040);
  // 0xF030: cleared, four places (the first is empty), the count; then the start-up commands of the modules.
  const auto& commands = slave.mailbox->coe_commands;
  ASSERT_GE(commands.size(), 6U);
  EXPECT_EQ(commands[1].command.index, 0xF030);
  EXPECT_THAT(commands[1].command.data, ElementsAre(0, 0, 0, 0));
  EXPECT_THAT(commands[4].command.data, ElementsAre(0, 1, 0, 0));
  EXPECT_THAT(commands[5].command.data, ElementsAre(4));
  EXPECT_EQ(commands.back().command.index, 0x9000);
}

TEST(CompiledModules, AreFoundAtTheirPlaces) {
  Project project;
  project.slaves = {default_slave(gateway(), 0)};
  ASSERT_TRUE(plug_module(project.slaves[0], 1, std::nullopt));
  auto findings = compile(project).value().findings;
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].place.key, "slave.0.module.1");
  project.slaves[0].modules.insert(project.slaves[0].modules.begin(), {1, 0x999});
  findings = compile(project).value().findings;
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_THAT(describe(findings[0]), HasSubstr("0x00000999"));
}

}  // namespace
}  // namespace syncline
