// SPDX-License-Identifier: Apache-2.0
// How a recording ends when nobody ends it: the program is killed, or the disk is full.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "record/recording_reader.h"
#include "support/random.h"
#include "support/whole_file.h"
#include "tests/app/cli_process.h"
#include "tests/app/cli_runner.h"
#include "tests/app/light_machine.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;

class CliRecordEnd : public testing::Test {
 protected:
  CliRecordEnd() {
    EXPECT_TRUE(write_whole_file(folder.file("machine.toml"), light_machine()));
    EXPECT_EQ(cli_run({"project", "create", project, "--scan", machine + "?virtual", "--cycle", "4000"}).code,
              cli::kDone);
  }

  TemporaryFolder folder;
  std::string project = folder.file("m.syncline"), machine = "sim:" + folder.file("machine.toml");
};

TEST_F(CliRecordEnd, KilledItIsWholeUpToTheLastSecond) {
  constexpr int kRuns = 10;
  constexpr Nanoseconds kBusyHost = kSecond;  // with all of them at once
  Random random(15);
  std::vector<std::unique_ptr<CliProcess>> runs;
  const auto file = [this](int i) { return folder.file("run" + std::to_string(i)); };
  for (int i = 0; i < kRuns; ++i) {
    const std::vector<std::string> words{"run", project, "--link", machine, "--for", "1h", "--record", file(i)};
    runs.push_back(std::make_unique<CliProcess>(words));
  }
  for (auto& run : runs) ASSERT_TRUE(run->wait_for_err("online: the master runs")) << run->err();
  std::this_thread::sleep_for(std::chrono::milliseconds(1'500));
  for (int i = 0; i < kRuns; ++i) {
    std::this_thread::sleep_for(std::chrono::microseconds(random.next() % 120'000));
    const auto killed = host_time();
    runs[static_cast<std::size_t>(i)]->signal(SIGKILL);
    EXPECT_EQ(runs[static_cast<std::size_t>(i)]->wait(), 128 + SIGKILL);
    auto reader = RecordingReader::open(file(i));
    ASSERT_TRUE(reader) << reader.error().detail.text();
    const auto verified = reader->verify();
    ASSERT_TRUE(verified) << verified.error().detail.text();
    const auto info = reader->info();
    ASSERT_TRUE(info);
    EXPECT_FALSE(info->ended);
    EXPECT_EQ(info->missing_cycles, 0U);
    EXPECT_LE(killed - info->end, kSecond + kBusyHost) << "run " << i;
    EXPECT_GE(killed, info->end);
  }
}

/// A small disk of memory where that may be had, else a bound on the size of files.
class SmallDisk {
 public:
  explicit SmallDisk(const std::string& folder) : folder_(folder) {
    mounted_ = ::mount("none", folder.c_str(), "tmpfs", 0, "size=2m") == 0;
    if (mounted_) return;
    before_ = ::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &limit_);
    const rlimit small{1U << 20, limit_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    if (mounted_) {
      ::umount2(folder_.c_str(), MNT_DETACH);
      return;
    }
    ::setrlimit(RLIMIT_FSIZE, &limit_);
    ::signal(SIGXFSZ, before_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  std::string folder_;
  bool mounted_ = false;
  rlimit limit_{};
  void (*before_)(int) = SIG_DFL;
};

TEST_F(CliRecordEnd, AFullDiskEndsItWithAMessageAndItOpens) {
  const auto disk = folder.path() / "disk";
  std::filesystem::create_directory(disk);
  const SmallDisk small(disk.string());
  const auto file = (disk / "run.slrec").string();
  CliProcess run({"run", project, "--link", machine + "?virtual", "--for", "10min", "--record", file,
                  "--record-keep-free-mib", "0"});
  EXPECT_EQ(run.wait(), cli::kFailed);
  EXPECT_THAT(run.err(), HasSubstr("run.slrec cannot be written"));
  EXPECT_THAT(run.err(), HasSubstr("free space"));
  EXPECT_THAT(run.out(), HasSubstr("150000 cycles")) << "the run went on to its end";
  auto reader = RecordingReader::open(file);
  ASSERT_TRUE(reader) << reader.error().detail.text();
  EXPECT_TRUE(reader->verify());
  const auto info = reader->info();
  ASSERT_TRUE(info);
  EXPECT_GT(info->cycles, 2'000U);
  EXPECT_LT(info->cycles, 150'000U);
}

}  // namespace
}  // namespace syncline::test
