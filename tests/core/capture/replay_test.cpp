// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "capture/capture_tap.h"
#include "capture/pcap_reader.h"
#include "capture/pcapng_writer.h"
#include "capture/recorded_bus.h"
#include "capture/replay_link.h"
#include "link/link.h"
#include "protocol/frame.h"
#include "protocol/registers.h"
#include "support/byte_order.h"
#include "support/clock.h"
#include "support/random.h"
#include "support/sample_folder.h"
#include "tests/support/source_dir.h"

namespace syncline {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::uint8_t, 6> kBroadcast{0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF};
constexpr std::array<std::uint8_t, 6> kMaster{0x10, 0x20, 0x30, 0x40, 0x50, 0x60};

/// Writes a capture as a master with its bus would have left it: each datagram sent and come back.
class CaptureFile {
 public:
  explicit CaptureFile(const std::string& name)
      : path_((fs::temp_directory_path() / (name + std::to_string(::getpid()) + ".pcapng")).string()) {
    auto writer = PcapngWriter::create(path_);
    EXPECT_TRUE(writer);
    writer_.emplace(std::move(*writer));
  }
  ~CaptureFile() { fs::remove(path_); }
  CaptureFile(const CaptureFile&) = delete;
  CaptureFile& operator=(const CaptureFile&) = delete;

  void exchange(Command command, std::uint16_t adp, std::uint16_t ado, std::vector<std::uint8_t> sent,
                const std::vector<std::uint8_t>& returned, std::uint16_t wkc) {
    FrameBuilder builder;
    builder.set_addresses(kBroadcast, kMaster);
    ASSERT_TRUE(builder.add(command, index_++, device_address(adp, ado), sent));
    const auto frame = builder.finish();
    writer_->write(frame, ++time_, PcapngWriter::Direction::kSent);
    std::vector<std::uint8_t> back(frame.begin(), frame.end());
    back[6] |= 0x02;
    FrameReader reader(back);
    auto datagram = reader.next();
    std::ranges::copy(returned, datagram->data.begin());
    datagram->set_wkc(wkc);
    if (is_auto_increment(command) || is_broadcast(command)) {
      datagram->header.address = device_address(static_cast<std::uint16_t>(adp + 2), ado);
      datagram->store_header();
    }
    writer_->write(back, ++time_, PcapngWriter::Direction::kReceived);
  }
  const std::string& finish() {
    EXPECT_TRUE(writer_->finish());
    return path_;
  }

