// SPDX-License-Identifier: Apache-2.0
#include "master/sii/sii_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "link/fault_link.h"
#include "master/exchange/slave_address.h"
#include "master/sii/sii_work.h"
#include "protocol/sii.h"
#include "sim/device/sii_from_device.h"
#include "support/random.h"
#include "tests/support/scan_bed.h"

namespace syncline {
namespace {

using testing::HasSubstr;

class SiiWriterTest : public ::testing::Test {
 protected:
  test::SimulatedNetwork network = test::different_slaves(4);
  VirtualClock clock;
  std::unique_ptr<FaultLink> link;
  std::unique_ptr<FrameExchange> exchange;
  std::atomic<bool> cancel{false};
  std::unique_ptr<Bus> bus;
  SlaveAddress slave = SlaveAddress::at_position(2);

  void SetUp() override {
    link = std::make_unique<FaultLink>(network.link(clock), clock, LinkFaults{});
    exchange = std::make_unique<FrameExchange>(*link, clock);
    bus = std::make_unique<Bus>(*exchange, clock, &cancel);
  }
  std::vector<std::uint8_t> content() {
    cancel = false;
    const auto bytes = read_eeprom(*bus, slave);
    EXPECT_TRUE(bytes);
    return bytes ? *bytes : std::vector<std::uint8_t>{};
  }
};

TEST_F(SiiWriterTest, ReadsTheWholeEeprom) {
  const auto& config = network.sim.slaves[2];
  EXPECT_EQ(content(), sii::encode(sim::sii_from_device(config.device, config.alias, config.serial_no)));
}

TEST_F(SiiWriterTest, WritesWhatIsDifferentAndReadsItBack) {
  auto image = content();
  image[0x20 * 2] ^= 0xFF;
  image[200] ^= 0x0F;
  const auto report = write_eeprom(*bus, slave, image);
  ASSERT_TRUE(report) << report.error().detail.text();
  EXPECT_EQ(*report, (SiiWriteReport{image.size() / 2, 2}));
  EXPECT_EQ(content(), image);
}

TEST_F(SiiWriterTest, SurvivesABadLine) {
  auto image = content();
  for (std::size_t i = 0x80; i < 0xC0; ++i) image[i] ^= 0xA5;
  link->set_faults({.lose_request = 0.02, .lose_reply = 0.02, .duplicate = 0.05, .late = 0.01, .seed = 4});
  const auto report = write_eeprom(*bus, slave, image);
  ASSERT_TRUE(report) << report.error().detail.text();
  EXPECT_EQ(content(), image);
  EXPECT_GT(link->injected().lost, 0U);
}

TEST_F(SiiWriterTest, TheAliasKeepsTheChecksumRight) {
  const auto report = write_alias(*bus, slave, 4711);
  ASSERT_TRUE(report);
  const auto image = sii::decode(content());
  ASSERT_TRUE(image);
  EXPECT_EQ(image->alias, 4711);
  EXPECT_TRUE(image->checksum_ok);
}

TEST_F(SiiWriterTest, AnInterruptedWriteIsTakenBack) {
  const auto before = content();
  auto image = before;
  for (std::size_t i = 0x80; i < 0x100; ++i) image[i] ^= 0xA5;
  const auto report = write_eeprom(*bus, slave, image, [&](std::size_t done, std::size_t) { cancel = done == 20; });
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, ErrorCode::kCancelled);
  EXPECT_EQ(content(), before);
}

/// Also while the EEPROM is storing a word, which takes it some milliseconds in which it hears nothing.
TEST_F(SiiWriterTest, AtWhateverMomentItIsCancelledTheContentIsTheOldOrTheNewOne) {
  network.sim.slaves[2].sii.write_time = 3 * kMillisecond;
  SetUp();
  const auto before = content();
  auto image = before;
  for (std::size_t i = 0x80; i < 0xA0; ++i) image[i] ^= 0xA5;
  Random random(7);
  Nanoseconds end = 0;
  bus->set_interrupt([&] { return end != 0 && clock.now() >= end; });
  int taken_back = 0, written = 0;
  for (int i = 0; i < 100; ++i) {
    end = clock.now() + static_cast<Nanoseconds>(random.next() % (200 * kMillisecond));
    const auto report = write_eeprom(*bus, slave, image);
    end = 0;
    const auto now = content();
    ASSERT_TRUE(now == before || now == image) << "round " << i;
    EXPECT_EQ(now == image, report.has_value()) << "round " << i;
    (report ? written : taken_back) += 1;
    if (report) {
      ASSERT_TRUE(write_eeprom(*bus, slave, before));
    }
  }
  EXPECT_GT(taken_back, 20);
  EXPECT_GT(written, 5);
}

TEST_F(SiiWriterTest, WhatWillBeWrittenIsTellableBeforeTheFirstWord) {
  const auto before = content();
  auto image = before;
  image[0x90] ^= 0xFF;
  std::vector<std::uint8_t> told_before, told_after;
  const auto refuse = [&](std::span<const std::uint8_t> was, std::span<const std::uint8_t> will) {
    told_before.assign(was.begin(), was.end());
    told_after.assign(will.begin(), will.end());
    return Status(fail(ErrorCode::kFileNotWritable));
  };
  EXPECT_EQ(write_eeprom(*bus, slave, image, {}, refuse).error().code, ErrorCode::kFileNotWritable);
  EXPECT_EQ(told_before, before);
  EXPECT_EQ(told_after, image);
  EXPECT_EQ(content(), before);
}

/// Nobody answers any more: nothing is asked for again.
TEST_F(SiiWriterTest, WhatIsGivenUpIsOver) {
  SiiWork work;
  std::vector<std::uint8_t> into;
  work.read(slave, 0, 64, into);
  ASSERT_NE(work.next(clock.now()), nullptr);
  work.give_up({.code = ErrorCode::kNoResponse});
  EXPECT_TRUE(work.over());
  EXPECT_EQ(work.next(clock.now()), nullptr);
  ASSERT_FALSE(work.result());
  EXPECT_EQ(work.result().error().code, ErrorCode::kNoResponse);
}

TEST_F(SiiWriterTest, AWordThatCannotBeStoredTakesTheOthersBack) {
  const auto before = content();
  auto image = before;
  image[0x90] ^= 0xFF;
  image.resize(before.size() + 4, 0x12);  // words that this EEPROM has not
  store_le(std::span(image).subspan(2 * 0x3E), static_cast<std::uint16_t>(image.size() / 128));
  const auto report = write_eeprom(*bus, slave, image);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, ErrorCode::kSii);
  EXPECT_THAT(report.error().detail.text(), HasSubstr("the old content was put back"));
  EXPECT_EQ(content(), before);
}

TEST_F(SiiWriterTest, RefusesImagesThatWouldBreakTheSlave) {
  auto image = content();
  image[14] ^= 1;
  EXPECT_EQ(write_eeprom(*bus, slave, image).error().code, ErrorCode::kBadValue);
  image.resize(0x40);
  EXPECT_EQ(write_eeprom(*bus, slave, image).error().code, ErrorCode::kBadValue);
  image.resize(0x201);
  EXPECT_EQ(write_eeprom(*bus, slave, image).error().code, ErrorCode::kBadValue);
}

}  // namespace
}  // namespace syncline
