// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/cli_runner.h"
#include "tests/support/source_dir.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;

TEST(CliDc, DelaysAreMeasuredAndShownWithTheirPorts) {
  const auto run = cli_run({"dc", "delays", demo(), "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = run.json();
  EXPECT_EQ(json["rounds"], 20);
  EXPECT_EQ(json["slaves"].size(), 9U);
  EXPECT_TRUE(json["findings"].empty());
  std::int64_t last = -1;
  for (const auto& slave : json["slaves"]) {
    if (slave["delay_ns"].is_null()) continue;
    EXPECT_GT(slave["delay_ns"].get<std::int64_t>(), last);
    last = slave["delay_ns"];
    for (const auto& port : slave["ports"]) EXPECT_GE(port["after_entry_ns"].get<std::int64_t>(), 0);
  }
  EXPECT_GT(last, 1000);
  const auto text = cli_run({"dc", "delays", demo(), "--rounds", "3"});
  ASSERT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("medians of 3 latches"));
}

TEST(CliDc, OnlyLookingLatchesNothing) {
  const auto run = cli_run({"dc", "delays", demo(), "--look-only", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.json()["rounds"], 0);
}

TEST(CliDc, StatusShowsTheClocksWithTheProjectsNames) {
  const TemporaryFolder folder;
  const auto project = folder.file("m.syncline");
  ASSERT_EQ(cli_run({"project", "create", project, "--scan", demo()}).code, 0);
  const auto run = cli_run({"dc", "status", demo(), "--project", project, "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto slaves = run.json()["slaves"];
  ASSERT_EQ(slaves.size(), 9U);
  std::size_t clocks = 0, references = 0;
  for (const auto& slave : slaves) {
    references += slave["reference_clock"].get<bool>() ? 1 : 0;
    if (!slave.contains("system_time_ns")) continue;
    ++clocks;
    EXPECT_EQ(slave["speed_counter_start"], 0x1000);  // as after power-on
    EXPECT_EQ(slave["assign_activate"], "0x0000");
  }
  EXPECT_EQ(references, 1U);
  EXPECT_GE(clocks, 4U);
  const auto text = cli_run({"dc", "status", demo()});
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("SYSTEM TIME ns"));
}

TEST(CliDc, OtherBusThanTheProjectsIsRefused) {
  const TemporaryFolder folder;
  const auto project = folder.file("m.syncline");
  ASSERT_EQ(cli_run({"project", "create", project, "--scan", demo()}).code, 0);
  const auto run =
      cli_run({"dc", "status", "sim:" + test::source_dir() + "/resources/scenarios/all-devices.toml?virtual",
               "--project", project});
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("9"));
}

}  // namespace
}  // namespace syncline::test
