// SPDX-License-Identifier: Apache-2.0
#include "capture/import_capture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "link/link.h"
#include "protocol/datagram.h"
#include "protocol/frame.h"
#include "protocol/registers.h"
#include "record/import_run.h"
#include "record/replay_run.h"
#include "support/whole_file.h"
#include "tests/support/plain_capture.h"
#include "tests/support/temporary_folder.h"
#include "trace/untold.h"

namespace syncline {
namespace {

using test::answered, test::cyclic_frame, test::kCaptureBegin, test::PlainCapture;

std::vector<std::uint8_t> stamped(std::vector<std::uint8_t> frame, std::uint64_t stamp) {
  const std::array<std::uint8_t, 8> head{0x01, 0x01, 0x05, 0x10, 0x00, 0x00, 0x80, 0x20};
  frame.insert(frame.end(), head.begin(), head.end());
  for (int i = 0; i < 8; ++i) frame.push_back(static_cast<std::uint8_t>(stamp >> (8 * i)));
  return frame;
}

std::string codes_of(const ImportedRun& run) {
  std::string codes;
  for (const auto& finding : run.findings) codes += std::string(codes.empty() ? "" : " ") + std::string(finding.code);
  return codes;
}

TEST(ImportCapture, TellsWhatItsFramesHold) {
  const test::TemporaryFolder folder;
  PlainCapture file;
  for (int i = 0; i < 100; ++i) {
    const auto sent = kCaptureBegin + i * 500 * kMicrosecond;
    const std::uint16_t station = i % 2 == 0 ? 1002 : 1003;
    // Once in a while the reference clock itself is read.
    const auto frame = cyclic_frame(static_cast<std::uint8_t>(i), i % 10 == 5 ? 1001 : station);
    file.add(sent, frame);
    if (i == 40) continue;  // it is lost
    file.add(sent + 28'000, answered(frame, static_cast<std::uint64_t>(sent + 77), i % 2 == 0 ? -12 : 300));
  }
  const auto run = import_capture(file.write(folder));
  ASSERT_TRUE(run.has_value()) << run.error().detail.text();
  EXPECT_EQ(run->about.limits.cycle_time, 500 * kMicrosecond);
  ASSERT_EQ(run->samples.size(), 100U);
  ASSERT_EQ(run->about.slaves.size(), 2U);
  EXPECT_EQ(run->about.slaves[1].name, "Station 1003");
  const auto& one = run->samples[10];
  EXPECT_EQ(one.cycle, 10U);
  EXPECT_EQ(one.send_time, kCaptureBegin + 5 * kMillisecond);
  EXPECT_EQ(one.round_trip_ns, 28'000);
  EXPECT_EQ(one.reference_time, one.send_time + 77);
  EXPECT_EQ(one.wkc_received, 6);
  EXPECT_EQ(one.slave_position, 0);
  EXPECT_EQ(one.slave_deviation_ns, -12);
  EXPECT_EQ(one.deviation_ns, 300U) << "the largest of the latest readings";
  EXPECT_NE(run->samples[40].flags & CycleSample::kFrameLost, 0);
  EXPECT_EQ(run->samples[40].frames_lost, 1);
  EXPECT_EQ(codes_of(*run), "import-times");
  EXPECT_NE(facts_text(run->findings.front()).find("software stamps"), std::string::npos);
  const auto replay = replayed(*run);
  for (const auto signal : {Signal::kLateness, Signal::kDcmError, Signal::kDrift, Signal::kDeviationOred})
    EXPECT_FALSE(replay.record->samples().series(signal).extent(0, INT64_MAX)) << info(signal).key;
  EXPECT_FALSE(replay.record->samples().value(Signal::kWkcExpected, one.send_time));
  EXPECT_EQ(replay.record->samples().value(Signal::kWkcReceived, one.send_time)->value, 6);
  EXPECT_EQ(replay.record->overview().deviation.statistics.count(), 99U) << "one is lost";
}

/// The host's times of the file are worth nothing beside those of the probe.
TEST(ImportCapture, TakesTheStampsOfAProbe) {
  const test::TemporaryFolder folder;
  PlainCapture file;
  std::uint64_t probe = 5'000'000;
  for (int i = 0; i < 50; ++i) {
    const auto host = kCaptureBegin + i * kMillisecond + (i % 7) * 100'000;
    const auto frame = cyclic_frame(static_cast<std::uint8_t>(i), 1002);
    file.add(host, stamped(frame, probe));
    file.add(host + 900'000, stamped(answered(frame, 1'000'000 + probe, 5), probe + 12'345));
    probe += 1'000'000;
  }
  const auto run = import_capture(file.write(folder));
  ASSERT_TRUE(run.has_value()) << run.error().detail.text();
  ASSERT_EQ(run->samples.size(), 50U);
  EXPECT_NE(facts_text(run->findings.front()).find("hardware stamps"), std::string::npos);
  for (std::size_t i = 0; i < run->samples.size(); ++i) {
    EXPECT_EQ(run->samples[i].send_time, kCaptureBegin + static_cast<Nanoseconds>(i) * kMillisecond);
    EXPECT_EQ(run->samples[i].round_trip_ns, 12'345);
  }
}

/// A probe on the way back alone: what came is known, not for how long it was under way, nor what is lost.
TEST(ImportCapture, OneWayIsNoRoundTrip) {
  const test::TemporaryFolder folder;
  PlainCapture file;
  for (int i = 0; i < 20; ++i) {
    const auto time = kCaptureBegin + i * kMillisecond;
    file.add(time, answered(cyclic_frame(static_cast<std::uint8_t>(i), 1002), static_cast<std::uint64_t>(time), 5));
  }
  const auto run = import_capture(file.write(folder));
  ASSERT_TRUE(run.has_value()) << run.error().detail.text();
  ASSERT_EQ(run->samples.size(), 20U);
  EXPECT_EQ(run->samples[3].reference_time, run->samples[3].send_time);
  EXPECT_FALSE(info(Signal::kRoundTrip).of_cycle(run->samples[3]));
  EXPECT_FALSE(info(Signal::kFramesLost).of_cycle(run->samples[3]));
  EXPECT_EQ(codes_of(*run), "import-times import-replies-missing");
}

/// A mirror port that cannot carry both ways leaves replies out: the capture alone does not tell that from lost frames.
TEST(ImportCapture, SaysHowManyRepliesAreMissing) {
  const test::TemporaryFolder folder;
  PlainCapture file;
  for (int i = 0; i < 60; ++i) {
    const auto sent = kCaptureBegin + i * kMillisecond;
    const auto frame = cyclic_frame(static_cast<std::uint8_t>(i), 1002);
    file.add(sent, frame);
    if (i % 10 != 5) file.add(sent + 28'000, answered(frame, static_cast<std::uint64_t>(sent), 5));
  }
  const auto run = import_capture(file.write(folder));
  ASSERT_TRUE(run.has_value()) << run.error().detail.text();
  EXPECT_EQ(codes_of(*run), "import-times import-replies-missing");
  EXPECT_NE(facts_text(run->findings.back()).find("6 cyclic frames have no reply in the capture, of 60"),
            std::string::npos)
      << facts_text(run->findings.back());
}

/// Through a switch or in a virtual machine times are not those of the wire: what proves it is named.
TEST(ImportCapture, WarnsOfSwitchesAndVirtualMachines) {
  const auto with = [](const auto& change, const std::string& codes, const std::string& words) {
    const test::TemporaryFolder folder;
    PlainCapture file;
    for (int i = 0; i < 20; ++i) {
      const auto sent = kCaptureBegin + i * kMillisecond;
      auto frame = cyclic_frame(static_cast<std::uint8_t>(i), 1002);
      change(file, sent, frame);
      file.add(sent + 28'000, answered(frame, static_cast<std::uint64_t>(sent), 5));
    }
    const auto run = import_capture(file.write(folder));
    ASSERT_TRUE(run.has_value()) << run.error().detail.text();
    EXPECT_EQ(codes_of(*run), codes);
    EXPECT_EQ(run->samples.size(), 20U) << codes;
    EXPECT_NE(facts_text(run->findings.back()).find(words), std::string::npos) << facts_text(run->findings.back());
  };
  using Frame = std::vector<std::uint8_t>;
  with(
      [](PlainCapture& file, Nanoseconds time, const Frame& frame) {
        Frame tree(60, 0);
        const std::array<std::uint8_t, 6> bridges{0x01, 0x80, 0xC2, 0x00, 0x00, 0x00};
        std::ranges::copy(bridges, tree.begin());
        file.add(time - 1000, tree);
        file.add(time, frame);
      },
      "import-times import-switch", "20 frames are of a switch itself");
  with(
      [](PlainCapture& file, Nanoseconds time, Frame& frame) {
        const std::array<std::uint8_t, 4> tag{0x81, 0x00, 0x00, 0x05};
        frame.insert(frame.begin() + 12, tag.begin(), tag.end());
        file.add(time, frame);
      },
      "import-times import-switch", "40 EtherCAT frames have a VLAN tag");
  with(
      [](PlainCapture& file, Nanoseconds time, const Frame& frame) {
        file.add(time, frame);
        if (time == kCaptureBegin + 7 * kMillisecond) file.add(time + 1000, frame);
      },
      "import-times import-switch", "1 EtherCAT frame came twice");
  with(
      [](PlainCapture& file, Nanoseconds time, Frame& frame) {
        const std::array<std::uint8_t, 6> adapter{0x00, 0x0C, 0x29, 0x12, 0x34, 0x56};
        std::ranges::copy(adapter, frame.begin() + 6);
        file.add(time, frame);
      },
      "import-times import-virtual-machine", "sent by 00:0c:29:12:34:56, the adapter of a virtual machine");
  with([](PlainCapture& file, Nanoseconds time, const Frame& frame) { file.add(time, frame); }, "import-times",
       "software stamps");
}

TEST(ImportCapture, SaysWhatIsMissing) {
  const test::TemporaryFolder folder;
  PlainCapture file;
  for (int i = 0; i < 20; ++i)
    file.add(kCaptureBegin + i * kMillisecond, cyclic_frame(static_cast<std::uint8_t>(i), 1002));
  const auto sent_only = import_capture(file.write(folder));
  ASSERT_FALSE(sent_only.has_value());
  EXPECT_EQ(sent_only.error().code, ErrorCode::kBadValue);
  EXPECT_TRUE(write_whole_file(folder.file("text"), std::string_view("no capture")).has_value());
  const auto text = import_capture(folder.file("text"));
  ASSERT_FALSE(text.has_value());
  EXPECT_EQ(text.error().code, ErrorCode::kNotThatKindOfFile);
  EXPECT_EQ(import_capture(folder.file("none")).error().code, ErrorCode::kFileNotFound);
}

TEST(ImportCapture, SaysHowFarItIsAndEndsWhenItIsNotWanted) {
  const test::TemporaryFolder folder;
  PlainCapture file;
  for (int i = 0; i < 10'000; ++i) {
    const auto sent = kCaptureBegin + i * 500 * kMicrosecond;
    const auto frame = cyclic_frame(static_cast<std::uint8_t>(i), 1002);
    file.add(sent, frame);
    file.add(sent + 28'000, answered(frame, static_cast<std::uint64_t>(sent + 77), -12));
  }
  const auto path = file.write(folder);
  std::vector<std::uint64_t> told;
  std::uint64_t all = 0;
  const auto run = import_capture(path, {}, [&](std::uint64_t done, std::uint64_t of) {
    told.push_back(done);
    all = of;
    return true;
  });
  ASSERT_TRUE(run);
  ASSERT_GE(told.size(), 4U);
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_GT(told.back(), all / 2);
  EXPECT_LE(told.back(), all);
  const auto ended = import_capture(path, {}, [](std::uint64_t, std::uint64_t) { return false; });
  ASSERT_FALSE(ended);
  EXPECT_EQ(ended.error().code, ErrorCode::kCancelled);
}

}  // namespace
}  // namespace syncline