 private:
  std::string path_;
  std::optional<PcapngWriter> writer_;
  std::uint8_t index_ = 0;
  Nanoseconds time_ = 1'000;
};

/// A capture of a bus of two: addresses, a register and a few words of one EEPROM.
const std::string& small_capture(CaptureFile& file) {
  file.exchange(Command::kBrd, 0, reg::kType, {0}, {0x15}, 2);
  file.exchange(Command::kApwr, 0, reg::kStationAddress, {0x01, 0x10}, {0x01, 0x10}, 1);
  file.exchange(Command::kApwr, 0xFFFF, reg::kStationAddress, {0x02, 0x10}, {0x02, 0x10}, 1);
  file.exchange(Command::kFprd, 0x1002, reg::kDlStatus, {0, 0}, {0x11, 0x56}, 1);
  file.exchange(Command::kFprd, 0x1002, reg::kDlStatus, {0, 0}, {0x31, 0x5A}, 1);  // later: not what a scan saw
  file.exchange(Command::kFprd, 0x1001, reg::kSystemTime, {0, 0, 0, 0}, {1, 2, 3, 4}, 0);
  file.exchange(Command::kFpwr, 0x1001, reg::kSiiControl, {0, 1, 8, 0, 0, 0}, {0, 1, 8, 0, 0, 0}, 1);
  file.exchange(Command::kFprd, 0x1001, reg::kSiiControl, {0, 0}, {0x00, 0x80}, 1);     // busy
  file.exchange(Command::kFprd, 0x1001, reg::kSiiData, {0, 0, 0, 0}, {9, 9, 9, 9}, 1);  // too early: no word
  file.exchange(Command::kFprd, 0x1001, reg::kSiiControl, {0, 0}, {0x00, 0x00}, 1);
  file.exchange(Command::kFprd, 0x1001, reg::kSiiData, {0, 0, 0, 0}, {0x17, 0x5C, 0, 0}, 1);
  return file.finish();
}

struct Answer {
  std::uint16_t wkc = 0;
  std::vector<std::uint8_t> data;
};

Answer ask(Link& link, Command command, std::uint16_t adp, std::uint16_t ado, const std::vector<std::uint8_t>& data) {
  FrameBuilder builder;
  builder.set_addresses(kBroadcast, link.describe().mac);
  (void)builder.add(command, 1, device_address(adp, ado), data);
  EXPECT_TRUE(link.send(builder.finish()));
  std::array<std::uint8_t, 1514> buffer{};
  const auto received = link.receive(buffer, 0);
  if (!received || received->length == 0) return {};
  FrameReader reader{std::span(buffer).first(received->length)};
  const auto datagram = reader.next();
  return {datagram->wkc(), {datagram->data.begin(), datagram->data.end()}};
}

TEST(ReplayLink, AnswersWhatTheCaptureHoldsAndNothingElse) {
  CaptureFile file("syncline-replay-");
  VirtualClock clock;
  auto link = make_replay_link(small_capture(file), clock);
  ASSERT_TRUE(link) << link.error().detail.text();
  EXPECT_EQ(ask(**link, Command::kApwr, 0, reg::kStationAddress, {0xE9, 0x03}).wkc, 1);
  EXPECT_EQ(ask(**link, Command::kApwr, 0xFFFF, reg::kStationAddress, {0xEA, 0x03}).wkc, 1);
  EXPECT_EQ(ask(**link, Command::kBwr, 0, reg::kDlControl + 3, {0}).wkc, 2);
  // By our own addresses, not by those of the capture's master.
  EXPECT_EQ(ask(**link, Command::kFprd, 0x1002, reg::kDlStatus, {0, 0}).wkc, 0);
  const auto status = ask(**link, Command::kFprd, 1002, reg::kDlStatus, {0, 0});
  EXPECT_EQ(status.wkc, 1);
  EXPECT_EQ(status.data, (std::vector<std::uint8_t>{0x11, 0x56}));
  EXPECT_EQ(ask(**link, Command::kFprd, 1001, reg::kSystemTime, {0, 0, 0, 0}).wkc, 0) << "nobody answered then";
  EXPECT_EQ(ask(**link, Command::kFpwr, 1001, reg::kSystemTime, {0, 0, 0, 0}).wkc, 0);
}

TEST(ReplayLink, EepromIsReadAsFarAsTheCaptureGoes) {
  CaptureFile file("syncline-replay-sii-");
  VirtualClock clock;
  auto link = make_replay_link(small_capture(file), clock);
  ASSERT_TRUE(link);
  EXPECT_EQ(ask(**link, Command::kApwr, 0, reg::kStationAddress, {0xE9, 0x03}).wkc, 1);
  EXPECT_EQ(ask(**link, Command::kFpwr, 1001, reg::kSiiControl, {0, 1, 8, 0, 0, 0}).wkc, 1);
  auto answer = ask(**link, Command::kFprd, 1001, reg::kSiiControl, std::vector<std::uint8_t>(10));
  EXPECT_EQ(load_le<std::uint16_t>(answer.data), 0);
  EXPECT_EQ(load_le<std::uint32_t>(std::span(answer.data).subspan(6)), 0x5C17U);
  EXPECT_EQ(ask(**link, Command::kFpwr, 1001, reg::kSiiControl, {0, 1, 0x40, 0, 0, 0}).wkc, 1);
  answer = ask(**link, Command::kFprd, 1001, reg::kSiiControl, {0, 0});
  EXPECT_EQ(load_le<std::uint16_t>(answer.data), 0x2000) << "a word nobody read has no value";
}

TEST(ReplayLink, FilesThatAreNoCaptureAreRefused) {
  VirtualClock clock;
  auto link = make_replay_link("/nowhere/there.pcapng", clock);
  ASSERT_FALSE(link);
  EXPECT_EQ(link.error().code, ErrorCode::kFileNotFound);
  link = make_replay_link(test::source_dir() + "/README.md", clock);
  ASSERT_FALSE(link);
  EXPECT_EQ(link.error().code, ErrorCode::kNotThatKindOfFile);
  CaptureFile empty("syncline-replay-empty-");
  link = make_replay_link(empty.finish(), clock);
  ASSERT_FALSE(link);
  EXPECT_EQ(link.error().code, ErrorCode::kNotThatKindOfFile);
}

TEST(PcapReader, DamagedCapturesEndWithAnErrorAndNeverElse) {
  CaptureFile file("syncline-replay-damaged-");
  std::ifstream in(small_capture(file), std::ios::binary);
  const std::vector<char> text{std::istreambuf_iterator<char>(in), {}};
  std::vector<std::uint8_t> good(text.begin(), text.end());
  Random random(7);
  for (int round = 0; round < 3'000; ++round) {
    auto bytes = good;
    for (int i = 0; i < 4; ++i) bytes[random.next() % bytes.size()] = static_cast<std::uint8_t>(random.next());
    bytes.resize(1 + random.next() % bytes.size());
    auto reader = PcapReader::from_memory(bytes, "damaged");
    if (!reader) continue;
    BusRecorder recorder;
    std::size_t frames = 0;
    for (auto frame = reader->next(); frame && *frame; frame = reader->next()) {
      recorder.add((*frame)->bytes);
      ++frames;
    }
    EXPECT_LE(recorder.slaves().size(), 4096U);
    EXPECT_LE(frames, bytes.size() / 28) << "more frames than the file has room for";
  }
}

TEST(PcapReader, TimeStampThatNoClockCanShowIsAnError) {
  CaptureFile file("syncline-replay-time-");
  std::ifstream in(small_capture(file), std::ios::binary);
  const std::vector<char> text{std::istreambuf_iterator<char>(in), {}};
  std::vector<std::uint8_t> bytes(text.begin(), text.end());
  constexpr std::array<std::uint8_t, 4> kEnhancedPacket{6, 0, 0, 0};
  // Not std::ranges::search: clang 14 cannot compile what libstdc++ 12 makes of it.
  const auto block =
      std::search(bytes.begin(), bytes.end(), kEnhancedPacket.begin(), kEnhancedPacket.end()) - bytes.begin();
  ASSERT_LT(block + 16, std::ssize(bytes));
  store_le(std::span(bytes).subspan(static_cast<std::size_t>(block) + 12, 4), std::uint32_t{0xFFFFFFFF});  // upper half
  auto reader = PcapReader::from_memory(bytes, "late.pcapng");
  ASSERT_TRUE(reader);
  const auto frame = reader->next();
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().file, "late.pcapng");
}

