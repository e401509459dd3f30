// SPDX-License-Identifier: Apache-2.0
#include "master/scan/bus_scanner.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "config/device_description.h"
#include "config/device_from_sii.h"
#include "config/sync_manager_type.h"
#include "master/exchange/bus.h"
#include "master/master_service.h"
#include "tests/support/test_bus.h"

namespace syncline {
namespace {

sii::Image image(std::uint32_t product) {
  sii::Image image;
  image.vendor_id = 0x5C17;
  image.product_code = product;
  image.revision_no = 0x10000;
  image.serial_no = 42;
  image.mailbox_protocols = sii::kProtocolCoe;
  image.general = sii::General{};
  image.general->name = "a drive";
  image.general->order = "DRV";
  image.general->coe_details = 0x25;
  image.general->physical_ports = 0x0011;
  image.fmmus = {1, 2, 3};
  image.sync_managers = {{0x1000, 128, 0x26, 0, 1, 1}, {0x1080, 128, 0x22, 0, 1, 2}, {0x1100, 6, 0x64, 0, 9, 3}};
  sii::Pdo pdo;
  pdo.index = 0x1600;
  pdo.sync_manager = 2;
  pdo.name = "outputs";
  pdo.entries.push_back({0x6040, 0, "Controlword", 6, 16, 0});
  image.rx_pdos.push_back(pdo);
  sii::DcMode mode;
  mode.name = "DC";
  mode.assign_activate = 0x0300;
  mode.cycle_factor_sync0 = 1;
  image.dc_modes.push_back(mode);
  return image;
}

class BusScannerTest : public ::testing::Test {
 protected:
  VirtualClock clock;
  test::TestBus link{clock, 3};
  FrameExchange exchange{link, clock};
  Bus bus{exchange, clock};

  void SetUp() override {
    for (std::uint32_t i = 0; i < 3; ++i) link.slave(i).sii = sii::encode(image(100 + i));
    link.slave(0).memory[reg::kType] = 0x11;
    link.slave(1).set<std::uint16_t>(reg::kStationAlias, 77);
  }
};

TEST_F(BusScannerTest, FindsWhoIsThere) {
  link.slave(2).has_system_time = false;
  link.slave(1).set<std::uint16_t>(reg::kFeatures, 0x0004);
  std::vector<std::pair<std::size_t, std::size_t>> progress;
  const auto scan = scan_slaves(
      bus, {}, {.progress = [&](std::size_t done, std::size_t found) { progress.emplace_back(done, found); }});
  ASSERT_TRUE(scan);
  ASSERT_EQ(scan->slaves.size(), 3U);
  EXPECT_EQ(scan->slaves[1].identity, (Identity{0x5C17, 101, 0x10000, 42}));
  EXPECT_EQ(scan->slaves[1].station_address, 1002);
  EXPECT_EQ(link.slave(1).get<std::uint16_t>(reg::kStationAddress), 1002);
  EXPECT_EQ(scan->slaves[1].alias, 77);
  EXPECT_EQ(scan->slaves[0].esc_type, 0x11);
  EXPECT_EQ(scan->slaves[0].dc, DcCapability::kSystemTime64);
  EXPECT_EQ(scan->slaves[1].dc, DcCapability::kSystemTime32);
  EXPECT_EQ(scan->slaves[2].dc, DcCapability::kReceiveTimesOnly);
  EXPECT_EQ(scan->slaves[2].previous, (PreviousPort{1, 1}));
  EXPECT_EQ(scan->slaves[2].sii->general->name, "a drive");
  EXPECT_EQ(progress.front(), std::pair(std::size_t{0}, std::size_t{3}));
  EXPECT_EQ(progress.back(), std::pair(std::size_t{3}, std::size_t{3}));
}

TEST_F(BusScannerTest, ReadsManySiisAtTheSameTime) {
  const auto before = link.frames_sent;
  ASSERT_TRUE(scan_slaves(bus));
  const auto three = link.frames_sent - before;
  test::TestBus single(clock, 1);
  single.slave(0).sii = link.slave(0).sii;
  FrameExchange single_exchange(single, clock);
  Bus single_bus(single_exchange, clock);
  ASSERT_TRUE(scan_slaves(single_bus));
  EXPECT_LT(three, single.frames_sent + 10);
}

TEST_F(BusScannerTest, ASlaveWithABrokenSiiIsStillThere) {
  link.slave(1).sii.assign(2048, 0);
  link.slave(1).sii[0x7C] = 15;                                             // 16 Kbit
  store_le<std::uint16_t>(std::span(link.slave(1).sii).subspan(0x80), 10);  // strings, longer than the EEPROM
  store_le<std::uint16_t>(std::span(link.slave(1).sii).subspan(0x82), 0x7000);
  const auto scan = scan_slaves(bus);
  ASSERT_TRUE(scan);
  EXPECT_FALSE(scan->slaves[1].sii);
  ASSERT_TRUE(scan->slaves[1].sii_error);
  EXPECT_EQ(scan->slaves[1].sii_error->code, ErrorCode::kSii);
  EXPECT_TRUE(scan->slaves[2].sii);
}

TEST_F(BusScannerTest, ASlaveThatHidesTheEepromAddressIsReadAllTheSame) {
  link.slave(1).shows_sii_address = false;
  const auto scan = scan_slaves(bus);
  ASSERT_TRUE(scan);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(scan->slaves[i].sii, sii::decode(link.slave(i).sii).value()) << i;
}

TEST_F(BusScannerTest, AsksSlavesWithSwitchesForTheirDeviceId) {
  for (std::uint32_t i = 0; i < 3; ++i) {
    auto with_id = image(200 + i);
    with_id.general->flags = i == 2 ? 0x10 : 0x08;
    with_id.general->physical_memory_address = 0x0F80;
    link.slave(i).sii = sii::encode(with_id);
  }
  link.slave(0).device_id = 321;
  link.slave(2).set<std::uint16_t>(0x0F80, 99);
  const auto scan = scan_slaves(bus);
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->slaves[0].device_id, 321);
  EXPECT_FALSE(scan->slaves[1].device_id);  // offers it, does not answer
  EXPECT_EQ(scan->slaves[2].device_id, 99);
  EXPECT_EQ(link.slave(0).get<std::uint16_t>(reg::kAlStatus), 1);  // the request is taken back

