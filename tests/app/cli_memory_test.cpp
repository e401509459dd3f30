// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

#include "tests/app/cli_runner.h"
#include "tests/support/source_dir.h"

/// What a machine with little memory does to the program: an exit code of the four and a sentence, never an abort. The
/// limit is one of address space (ulimit -v), so that threads' stacks and every allocation may fail, wherever they are.
namespace syncline::test {
namespace {

using testing::HasSubstr;

struct Ended {
  int code = 0;  // 128 and the signal's number where one ended it
  std::string words;
};

class CliMemory : public testing::Test {
 protected:
  void SetUp() override {
#ifdef SYNCLINE_SANITIZED
    GTEST_SKIP() << "a sanitizer needs an address space without bounds";
#endif
  }
  [[nodiscard]] Ended within(int kilobytes, const std::string& arguments) const {
    const auto program = (std::filesystem::read_symlink("/proc/self/exe").parent_path() / "synclinectl").string();
    const auto said = folder_.file("said");
    const auto status = std::system(fmt::format("cd {} && ulimit -c 0 && ulimit -v {} && exec {} {} > {} 2>&1",
                                                folder_.file(""), kilobytes, program, arguments, said)
                                        .c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_text(said)};
  }
  /// From less than the program needs to be loaded up to enough.
  void expect_a_code_at_each_limit(const std::string& arguments) const {
    bool done = false;
    for (int kilobytes = 20'000; kilobytes <= 400'000; kilobytes += kilobytes < 120'000 ? 8'000 : 70'000) {
      std::filesystem::remove_all(folder_.file("out.slrec"));
      const auto ended = within(kilobytes, arguments);
      if (ended.code == 127) continue;  // the loader had not enough for the program
      EXPECT_THAT(ended.code, testing::AnyOf(0, 1, 2, 3)) << kilobytes << " KB: " << arguments << '\n' << ended.words;
      EXPECT_TRUE(ended.code != 3 || !ended.words.empty()) << kilobytes << " KB";
      done = done || ended.code == 0;
    }
    EXPECT_TRUE(done) << arguments;
  }

  const std::string machine_ = test::source_dir() + "/resources/demo/machine.toml";
  TemporaryFolder folder_;
};

TEST_F(CliMemory, OfTooLittleAScanEndsWithASentence) {
  expect_a_code_at_each_limit(fmt::format("scan 'sim:{}?virtual'", machine_));
}

TEST_F(CliMemory, OfTooLittleARunWithRecordingAndBlackBoxEndsWithASentence) {
  ASSERT_EQ(cli_run({"project", "create", folder_.file("m.syncline"), "--scan", "sim:" + machine_ + "?virtual"}).code,
            cli::kDone);
  expect_a_code_at_each_limit(
      fmt::format("run m.syncline --link 'sim:{}?virtual' --for 300ms --record out.slrec --black-box box", machine_));
}

TEST_F(CliMemory, OfTooLittleATrialOfEsiFilesEndsWithASentence) {
  expect_a_code_at_each_limit(fmt::format("esi try --threads 4 --every 16 {}/resources/esi", test::source_dir()));
}

}  // namespace
}  // namespace syncline::test
