// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/app/cli_runner.h"
#include "tests/support/source_dir.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;

std::string scenario(const std::string& name) {
  return "sim:" + test::source_dir() + "/resources/" + name + "?virtual";
}

/// Our own export, in which `from` is replaced once.
std::string edited(const TemporaryFolder& folder, const std::string& from, const std::string& to) {
  const auto project = folder.file("m.syncline");
  const auto eni = folder.file("m.eni.xml");
  EXPECT_EQ(cli_run({"project", "create", project, "--scan", demo()}).code, cli::kDone);
  EXPECT_EQ(cli_run({"export", project, "-o", eni}).code, cli::kDone);
  std::string text = read_text(eni);
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos);
  text.replace(at, from.size(), to);
  std::ofstream(eni, std::ios::binary) << text;
  return eni;
}

TEST(CliCheck, ExportsOfEveryMachineOfOursAreWithoutErrorAndWarning) {
  const TemporaryFolder folder;
  for (const char* name : {"demo/machine.toml", "scenarios/all-devices.toml", "scenarios/sixteen-networks.toml",
                           "scenarios/thousand.toml"}) {
    const auto project = folder.file("m.syncline");
    const auto eni = folder.file("m.eni.xml");
    ASSERT_EQ(
        cli_run({"project", "create", project, "--scan", scenario(name), "--sync-window", "on", "--cycle", "1000"})
            .code,
        cli::kDone);
    for (const char* dialect : {"ec-master", "twincat"}) {
      ASSERT_EQ(cli_run({"export", project, "-o", eni, "--dialect", dialect}).code, cli::kDone) << name;
      const auto run = cli_run({"check", eni, "--strict", "--severity", "warning"});
      EXPECT_EQ(run.code, cli::kDone) << name << ' ' << dialect << '\n' << run.out;
      EXPECT_THAT(run.out, HasSubstr("0 errors, 0 warnings"));
    }
  }
}

TEST(CliCheck, AFindingNamesFileLineReasonAndRemedy) {
  const TemporaryFolder folder;
  const auto eni = edited(folder, "<ReferenceClock>1</ReferenceClock>", "<ReferenceClock>0</ReferenceClock>");
  const auto run = cli_run({"check", eni});
  EXPECT_EQ(run.code, cli::kAnswerIsNo);
  EXPECT_THAT(run.out, testing::ContainsRegex("m\\.eni\\.xml:[0-9]+: error: .*\\[ENI-DC-03\\]"));
  EXPECT_THAT(run.out, HasSubstr("at   /EtherCATConfig/Config/Cyclic[1]/Frame[1]/Cmd["));
  EXPECT_THAT(run.out, HasSubstr("why  "));
  EXPECT_THAT(run.out, HasSubstr("mend "));
  const auto report = cli_run({"check", eni, "--json"}).json();
  EXPECT_EQ(report["errors"], 1);
  EXPECT_EQ(report["findings"][0]["code"], "ENI-DC-03");
  EXPECT_GT(report["findings"][0]["line"].get<int>(), 100);
}

TEST(CliCheck, SeverityAndStrictSayWhatCounts) {
  const TemporaryFolder folder;
  const auto eni = edited(folder, "<PhysAddr>1001</PhysAddr>", "<PhysAddr>0x3e9</PhysAddr>");
  EXPECT_EQ(cli_run({"check", eni}).code, cli::kDone);
  EXPECT_EQ(cli_run({"check", eni, "--strict"}).code, cli::kAnswerIsNo);
  EXPECT_THAT(cli_run({"check", eni}).out, HasSubstr("ENI-XML-06"));
  const auto errors_only = cli_run({"check", eni, "--severity", "error"});
  EXPECT_THAT(errors_only.out, testing::Not(HasSubstr("ENI-XML-06")));
  EXPECT_THAT(errors_only.out, HasSubstr("0 errors, 1 warning,"));
}

TEST(CliCheck, OtherFilesAndNoFileAreRefused) {
  EXPECT_EQ(cli_run({"check"}).code, cli::kUsage);
  EXPECT_EQ(cli_run({"check", "there-is-no-such-file.xml"}).code, cli::kFailed);
  EXPECT_EQ(cli_run({"check", test::source_dir() + "/resources/demo/machine.toml"}).code, cli::kAnswerIsNo);  // no XML
  EXPECT_THAT(cli_run({"check", "--rules"}).out, HasSubstr("ENI-FMMU-02"));
}

TEST(CliCompare, ABusIsComparedWithWhatIsConfigured) {
  const TemporaryFolder folder;
  const auto project = folder.file("m.syncline");
  ASSERT_EQ(cli_run({"project", "create", project, "--scan", demo()}).code, cli::kDone);
  EXPECT_EQ(cli_run({"compare", project, demo()}).code, cli::kDone);
  const auto run = cli_run({"compare", project, scenario("scenarios/all-devices.toml"), "--json"});
  EXPECT_EQ(run.code, cli::kAnswerIsNo);
  const auto differences = run.json()["differences"];
  ASSERT_FALSE(differences.empty());
  for (const auto& difference : differences) {
    EXPECT_THAT((std::vector<std::string>{"slaves", "wiring", "clocks", "mailbox"}),
                testing::Contains(difference["group"].get<std::string>()));
  }
  EXPECT_THAT(run.out, HasSubstr("not configured -> 0x"));
  EXPECT_THAT(run.out, HasSubstr("-> missing"));
}

TEST(CliCompare, SettingsHaveNamesAndDetailsHaveBytes) {
  const TemporaryFolder folder;
  const auto project = folder.file("m.syncline");
  const auto eni = folder.file("m.eni.xml");
  ASSERT_EQ(cli_run({"project", "create", project, "--scan", demo()}).code, cli::kDone);
  ASSERT_EQ(cli_run({"export", project, "-o", eni}).code, cli::kDone);
  ASSERT_EQ(cli_run({"project", "set", project, "slave.3.dc.sync0.factor=2"}).code, cli::kDone);
  const auto run = cli_run({"compare", eni, project, "--details"});
  EXPECT_EQ(run.code, cli::kAnswerIsNo);
  EXPECT_THAT(run.out, HasSubstr("SYNC0 cycle 1 ms -> 2 ms"));
  EXPECT_THAT(run.out, HasSubstr("0x09a0"));
}

}  // namespace
}  // namespace syncline::test
