// SPDX-License-Identifier: Apache-2.0
#include "support/output_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "support/stop_signals.h"
#include "support/whole_file.h"

namespace syncline {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class OutputFileTest : public ::testing::Test {
 protected:
  OutputFileTest() {
    std::string pattern = (fs::temp_directory_path() / "syncline-output-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~OutputFileTest() override { fs::remove_all(folder_); }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder_), {}); }
  fs::path folder_;
};

TEST_F(OutputFileTest, HasItsNameWhenItIsFinishedAndNotBefore) {
  auto file = OutputFile::create(path("a"));
  ASSERT_TRUE(file);
  ASSERT_TRUE(file->write("one "));
  ASSERT_TRUE(file->flush());
  ASSERT_TRUE(file->write("two"));
  EXPECT_FALSE(fs::exists(path("a")));
  ASSERT_TRUE(file->finish());
  EXPECT_EQ(read_whole_file(path("a")), "one two");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, WhatIsNotFinishedLeavesTheOldFileAndNothingElse) {
  ASSERT_TRUE(write_whole_file(path("a"), "old"));
  {
    auto file = OutputFile::create(path("a"));
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->write(std::string(1U << 20, 'x')));
    EXPECT_EQ(files(), 2);
  }
  EXPECT_EQ(read_whole_file(path("a")), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, ADeviceIsWrittenToAndStaysADevice) {
  struct stat before {
  }, after{};
  ASSERT_EQ(::stat("/dev/full", &before), 0);
  const auto written = write_whole_file("/dev/full", "x");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::kFileNotWritable);
  EXPECT_EQ(written.error().file, "/dev/full");
  EXPECT_THAT(written.error().detail.text(), HasSubstr("No space left"));
  EXPECT_TRUE(write_whole_file("/dev/null", "x"));
  ASSERT_EQ(::stat("/dev/full", &after), 0);
  EXPECT_TRUE(S_ISCHR(after.st_mode));
  EXPECT_EQ(before.st_ino, after.st_ino);
}

TEST_F(OutputFileTest, APipeGetsTheBytes) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = read_whole_file(path("pipe")).value_or("nothing"); });
  EXPECT_TRUE(write_whole_file(path("pipe"), "through the pipe"));
  reader.join();
  EXPECT_EQ(got, "through the pipe");
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
}

TEST_F(OutputFileTest, FoldersAreRefusedByName) {
  const auto written = write_whole_file(folder_.string(), "x");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().file, folder_.string());
  EXPECT_THAT(written.error().detail.text(), HasSubstr("folder"));
  EXPECT_EQ(files(), 0);
}

TEST_F(OutputFileTest, AnOpenFileOfAProgramIsWrittenToNotReplaced) {
  ASSERT_TRUE(write_whole_file(path("a"), "head "));
  const int descriptor = ::open(path("a").c_str(), O_WRONLY);
  struct stat before {
  }, after{};
  ASSERT_EQ(::fstat(descriptor, &before), 0);
  ASSERT_TRUE(write_whole_file("/proc/self/fd/" + std::to_string(descriptor), "tail"));
  ASSERT_EQ(::stat(path("a").c_str(), &after), 0);
  ::close(descriptor);
  EXPECT_EQ(before.st_ino, after.st_ino);
  EXPECT_EQ(read_whole_file(path("a")), "head tail");
}

TEST_F(OutputFileTest, PermissionsAndLinksStay) {
  ASSERT_TRUE(write_whole_file(path("a"), "one"));
  ASSERT_EQ(::chmod(path("a").c_str(), 0640), 0);
  if (::geteuid() == 0) {
    ASSERT_EQ(::chown(path("a").c_str(), 12345, 12345), 0);
  }
  fs::create_symlink("a", path("link"));
  fs::create_symlink("link", path("link2"));
  ASSERT_TRUE(write_whole_file(path("link2"), "two"));
  EXPECT_TRUE(fs::is_symlink(path("link")) && fs::is_symlink(path("link2")));
  struct stat now {};
  ASSERT_EQ(::stat(path("a").c_str(), &now), 0);
  EXPECT_EQ(now.st_mode & 07777U, 0640U);
  if (::geteuid() == 0) {
    EXPECT_EQ(now.st_uid, 12345U);
  }
  EXPECT_EQ(read_whole_file(path("a")), "two");
}

TEST_F(OutputFileTest, ALinkToNothingMakesWhatItNames) {
  fs::create_symlink("new", path("link"));
  ASSERT_TRUE(write_whole_file(path("link"), "x"));
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(read_whole_file(path("new")), "x");
  fs::create_symlink("round", path("round"));
  EXPECT_FALSE(write_whole_file(path("round"), "x"));
}

TEST_F(OutputFileTest, LinksThatSomebodyHasLaidOutAreNotFollowed) {
  ASSERT_TRUE(write_whole_file(path("victim"), "precious"));
  for (const char* name : {"a.part", "a.tmp", ".a.saving-abcdef", ".a.saving-XXXXXX"})
    fs::create_symlink("victim", path(name));
  ASSERT_TRUE(write_whole_file(path("a"), "x"));
  EXPECT_EQ(read_whole_file(path("victim")), "precious");
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(path("a"))));
}

TEST_F(OutputFileTest, AFileThatCannotGrowIsToldOnceAndLeavesNothing) {
  ASSERT_TRUE(write_whole_file(path("a"), "old"));
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = ::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{100'000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  auto file = OutputFile::create(path("a"));
  ASSERT_TRUE(file);
  Status status;
  for (int i = 0; i < 100 && status; ++i) status = file->write(std::string(10'000, 'x'));
  const auto left = files();
  const auto finished = file->finish();
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, handler);
  ASSERT_FALSE(status);
  EXPECT_THAT(status.error().detail.text(), HasSubstr("too large"));
  EXPECT_EQ(left, 1) << "the space is given back at once";
  EXPECT_FALSE(finished);
  EXPECT_EQ(read_whole_file(path("a")), "old");
}

TEST_F(OutputFileTest, ASignalEndsTheWaitingForAPipe) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const StopSignals stop;
  const pthread_t self = ::pthread_self();
  std::atomic<bool> over{false};
  std::thread killer([&] {
    while (!over) {  // whenever it comes to waiting
      ::pthread_kill(self, SIGINT);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  const auto read = read_whole_file(path("pipe"));
  const auto written = write_whole_file(path("pipe"), "x");
  over = true;
  killer.join();
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::kCancelled);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::kCancelled);
  EXPECT_TRUE(stop.interrupted());
  EXPECT_EQ(stop.number(), SIGINT);
}

}  // namespace
}  // namespace syncline
