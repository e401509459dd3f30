// SPDX-License-Identifier: Apache-2.0
// A pipe that nobody writes to in place of each kind of file: Ctrl-C ends the waiting at once and the file is named.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/app/cli_process.h"
#include "tests/app/cli_runner.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;

class CliWaiting : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(::mkfifo(pipe().c_str(), 0600), 0);
    ASSERT_EQ(cli_run({"project", "create", project(), "--scan", demo()}).code, cli::kDone);
  }
  [[nodiscard]] std::string pipe() const { return folder.file("pipe"); }
  [[nodiscard]] std::string project() const { return folder.file("m.syncline"); }
  [[nodiscard]] std::string scenario(const std::string& text) const {
    static int number = 0;
    const auto file = folder.file("s" + std::to_string(number++) + ".toml");
    std::ofstream(file) << text;
    return file;
  }
  static void wait_until_it_hears(const CliProcess& program) {
    const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (!program.catches(SIGINT) && std::chrono::steady_clock::now() < patience)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_TRUE(program.catches(SIGINT));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));  // and waits
  }

  TemporaryFolder folder;
};

TEST_F(CliWaiting, CtrlCEndsItForEveryKindOfFile) {
  const std::string device = "esi = \"" + source_dir() + "/resources/esi/SL-1100.xml\"\n";
  const auto host = scenario("[host]\nprofile = \"pipe\"\n[[slave]]\n" + device);
  const auto esi = scenario("[[slave]]\nesi = \"pipe\"\n");
  const std::vector<std::vector<std::string>> waiting{
      {"check", pipe()},
      {"compare", pipe(), project()},
      {"compare", project(), pipe()},
      {"compare", project(), "sim:" + pipe()},
      {"project", "show", pipe()},
      {"project", "set", pipe(), "master.cycle_time_us=1000"},
      {"project", "create", folder.file("x"), "--eni", pipe()},
      {"project", "create", folder.file("x"), "--scan", "replay:" + pipe()},
      {"project", "create", project(), "--scan", "sim:" + pipe()},
      {"project", "create", project(), "--scan", "sim:" + esi},
      {"export", pipe(), "-o", folder.file("x")},
      {"run", pipe(), "--link", demo()},
      {"run", project(), "--link", "sim:" + pipe()},
      {"run", project(), "--link", "replay:" + pipe()},
      {"scan", "sim:" + host},
      {"scan", "sim:" + esi},
      {"simulate", pipe(), "--nic", "lo"},
      {"record", "import", pipe(), folder.file("x")},
      {"sii", "write", demo(), "0", pipe()},
      {"foe", "write", demo(), "3", "name", pipe()},
      {"dc", "status", demo(), "--project", pipe()},
  };
  std::vector<std::unique_ptr<CliProcess>> all;
  for (const auto& arguments : waiting) all.push_back(std::make_unique<CliProcess>(arguments));
  for (std::size_t i = 0; i < all.size(); ++i) {
    SCOPED_TRACE(waiting[i][0] + " " + waiting[i][1]);
    wait_until_it_hears(*all[i]);
    all[i]->signal(SIGINT);
    EXPECT_EQ(all[i]->wait(), cli::kFailed) << all[i]->err();
    EXPECT_THAT(all[i]->err(), HasSubstr("pipe: Cancelled: a signal ended the waiting for its content."));
  }
}

TEST_F(CliWaiting, CtrlCEndsItForAReaderToo) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"export", project(), "-o", pipe()},
                                                    {"run", project(), "--link", demo(), "--csv", pipe()},
                                                    {"scan", demo(), "--capture", pipe()}}) {
    CliProcess program(arguments);
    wait_until_it_hears(program);
    program.signal(SIGINT);
    EXPECT_EQ(program.wait(), cli::kFailed) << program.err();
    EXPECT_THAT(program.err(), HasSubstr("pipe: Cancelled: a signal ended the waiting for its reader."));
  }
}

TEST_F(CliWaiting, CtrlZStopsItAsUsual) {
  CliProcess check({"check", pipe()});
  wait_until_it_hears(check);
  EXPECT_FALSE(check.catches(SIGTSTP));
  EXPECT_FALSE(check.ignores(SIGTSTP));
}

TEST_F(CliWaiting, WhatComesOverAPipeIsReadToItsEnd) {
  CliProcess check({"check", pipe()});
  std::ofstream out(pipe());
  out << "<EtherCATConfig" << std::flush;
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  out << "/>";
  out.close();
  EXPECT_EQ(check.wait(), cli::kAnswerIsNo) << check.err();
  EXPECT_THAT(check.out(), HasSubstr("pipe"));
}

TEST_F(CliWaiting, APipeIsNoRecordingAndNoFileOfAFolder) {
  for (const char* command : {"info", "figures"}) {
    const auto run = cli_run({"record", command, pipe()});
    EXPECT_EQ(run.code, cli::kFailed);
    EXPECT_THAT(run.err, HasSubstr("expected: a recording"));
  }
  const auto esi = folder.file("esi");
  std::filesystem::create_directory(esi);
  std::filesystem::copy_file(source_dir() + "/resources/esi/SL-1002.xml", esi + "/SL-1002.xml");
  ASSERT_EQ(::mkfifo((esi + "/pipe.xml").c_str(), 0600), 0);
  EXPECT_EQ(cli_run({"esi", "try", esi}).code, cli::kDone);
  const auto index = cli_run({"esi", "index", esi, "--cache", folder.file("c.sqlite")});
  EXPECT_EQ(index.code, cli::kDone) << index.err;
  EXPECT_THAT(index.out, HasSubstr("1 file, 1 read"));
}

}  // namespace
}  // namespace syncline::test
