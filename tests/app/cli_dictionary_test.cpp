// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "config/object_description.h"
#include "config/project.h"
#include "eni/project/project_file.h"
#include "tests/app/cli_runner.h"

/// Slaves without an ESI: what they say of themselves.
namespace syncline::test {
namespace {

constexpr std::size_t kServo = 3;  // of the demonstration machine

class CliDictionary : public testing::Test {
 protected:
  Project create(const std::vector<std::string>& more = {}) {
    std::filesystem::create_directories(folder.file("no-esi"));
    std::vector<std::string> arguments{"project", "create", file, "--scan", demo(), "--esi", folder.file("no-esi")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto run = cli_run(arguments);
    EXPECT_EQ(run.code, cli::kDone) << run.err;
    return eni::load_project(file).value_or(Project{});
  }
  TemporaryFolder folder;
  const std::string file = folder.file("m.syncline");
};

TEST_F(CliDictionary, SlavesWithoutAnEsiAreDescribedByTheirObjects) {
  const auto project = create();
  ASSERT_GT(project.slaves.size(), kServo);
  const auto& servo = project.slaves[kServo];
  EXPECT_EQ(servo.device.source, "SII");
  const auto controlword = std::ranges::find(servo.device.dictionary, 0x6040, &ObjectDescription::index);
  ASSERT_NE(controlword, servo.device.dictionary.end());
  EXPECT_EQ(controlword->name, "Controlword");
  ASSERT_FALSE(servo.device.rx_pdos.empty());
  const auto& outputs = servo.device.rx_pdos.front();
  EXPECT_EQ(servo.assigned_rx_pdos, std::vector<std::uint16_t>{outputs.index});
  ASSERT_FALSE(outputs.entries.empty());
  EXPECT_EQ(outputs.entries.front().name, "Controlword");
  EXPECT_EQ(outputs.entries.front().data_type, "UINT");
  EXPECT_TRUE(project.slaves[0].device.dictionary.empty()) << "a coupler has no mailbox";
  const auto run = cli_run({"run", file, "--link", demo(), "--for", "6s"});
  EXPECT_EQ(run.code, cli::kDone) << run.out << run.err;
}

TEST_F(CliDictionary, TheEepromAloneWhenTheUserWantsThat) {
  const auto project = create({"--no-dictionary"});
  ASSERT_GT(project.slaves.size(), kServo);
  EXPECT_TRUE(project.slaves[kServo].device.dictionary.empty());
  EXPECT_FALSE(project.slaves[kServo].device.rx_pdos.empty());
}

}  // namespace
}  // namespace syncline::test
