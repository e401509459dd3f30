// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/app/cli_process.h"
#include "tests/app/cli_runner.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(CliOutput, AnErrorIsOneValidJsonObjectToo) {
  const TemporaryFolder folder;
  const std::vector<std::vector<std::string>> wrong{
      {"scan", "nic:nowhere", "--json"},
      {"scan", "sim:/no/such.toml", "--json"},
      {"scan", "what", "--json"},
      {"scan", "--json"},
      {"nonsense", "--json"},
      {"run", folder.file("missing.xml"), "--link", demo(), "--json"},
      {"run", folder.file("missing.xml"), "--link", demo(), "--for", "no", "--json"},
      {"sdo", "read", demo(), "99", "0x1000", "--json"},
      {"state", demo(), "0", "NOWHERE", "--json"},
      {"project", "set", folder.file("missing.syncline"), "a=b", "--json"},
      {"check", folder.file("missing.xml"), "--json"},
      {"export", folder.file("missing.xml"), "-o", folder.file("a"), "--json"},
      {"sii", "finish", demo(), "0", "--json"},
  };
  for (const auto& arguments : wrong) {
    const auto run = cli_run(arguments);
    EXPECT_NE(run.code, cli::kDone) << arguments[0];
    const auto json = nlohmann::json::parse(run.out, nullptr, false);
    ASSERT_TRUE(json.is_object()) << arguments[0] << ": " << run.out;
    ASSERT_TRUE(json.contains("error")) << run.out;
    EXPECT_FALSE(json["error"]["message"].get<std::string>().empty()) << run.out;
    EXPECT_FALSE(run.err.empty());
  }
}

TEST(CliOutput, AFlagWithAValueIsRefusedAndNeverIgnored) {
  const TemporaryFolder folder;
  const auto project = folder.file("m.syncline");
  ASSERT_EQ(cli_run({"project", "create", project, "--scan", demo()}).code, cli::kDone);
  for (const char* flag : {"--json=out.json", "--json=true", "--json=false", "--json=1", "--json="}) {
    const auto shown = cli_run({"project", "show", project, flag});
    EXPECT_EQ(shown.code, cli::kUsage) << flag;
    EXPECT_THAT(shown.err, HasSubstr("--json takes no value")) << flag;
    EXPECT_TRUE(shown.json().contains("error")) << flag;
  }
  for (const char* flag : {"--strict=no", "--strict=2", "--strict=file"}) {
    const auto checked = cli_run({"check", project, flag});
    EXPECT_EQ(checked.code, cli::kUsage) << flag;
    EXPECT_THAT(checked.err, HasSubstr("--strict takes no value")) << flag;
  }
  EXPECT_EQ(cli_run({"check", project, "--severity=error"}).code,
            cli_run({"check", project, "--severity", "error"}).code);
}

TEST(CliOutput, TheErrorOfAFileNamesItAndTheLine) {
  const TemporaryFolder folder;
  const auto file = folder.file("broken.toml");
  std::ofstream(file) << "seed = 1\n[[slave]]\nalias = 70000\n";
  const auto run = cli_run({"scan", "sim:" + file, "--json"});
  EXPECT_EQ(run.json()["error"]["file"], file);
  EXPECT_GT(run.json()["error"]["line"], 0);
}

TEST(CliOutput, BytesThatAreNoUtf8DoNotStopTheJson) {
  const TemporaryFolder folder;
  const auto name = folder.file("m\xFF\xFE.syncline");
  ASSERT_EQ(cli_run({"project", "create", name, "--scan", demo()}).code, cli::kDone);
  const auto shown = cli_run({"project", "show", name, "--json"});
  EXPECT_EQ(shown.code, cli::kDone) << shown.err;
  EXPECT_THAT(shown.json()["file"].get<std::string>(), HasSubstr("\xEF\xBF\xBD"));
  const auto missing = cli_run({"check", folder.file("\xC0\x80.xml"), "--json"});
  EXPECT_EQ(missing.code, cli::kFailed);
  EXPECT_TRUE(missing.json().contains("error"));
}

TEST(CliOutput, AFullDiskBelowTheOutputIsNoticed) {
  for (const bool json : {false, true}) {
    std::vector<std::string> arguments{"scan", demo()};
    if (json) arguments.emplace_back("--json");
    CliProcess process(arguments, "/dev/full");
    EXPECT_EQ(process.wait(), cli::kFailed);
    EXPECT_THAT(process.err(), HasSubstr("disk full"));
  }
}

class CliSideFiles : public testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(cli_run({"project", "create", project(), "--scan", demo()}).code, cli::kDone); }
  [[nodiscard]] std::string project() const { return folder.file("m.syncline"); }
  CliRun run(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"run", project(), "--link", demo(), "--for", "8s"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return cli_run(arguments);
  }
  TemporaryFolder folder;
};

TEST_F(CliSideFiles, OneThatFailsIsSaidAndDoesNotCostTheReport) {
  for (const std::string option : {"--csv", "--dcm-log", "--capture", "--save-host"}) {
    const auto text = run({option, "/dev/full"});
    EXPECT_EQ(text.code, cli::kFailed) << option;
    EXPECT_THAT(text.err, testing::AllOf(HasSubstr("/dev/full"), HasSubstr("No space left"))) << option;
    EXPECT_THAT(text.out, HasSubstr("OP")) << option;
    const auto json = run({option, "/dev/full", "--json"});
    EXPECT_EQ(json.json()["state"], "OP") << option;
    EXPECT_EQ(json.json()["error"]["file"], "/dev/full") << option;
  }
}

TEST_F(CliSideFiles, OneThatCannotBeBegunEndsTheRunBeforeTheBusIsTouched) {
  for (const std::string option : {"--csv", "--dcm-log", "--capture"}) {
    const auto file = folder.file("no/such/folder");
    const auto text = run({option, file});
    EXPECT_EQ(text.code, cli::kFailed) << option;
    EXPECT_THAT(text.err, HasSubstr(file)) << option;
    EXPECT_THAT(text.err, Not(HasSubstr("PREOP"))) << option;
  }
}

TEST_F(CliSideFiles, AScanWithoutItsCaptureIsAScan) {
  const auto run = cli_run({"scan", demo(), "--capture", "/dev/full", "--json"});
  EXPECT_EQ(run.code, cli::kFailed);
  EXPECT_FALSE(run.json()["slaves"].empty());
  EXPECT_TRUE(run.json().contains("error"));
}

TEST_F(CliSideFiles, ExportAndReadingAnEepromRefuseADeviceThatIsFull) {
  EXPECT_EQ(cli_run({"export", project(), "-o", "/dev/full"}).code, cli::kFailed);
  EXPECT_EQ(cli_run({"sii", "read", demo(), "0", "/dev/full"}).code, cli::kFailed);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

}  // namespace
}  // namespace syncline::test
