// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <regex>
#include <set>

#include "tests/app/cli_runner.h"
#include "tests/support/source_dir.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;

TEST(CliUsage, NoCommandAndUnknownCommandAreUsageErrors) {
  EXPECT_EQ(cli_run({}).code, cli::kUsage);
  EXPECT_EQ(cli_run({"frobnicate"}).code, cli::kUsage);
  EXPECT_EQ(cli_run({"--help"}).code, cli::kDone);
}

TEST(CliAdapters, ListsTheSimulatedMachineBesideTheCards) {
  const auto run = cli_run({"adapters", "--json"});
  ASSERT_EQ(run.code, cli::kDone) << run.err;
  const auto rows = run.json()["adapters"];
  ASSERT_GE(rows.size(), 1U);
  EXPECT_EQ(rows[0]["kind"], "simulated");
}

TEST(CliScan, NamesEverySlaveOfTheDemonstrationMachine) {
  const auto run = cli_run({"scan", demo(), "--json"});
  ASSERT_EQ(run.code, cli::kDone) << run.err;
  const auto slaves = run.json()["slaves"];
  ASSERT_GE(slaves.size(), 6U);
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    EXPECT_EQ(slaves[i]["position"], i);
    EXPECT_NE(slaves[i]["vendor_id"], "0x00000000");
    EXPECT_EQ(slaves[i].contains("previous"), i != 0);
  }
}

TEST(CliScan, MissingScenarioIsAFileErrorThatNamesTheFile) {
  const auto run = cli_run({"scan", "sim:/nowhere/at-all.toml?virtual"});
  EXPECT_EQ(run.code, cli::kFailed);
  EXPECT_THAT(run.err, HasSubstr("/nowhere/at-all.toml"));
}

TEST(CliScan, MissingAdapterSaysItsName) {
  const auto run = cli_run({"scan", "nic:no-such-card0"});
  EXPECT_EQ(run.code, cli::kFailed);
  EXPECT_THAT(run.err, HasSubstr("no-such-card0"));
}

TEST(CliProject, CreateSetShowKeepEachOthersValues) {
  const TemporaryFolder folder;
  const auto file = folder.file("m.syncline");
  const auto create = cli_run({"project", "create", file, "--scan", demo(), "--cycle", "2000", "--shift", "master",
                               "--sync-window", "on", "--reference-clock", "0"});
  ASSERT_EQ(create.code, cli::kDone) << create.err;
  const auto shown = cli_run({"project", "show", file, "--json"}).json()["settings"];
  EXPECT_EQ(shown["master.cycle_time_us"], "2000");
  EXPECT_EQ(shown["master.dc.mode"], "master-shift");
  EXPECT_EQ(shown["master.dc.sync_window"], "on");
  EXPECT_EQ(shown["master.dc.reference_clock"], "0");

  ASSERT_EQ(cli_run({"project", "set", file, "master.cycle_time_us=1000", "master.dc.mode=bus-shift"}).code,
            cli::kDone);
  EXPECT_EQ(cli_run({"project", "show", file, "master.cycle_time_us"}).out, "master.cycle_time_us=1000\n");
}

TEST(CliProject, SetOfEveryShownValueChangesNothing) {
  const TemporaryFolder folder;
  const auto file = folder.file("m.syncline");
  ASSERT_EQ(cli_run({"project", "create", file, "--scan", demo()}).code, cli::kDone);
  const auto before = read_text(file);
  std::vector<std::string> arguments{"project", "set", file};
  const auto shown = cli_run({"project", "show", file, "--json"}).json();
  for (const auto& [key, value] : shown["settings"].items()) {
    arguments.push_back(key + "=" + value.get<std::string>());
  }
  ASSERT_GT(arguments.size(), 50U);
  const auto set = cli_run(arguments);
  ASSERT_EQ(set.code, cli::kDone) << set.err;
  EXPECT_EQ(read_text(file), before);
}

TEST(CliProject, BadKeysAndValuesLeaveTheFileAlone) {
  const TemporaryFolder folder;
  const auto file = folder.file("m.syncline");
  ASSERT_EQ(cli_run({"project", "create", file, "--scan", demo()}).code, cli::kDone);
  const auto before = read_text(file);
  for (const char* edit : {"master.no_such=1", "master.cycle_time_us=fast", "master.dc.mode=sideways",
                           "slave.99.name=x", "master.dc.sync_window_exponent=77", "nonsense"}) {
    // The good edit in front must not be saved either.
    const auto run = cli_run({"project", "set", file, "master.name=Changed", edit});
    EXPECT_EQ(run.code, cli::kUsage) << edit;
    EXPECT_FALSE(run.err.empty()) << edit;
    EXPECT_EQ(read_text(file), before) << edit;
  }
}

