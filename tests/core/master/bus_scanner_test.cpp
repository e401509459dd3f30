// SPDX-License-Identifier: Apache-2.0
#include "master/scan/bus_scanner.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "config/device_description.h"
#include "config/device_from_sii.h"
#include "config/sync_manager_type.h"
#include "master/exchange/bus.h"
#include "master/master_service.h"
#include "protocol/sii.h"
#include "tests/support/sample_image.h"
#include "tests/support/simulated_segment.h"

namespace syncline {
namespace {

/// A line of terminals with these EEPROMs.
SimConfig segment_of(const std::vector<sii::Image>& images) {
  auto config = test::terminals(images.size());
  for (std::size_t i = 0; i < images.size(); ++i) config.slaves[i].sii_image = sii::encode(images[i]);
  return config;
}

/// Three of them, scanned by a bus of its own for each configuration.
class BusScannerTest : public ::testing::Test {
 protected:
  VirtualClock clock;
  SimConfig config = segment_of({sample::drive_image(100), sample::drive_image(101), sample::drive_image(102)});
  std::unique_ptr<test::SimulatedSegment> link;

  Result<BusScan> scan(const ScanOptions& options = {}, const ScanObserver& observer = {}) {
    if (!link) open();
    FrameExchange exchange(*link, clock);
    Bus bus(exchange, clock);
    return scan_slaves(bus, options, observer);
  }
  void open() { link = std::make_unique<test::SimulatedSegment>(clock, config); }
  void expect_all_read(const Result<BusScan>& scan) const {
    ASSERT_TRUE(scan);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(scan->slaves[i].sii, sii::decode(config.slaves[i].sii_image).value()) << i;
    }
  }
};

TEST_F(BusScannerTest, FindsWhoIsThere) {
  config.slaves[1].esc_type = config.slaves[2].esc_type = 0x04;
  config.slaves[1].dc.is_64bit = false;
  config.slaves[2].dc.system_time = false;
  config.slaves[1].alias = 77;
  std::vector<std::pair<std::size_t, std::size_t>> progress;
  const auto found =
      scan({}, {.progress = [&](std::size_t done, std::size_t all) { progress.emplace_back(done, all); }});
  ASSERT_TRUE(found);
  ASSERT_EQ(found->slaves.size(), 3U);
  EXPECT_EQ(found->slaves[1].identity, (Identity{0x5C17, 101, 0x10000, 42}));
  EXPECT_EQ(found->slaves[1].station_address, 1002);
  EXPECT_EQ(link->get<std::uint16_t>(1, reg::kStationAddress), 1002);
  EXPECT_EQ(found->slaves[1].alias, 77);
  EXPECT_EQ(found->slaves[0].esc_type, 0x11);
  EXPECT_EQ(found->slaves[0].fmmu_count, link->get<std::uint8_t>(0, reg::kFmmuCount));
  EXPECT_EQ(found->slaves[0].sync_manager_count, link->get<std::uint8_t>(0, reg::kSyncManagerCount));
  EXPECT_EQ(found->slaves[1].esc_type, 0x04);
  EXPECT_EQ(found->slaves[0].dc, DcCapability::kSystemTime64);
  EXPECT_EQ(found->slaves[1].dc, DcCapability::kSystemTime32);
  EXPECT_EQ(found->slaves[2].dc, DcCapability::kReceiveTimesOnly);
  EXPECT_EQ(found->slaves[2].previous, (PreviousPort{1, 1}));
  EXPECT_EQ(found->slaves[2].sii->general->name, "a drive");
  EXPECT_EQ(progress.front(), std::pair(std::size_t{0}, std::size_t{3}));
  EXPECT_EQ(progress.back(), std::pair(std::size_t{3}, std::size_t{3}));
}

TEST_F(BusScannerTest, ReadsManySiisAtTheSameTime) {
  ASSERT_TRUE(scan());
  const auto three = link->frames_sent;
  config = segment_of({sample::drive_image(100)});
  open();
  ASSERT_TRUE(scan());
  EXPECT_LT(three, link->frames_sent + 10);
}

TEST_F(BusScannerTest, ASlaveWithABrokenSiiIsStillThere) {
  auto& bytes = config.slaves[1].sii_image;
  bytes.assign(2048, 0);
  bytes[0x7C] = 15;                                             // 16 Kbit
  store_le<std::uint16_t>(std::span(bytes).subspan(0x80), 10);  // strings, longer than the EEPROM
  store_le<std::uint16_t>(std::span(bytes).subspan(0x82), 0x7000);
  const auto found = scan();
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->slaves[1].sii);
  ASSERT_TRUE(found->slaves[1].sii_error);
  EXPECT_EQ(found->slaves[1].sii_error->code, ErrorCode::kSii);
  EXPECT_TRUE(found->slaves[2].sii);
}

