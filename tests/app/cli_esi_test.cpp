// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/cli_runner.h"
#include "tests/support/source_dir.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The ESI files of our own simulated devices, with a database that goes with the test.
class CliEsi : public testing::Test {
 protected:
  [[nodiscard]] CliRun esi(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "esi");
    arguments.insert(arguments.end(), {"--cache", database()});
    return cli_run(arguments);
  }
  [[nodiscard]] std::string database() const { return folder_.file("cache.db"); }
  [[nodiscard]] CliRun index() const { return esi({"index", kEsi, "--json"}); }

  const std::string kEsi = test::source_dir() + "/resources/esi";
  TemporaryFolder folder_;
};

TEST_F(CliEsi, IndexReadsOnlyWhatChanged) {
  const auto first = index();
  ASSERT_EQ(first.code, cli::kDone) << first.err;
  const auto files = first.json()["folders"][0]["files"].get<int>();
  EXPECT_GT(files, 3);
  EXPECT_EQ(first.json()["folders"][0]["read"], files);
  EXPECT_GT(first.json()["devices"], 3);
  EXPECT_TRUE(first.json()["warnings"].empty()) << first.out;
  EXPECT_EQ(first.json()["database"], database());
  EXPECT_EQ(index().json()["folders"][0]["read"], 0);
  const auto missing = esi({"index", folder_.file("none")});
  EXPECT_EQ(missing.code, cli::kFailed);
  EXPECT_THAT(missing.err, HasSubstr("none"));
}

TEST_F(CliEsi, IndexNamesConflictsAndBadFiles) {
  const auto text = [](const char* name) {
    return std::string(
               "<EtherCATInfo><Vendor><Id>1</Id></Vendor><Descriptions><Devices><Device><Type ProductCode=\"2\" "
               "RevisionNo=\"3\">T</Type><Name>") +
           name + "</Name></Device></Devices></Descriptions></EtherCATInfo>";
  };
  std::ofstream(folder_.file("a.xml")) << text("one");
  std::ofstream(folder_.file("b.xml")) << text("two");
  std::ofstream(folder_.file("c.xml")) << "<EtherCATInfo>";
  const auto where = std::filesystem::path(folder_.file("a.xml")).parent_path().string();
  const auto run = esi({"index", where, "--progress"});
  EXPECT_EQ(run.code, cli::kDone);
  EXPECT_THAT(run.out, HasSubstr("conflict: 0x00000001:0x00000002:0x00000003"));
  EXPECT_THAT(run.out, HasSubstr("b.xml:1"));
  EXPECT_THAT(run.out, HasSubstr("c.xml:1: this is not well-formed XML"));
  EXPECT_THAT(run.err, HasSubstr("3/3 "));
  const auto json = esi({"index", where, "--json"}).json();
  EXPECT_EQ(json["duplicates"][0]["conflict"], true);
  EXPECT_EQ(json["duplicates"][0]["entries"].size(), 2U);
}

TEST_F(CliEsi, SearchListsWhatWasIndexed) {
  ASSERT_EQ(index().code, cli::kDone);
  const auto all = esi({"search", "--json"});
  ASSERT_EQ(all.code, cli::kDone) << all.err;
  const auto devices = all.json()["devices"];
  ASSERT_GT(devices.size(), 3U);
  const auto type = devices[0]["type"].get<std::string>();
  const auto found = esi({"search", type});
  EXPECT_THAT(found.out, HasSubstr(type));
  const auto none = esi({"search", "nothing-of-that-name"});
  EXPECT_EQ(none.code, cli::kAnswerIsNo);
  EXPECT_EQ(esi({"search", "--limit", "1", "--json"}).json()["devices"].size(), 1U);
}