  const auto looked = scan_slaves(bus, {.look_only = true});
  ASSERT_TRUE(looked);
  EXPECT_FALSE(looked->slaves[0].device_id);
  EXPECT_EQ(looked->slaves[2].device_id, 99);
  EXPECT_EQ(std::ranges::count(looked->findings, std::string_view("scan-device-id-unread"), &Finding::code), 2);
}

TEST(SlowEeproms, CostTimeAndFewFrames) {
  for (const auto takes : {300 * kMicrosecond, 700 * kMicrosecond, 2 * kMillisecond}) {
    VirtualClock clock;
    test::TestBus link(clock, 100);
    for (std::uint32_t i = 0; i < 100; ++i) {
      auto own = image(7);
      own.serial_no = i;
      link.slave(i).sii = sii::encode(own);
      link.slave(i).sii_time = takes;
    }
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
  link.slave(1).sii_bytes = 4;
  link.slave(1).sii_time = 200 * kMicrosecond;
  for (const bool share : {true, false}) {
    const auto scan = scan_slaves(bus, {.share_kinds = share});
    ASSERT_TRUE(scan);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(scan->slaves[i].sii, sii::decode(link.slave(i).sii).value()) << i;
  }
}

TEST_F(BusScannerTest, AnEmptyBusIsAnError) {
  for (std::size_t i = 0; i < 3; ++i) link.slave(i).present = false;
  const auto scan = scan_slaves(bus);
  ASSERT_FALSE(scan);
  EXPECT_EQ(scan.error().code, ErrorCode::kNoResponse);
}

TEST(DeviceFromSii, KeepsWhatAnEsiWouldSay) {
  const auto device = device_from_sii(image(7));
  EXPECT_EQ(device.identity, (Identity{0x5C17, 7, 0x10000, 0}));
  EXPECT_EQ(device.type, "DRV");
  EXPECT_EQ(device.physics, "YY");
  ASSERT_TRUE(device.mailbox && device.mailbox->coe);
  EXPECT_TRUE(device.mailbox->coe->pdo_assign);
  EXPECT_TRUE(device.mailbox->coe->complete_access);
  EXPECT_FALSE(device.mailbox->coe->pdo_config);
  ASSERT_EQ(device.sync_managers.size(), 3U);
  EXPECT_EQ(device.sync_managers[2].type, SyncManagerType::kOutputs);
  EXPECT_TRUE(device.sync_managers[2].op_only);
  ASSERT_EQ(device.rx_pdos.size(), 1U);
  EXPECT_EQ(device.rx_pdos[0].entries[0].data_type, "UINT");
  EXPECT_EQ(device.rx_pdos[0].sync_manager, 2);
  ASSERT_TRUE(device.dc);
  EXPECT_EQ(device.dc->op_modes[0].cycle_time_sync0.factor, 1);
  EXPECT_EQ(device.source, "SII");
}

}  // namespace
}  // namespace syncline
