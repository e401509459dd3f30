// SPDX-License-Identifier: Apache-2.0
// `export` in every format, and ENI files wherever a project is taken.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "tests/app/cli_runner.h"
#include "tests/support/source_dir.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string content(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class CliExport : public testing::Test {
 protected:
  void SetUp() override {
    project_ = folder_.file("machine.syncline");
    eni_ = folder_.file("machine.xml");
    ASSERT_EQ(cli_run({"project", "create", project_, "--scan", demo()}).code, cli::kDone);
    ASSERT_EQ(cli_run({"export", project_, "-o", eni_}).code, cli::kDone);
  }
  std::string exported(const std::string& file, const std::string& format, const std::string& name) {
    const auto path = folder_.file(name);
    const auto run = cli_run({"export", file, "-o", path, "--format", format});
    EXPECT_EQ(run.code, cli::kDone) << run.err;
    return content(path);
  }
  TemporaryFolder folder_;
  std::string project_, eni_;
};

TEST_F(CliExport, WritesAnEniAgainByteForByte) {
  const auto again = folder_.file("again.xml");
  const auto run = cli_run({"export", eni_, "-o", again});
  ASSERT_EQ(run.code, cli::kDone) << run.err;
  EXPECT_EQ(content(again), content(eni_));
  EXPECT_EQ(cli_run({"compare", eni_, again}).code, cli::kDone);
}

TEST_F(CliExport, SpellsAsTheDialectAndSaysThatTheLayoutStays) {
  const auto other = folder_.file("twincat.xml");
  const auto run = cli_run({"export", eni_, "-o", other, "--dialect", "twincat"});
  ASSERT_EQ(run.code, cli::kDone) << run.err;
  EXPECT_THAT(run.err, HasSubstr("the layout of its image stay"));
  EXPECT_THAT(content(other), HasSubstr("<BeforeSlave>true</BeforeSlave>"));
  EXPECT_EQ(cli_run({"compare", eni_, other}).code, cli::kDone);
  EXPECT_EQ(cli_run({"export", project_, "-o", other, "--dialect", "twincat"}).err.find("layout"), std::string::npos);
}

TEST_F(CliExport, SaysWhatCheckWouldSayOfWhatItWrote) {
  ASSERT_EQ(cli_run({"project", "set", project_, "slave.3.startup.0=PS 0x1C12:00=00"}).code, cli::kDone);
  auto run = cli_run({"export", project_, "-o", eni_});
  EXPECT_EQ(run.code, cli::kAnswerIsNo);
  EXPECT_THAT(run.err, HasSubstr("0x1c12"));
  EXPECT_THAT(run.err, HasSubstr("was written"));
  EXPECT_EQ(cli_run({"check", eni_}).code, cli::kAnswerIsNo) << "the same";
  run = cli_run({"export", project_, "-o", eni_, "--json"});
  EXPECT_EQ(run.code, cli::kAnswerIsNo);
  EXPECT_EQ(run.json()["written"], true);
  EXPECT_EQ(run.json()["findings"].back()["code"], "ENI-COE-01");
  EXPECT_EQ(run.json()["findings"].back()["slave"], 3);
  EXPECT_EQ(cli_run({"export", eni_, "-o", folder_.file("again.xml")}).code, cli::kDone) << "it is no project's";
}

TEST_F(CliExport, TimesThatNoEniHoldsAreNotTaken) {
  EXPECT_EQ(cli_run({"project", "set", project_, "slave.3.dc.sync0.shift_us=2147484"}).code, cli::kUsage);
  EXPECT_EQ(cli_run({"project", "set", project_, "slave.3.dc.sync0.shift_us=-2147483.647"}).code, cli::kDone);
  EXPECT_EQ(cli_run({"project", "set", project_, "slave.3.dc.sync1.shift_us=2147484"}).code, cli::kUsage);
  EXPECT_EQ(cli_run({"project", "set", project_, "slave.3.dc.sync0.cycle_us=2147484"}).code, cli::kUsage);
}

TEST_F(CliExport, WritesTablesAHeaderAndADrawing) {
  for (const auto& file : {project_, eni_}) {
    EXPECT_THAT(exported(file, "csv", "image.csv"), StartsWith("direction,name,data_type,bits,byte,bit,comment\r\n"));
    EXPECT_THAT(exported(file, "pdo-csv", "pdo.csv"), StartsWith("slave,slave_name,direction,pdo,"));
    EXPECT_THAT(exported(file, "init-csv", "init.csv"), StartsWith("slave,slave_name,transitions,"));
    EXPECT_THAT(exported(file, "slaves-csv", "slaves.csv"), StartsWith("position,name,station_address,"));
    EXPECT_THAT(exported(file, "svg", "topology.svg"), HasSubstr("<svg xmlns="));
    EXPECT_THAT(exported(file, "c-header", "my machine.h"), HasSubstr("#ifndef MY_MACHINE_PROCESS_IMAGE_H"));
  }
  EXPECT_EQ(cli_run({"export", project_, "-o", folder_.file("x"), "--format", "pdf"}).code, cli::kUsage);
}