TEST_F(CliEsi, ShowAndMatchAgree) {
  const auto device = esi({"search", "--esi", kEsi, "--json", "--limit", "1"}).json()["devices"][0];
  const auto identity = device["vendor_id"].get<std::string>() + ":" + device["product_code"].get<std::string>();
  const auto exact = esi({"match", identity + ":" + device["revision_no"].get<std::string>(), "--esi", kEsi, "--json"});
  ASSERT_EQ(exact.code, cli::kDone) << exact.err;
  EXPECT_EQ(exact.json()["match"], "exact");
  EXPECT_EQ(exact.json()["device"]["file"], device["file"]);
  const auto newer = esi({"match", identity + ":0xfffffff0", "--esi", kEsi});
  EXPECT_EQ(newer.code, cli::kDone);
  EXPECT_THAT(newer.out, HasSubstr("no ESI file has revision 0xfffffff0"));
  EXPECT_EQ(esi({"match", "0x1:0x2", "--esi", kEsi}).code, cli::kAnswerIsNo);
  EXPECT_EQ(esi({"match", "nonsense", "--esi", kEsi}).code, cli::kUsage);

  const auto by_identity = esi({"show", identity, "--esi", kEsi, "--json"});
  ASSERT_EQ(by_identity.code, cli::kDone) << by_identity.err;
  EXPECT_EQ(by_identity.json()["type"], device["type"]);
  EXPECT_TRUE(by_identity.json().contains("rx_pdos"));
  const auto by_type = esi({"show", device["type"].get<std::string>(), "--esi", kEsi});
  EXPECT_THAT(by_type.out, HasSubstr(device["name"].get<std::string>()));
  EXPECT_EQ(esi({"show", "nothing-of-that-name", "--esi", kEsi}).code, cli::kFailed);
}

TEST_F(CliEsi, ScanSaysWhichEsiDescribesEachSlave) {
  const auto run = cli_run({"scan", demo(), "--esi", kEsi, "--cache", database(), "--json"});
  ASSERT_EQ(run.code, cli::kDone) << run.err;
  const auto scan = run.json();
  for (const auto& slave : scan["slaves"]) EXPECT_EQ(slave["esi"]["match"], "exact") << slave.dump();
  const auto words = cli_run({"scan", demo(), "--esi", kEsi, "--cache", database()});
  EXPECT_THAT(words.out, HasSubstr("exactly"));
  EXPECT_FALSE(cli_run({"scan", demo(), "--json"}).json()["slaves"][0].contains("esi"));
}

TEST_F(CliEsi, ACacheThatIsSomethingElseIsRefused) {
  std::ofstream(folder_.file("cache.db")) << "my own file";
  const auto run = esi({"search", "x"});
  EXPECT_EQ(run.code, cli::kFailed);
  EXPECT_THAT(run.err, HasSubstr("it is no device catalogue"));
  EXPECT_THAT(run.err, HasSubstr("Delete it"));
  EXPECT_EQ(read_text(database()), "my own file");
  const auto project =
      cli_run({"project", "create", folder_.file("m.syncline"), "--scan", demo(), "--cache", database()});
  EXPECT_EQ(project.code, cli::kFailed);
}

TEST_F(CliEsi, ForgottenFoldersAreNotSearched) {
  std::ofstream(folder_.file("a.xml"))
      << "<EtherCATInfo><Vendor><Id>1</Id></Vendor><Descriptions><Devices><Device><Type "
         "ProductCode=\"2\">Zebra</Type></Device></Devices></Descriptions></EtherCATInfo>";
  const auto where = std::filesystem::path(folder_.file("a.xml")).parent_path().string();
  ASSERT_EQ(esi({"index", where}).code, cli::kDone);
  EXPECT_THAT(esi({"search", "zeb"}).out, HasSubstr("Zebra"));
  ASSERT_EQ(esi({"index", where, "--forget"}).code, cli::kDone);
  EXPECT_THAT(esi({"search", "zeb"}).out, Not(HasSubstr("Zebra")));
}

}  // namespace
}  // namespace syncline::test
