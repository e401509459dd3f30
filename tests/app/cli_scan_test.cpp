// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/app/cli_runner.h"
#include "tests/support/source_dir.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;

std::size_t size_of(const std::string& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  return error ? 0 : static_cast<std::size_t>(size);
}

TEST(CliScan, TableNamesEverySlave) {
  const auto run = cli_run({"scan", demo()});
  ASSERT_EQ(run.code, cli::kDone) << run.err;
  EXPECT_THAT(run.out, HasSubstr("PORTS"));
  EXPECT_THAT(run.out, HasSubstr("INIT"));
  EXPECT_THAT(run.out, HasSubstr("0 port B"));
}

TEST(CliScan, JsonTellsPortsAndIdentification) {
  const auto run = cli_run({"scan", demo(), "--json"});
  ASSERT_EQ(run.code, cli::kDone) << run.err;
  const auto report = run.json();
  EXPECT_EQ(report["look_only"], false);
  EXPECT_EQ(report["running"], 0);
  const auto& slave = report["slaves"][1];
  EXPECT_EQ(slave["station_address"], 1002);
  EXPECT_EQ(slave["entry_port"], 0);
  EXPECT_EQ(slave["ports"].size(), 4U);
  EXPECT_EQ(slave["ports"][0]["open"], true);
  EXPECT_TRUE(slave["device_id"].is_null());
  EXPECT_TRUE(slave["sii_error"].is_null());
}

TEST(CliScan, JsonHasFindingsAsTextsAndWithTheirCodes) {
  const TemporaryFolder folder;
  const auto machine = folder.file("twins.toml");
  const auto drive = source_dir() + "/resources/esi/SL-SV7.xml";
  std::ofstream(machine) << "[[slave]]\nesi = \"" << drive << "\"\nalias = 7\n[[slave]]\nesi = \"" << drive
                         << "\"\nalias = 7\n";
  const auto run = cli_run({"scan", "sim:" + machine, "--json"});
  ASSERT_EQ(run.code, cli::kDone) << run.err;
  const auto report = run.json();
  const auto& coded = report["coded_findings"];
  ASSERT_EQ(coded.size(), 1U);
  EXPECT_EQ(coded[0]["code"], "scan-alias-twice");
  EXPECT_EQ(coded[0]["severity"], "warning");
  EXPECT_EQ(coded[0]["slave"], 1);
  EXPECT_EQ(coded[0]["evidence"]["alias"], 7);
  ASSERT_EQ(report["findings"].size(), 1U);
  EXPECT_EQ(report["findings"][0], coded[0]["text"]);
}

TEST(CliScan, LookOnlyFindsTheSameWithoutAddresses) {
  const auto full = cli_run({"scan", demo(), "--json"}).json();
  const auto run = cli_run({"scan", demo(), "--look-only", "--json"});
  ASSERT_EQ(run.code, cli::kDone) << run.err;
  const auto looked = run.json();
  EXPECT_EQ(looked["look_only"], true);
  ASSERT_EQ(looked["slaves"].size(), full["slaves"].size());
  for (std::size_t i = 0; i < full["slaves"].size(); ++i) {
    for (const auto* key : {"product_code", "serial_no", "alias", "dc", "name"}) {
      EXPECT_EQ(looked["slaves"][i][key], full["slaves"][i][key]) << i << " " << key;
    }
    EXPECT_EQ(looked["slaves"][i]["station_address"], 0);
  }
}

