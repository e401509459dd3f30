// SPDX-License-Identifier: Apache-2.0
#include "record/black_box.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <thread>

#include "config/network_config.h"
#include "support/random.h"
#include "support/text_bytes.h"
#include "support/whole_file.h"
#include "tests/support/black_box_file.h"
#include "tests/support/pcapng_file.h"

namespace syncline {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

using test::BlackBoxFile;
using test::kBegin;
using test::kMiB;

TEST_F(BlackBoxFile, HoldsFramesWithTimesDirectionsAndWhatHappened) {
  auto box = start(options());
  for (int i = 0; i < 1'000; ++i) {
    push();
    if (i == 500) box->note(kBegin + 490 * kMillisecond + 1, "slave 2 is lost");
    if (i == 500) box->note(kBegin + 485 * kMillisecond, "frames are lost");
    if (i == 999) box->note(kBegin + kSecond, "offline");
  }
  EXPECT_TRUE(box->finish());
  const auto report = box->report();
  EXPECT_EQ(report.frames, 1'000U);
  EXPECT_EQ(report.replaced + report.lost, 0U);
  EXPECT_EQ(report.begin, kBegin);
  EXPECT_EQ(report.end, kBegin + 999 * kMillisecond);
  EXPECT_FALSE(report.error);
  EXPECT_EQ(report.bytes, bytes());
  ASSERT_EQ(report.files, files().size());
  EXPECT_EQ(fs::path(files().front()).filename(), "box_00001_20251225174640.pcapng");

  const auto packets = test::packets_in(files());
  ASSERT_EQ(packets.size(), 1'000U);
  for (std::size_t i = 0; i < packets.size(); ++i) {
    EXPECT_EQ(packets[i].time, kBegin + static_cast<Nanoseconds>(i) * kMillisecond);
    EXPECT_EQ(load_le<std::uint32_t>(packets[i].frame), i);
    EXPECT_EQ(packets[i].number(2) & 3U, i % 2 == 0 ? 2U : 1U) << "outbound, inbound";
  }
  EXPECT_THAT(packets[485].comments(), ElementsAre("frames are lost"));
  EXPECT_THAT(packets[491].comments(), ElementsAre("slave 2 is lost"));
  EXPECT_EQ(std::ranges::count_if(packets, [](const auto& packet) { return !packet.comments().empty(); }), 2);

  const auto text = read_whole_file(files().back()).value_or("");
  const auto blocks = test::pcapng_blocks(bytes_of(text));
  EXPECT_EQ(blocks.front().type, test::kSectionBlock);
  EXPECT_EQ(blocks[1].type, test::kInterfaceBlock);
  EXPECT_THAT(text, HasSubstr("test 1.0"));
  EXPECT_THAT(text, HasSubstr("nic:eth1"));
  EXPECT_THAT(text, HasSubstr("machine.syncline"));
  ASSERT_EQ(blocks.back().type, test::kStatisticsBlock);
  EXPECT_EQ(blocks.back().end, text.size());
  EXPECT_THAT(blocks.back().comments(), ElementsAre("offline")) << "no frame came after it";
}

/// An answer has the time at which it came, and is fetched when all frames of its cycle have gone.
TEST_F(BlackBoxFile, PutsFramesInTheOrderOfTime) {
  auto box = start(options());
  const std::vector<std::uint8_t> frame(60);
  for (Nanoseconds cycle = 0; cycle < 500; ++cycle) {
    const auto begin = kBegin + cycle * kMillisecond;
    for (const Nanoseconds sent : {0, 20, 40}) ring_->push(frame, begin + sent, FrameDirection::kSent);
    for (const Nanoseconds came : {30, 50, 70}) ring_->push(frame, begin + came, FrameDirection::kReceived);
  }
  EXPECT_TRUE(box->finish());
  const auto packets = test::packets_in(files());
  EXPECT_EQ(packets.size(), 3'000U);
  EXPECT_TRUE(std::ranges::is_sorted(packets, {}, &test::PcapngBlock::time));
}

TEST_F(BlackBoxFile, NeverGrowsBeyondItsSizeAndKeepsTheLast) {
  auto box = start(options());
  constexpr std::size_t kFrames = 40'000;  // 14 MB
  for (std::size_t i = 0; i < kFrames; ++i) {
    push();
    if (i % 500 == 0) {
      EXPECT_LE(box->report().bytes, kMiB);
      EXPECT_LE(bytes(), kMiB + kMiB / FrameSegments::kSegments) << "one may have come and one gone meanwhile";
    }
  }
  EXPECT_TRUE(box->finish());
  EXPECT_LE(bytes(), kMiB);
  EXPECT_GT(bytes(), kMiB * 14 / 16);
  EXPECT_LE(files().size(), FrameSegments::kSegments + 1) << "none is filled to its last byte";
  const auto report = box->report();
  const auto packets = test::packets_in(files());
  EXPECT_EQ(report.frames, packets.size());
  EXPECT_EQ(report.frames + report.replaced, kFrames);
  EXPECT_EQ(load_le<std::uint32_t>(packets.back().frame), kFrames - 1);
  for (std::size_t i = 1; i < packets.size(); ++i)
    EXPECT_EQ(load_le<std::uint32_t>(packets[i].frame), load_le<std::uint32_t>(packets[i - 1].frame) + 1);
}

/// What the disk is too slow for is counted where it is missing, and in the sum.
TEST_F(BlackBoxFile, TellsEachLostFrame) {
  auto wanted = options(16 * kMiB);
  wanted.virtual_time = false;
  wanted.ring_bytes = 4096;
  auto box = start(wanted);
  for (int i = 0; i < 20'000; ++i) push();
  EXPECT_TRUE(box->finish());
  const auto report = box->report();
  EXPECT_GT(report.lost, 0U);
  EXPECT_EQ(report.frames + report.lost, 20'000U);
  std::uint64_t told = 0, received = 0, dropped = 0;
  std::size_t expected = 0;
  for (const auto& file : files()) {
    const auto text = read_whole_file(file).value_or("");
    for (const auto& block : test::pcapng_blocks(bytes_of(text))) {
      if (block.type == test::kPacketBlock) {
        told += block.number(4);
        expected += block.number(4);
        EXPECT_EQ(load_le<std::uint32_t>(block.frame), expected++);
      } else if (block.type == test::kStatisticsBlock) {
        received += block.number(4);
        dropped += block.number(5);
      }
    }
  }
  EXPECT_EQ(told + (20'000 - expected), report.lost);
  EXPECT_EQ(dropped, report.lost);
  EXPECT_EQ(received, 20'000U);
}

TEST_F(BlackBoxFile, OnVirtualTimeTheSameRunGivesTheSameFiles) {
  const auto once = [this](const std::string& name) {
    fs::create_directory(folder_.file(name));
    auto wanted = options();
    wanted.name = folder_.file(name) + "/box";
    auto box = start(wanted);
    pushed_ = 0;
    for (int i = 0; i < 6'000; ++i) {
      push(60 + static_cast<std::size_t>(i) % 700);
      // As a run tells its events: every 100 ms those of the time before.
      if (i % 100 == 0) box->note(kBegin + (i - 50) * kMillisecond, "event");
    }
    EXPECT_TRUE(box->finish());
    EXPECT_EQ(box->report().lost, 0U);
    std::vector<std::pair<std::string, std::string>> contents;
    for (const auto& file : test::files_in(folder_.file(name)))
      contents.emplace_back(fs::path(file).filename().string(), *read_whole_file(file));
    return contents;
  };
  const auto first = once("first");
  EXPECT_GT(first.size(), 10U);
  EXPECT_TRUE(first == once("second"));
}

/// What a run before has left is evidence: it stays until newer frames need its room.
TEST_F(BlackBoxFile, GoesOnBehindAnEarlierRun) {
  auto box = start(options());
  for (int i = 0; i < 1'000; ++i) push();
  EXPECT_TRUE(box->finish());
  const auto before = files();
  ASSERT_TRUE(write_whole_file(folder_.file("box_00077_20260101000000.pcapng"), "of another program"));
  ASSERT_TRUE(write_whole_file(folder_.file("box_1.pcapng"), "not of this kind"));
  box = start(options());
  EXPECT_EQ(box->report().files, before.size());
  push();
  EXPECT_TRUE(box->finish());
  EXPECT_EQ(box->report().frames, 1U);
  EXPECT_EQ(box->report().files, before.size() + 1);
  EXPECT_THAT(box->report().file, HasSubstr("box_00078_"));
  for (const auto& file : before) EXPECT_TRUE(fs::exists(file)) << file;

  box = start(options());
  for (int i = 0; i < 10'000; ++i) push();
  EXPECT_TRUE(box->finish());
  for (const auto& file : before) EXPECT_FALSE(fs::exists(file)) << file;
  EXPECT_EQ(read_whole_file(folder_.file("box_00077_20260101000000.pcapng")).value_or(""), "of another program");
  EXPECT_TRUE(fs::exists(folder_.file("box_1.pcapng")));
}

TEST_F(BlackBoxFile, AFolderIsANameToo) {
  auto wanted = options();
  wanted.name = folder_.path().string();
  auto box = start(wanted);
  push();
  EXPECT_TRUE(box->finish());
  EXPECT_THAT(files().front(), HasSubstr("/black-box_00001_"));
}

TEST_F(BlackBoxFile, WhatCannotWorkIsSaidBeforeItBegins) {
  auto wanted = options();
  wanted.name = folder_.file("none/box");
  auto box = BlackBox::start(ring_, wanted);
  ASSERT_FALSE(box);
  EXPECT_EQ(box.error().code, ErrorCode::kFileNotWritable);
  EXPECT_EQ(box.error().detail.text(), "No such file or directory");
  wanted = options();
  wanted.keep_free_bytes = UINT64_MAX / 2;
  box = BlackBox::start(ring_, wanted);
  ASSERT_FALSE(box);
  EXPECT_THAT(box.error().detail.text(), HasSubstr("left, a black box needs"));
  EXPECT_FALSE(ring_->is_open());
}

TEST_F(BlackBoxFile, TwoProgramsDoNotShareOne) {
  auto wanted = options();
  wanted.virtual_time = false;
  auto box = start(wanted);
  push();
  // By what is written, not by the clock.
  while (box->report().frames == 0) std::this_thread::yield();
  const auto other = BlackBox::start(std::make_shared<FrameRing>(), options());
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().detail.text(), HasSubstr("another program"));
  EXPECT_TRUE(box->finish());
  EXPECT_TRUE(BlackBox::start(std::make_shared<FrameRing>(), options()));
}

TEST_F(BlackBoxFile, EndsWithAMessageWhenItsFolderIsTakenAway) {
  fs::create_directory(folder_.file("stick"));
  auto wanted = options();
  wanted.name = folder_.file("stick") + "/box";
  auto box = start(wanted);
  for (int i = 0; i < 1'000; ++i) push();
  while (box->report().frames == 0) std::this_thread::yield();
  fs::rename(folder_.file("stick"), folder_.file("gone"));
  while (ring_->is_open()) push();
  const auto status = box->finish();
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kFileNotWritable);
  ASSERT_EQ(stopped_.size(), 1U);
  push();  // the run goes on
  EXPECT_GT(test::packets_in(test::files_in(folder_.file("gone"))).size(), 100U);
}

/// A file that may not grow any more, as on a full disk: it ends with a whole block.
TEST_F(BlackBoxFile, SurvivesADiskThatIsFull) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{40'000, 40'000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    auto box = BlackBox::start(ring_, options());
    if (!box) ::_exit(2);
    for (int i = 0; i < 2'000; ++i) push();
    ::_exit((*box)->finish() ? 3 : 0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  ASSERT_EQ(files().size(), 1U);
  const auto text = *read_whole_file(files().front());
  const auto blocks = test::pcapng_blocks(bytes_of(text));
  EXPECT_EQ(blocks.empty() ? 0 : blocks.back().end, text.size());
}

/// On a small disk of its own, where such a one may be had.
TEST_F(BlackBoxFile, StopsBeforeTheDiskIsFull) {
  const auto disk = folder_.file("disk");
  fs::create_directory(disk);
  if (::mount("none", disk.c_str(), "tmpfs", 0, "size=4m") != 0) GTEST_SKIP() << "this user may not mount";
  auto wanted = options();
  wanted.name = disk + "/box";
  wanted.keep_free_bytes = 2 * kMiB;
  auto box = start(wanted);
  push();
  EXPECT_TRUE(write_whole_file(disk + "/others", std::string(5 * kMiB / 2, 'x')));
  while (ring_->is_open()) push();
  const auto status = box->finish();
  ASSERT_FALSE(status);
  EXPECT_THAT(status.error().detail.text(), HasSubstr("are left on the disk; the black box is whole up to here"));
  EXPECT_EQ(stopped_.size(), 1U);
  EXPECT_GT(test::packets_in({box->report().file}).size(), 0U);
  box.reset();
  ::umount2(disk.c_str(), MNT_DETACH);
}

TEST(BlackBoxReach, FollowsFromTheFramesOfACycle) {
  NetworkConfig config;
  EXPECT_EQ(black_box_reach(config, kMiB), 0);
  config.cyclic.resize(1);
  config.cyclic.front().cycle_time = kMillisecond;
  config.cyclic.front().frames.resize(1);
  // Two blocks of 60 bytes and 44 around them a millisecond.
  EXPECT_NEAR(static_cast<double>(black_box_reach(config, kMiB)), 1e6 * kMiB / 208, 1e6);
}

}  // namespace
}  // namespace syncline
