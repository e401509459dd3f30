// SPDX-License-Identifier: Apache-2.0
// An option that would have no effect is refused, and says what it goes with.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/app/cli_runner.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;

TEST(CliIgnored, OptionsWithoutEffectAreRefused) {
  const TemporaryFolder folder;
  const auto project = folder.file("m.syncline"), eni = folder.file("m.xml");
  ASSERT_EQ(cli_run({"project", "create", project, "--scan", demo()}).code, cli::kDone);
  ASSERT_EQ(cli_run({"export", project, "-o", eni}).code, cli::kDone);
  const std::vector<std::string> run{"run", project, "--link", demo(), "--for", "100ms"};
  struct Row {
    std::vector<std::string> arguments;
    std::string option, with;
    bool after_run = false;
  };
  const std::vector<Row> rows{
      {{"--record-longest", "10s"}, "--record-longest", "--record", true},
      {{"--record-most-mib", "10"}, "--record-most-mib", "--record", true},
      {{"--record-keep-free-mib", "10"}, "--record-keep-free-mib", "--record", true},
      {{"--black-box-mib", "10"}, "--black-box-mib", "--black-box", true},
      {{"--black-box-keep-free-mib", "10"}, "--black-box-keep-free-mib", "--black-box", true},
      {{"--watch", "3.statusword"}, "--watch", "--csv", true},
      {{"--every-event", "--json"}, "--every-event", "--json", true},
      {{"run", eni, "--link", demo(), "--network", "1"}, "network", "ENI"},
      {{"export", eni, "-o", folder.file("new.xml"), "--network", "1"}, "network", "ENI"},
      {{"project", "show", eni, "--network", "1"}, "network", "ENI"},
      {{"check", eni, "--rules"}, "--rules", "file"},
      {{"check", "--rules", "--strict"}, "--rules", "--strict"},
      {{"compare", eni, demo(), "--details"}, "--details", "bus"},
      {{"compare", eni, project, "--look-only"}, "--look-only", project},
      {{"dc", "status", demo(), "--network", "1"}, "--network", "--project"},
      {{"dc", "delays", demo(), "--look-only", "--rounds", "3"}, "--rounds", "--look-only"},
      {{"project", "create", folder.file("n"), "--device", "1:2", "--no-dictionary"}, "--no-dictionary", "--scan"},
      {{"esi", "index", folder.file(""), "--forget", "--progress"}, "--progress", "--forget"},
  };
  for (const auto& row : rows) {
    auto arguments = row.after_run ? run : std::vector<std::string>{};
    arguments.insert(arguments.end(), row.arguments.begin(), row.arguments.end());
    const auto refused = cli_run(arguments);
    EXPECT_EQ(refused.code, cli::kUsage) << row.option << ": " << refused.err;
    EXPECT_THAT(refused.err, testing::AllOf(HasSubstr(row.option), HasSubstr(row.with))) << row.option;
  }
}

}  // namespace
}  // namespace syncline::test