TEST_F(CliExport, DocumentsTheDemonstrationMachine) {
  const auto report = folder_.file("report.html");
  const auto run = cli_run({"export", project_, "-o", eni_, "--report", report, "--json"});
  ASSERT_EQ(run.code, cli::kDone) << run.err;
  EXPECT_EQ(run.json()["report"], report);
  const auto html = content(report);
  EXPECT_THAT(html, StartsWith("<!DOCTYPE html>"));
  const auto size = std::to_string(content(eni_).size());
  for (const auto& part :
       {std::string("machine.syncline"), std::string("synclinectl "), "machine.xml, " + size + " bytes",
        std::string("master.dc.burst_total"), std::string("10000 frames"), std::string("SL-SV7"), std::string(" UTC")})
    EXPECT_THAT(html, HasSubstr(part));
  ASSERT_EQ(cli_run({"export", eni_, "-o", folder_.file("again.xml"), "--report", report}).code, cli::kDone);
  EXPECT_THAT(content(report), HasSubstr("it was read from an ENI"));
  EXPECT_EQ(content(folder_.file("again.xml")), content(eni_));
}

TEST_F(CliExport, LeavesNeitherFileWhenOneCannotBeWritten) {
  const auto eni = folder_.file("new.xml"), missing = folder_.file("missing/report.html");
  auto run = cli_run({"export", project_, "-o", eni, "--report", missing});
  EXPECT_EQ(run.code, cli::kFailed);
  EXPECT_THAT(run.err, HasSubstr(missing));
  EXPECT_FALSE(std::filesystem::exists(eni));
  const auto report = folder_.file("report.html");
  run = cli_run({"export", project_, "-o", folder_.file("missing/new.xml"), "--report", report});
  EXPECT_EQ(run.code, cli::kFailed);
  EXPECT_FALSE(std::filesystem::exists(report));
  run = cli_run({"export", project_, "-o", eni, "--report", eni});
  EXPECT_EQ(run.code, cli::kUsage);
  EXPECT_THAT(run.err, HasSubstr("--output writes the file"));
  EXPECT_FALSE(std::filesystem::exists(eni));
  EXPECT_EQ(cli_run({"export", project_, "-o", eni, "--format", "svg", "--report", report}).code, cli::kUsage);
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_.file(""))) ++files;
  EXPECT_EQ(files, 2U) << "project and ENI of before, nothing beside them";
}

TEST_F(CliExport, AnEniBecomesAProjectThatExportsTheSame) {
  const auto recovered = folder_.file("recovered.syncline");
  const auto run = cli_run(
      {"project", "create", recovered, "--eni", eni_, "--esi", test::source_dir() + "/resources/esi", "--json"});
  ASSERT_EQ(run.code, cli::kDone) << run.err;
  EXPECT_EQ(run.json()["differences"], nlohmann::json::array()) << run.out;
  const auto again = folder_.file("again.xml");
  ASSERT_EQ(cli_run({"export", recovered, "-o", again}).code, cli::kDone);
  const auto compared = cli_run({"compare", eni_, again});
  EXPECT_EQ(compared.code, cli::kDone) << compared.out;
}

TEST_F(CliExport, AnEniIsShownAsAProject) {
  const auto of_eni = cli_run({"project", "show", eni_, "--json"});
  ASSERT_EQ(of_eni.code, cli::kDone) << of_eni.err;
  const auto of_project = cli_run({"project", "show", project_, "--json"});
  EXPECT_EQ(of_eni.json()["settings"]["master.cycle_time_us"], of_project.json()["settings"]["master.cycle_time_us"]);
  EXPECT_EQ(of_eni.json()["settings"]["slave.1.name"], of_project.json()["settings"]["slave.1.name"]);
}

TEST_F(CliExport, ProjectAndEniRunOnTheBusThatTheyDescribe) {
  for (const auto& file : {project_, eni_}) {
    const auto run = cli_run({"run", file, "--link", "sim:" + file + "?virtual", "--for", "8s", "--json"});
    EXPECT_EQ(run.code, cli::kDone) << run.err << run.out.substr(0, 2000);
    const auto scanned = cli_run({"scan", "sim:" + file + "?virtual", "--json"});
    EXPECT_EQ(scanned.code, cli::kDone) << scanned.err;
  }
}

TEST_F(CliExport, EachNetworkOfAMachineHasABusOfItsOwn) {
  const auto machine = folder_.file("two.syncline");
  ASSERT_EQ(cli_run({"project", "create", machine, "--eni", eni_, "--network", "left"}).code, cli::kDone);
  ASSERT_EQ(cli_run({"project", "create", machine, "--device", "0x5c17:0x1100", "--esi",
                     test::source_dir() + "/resources/esi", "--network", "right"})
                .code,
            cli::kDone);
  const auto left = cli_run({"scan", "sim:" + machine + "?virtual&network=0", "--json"});
  const auto right = cli_run({"scan", "sim:" + machine + "?virtual&network=1", "--json"});
  ASSERT_EQ(left.code, cli::kDone) << left.err;
  ASSERT_EQ(right.code, cli::kDone) << right.err;
  EXPECT_EQ(left.json()["slaves"].size(), 9U);
  EXPECT_EQ(right.json()["slaves"].size(), 1U);
  EXPECT_NE(cli_run({"scan", "sim:" + machine + "?virtual&network=2"}).code, cli::kDone);
}

TEST_F(CliExport, AnEniThatIsNoneIsAFileError) {
  const auto file = folder_.file("other.xml");
  std::ofstream(file) << "<Network/>";
  for (const auto& arguments : {std::vector<std::string>{"export", file, "-o", folder_.file("x.xml")},
                                std::vector<std::string>{"project", "create", folder_.file("p"), "--eni", file},
                                std::vector<std::string>{"run", eni_, "--link", "sim:" + file + "?virtual"}}) {
    const auto run = cli_run(arguments);
    EXPECT_EQ(run.code, cli::kFailed) << run.out;
    EXPECT_THAT(run.err, HasSubstr(file));
  }
}

}  // namespace
}  // namespace syncline::test