/// Every frame of every capture decodes, and what is in it makes sense.
TEST(Captures, EveryEtherCatFrameDecodes) {
  int files = 0;
  std::size_t frames = 0, datagrams = 0;
  for (const auto& path : test::all_samples("pcap", ".pcapng")) {
    ++files;
    auto reader = PcapReader::open(path.string());
    ASSERT_TRUE(reader) << path;
    for (;;) {
      auto frame = reader->next();
      ASSERT_TRUE(frame) << path << ": " << frame.error().detail.text();
      if (!*frame) break;
      FrameReader decoded((*frame)->bytes);
      if (!decoded.is_ethercat()) continue;
      ++frames;
      while (const auto datagram = decoded.next()) {
        ++datagrams;
        EXPECT_LE(static_cast<int>(datagram->header.command), kLastCommand);
      }
      EXPECT_FALSE(decoded.malformed()) << path << " frame at " << (*frame)->time;
    }
  }
  EXPECT_GT(files, 0);
  EXPECT_GT(frames, test::sample_folder() ? 1'000U : 100U);
  EXPECT_GE(datagrams, frames);
}

/// A broadcast that claims thousands of slaves, seven times over the whole memory of an ESC: some 20 KB of frames.
TEST(BusRecorder, WhatIsWrittenToAllIsKeptOnceForAll) {
  constexpr std::uint16_t kClaimed = 4096;
  BusRecorder recorder;
  for (std::uint16_t i = 0; i < 7; ++i) {
    FrameBuilder builder;
    builder.set_addresses(kBroadcast, kMaster);
    const std::vector<std::uint8_t> data(1400, 0x11);
    ASSERT_TRUE(builder.add(Command::kBwr, static_cast<std::uint8_t>(i),
                            device_address(0, static_cast<std::uint16_t>(0x1000 + 1400 * i)), data));
    const auto frame = builder.finish();
    std::vector<std::uint8_t> sent(frame.begin(), frame.end()), back = sent;
    back[6] |= 0x02;
    FrameReader reader(back);
    reader.next()->set_wkc(kClaimed);
    recorder.add(sent);
    recorder.add(back);
  }
  const auto slaves = recorder.slaves();
  ASSERT_EQ(slaves.size(), kClaimed);
  std::size_t bytes = 0;
  for (const auto& slave : slaves) bytes += slave.memory.size();
  EXPECT_EQ(bytes, 0U);
  EXPECT_TRUE(slaves.back().knows(0x1000, 7 * 1400));
  EXPECT_FALSE(slaves.back().knows(0x0FFF, 2));
}

/// Also a slave of which nothing was known yet has heard the broadcast.
TEST(BusRecorder, EepromAddressSetByBroadcastIsThatOfEverySlave) {
  CaptureFile file("syncline-replay-sii-all-");
  file.exchange(Command::kBwr, 0, reg::kSiiControl, {0, 1, 8, 0, 0, 0}, {0, 1, 8, 0, 0, 0}, 1);
  file.exchange(Command::kAprd, 0xFFFF, reg::kSiiData, {0, 0, 0, 0}, {0x17, 0x5C, 0x22, 0x33}, 1);
  auto reader = PcapReader::open(file.finish());
  ASSERT_TRUE(reader);
  BusRecorder recorder;
  for (auto frame = reader->next(); frame && *frame; frame = reader->next()) recorder.add((*frame)->bytes);
  const auto slaves = recorder.slaves();
  ASSERT_EQ(slaves.size(), 2U);
  EXPECT_EQ(slaves[1].sii, (std::map<std::uint32_t, std::uint16_t>{{8, 0x5C17}, {9, 0x3322}}));
}

std::vector<std::uint8_t> bytes_of_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void exchange_state(CaptureFile& file) {
  file.exchange(Command::kBrd, 0, reg::kType, {0, 0}, {0x11, 0}, 2);
  file.exchange(Command::kAprd, 0, reg::kAlStatus, {0, 0}, {0x01, 0}, 1);
}

TEST(Replay, AFileThatBreaksOffIsUsedAsFarAsItGoesAndThatIsTold) {
  CaptureFile file("syncline-broken-");
  exchange_state(file);
  exchange_state(file);
  const auto path = file.finish();
  fs::resize_file(path, fs::file_size(path) - 30);
  VirtualClock clock;
  ReplayNotes notes;
  ASSERT_TRUE(make_replay_link(path, clock, &notes));
  ASSERT_TRUE(notes.broken_off);
  EXPECT_EQ(notes.broken_off->file, path);
  ASSERT_EQ(notes.slaves.size(), 2U);
  EXPECT_TRUE(notes.slaves[0].state);
  EXPECT_FALSE(notes.slaves[1].state) << "nobody has read it";
  EXPECT_FALSE(notes.slaves[0].vendor_id);
}

TEST(Replay, FramesThatAreThereInPartOnlyAreCounted) {
  CaptureFile file("syncline-cut-");
  exchange_state(file);
  exchange_state(file);
  const auto path = file.finish();
  auto bytes = bytes_of_file(path);
  // The original length of the last packet, 4 bytes behind the captured one in its block (block of 28 + frame +
  // options).
  std::size_t block = 28 + 32, last = block;
  while (block + 12 <= bytes.size()) {
    last = block;
    block += load_le<std::uint32_t>(std::span(bytes).subspan(block + 4));
  }
  store_le(std::span(bytes).subspan(last + 24), std::uint32_t{1500});
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  VirtualClock clock;
  ReplayNotes notes;
  ASSERT_TRUE(make_replay_link(path, clock, &notes));
  EXPECT_EQ(notes.cut_frames, 1U);
  EXPECT_EQ(notes.frames, 8U);
}

}  // namespace
}  // namespace syncline