TEST_F(BusScannerTest, ASlaveThatHidesTheEepromAddressIsReadAllTheSame) {
  open();
  link->on_reply = [](DatagramView& reply) {
    if (test::is_reply_of(reply, 1, 3, reg::kSiiControl) && reply.data.size() >= 6) {
      store_le(reply.data.subspan(2), std::uint32_t{0});
    }
  };
  expect_all_read(scan());
}

TEST_F(BusScannerTest, AsksSlavesWithSwitchesForTheirDeviceId) {
  constexpr std::uint16_t kSwitches = 0x0F80;
  std::vector<sii::Image> images;
  for (std::uint32_t i = 0; i < 3; ++i) {
    auto& with_id = images.emplace_back(sample::drive_image(200 + i));
    with_id.general->flags = i == 2 ? 0x10 : 0x08;
    with_id.general->physical_memory_address = kSwitches;
  }
  config = segment_of(images);
  config.slaves[0].device_id = 321;
  open();
  ASSERT_TRUE(link->set<std::uint16_t>(2, kSwitches, 99));
  link->on_reply = [](DatagramView& reply) {  // the second one offers it and does not answer
    if (test::is_reply_of(reply, 1, 3, reg::kAlStatus)) reply.data[0] &= 0x1F;
  };
  const auto found = scan();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->slaves[0].device_id, 321);
  EXPECT_FALSE(found->slaves[1].device_id);
  EXPECT_EQ(found->slaves[2].device_id, 99);
  link->bus().advance_to(clock.now() + 10 * kMillisecond);
  EXPECT_EQ(link->get<std::uint16_t>(0, reg::kAlStatus), 1);  // the request is taken back

  clock.advance_to(clock.now() + 10 * kMillisecond);
  const auto looked = scan({.look_only = true});
  ASSERT_TRUE(looked);
  EXPECT_FALSE(looked->slaves[0].device_id);
  EXPECT_EQ(looked->slaves[2].device_id, 99);
  EXPECT_EQ(std::ranges::count(looked->findings, std::string_view("scan-device-id-unread"), &Finding::code), 2);
}

TEST(SlowEeproms, CostTimeAndFewFrames) {
  for (const auto takes : {300 * kMicrosecond, 700 * kMicrosecond, 2 * kMillisecond}) {
    VirtualClock clock;
    std::vector<sii::Image> images(100, sample::drive_image(7));
    for (std::uint32_t i = 0; i < 100; ++i) images[i].serial_no = i;
    auto config = segment_of(images);
    for (auto& slave : config.slaves) slave.sii.read_time = takes;
    test::SimulatedSegment link(clock, config);
    FrameExchange exchange(link, clock);
    Bus bus(exchange, clock);
    const auto scan = scan_slaves(bus);
    ASSERT_TRUE(scan);
    for (std::uint32_t i = 0; i < 100; ++i) {
      ASSERT_TRUE(scan->slaves[i].sii);
      EXPECT_EQ(scan->slaves[i].identity.serial_no, i);
    }
    EXPECT_LE(link.frames_sent, 40U) << takes;
  }
}

TEST_F(BusScannerTest, FourAndEightBytesAReadStandSideBySide) {
  config.slaves[1].sii = {200 * kMicrosecond, 0, false};
  for (const bool share : {true, false}) expect_all_read(scan({.share_kinds = share}));
}

/// Frames come back as they were sent: there is a plug at the end of the cable, and nobody else.
TEST_F(BusScannerTest, AnEmptyBusIsAnError) {
  open();
  link->on_reply = [](DatagramView& reply) { reply.set_wkc(0); };
  const auto found = scan();
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kNoResponse);
}

}  // namespace
}  // namespace syncline
