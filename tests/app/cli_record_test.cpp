// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/app/cli_runner.h"
#include "trace/csv.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;

class CliRecord : public testing::Test {
 protected:
  CliRecord() {
    const auto create =
        cli_run({"project", "create", project, "--scan", demo(), "--cycle", "1000", "--sync-window", "on"});
    EXPECT_EQ(create.code, cli::kDone) << create.err;
  }
  /// A run of the demonstration machine that is recorded.
  CliRun run(const std::vector<std::string>& more = {}, const std::string& record = "run.slrec") {
    std::vector<std::string> arguments{"run",   project, "--link",   demo("?virtual&seed=5"),
                                       "--for", "6s",    "--record", folder.file(record)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return cli_run(arguments);
  }

  TemporaryFolder folder;
  std::string project = folder.file("m.syncline"), recording = folder.file("run.slrec");
};

TEST_F(CliRecord, ExportsTheTableThatTheRunWrites) {
  const auto csv = folder.file("run.csv"), exported = folder.file("exported.csv");
  const auto recorded = run({"--csv", csv});
  ASSERT_EQ(recorded.code, cli::kDone) << recorded.err;
  const auto copied = cli_run({"record", "export", recording, exported});
  ASSERT_EQ(copied.code, cli::kDone) << copied.err;
  const auto table = read_text(csv);
  EXPECT_GT(table.size(), 100'000U);
  EXPECT_TRUE(table == read_text(exported)) << "byte for byte";
}

TEST_F(CliRecord, HoldsTheVariablesThatAreWatched) {
  const auto csv = folder.file("run.csv"), exported = folder.file("exported.csv");
  const auto recorded = run({"--csv", csv, "--watch", "3.Position actual value", "--watch", "3.statusword"});
  ASSERT_EQ(recorded.code, cli::kDone) << recorded.err;
  const auto table = read_text(csv);
  const auto head = table.substr(0, table.find('\n'));
  EXPECT_THAT(head, HasSubstr("Position actual value\",\""));
  EXPECT_TRUE(head.ends_with("Statusword\"")) << head;
  const auto last = table.substr(table.rfind('\n', table.size() - 2) + 1);
  EXPECT_EQ(std::ranges::count(last, ','), std::ranges::count(sample_csv_header(), ',') + 2) << last;
  EXPECT_NE(last[last.rfind(',') + 1], '\n') << "it has a value in OP";
  ASSERT_EQ(cli_run({"record", "export", recording, exported}).code, cli::kDone);
  EXPECT_TRUE(table == read_text(exported)) << "byte for byte";
  const auto json = cli_run({"record", "info", recording, "--json"}).json();
  ASSERT_EQ(json["variables"].size(), 2U);
  EXPECT_EQ(json["variables"][0]["slave"], 3);
  EXPECT_EQ(json["variables"][0]["type"], "DINT");
  EXPECT_EQ(json["variables"][0]["direction"], "input");
  EXPECT_EQ(cli_run({"record", "verify", recording}).code, cli::kDone);
}

TEST_F(CliRecord, RefusesVariablesThatAreNotThere) {
  const auto refused = run({"--watch", "3.Nothing of the kind"});
  EXPECT_EQ(refused.code, cli::kUsage) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("--watch 3.Nothing of the kind"));
  EXPECT_FALSE(std::filesystem::exists(recording));
}

TEST_F(CliRecord, TellsWhatWasRun) {
  ASSERT_EQ(run().code, cli::kDone);
  const auto told = cli_run({"record", "info", recording, "--json"});
  ASSERT_EQ(told.code, cli::kDone) << told.err;
  const auto json = told.json();
  EXPECT_EQ(json["ended"], "end of the run");
  EXPECT_EQ(json["missing_cycles"], 0);
  EXPECT_GT(json["cycles"], 4'000);
  EXPECT_EQ(json["cycle_time_us"], 1000);
  EXPECT_GT(json["limits"]["deviation_ns"], 0);
  EXPECT_GT(json["slaves"].size(), 3U);
  EXPECT_FALSE(json["events"].empty());
  const auto copy = folder.file("copy.syncline");
  ASSERT_EQ(cli_run({"record", "export", recording, copy, "--document", "project"}).code, cli::kDone);
  EXPECT_EQ(read_text(copy), read_text(project));
  const auto eni = folder.file("copy.xml"), exported = folder.file("m.eni.xml");
  ASSERT_EQ(cli_run({"record", "export", recording, eni, "--document", "configuration"}).code, cli::kDone);
  ASSERT_EQ(cli_run({"export", project, "-o", exported}).code, cli::kDone);
  EXPECT_EQ(read_text(eni), read_text(exported));
  EXPECT_EQ(cli_run({"record", "export", recording, copy, "--document", "poem"}).code, cli::kUsage);
  EXPECT_THAT(cli_run({"record", "info", recording}).out, HasSubstr("cycles of 1000 us"));
}

TEST_F(CliRecord, VerifiesAndExplains) {
  ASSERT_EQ(run().code, cli::kDone);
  EXPECT_EQ(cli_run({"record", "verify", recording}).code, cli::kDone);
  std::filesystem::resize_file(recording, std::filesystem::file_size(recording) / 2);
  const auto cut = cli_run({"record", "verify", recording});
  EXPECT_EQ(cut.code, cli::kAnswerIsNo);
  EXPECT_THAT(cut.err, HasSubstr("damaged or cut off"));
  const auto other = cli_run({"record", "verify", project});
  EXPECT_EQ(other.code, cli::kFailed);
  EXPECT_THAT(other.err, HasSubstr("another kind of file"));
  EXPECT_EQ(cli_run({"record", "info", folder.file("none")}).code, cli::kFailed);
}

TEST_F(CliRecord, EndsAtItsBoundAndTheRunGoesOn) {
  const auto bounded = run({"--record-longest", "2s"});
  EXPECT_EQ(bounded.code, cli::kDone) << bounded.err;
  EXPECT_THAT(bounded.err, HasSubstr("the recording has ended, it has its length of 2 s"));
  const auto told = cli_run({"record", "info", recording, "--json"}).json();
  EXPECT_NEAR(told["duration_s"].get<double>(), 2.0, 1.1);
  const auto again = run();
  EXPECT_EQ(again.code, cli::kFailed) << "it replaces nothing";
  EXPECT_THAT(again.err, HasSubstr("already"));
  const auto full = run({"--record-keep-free-mib", "4000000000"}, "full.slrec");
  EXPECT_EQ(full.code, cli::kFailed);
  EXPECT_THAT(full.err, HasSubstr("left on the disk"));
  EXPECT_EQ(cli_run({"record", "verify", folder.file("full.slrec")}).code, cli::kDone);
}

}  // namespace
}  // namespace syncline::test
