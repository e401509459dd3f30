// SPDX-License-Identifier: Apache-2.0
// A program that is killed while it saves leaves the old file or the new one, whole.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "eni/project/project_file.h"
#include "eni/xml/xml_text.h"
#include "support/random.h"
#include "tests/support/sample_devices.h"

namespace syncline::eni {
namespace {

class KillWhileSaving : public ::testing::Test {
 protected:
  KillWhileSaving() {
    std::string pattern = (std::filesystem::temp_directory_path() / "syncline-kill-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    old_ = sample::small_machine();
    old_.name = "old";
    new_ = old_;
    new_.name = "new";
    new_.slaves.insert(new_.slaves.end(), old_.slaves.begin(), old_.slaves.end());  // another length
  }
  ~KillWhileSaving() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string path() const { return (folder_ / "machine.syncline").string(); }
  [[nodiscard]] std::size_t file_count() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_), {}));
  }
  /// The name of the project in the file; it must be one of the two, whole.
  [[nodiscard]] std::string saved() const {
    const auto loaded = load_project(path());
    if (!loaded) return "unreadable";
    return *loaded == old_ || *loaded == new_ ? loaded->name : "mixed";
  }
  void expect_next_save_cleans_up() const {
    ASSERT_TRUE(save_project(old_, path()));
    EXPECT_EQ(saved(), "old");
    EXPECT_EQ(file_count(), 1U) << "what the killed program left is still there";
  }

  std::filesystem::path folder_;
  Project old_, new_;
};

/// A child that saves once, stopped at each system call on its way; killed at the `stop`th. False when it came to its
/// end.
bool kill_at_stop(int stop, const Project& project, const std::string& path, bool& traced) {
  const pid_t child = ::fork();
  if (child == 0) {
    if (::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) ::_exit(2);
    ::raise(SIGSTOP);
    ::_exit(save_project(project, path) ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  traced = WIFSTOPPED(status);
  for (int i = 0; i < stop && WIFSTOPPED(status); ++i) {
    ::ptrace(PTRACE_SYSCALL, child, nullptr, nullptr);
    ::waitpid(child, &status, 0);
  }
  if (!WIFSTOPPED(status)) return false;
  ::kill(child, SIGKILL);
  ::waitpid(child, &status, 0);
  return true;
}

TEST_F(KillWhileSaving, AtEachSystemCallTheFileIsTheOldOrTheNewOne) {
  int stops = 0, kept = 0, replaced = 0, left_over = 0;
  for (bool killed = true; killed; ++stops) {
    ASSERT_TRUE(save_project(old_, path()));
    bool traced = false;
    killed = kill_at_stop(stops, new_, path(), traced);
    if (!traced) GTEST_SKIP() << "this place does not let a program be traced";
    const auto found = saved();
    ASSERT_TRUE(found == "old" || found == "new") << "killed at stop " << stops << ": " << found;
    (found == "old" ? kept : replaced) += 1;
    left_over += file_count() > 1 ? 1 : 0;
    expect_next_save_cleans_up();
    ASSERT_LT(stops, 10'000);
  }
  EXPECT_GT(kept, 5);
  EXPECT_GT(replaced, 1);
  EXPECT_GT(left_over, 2) << "never killed between making the temporary file and renaming it";
}

TEST_F(KillWhileSaving, AtAnyMomentTheFileIsTheOldOrTheNewOne) {
  Random random(2026);
  for (int round = 0; round < 40; ++round) {
    ASSERT_TRUE(save_project(old_, path()));
    const pid_t child = ::fork();
    if (child == 0) {
      for (;;) {
        if (!save_project(new_, path()) || !save_project(old_, path())) ::_exit(1);
      }
    }
    const auto until = std::chrono::steady_clock::now() + std::chrono::microseconds(random.next() % 4'000);
    while (std::chrono::steady_clock::now() < until) {
    }
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "a save failed";
    const auto found = saved();
    ASSERT_TRUE(found == "old" || found == "new") << found;
    expect_next_save_cleans_up();
  }
}

TEST_F(KillWhileSaving, TwoWhoSaveTheSameFileDoNotDisturbEachOther) {
  const pid_t child = ::fork();
  if (child == 0) {
    for (int i = 0; i < 100; ++i) {
      if (!save_project(new_, path())) ::_exit(1);
    }
    ::_exit(0);
  }
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(save_project(old_, path()));
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "the other one could not save";
  expect_next_save_cleans_up();
}

TEST_F(KillWhileSaving, OtherFilesBesideItStay) {
  for (const char* name : {"machine.syncline.backup", ".machine.syncline.saving", ".machine.syncline.saving-1234567",
                           ".other.syncline.saving-abcdef", "machine.syncline~"}) {
    std::ofstream(folder_ / name) << "mine";
  }
  ASSERT_TRUE(save_project(old_, path()));
  EXPECT_EQ(file_count(), 6U);
  const std::string long_name(255, 'n');
  EXPECT_TRUE(write_file_atomic((folder_ / long_name).string(), "x"));
}

}  // namespace
}  // namespace syncline::eni
