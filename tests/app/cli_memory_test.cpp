// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <random>

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
  /// `first`: what the shell does before it becomes the program.
  [[nodiscard]] Ended ended(const std::string& first, const std::string& arguments) const {
    const auto program = (std::filesystem::read_symlink("/proc/self/exe").parent_path() / "synclinectl").string();
    const auto said = folder_.file("said");
    std::filesystem::remove_all(folder_.file("out.slrec"));
    std::filesystem::remove_all(folder_.file("box"));
    const auto status = std::system(fmt::format("cd {} && ulimit -c 0 && {} exec {} {} > {} 2>&1", folder_.file(""),
                                                first, program, arguments, said)
                                        .c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_text(said)};
  }
  [[nodiscard]] Ended within(int kilobytes, const std::string& arguments) const {
    return ended(fmt::format("ulimit -v {} &&", kilobytes), arguments);
  }
  [[nodiscard]] Ended preloaded(const std::string& settings, const std::string& arguments) const {
    const auto library = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "failing_memory.so";
    return ended(fmt::format("export LD_PRELOAD={} {} &&", library.string(), settings), arguments);
  }
  /// So many allocations are made.
  [[nodiscard]] long allocations(const std::string& arguments, const std::string& of = "") const {
    const auto ended = preloaded(fmt::format("{} FAILING_MEMORY_TOLD={}", of, folder_.file("told")), arguments);
    EXPECT_EQ(ended.code, 0) << ended.words;
    return std::atol(read_text(folder_.file("told")).c_str());
  }
  /// From less than the program needs to be loaded up to enough.
  void expect_a_code_at_each_limit(const std::string& arguments) const {
    bool done = false;
    for (int kilobytes = 20'000; kilobytes <= 400'000; kilobytes += kilobytes < 120'000 ? 8'000 : 70'000) {
      const auto ended = within(kilobytes, arguments);
      if (ended.code == 127) continue;  // the loader had not enough for the program
      EXPECT_THAT(ended.code, testing::AnyOf(0, 1, 2, 3)) << kilobytes << " KB: " << arguments << '\n' << ended.words;
      EXPECT_TRUE(ended.code != 3 || !ended.words.empty()) << kilobytes << " KB";
      done = done || ended.code == 0;
    }
    EXPECT_TRUE(done) << arguments;
  }

  void expect_a_code_with(const std::string& settings, const std::string& arguments) const {
    const auto ended = preloaded(settings, arguments);
    EXPECT_THAT(ended.code, testing::AnyOf(0, 1, 2, 3)) << settings << ": " << arguments << '\n' << ended.words;
  }

  /// Single allocations, some and all further ones fail at random places (the same at each run), the further ones until
  /// a large block is given back. Not with --json: nlohmann::json allocates where it is destroyed.
  void expect_a_code_wherever_it_fails(const std::string& arguments) const {
    // Before its arguments are read it has done nothing that could be lost.
    const auto first = allocations("--version"), last = allocations(arguments);
    ASSERT_GT(last, first) << arguments;
    std::mt19937 random(1);
    std::uniform_int_distribution<long> any(first, last);
    for (const long count : {1L, 40L, 1L << 30}) {
      for (int i = 0; i < 20; ++i)
        expect_a_code_with(fmt::format("FAILING_MEMORY_FROM={} FAILING_MEMORY_COUNT={}", any(random), count),
                           arguments);
    }
  }

  /// As where others ask for memory, too: here and there an allocation fails, for a while or from there on. Not while
  /// the machine's file is read, whose library ends the program then.
  void expect_a_code_with_failures_here_and_there(const std::string& arguments, const std::string& reads) const {
    const auto first = allocations(reads), last = allocations(arguments);
    ASSERT_GT(last, first) << arguments;
    std::mt19937 random(2);
    std::uniform_int_distribution<long> any(first, last);
    for (const long count : {40L, 400L, 1L << 30}) {
      for (int share = 20; share < 60; ++share)
        expect_a_code_with(fmt::format("FAILING_MEMORY_FROM={} FAILING_MEMORY_COUNT={} FAILING_MEMORY_SHARE={}",
                                       any(random), count, share),
                           arguments);
    }
  }

  /// Large blocks are what memory that is short refuses first: each of them in turn.
  void expect_a_code_without_each_large_block(const std::string& arguments) const {
    const std::string large = "FAILING_MEMORY_LEAST=8192";
    const auto all = allocations(arguments, large);
    ASSERT_GT(all, 10) << arguments;
    for (long from = 0; from < all; from += std::max(all / 60, 1L))
      expect_a_code_with(fmt::format("{} FAILING_MEMORY_FROM={} FAILING_MEMORY_COUNT=1", large, from), arguments);
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

TEST_F(CliMemory, WhereverAnAllocationFailsAScanEndsWithACode) {
  expect_a_code_wherever_it_fails(fmt::format("scan 'sim:{}?virtual'", machine_));
}

TEST_F(CliMemory, WithoutALargeBlockATrialOfAnEsiFileEndsWithACode) {
  expect_a_code_without_each_large_block(
      fmt::format("esi try --threads 1 {}/resources/esi/SL-2002.xml", test::source_dir()));
}

TEST_F(CliMemory, WhereverAnAllocationFailsARunEndsWithACode) {
  ASSERT_EQ(cli_run({"project", "create", folder_.file("m.syncline"), "--scan", "sim:" + machine_ + "?virtual"}).code,
            cli::kDone);
  expect_a_code_wherever_it_fails(
      fmt::format("run m.syncline --link 'sim:{}?virtual' --for 100ms --csv c.csv --record out.slrec "
                  "--black-box box --capture c.pcapng",
                  machine_));
}

TEST_F(CliMemory, WithFailuresHereAndThereARunEndsWithACode) {
  ASSERT_EQ(cli_run({"project", "create", folder_.file("m.syncline"), "--scan", "sim:" + machine_ + "?virtual"}).code,
            cli::kDone);
  expect_a_code_with_failures_here_and_there(
      fmt::format("run m.syncline --link 'sim:{}?virtual' --for 100ms --record out.slrec --black-box box", machine_),
      fmt::format("scan 'sim:{}?virtual'", machine_));
}

TEST_F(CliMemory, WhereverAnAllocationFailsACheckEndsWithACode) {
  ASSERT_EQ(cli_run({"project", "create", folder_.file("m.syncline"), "--scan", "sim:" + machine_ + "?virtual"}).code,
            cli::kDone);
  ASSERT_EQ(cli_run({"export", folder_.file("m.syncline"), "-o", folder_.file("m.xml")}).code, cli::kDone);
  expect_a_code_wherever_it_fails("check m.xml");
}

TEST_F(CliMemory, WhereverAnAllocationFailsATrialOfEsiFilesEndsWithACode) {
  expect_a_code_wherever_it_fails(fmt::format("esi try --threads 4 {}/resources/esi/SL-1100.xml", test::source_dir()));
}

}  // namespace
}  // namespace syncline::test
