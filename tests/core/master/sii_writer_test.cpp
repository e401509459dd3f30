// SPDX-License-Identifier: Apache-2.0
#include "master/sii_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "link/fault_link.h"
#include "protocol/sii.h"
#include "sim/sii_from_device.h"
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
  ASSERT_TRUE(report) << report.error().detail;
  EXPECT_EQ(*report, (SiiWriteReport{image.size() / 2, 2}));
  EXPECT_EQ(content(), image);
}

TEST_F(SiiWriterTest, SurvivesABadLine) {
  auto image = content();
  for (std::size_t i = 0x80; i < 0xC0; ++i) image[i] ^= 0xA5;
  link->set_faults({.lose_request = 0.02, .lose_reply = 0.02, .duplicate = 0.05, .late = 0.01, .seed = 4});
  const auto report = write_eeprom(*bus, slave, image);
  ASSERT_TRUE(report) << report.error().detail;
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

TEST_F(SiiWriterTest, AWordThatCannotBeStoredTakesTheOthersBack) {
  const auto before = content();
  auto image = before;
  image[0x90] ^= 0xFF;
  image.resize(before.size() + 4, 0x12);  // words that this EEPROM has not
  store_le(std::span(image).subspan(2 * 0x3E), static_cast<std::uint16_t>(image.size() / 128));
  const auto report = write_eeprom(*bus, slave, image);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, ErrorCode::kSii);
  EXPECT_THAT(report.error().detail, HasSubstr("the old content was put back"));
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
