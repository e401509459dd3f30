// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/app/cli_runner.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;

/// A slave of the demo machine that has objects, by asking each.
std::string slave_with_objects() {
  for (int position = 0; position < 10; ++position) {
    const auto text = std::to_string(position);
    if (cli_run({"sdo", "read", demo(), text, "0x1018:01"}).code == cli::kDone) return text;
  }
  ADD_FAILURE() << "no slave of the demo machine has objects";
  return "0";
}

TEST(CliSdo, ReadsTheIdentityThatTheScanSaw) {
  const auto position = slave_with_objects();
  const auto scan = cli_run({"scan", demo(), "--json"}).json();
  const auto run = cli_run({"sdo", "read", demo(), position, "0x1018:02", "--json"});
  ASSERT_EQ(run.code, cli::kDone) << run.err;
  EXPECT_THAT(run.err, HasSubstr("was in INIT and is led to PREOP"));
  const auto report = run.json();
  EXPECT_EQ(report["index"], "0x1018");
  EXPECT_EQ(report["sub_index"], 2);
  EXPECT_EQ(report["type"], "UDINT");
  const auto product = scan["slaves"][std::stoul(position)]["product_code"].get<std::string>();
  EXPECT_EQ(std::stoul(report["value"].get<std::string>()), std::stoul(product, nullptr, 0));
}

TEST(CliSdo, ListsObjectsWithNamesAndTypes) {
  const auto run = cli_run({"sdo", "list", demo(), slave_with_objects()});
  ASSERT_EQ(run.code, cli::kDone) << run.err;
  EXPECT_THAT(run.out, HasSubstr("0x1018"));
  EXPECT_THAT(run.out, HasSubstr("UDINT"));
}

TEST(CliSdo, SaysThatASlaveHasNoCompleteAccess) {
  const auto run = cli_run({"sdo", "read", demo(), slave_with_objects(), "0x1018:01", "--complete"});
  EXPECT_EQ(run.code, cli::kFailed);
  EXPECT_THAT(run.err, HasSubstr("0x06010004"));
}

TEST(CliSdo, SaysWhatTheSlaveRefuses) {
  const auto position = slave_with_objects();
  const auto missing = cli_run({"sdo", "read", demo(), position, "0x5FFF"});
  EXPECT_EQ(missing.code, cli::kFailed);
  EXPECT_THAT(missing.err, HasSubstr("0x5FFF"));
  const auto constant = cli_run({"sdo", "write", demo(), position, "0x1018:01", "5"});
  EXPECT_EQ(constant.code, cli::kFailed);
  EXPECT_EQ(cli_run({"sdo", "read", demo(), "99", "0x1018"}).code, cli::kFailed);
}

TEST(CliSdo, RefusesWhatIsNoObjectBeforeItTouchesTheSlave) {
  const auto run = cli_run({"sdo", "read", demo(), "1", "identity"});
  EXPECT_EQ(run.code, cli::kUsage);
  EXPECT_THAT(run.err, testing::Not(HasSubstr("is led to")));
  EXPECT_EQ(cli_run({"sdo", "read", demo(), "1", "0x1018", "--type", "FLOAT"}).code, cli::kUsage);
  EXPECT_EQ(cli_run({"sdo", "read", demo(), "1", "0x1018:02", "--complete"}).code, cli::kUsage);
}

TEST(CliState, LeadsAndSaysWhyNot) {
  const auto position = slave_with_objects();
  const auto run = cli_run({"state", demo(), position, "PREOP", "--json"});
  ASSERT_EQ(run.code, cli::kDone) << run.err;
  EXPECT_EQ(run.json()["from"], "INIT");
  EXPECT_EQ(run.json()["to"], "PREOP");
  const auto op = cli_run({"state", demo(), position, "OP"});  // without process data
  EXPECT_EQ(op.code, cli::kFailed);
  EXPECT_THAT(op.err, HasSubstr("SAFEOP"));
  EXPECT_EQ(cli_run({"state", demo(), position, "RUN"}).code, cli::kUsage);
}

TEST(CliHistory, IsReadWithoutAConfiguration) {
  const auto run = cli_run({"history", demo(), slave_with_objects(), "--json"});
  ASSERT_EQ(run.code, cli::kDone) << run.err;
  EXPECT_TRUE(run.json()["messages"].is_array());
  EXPECT_EQ(run.json()["unreadable"], 0);
}

TEST(CliFoe, NamesTheFileThatIsMissing) {
  const TemporaryFolder folder;
  const auto write = cli_run({"foe", "write", demo(), "1", "x", folder.file("none.bin")});
  EXPECT_EQ(write.code, cli::kFailed);
  EXPECT_THAT(write.err, HasSubstr("none.bin"));
  const auto read = cli_run({"foe", "read", demo(), slave_with_objects(), "no such file", folder.file("out.bin")});
  EXPECT_EQ(read.code, cli::kFailed);
  EXPECT_FALSE(std::ifstream(folder.file("out.bin")));
}

TEST(CliFoe, LeadsTheSlaveToBootWhenAsked) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("in.bin"), std::ios::binary) << "firmware";
  const auto position = slave_with_objects();
  const auto run = cli_run({"foe", "write", demo(), position, "firmware.bin", folder.file("in.bin"), "--boot"});
  ASSERT_EQ(run.code, cli::kDone) << run.err;
  EXPECT_THAT(run.err, HasSubstr("was in INIT and is led to BOOT"));
  EXPECT_THAT(run.out, HasSubstr("8 bytes of \"firmware.bin\" written"));
}

}  // namespace
}  // namespace syncline::test