TEST(CliScan, CapturesEveryFrame) {
  const TemporaryFolder folder;
  const auto file = folder.file("scan.pcapng");
  const auto run = cli_run({"scan", demo(), "--capture", file});
  ASSERT_EQ(run.code, cli::kDone) << run.err;
  const auto bytes = read_text(file);
  EXPECT_EQ(bytes.substr(0, 4), "\x0A\x0D\x0D\x0A");
  // EtherType of each frame, there and back; the first command of a scan counts the slaves.
  EXPECT_GT(bytes.size(), 10'000U);
  EXPECT_THAT(bytes, HasSubstr(std::string("\x88\xA4", 2)));
  EXPECT_FALSE(std::filesystem::exists(file + ".part"));
  const auto again = cli_run({"scan", "replay:" + file, "--json"});
  ASSERT_EQ(again.code, cli::kDone) << again.err;
  EXPECT_EQ(again.json()["slaves"].size(), cli_run({"scan", demo(), "--json"}).json()["slaves"].size());
  EXPECT_EQ(cli_run({"scan", demo(), "--capture", folder.file("none/scan.pcapng")}).code, cli::kFailed);
}

TEST(CliSii, ReadsWritesAndVerifies) {
  const TemporaryFolder folder;
  const auto image = folder.file("eeprom.bin");
  const auto read = cli_run({"sii", "read", demo(), "1", image, "--json"});
  ASSERT_EQ(read.code, cli::kDone) << read.err;
  EXPECT_EQ(read.json()["bytes"], size_of(image));
  EXPECT_GE(size_of(image), 128U);
  // Every run switches the simulated bus on afresh: the same image changes nothing.
  const auto same = cli_run({"sii", "write", demo(), "1", image, "--json"});
  ASSERT_EQ(same.code, cli::kDone) << same.err;
  EXPECT_EQ(same.json()["written"], 0);
  const auto other = cli_run({"sii", "write", demo(), "0", image, "--json"});
  ASSERT_EQ(other.code, cli::kDone) << other.err;
  EXPECT_GT(other.json()["written"], 4);
  EXPECT_EQ(other.json()["verified"], true);
}

TEST(CliSii, WritesAnAlias) {
  const auto run = cli_run({"sii", "alias", demo(), "1", "4711"});
  ASSERT_EQ(run.code, cli::kDone) << run.err;
  EXPECT_THAT(run.out, HasSubstr("the alias is 4711; 2 of 8 words"));
}

TEST(CliSii, SaysWhyItDoesNot) {
  const TemporaryFolder folder;
  const auto nobody = cli_run({"sii", "read", demo(), "99", folder.file("x.bin")});
  EXPECT_EQ(nobody.code, cli::kFailed);
  EXPECT_THAT(nobody.err, HasSubstr("slave 99"));
  const auto broken = folder.file("broken.bin");
  std::ofstream(broken, std::ios::binary) << std::string(256, 'x');
  const auto refused = cli_run({"sii", "write", demo(), "1", broken});
  EXPECT_EQ(refused.code, cli::kUsage);
  EXPECT_THAT(refused.err, HasSubstr("checksum"));
}

TEST(CliScan, ACaptureShowsWhatItProvesAndUnknownForTheRest) {
  const TemporaryFolder folder;
  const auto whole = folder.file("whole.pcapng"), cut = folder.file("cut.pcapng");
  ASSERT_EQ(cli_run({"scan", demo(), "--capture", whole}).code, cli::kDone);
  const auto all = cli_run({"scan", "replay:" + whole});
  EXPECT_EQ(all.code, cli::kDone) << all.err;
  EXPECT_EQ(all.out.find("unknown"), std::string::npos) << all.out;

  const auto bytes = read_text(whole);
  std::ofstream(cut, std::ios::binary) << bytes.substr(0, bytes.size() / 12);
  const auto part = cli_run({"scan", "replay:" + cut});
  EXPECT_EQ(part.code, cli::kDone) << part.err;
  EXPECT_NE(part.out.find("unknown"), std::string::npos) << part.out;
  EXPECT_EQ(part.out.find("0x00000000:0x00000000"), std::string::npos) << part.out;
  EXPECT_NE(part.err.find("breaks off"), std::string::npos) << part.err;
  EXPECT_EQ(part.err.find("acknowledges no read"), std::string::npos) << part.err;
  const auto json = cli_run({"scan", "replay:" + cut, "--json"}).json();
  EXPECT_TRUE(json["slaves"].back()["vendor_id"].is_null()) << json["slaves"].back();
}

}  // namespace
}  // namespace syncline::test
