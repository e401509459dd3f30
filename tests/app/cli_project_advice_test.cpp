// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/cli_runner.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;

class CliProjectAdvice : public testing::Test {
 protected:
  void SetUp() override {
    const auto create = cli_run({"project", "create", file, "--scan", demo(), "--cycle", "1000"});
    ASSERT_EQ(create.code, cli::kDone) << create.err;
  }
  const TemporaryFolder folder;
  const std::string file = folder.file("m.syncline");
};

TEST_F(CliProjectAdvice, ReportNamesFramesSlavesAndObjects) {
  const auto report = cli_run({"project", "report", file, "--json"});
  ASSERT_EQ(report.code, cli::kDone) << report.err;
  const auto json = report.json();
  EXPECT_EQ(json["cycle_us"], 1000.0);
  ASSERT_FALSE(json["frames"].empty());
  double wire_time = 0;
  for (const auto& frame : json["frames"]) wire_time += frame["wire_time_us"].get<double>();
  EXPECT_DOUBLE_EQ(json["wire_time_us"].get<double>(), wire_time);
  EXPECT_NEAR(json["bandwidth"].get<double>(), wire_time / 1000, 1e-9);
  for (std::size_t i = 1; i < json["slaves"].size(); ++i) {
    EXPECT_GE(json["slaves"][i - 1]["wire_time_us"], json["slaves"][i]["wire_time_us"]);
  }
  EXPECT_THAT(cli_run({"project", "report", file}).out, HasSubstr("% of the bandwidth"));
}

TEST_F(CliProjectAdvice, CycleTimesSayNoToACycleThatSomebodyRefuses) {
  const auto good = cli_run({"project", "cycle-times", file, "--json"});
  ASSERT_EQ(good.code, cli::kDone) << good.err;
  EXPECT_EQ(good.json()["current"]["accepted"], true);
  ASSERT_EQ(cli_run({"project", "set", file, "master.cycle_time_us=31.25"}).code, cli::kDone);
  const auto bad = cli_run({"project", "cycle-times", file, "--json"});
  EXPECT_EQ(bad.code, cli::kAnswerIsNo);
  EXPECT_FALSE(bad.json()["current"]["refusals"].empty());
  EXPECT_THAT(cli_run({"project", "cycle-times", file}).out, HasSubstr("refused (the project's cycle)"));
}

TEST_F(CliProjectAdvice, AnEniIsTakenToo) {
  const auto eni = folder.file("m.xml");
  ASSERT_EQ(cli_run({"export", file, "-o", eni}).code, cli::kDone);
  const auto of_project = cli_run({"project", "report", file, "--json"}).json();
  const auto of_eni = cli_run({"project", "report", eni, "--json"});
  ASSERT_EQ(of_eni.code, cli::kDone) << of_eni.err;
  EXPECT_EQ(of_eni.json()["wire_time_us"], of_project["wire_time_us"]);
  EXPECT_EQ(of_eni.json()["frames"], of_project["frames"]);
}

TEST_F(CliProjectAdvice, OneFileForSeveralNetworks) {
  const auto machine = folder.file("machine.syncline");
  for (const char* name : {"Feeder", "Press"}) {
    ASSERT_EQ(cli_run({"project", "create", machine, "--network", name, "--scan", demo()}).code, cli::kDone);
  }
  const auto asked = cli_run({"project", "show", machine, "network.name"});
  EXPECT_EQ(asked.code, cli::kUsage);
  EXPECT_THAT(asked.err, HasSubstr("0 \"Feeder\", 1 \"Press\""));
  ASSERT_EQ(cli_run({"project", "set", machine, "--network", "Press", "master.cycle_time_us=4000"}).code, cli::kDone);
  EXPECT_EQ(cli_run({"project", "show", machine, "--network", "1", "master.cycle_time_us"}).out,
            "master.cycle_time_us=4000\n");
  EXPECT_EQ(cli_run({"project", "show", machine, "--network", "Feeder", "master.cycle_time_us"}).out,
            "master.cycle_time_us=1000\n");
}

TEST_F(CliProjectAdvice, SlowSlavesGetATaskOfTheirOwnAndReachOp) {
  ASSERT_EQ(cli_run({"project", "set", file, "master.task.0=Slow x4", "master.sync_unit.0=Late@Slow",
                     "slave.1.sync_unit.inputs=Late", "slave.1.sync_unit.outputs=Late", "slave.2.sync_unit.inputs=Late",
                     "slave.2.sync_unit.outputs=Late"})
                .code,
            cli::kDone);
  const auto report = cli_run({"project", "report", file, "--json"}).json();
  ASSERT_EQ(report["frames"].size(), 2U);
  EXPECT_EQ(report["frames"][1]["cycle_us"], 4000.0);
  const auto run = cli_run({"run", file, "--link", demo(), "--for", "1s", "--json"});
  EXPECT_EQ(run.code, cli::kDone) << run.err << run.out.substr(0, 400);
}

}  // namespace
}  // namespace syncline::test
