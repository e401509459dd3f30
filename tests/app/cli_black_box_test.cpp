// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "capture/pcap_reader.h"
#include "support/random.h"
#include "support/whole_file.h"
#include "tests/app/cli_process.h"
#include "tests/app/cli_runner.h"
#include "tests/app/light_machine.h"
#include "tests/support/pcapng_file.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;

class CliBlackBox : public testing::Test {
 protected:
  CliBlackBox() {
    EXPECT_TRUE(write_whole_file(folder.file("machine.toml"), light_machine()));
    EXPECT_EQ(cli_run({"project", "create", project, "--scan", machine + "?virtual", "--cycle", "1000"}).code,
              cli::kDone);
    std::filesystem::create_directory(boxes);
  }
  CliRun run(const std::vector<std::string>& options) {
    std::vector<std::string> words{"run",   project, "--link",      machine + "?virtual",
                                   "--for", "20s",   "--black-box", boxes + "/box"};
    words.insert(words.end(), options.begin(), options.end());
    return cli_run(words);
  }

  TemporaryFolder folder;
  std::string project = folder.file("m.syncline"), machine = "sim:" + folder.file("machine.toml"),
              boxes = folder.file("boxes");
};

TEST_F(CliBlackBox, KeepsTheLastFramesAndSaysWhere) {
  const auto done = run({"--black-box-mib", "1", "--json"});
  ASSERT_EQ(done.code, cli::kDone) << done.err;
  const auto json = done.json()["black_box"];
  const auto files = files_in(boxes);
  const auto packets = packets_in(files);
  EXPECT_EQ(json["name"], boxes + "/box");
  EXPECT_EQ(json["file"], files.back());
  EXPECT_EQ(json["files"], files.size());
  EXPECT_EQ(json["frames"], packets.size());
  EXPECT_GT(json["replaced"].get<std::size_t>(), 10'000U);
  EXPECT_EQ(json["lost"], 0);
  EXPECT_TRUE(json["error"].is_null());
  EXPECT_EQ(json["begin_ns"], packets.front().time);
  EXPECT_EQ(json["end_ns"], packets.back().time);
  std::uint64_t bytes = 0;
  for (const auto& file : files) bytes += std::filesystem::file_size(file);
  EXPECT_EQ(json["bytes"], bytes);
  EXPECT_LE(bytes, 1U << 20U);
  const auto text = run({"--black-box-mib", "1"});
  EXPECT_THAT(text.out, HasSubstr("black box " + boxes + "/box_*.pcapng: "));
  EXPECT_THAT(text.out, HasSubstr(" before them replaced, 0 lost"));
}

TEST_F(CliBlackBox, HoldsTheBringUpAndWhatWasTold) {
  ASSERT_EQ(run({}).code, cli::kDone);
  const auto packets = packets_in(files_in(boxes));
  std::vector<std::string> told;
  for (const auto& packet : packets) {
    for (auto& comment : packet.comments()) told.push_back(std::move(comment));
  }
  EXPECT_THAT(told, testing::Contains(HasSubstr("online")));
  EXPECT_THAT(told, testing::Contains(HasSubstr("PREOP")));
  EXPECT_THAT(told, testing::Each(testing::Not(HasSubstr("before this frame")))) << "none came too late";
  EXPECT_TRUE(std::ranges::is_sorted(packets, {}, &PcapngBlock::time));
}

/// Our own reader takes each file: its registers can be scanned like any capture.
TEST_F(CliBlackBox, CanBeScannedLikeACapture) {
  ASSERT_EQ(run({}).code, cli::kDone);
  const auto scanned = cli_run({"scan", "replay:" + files_in(boxes).front(), "--json"});
  EXPECT_EQ(scanned.code, cli::kDone) << scanned.err;
  EXPECT_EQ(scanned.json()["slaves"].size(), 2U);
}

TEST_F(CliBlackBox, WhatCannotBeIsSaidBeforeTheRun) {
  EXPECT_EQ(run({"--black-box-mib", "0"}).code, cli::kUsage);
  const auto full = run({"--black-box-keep-free-mib", "4000000000"});
  EXPECT_EQ(full.code, cli::kFailed);
  EXPECT_THAT(full.err, HasSubstr("a black box needs"));
  EXPECT_EQ(full.out, "");
  std::filesystem::remove_all(boxes);
  const auto none = run({});
  EXPECT_EQ(none.code, cli::kFailed);
  EXPECT_THAT(none.err, HasSubstr("No such file or directory"));
}

std::uint64_t size_of_all(const std::string& folder) {
  std::uint64_t sum = 0;
  std::error_code gone;  // the oldest may go meanwhile
  for (const auto& entry : std::filesystem::directory_iterator(folder, gone)) {
    const auto size = entry.file_size(gone);
    if (!gone) sum += size;
  }
  return sum;
}

/// Killed as soon as so much is written, wherever that is: all files are whole but for the last block of the last, and
/// the next run goes on behind them.
TEST_F(CliBlackBox, KilledItIsWholeUpToTheLastSecond) {
  constexpr int kRounds = 8;
  constexpr Nanoseconds kBusyHost = kSecond;
  Random random(20);
  std::uint64_t written = 0;
  std::size_t known = 0;
  for (int round = 0; round < kRounds; ++round) {
    CliProcess run({"run", project, "--link", machine, "--for", "1h", "--black-box", boxes + "/box"});
    ASSERT_TRUE(run.wait_for_err("online: the master runs")) << run.err();
    written += 100'000 + random.next() % 200'000;
    while (size_of_all(boxes) < written) std::this_thread::sleep_for(std::chrono::microseconds(500));
    const auto killed = host_time();
    run.signal(SIGKILL);
    EXPECT_EQ(run.wait(), 128 + SIGKILL);
    written = size_of_all(boxes);

    const auto files = files_in(boxes);
    EXPECT_EQ(files.size(), static_cast<std::size_t>(round) + 1) << "what the runs before have left stays";
    std::size_t found = 0;
    Nanoseconds last = 0;
    for (const auto& file : files) {
      auto reader = PcapReader::open(file);
      ASSERT_TRUE(reader) << file;
      auto next = reader->next();
      for (; next && *next; next = reader->next()) {
        ++found;
        EXPECT_GE((*next)->time, last);
        last = (*next)->time;
      }
    }
    EXPECT_GT(found, known);
    known = found;
    EXPECT_EQ(found, packets_in(files).size());
    EXPECT_LE(killed - last, kSecond + kBusyHost) << "round " << round;
    EXPECT_GE(killed, last);
  }
}

TEST_F(CliBlackBox, AFolderThatIsTakenAwayEndsItAndTheRunGoesOn) {
  CliProcess run({"run", project, "--link", machine, "--for", "4s", "--black-box", boxes + "/box"});
  while (size_of_all(boxes) == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  std::filesystem::remove_all(boxes);
  EXPECT_EQ(run.wait(), cli::kFailed);
  EXPECT_THAT(run.err(), HasSubstr("the file is gone"));
  EXPECT_THAT(run.out(), HasSubstr("state OP")) << "the run went on to its end";
}

}  // namespace
}  // namespace syncline::test
