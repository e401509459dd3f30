// SPDX-License-Identifier: Apache-2.0
// No command writes over a file that it reads, whatever the file is called.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/app/cli_runner.h"
#include "tests/app/light_machine.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class CliFiles : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directory(folder.file("esi"));
    for (const auto* name : {"SL-1100.xml", "SL-2002.xml"}) {
      fs::copy_file(source_dir() + "/resources/esi/" + name, folder.file("esi/") + name);
    }
    std::ofstream(folder.file("sim.toml")) << "[[slave]]\nname = \"Coupler\"\nesi = \"esi/SL-1100.xml\"\n";
    std::ofstream(folder.file("log.csv")) << "cycle,send_time_ns,dcm_error_ns\n0,1000000000,5\n1,1001000000,6\n";
    made({"project", "create", folder.file("m.syncline"), "--scan", link(), "--esi", folder.file("esi"), "--cache",
          folder.file("cache.sqlite")});
    made({"export", folder.file("m.syncline"), "-o", folder.file("m.xml")});
    made({"run", folder.file("m.syncline"), "--link", link(), "--for", "2s", "--record", folder.file("r.slrec"),
          "--capture", folder.file("c.pcapng")});
    std::ofstream(folder.file("r.slrec-wal")) << "what a run that was cut short has left";
  }
  void made(const std::vector<std::string>& arguments) {
    const auto run = cli_run(arguments);
    ASSERT_TRUE(fs::exists(arguments[0] == "run" ? folder.file("r.slrec") : folder.file("m.syncline"))) << run.err;
  }
  [[nodiscard]] std::string link() const { return "sim:" + folder.file("sim.toml") + "?virtual"; }
  TemporaryFolder folder;
};

/// The other names of a file.
std::vector<std::string> names_of(const std::string& file) {
  const fs::path path(file);
  const auto link = file + ".link", hard = file + ".hard";
  std::error_code there_already;
  fs::create_symlink(path.filename(), link, there_already);
  fs::create_hard_link(path, hard, there_already);
  return {file, (path.parent_path() / "." / path.filename()).string(), link, hard};
}

TEST_F(CliFiles, WhatACommandReadsItDoesNotWrite) {
  const auto project = folder.file("m.syncline"), eni = folder.file("m.xml"), recording = folder.file("r.slrec"),
             scenario = folder.file("sim.toml"), capture = folder.file("c.pcapng"), table = folder.file("log.csv"),
             esi = folder.file("esi/SL-1100.xml");
  struct Row {
    std::vector<std::string> arguments;
    std::string written;             // the option, whose file follows
    std::vector<std::string> files;  // each of which it must not be
    std::string read{};              // the option that reads it
  };
  const std::vector<std::string> run{"run", project, "--link", link(), "--for", "100ms"};
  const auto with = [](std::vector<std::string> first, const std::vector<std::string>& more) {
    first.insert(first.end(), more.begin(), more.end());
    return first;
  };
  const std::vector<Row> rows{
      {{"record", "export", recording}, "out", {recording, recording + "-wal"}, "file"},
      {{"record", "export", recording, "--document", "project"}, "out", {recording}, "file"},
      {{"record", "report", recording}, "out", {recording, recording + "-wal"}, "file"},
      {{"record", "import", table}, "out", {table}, "file"},
      {{"record", "import", capture}, "out", {capture}, "file"},
      {{"export", project}, "--output", {project}, "file"},
      {{"export", eni}, "--output", {eni}, "file"},
      {{"export", project, "--format", "csv"}, "--output", {project}, "file"},
      {{"export", project, "-o", folder.file("new.xml")}, "--report", {project}, "file"},
      {run, "--csv", {project}, "file"},
      {run, "--csv", {scenario, esi}, "--link"},
      {run, "--dcm-log", {project}, "file"},
      {run, "--capture", {project}, "file"},
      {run, "--capture", {scenario}, "--link"},
      {run, "--save-host", {project}, "file"},
      {run, "--save-host", {scenario}, "--link"},
      {run, "--record", {project}, "file"},
      {{"scan", link()}, "--capture", {scenario, esi}, "link"},
      {{"scan", "replay:" + capture}, "--capture", {capture}, "link"},
      {{"scan", link(), "--esi", folder.file("esi")}, "--capture", {folder.file("esi/SL-2002.xml")}, "--esi"},
      {{"scan", "sim:" + project + "?virtual"}, "--capture", {project}, "link"},
      {{"sii", "read", link(), "0"}, "file", {scenario, esi}, "link"},
      {{"foe", "read", link(), "0", "firmware"}, "file", {scenario, esi}, "link"},
      {{"project", "create", "--eni", eni}, "file", {eni}, "--eni"},
      {{"project", "create", "--scan", link()}, "file", {scenario, esi}, "--scan"},
      {{"project", "create", "--device", "1:2", "--esi", folder.file("esi")}, "file", {esi}, "--esi"},
  };
  for (const auto& row : rows) {
    for (const auto& file : row.files) {
      for (const auto& name : names_of(file)) {
        const auto before = read_text(file);
        const bool option = row.written.starts_with('-');
        auto arguments = with(row.arguments, option ? std::vector{row.written, name} : std::vector{name});
        // Of `project create` the file comes first.
        if (row.arguments[0] == "project") {
          arguments.pop_back();
          arguments.insert(arguments.begin() + 2, name);
        }
        const auto refused = cli_run(arguments);
        const auto what = row.arguments[0] + " " + row.written + " " + name;
        EXPECT_EQ(refused.code, cli::kUsage) << what << ": " << refused.err;
        EXPECT_THAT(refused.err, testing::AllOf(HasSubstr(row.written), HasSubstr(" " + row.read + " reads"),
                                                HasSubstr("name another")))
            << what;
        EXPECT_TRUE(read_text(file) == before) << what << " is byte for byte what it was";
      }
    }
  }
}