TEST(CliProject, EveryShownKeyIsExplained) {
  const TemporaryFolder folder;
  const auto file = folder.file("m.syncline");
  ASSERT_EQ(cli_run({"project", "create", file, "--scan", demo()}).code, cli::kDone);
  std::set<std::string> explained;
  const auto keys = cli_run({"project", "keys", "--json"}).json();
  for (const auto& row : keys["keys"]) {
    explained.insert(row["key"].get<std::string>());
    EXPECT_FALSE(row["meaning"].get<std::string>().empty()) << row["key"];
    EXPECT_FALSE(row["name"].get<std::string>().empty()) << row["key"];
    EXPECT_TRUE(row["default"].is_string() && row["goes_to"].is_string() && row["eni"].is_string()) << row["key"];
    EXPECT_NE(row["eni"].get<std::string>().empty(), row["no_eni"].get<std::string>().empty()) << row["key"];
    EXPECT_TRUE(row["expert"].is_boolean()) << row["key"];
  }
  const auto shown = cli_run({"project", "show", file, "--json"}).json();
  for (const auto& [key, value] : shown["settings"].items()) {
    auto pattern = std::regex_replace(key, std::regex("^slave\\.[0-9]+"), "slave.N");
    pattern = std::regex_replace(pattern, std::regex("\\.0x[0-9a-f]+"), ".0xIIII");
    pattern = std::regex_replace(pattern, std::regex("\\.[0-9]+$"), ".K");
    const bool known = explained.contains(pattern);
    EXPECT_TRUE(known) << key;
  }
}

TEST(CliProject, OfflineFromEsiFilesEqualsTheScan) {
  const TemporaryFolder folder;
  const auto slaves = cli_run({"scan", demo(), "--json"}).json()["slaves"];
  std::vector<std::string> arguments{"project", "create", folder.file("offline.syncline"), "--esi",
                                     test::source_dir() + "/resources/esi"};
  for (const auto& slave : slaves) {
    arguments.push_back("--device");
    arguments.push_back(slave["vendor_id"].get<std::string>() + ":" + slave["product_code"].get<std::string>() + ":" +
                        slave["revision_no"].get<std::string>());
  }
  const auto offline = cli_run(arguments);
  ASSERT_EQ(offline.code, cli::kDone) << offline.err;
  ASSERT_EQ(cli_run({"project", "create", folder.file("scan.syncline"), "--scan", demo()}).code, cli::kDone);
  auto a = cli_run({"project", "show", folder.file("offline.syncline"), "--json"}).json()["settings"];
  auto b = cli_run({"project", "show", folder.file("scan.syncline"), "--json"}).json()["settings"];
  for (auto* settings : {&a, &b}) {
    for (auto it = settings->begin(); it != settings->end();) {
      // Offline devices stand in a line; a scan knows the branches and the alias.
      const bool wiring = it.key().find("previous") != std::string::npos || it.key().find("alias") != std::string::npos;
      it = wiring ? settings->erase(it) : std::next(it);
    }
  }
  EXPECT_EQ(a, b);
}

TEST(CliCompare, AProjectEqualsItsExportAndNamesWhatAnEditChanges) {
  const TemporaryFolder folder;
  const auto project = folder.file("m.syncline");
  const auto eni = folder.file("m.eni.xml");
  ASSERT_EQ(cli_run({"project", "create", project, "--scan", demo(), "--shift", "bus"}).code, cli::kDone);
  ASSERT_EQ(cli_run({"export", project, "-o", eni}).code, cli::kDone);
  EXPECT_EQ(cli_run({"compare", project, eni}).code, cli::kDone);
  // Master shift needs no write to the reference clock's time: exactly that command goes.
  ASSERT_EQ(cli_run({"project", "set", project, "master.dc.mode=master-shift"}).code, cli::kDone);
  const auto changed = cli_run({"compare", project, eni, "--json"});
  EXPECT_EQ(changed.code, cli::kAnswerIsNo);
  const auto report = changed.json();
  ASSERT_EQ(report["differences"].size(), 1U) << changed.out;
  EXPECT_THAT(report["differences"][0].dump(), HasSubstr("0x0910"));
}

TEST(CliProject, UnknownDeviceNamesItsIdentity) {
  const TemporaryFolder folder;
  const auto run = cli_run({"project", "create", folder.file("m.syncline"), "--device", "0x1234:0x5678:0x9"});
  EXPECT_EQ(run.code, cli::kFailed);
  EXPECT_THAT(run.err, HasSubstr("0x00001234"));
  EXPECT_FALSE(std::filesystem::exists(folder.file("m.syncline")));
}

}  // namespace
}  // namespace syncline::test
