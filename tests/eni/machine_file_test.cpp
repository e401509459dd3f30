// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <filesystem>

#include "config/project.h"
#include "eni/project/project_file.h"
#include "support/random_project.h"

namespace syncline::eni {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Project network(std::uint32_t seed, std::string name) {
  Project project = test::RandomProject(seed).project();
  project.name = std::move(name);
  return project;
}

Machine press_line() { return {"Line 7", {network(3, "Feeder"), network(5, "Press"), network(3, "1")}}; }

TEST(MachineFile, ComesBackEqualAndWithTheSameBytes) {
  EXPECT_TRUE(rc::check([](std::uint32_t seed, std::uint8_t more) {
    Machine machine{seed % 2 == 0 ? "" : "Line 7", {}};
    for (unsigned i = 0; i <= more % 3U; ++i) machine.networks.push_back(test::RandomProject(seed + i).project());
    const auto text = write_machine(machine);
    const auto read = parse_machine(text, "m.syncline");
    RC_ASSERT(read.has_value());
    RC_ASSERT(*read == machine);
    RC_ASSERT(write_machine(*read) == text);
  }));
}

TEST(MachineFile, OneNetworkIsWrittenAsOlderProgramsReadIt) {
  const Project project = network(3, "");
  const auto text = write_machine({"", {project}});
  EXPECT_EQ(text, write_project(project));
  EXPECT_THAT(text, HasSubstr("Version=\"1\""));
  EXPECT_THAT(text, Not(HasSubstr("<Network")));
}

TEST(MachineFile, DevicesOfSeveralNetworksAreWrittenOnce) {
  const auto machine = press_line();
  const auto text = write_machine(machine);
  std::size_t count = 0;
  for (auto at = text.find("<DeviceDescription "); at != std::string::npos;
       at = text.find("<DeviceDescription ", at + 1))
    ++count;
  EXPECT_EQ(count, machine.networks[0].slaves.size() + machine.networks[1].slaves.size());
}

TEST(MachineFile, ANetworkIsChosenByNameOrNumber) {
  const auto machine = press_line();
  EXPECT_EQ(find_network(machine, "Press"), 1U);
  EXPECT_EQ(find_network(machine, "0"), 0U);
  EXPECT_EQ(find_network(machine, "1"), 1U);  // the number stands before the name in the file
  const auto none = find_network(machine, "").error();
  EXPECT_EQ(none.code, ErrorCode::kBadValue);
  EXPECT_EQ(none.subject, "--network");
  EXPECT_THAT(none.detail.text(), HasSubstr("0 \"Feeder\", 1 \"Press\", 2 \"1\""));
  EXPECT_THAT(find_network(machine, "Pump").error().detail.text(), HasSubstr("\"Press\""));
}

TEST(MachineFile, LoadingAProjectAsksWhich) {
  const auto path = (std::filesystem::path(testing::TempDir()) / "machine_file_test.syncline").string();
  const auto machine = press_line();
  ASSERT_TRUE(save_machine(machine, path));
  EXPECT_EQ(load_project(path).error().subject, "--network");
  EXPECT_EQ(load_project(path, "Press"), machine.networks[1]);
  ASSERT_TRUE(save_project(machine.networks[0], path));
  EXPECT_EQ(load_project(path), machine.networks[0]);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace syncline::eni