TEST_F(CliFiles, TwoOutputsAreTwoFiles) {
  const auto project = folder.file("m.syncline"), one = folder.file("one"), again = folder.file("./one");
  const std::vector<std::string> run{"run", project, "--link", link(), "--for", "100ms"};
  const std::vector<std::vector<std::string>> outputs{
      {"--csv", one, "--dcm-log", again},       {"--csv", one, "--capture", again},
      {"--csv", one, "--save-host", again},     {"--csv", one, "--record", again},
      {"--csv", one + "-wal", "--record", one}, {"--capture", one, "--record", again},
  };
  for (const auto& both : outputs) {
    auto arguments = run;
    arguments.insert(arguments.end(), both.begin(), both.end());
    const auto refused = cli_run(arguments);
    EXPECT_EQ(refused.code, cli::kUsage) << both[0] << ' ' << both[2] << ": " << refused.err;
    EXPECT_THAT(refused.err, testing::AllOf(HasSubstr(both[0]), HasSubstr(both[2]))) << both[2];
    EXPECT_FALSE(fs::exists(one)) << both[2];
  }
  const auto refused = cli_run({"export", project, "-o", one, "--report", again});
  EXPECT_EQ(refused.code, cli::kUsage) << refused.err;
  EXPECT_THAT(refused.err, testing::AllOf(HasSubstr("--output"), HasSubstr("--report")));
  const auto created =
      cli_run({"project", "create", one, "--scan", link(), "--esi", folder.file("esi"), "--cache", again});
  EXPECT_EQ(created.code, cli::kUsage) << created.err;
  EXPECT_FALSE(fs::exists(one));
  EXPECT_EQ(cli_run({"scan", link(), "--esi", folder.file("esi"), "--cache", one, "--capture", again}).code,
            cli::kUsage);
}

TEST_F(CliFiles, WhatTakesNoHarmIsNoFile) {
  const auto run = cli_run({"run", folder.file("m.syncline"), "--link", link(), "--for", "100ms", "--csv", "/dev/null",
                            "--dcm-log", "/dev/null", "--capture", "/dev/null"});
  EXPECT_NE(run.code, cli::kUsage) << run.err;
}

TEST_F(CliFiles, KeptEniFilesTakeNoEsiFilesPlace) {
  const auto esi = folder.file("esi/SL-1100-1.xml");
  fs::copy_file(folder.file("esi/SL-2002.xml"), esi);
  const auto before = read_text(esi);
  const auto refused = cli_run({"esi", "try", folder.file("esi"), "--keep", folder.file("esi/.")});
  EXPECT_EQ(refused.code, cli::kUsage) << refused.err;
  EXPECT_THAT(refused.err, testing::AllOf(HasSubstr("--keep"), HasSubstr("the argument path reads")));
  EXPECT_TRUE(read_text(esi) == before);
}

}  // namespace
}  // namespace syncline::test
