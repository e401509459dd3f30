// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/sim/drive_bed.h"
#include "core/sim/sim_probe.h"

namespace syncline::test {
namespace {

/// Digital outputs with device emulation in OP.
class Outputs : public testing::Test {
 protected:
  Outputs() : probe(line({sim_slave("SL-2002")})) {
    probe.set_sync_manager(0, 0, 0x0F00, 1, 0x44);
    probe.request(0, 8);
  }
  std::uint8_t status() { return probe.read(0, reg::kWatchdogStatus, 1).data[0] & 1; }
  std::uint8_t expirations() { return probe.read(0, reg::kWatchdogCounterProcessData, 1).data[0]; }
  std::uint8_t outputs() { return probe.bus->peek(0, 0x0F00, 1)[0]; }

  SimProbe probe;
};

TEST_F(Outputs, AreSwitchedOffWhenNobodyWritesThemAnyMore) {
  EXPECT_EQ(probe.write(0, 0x0F00, {0x03}).wkc, 1);
  EXPECT_EQ(outputs(), 0x03);
  probe.pass(99 * kMillisecond);  // 1000 ticks of 100 us
  EXPECT_EQ(outputs(), 0x03);
  EXPECT_EQ(status(), 1);
  probe.pass(2 * kMillisecond);
  EXPECT_EQ(outputs(), 0x00);
  EXPECT_EQ(status(), 0);
  EXPECT_EQ(expirations(), 1);
  probe.pass(500 * kMillisecond);
  EXPECT_EQ(expirations(), 1) << "it expires once";
  EXPECT_EQ(probe.write(0, 0x0F00, {0x01}).wkc, 1);
  EXPECT_EQ(status(), 1);
}

TEST_F(Outputs, CountAnewWhenEitherCounterIsWritten) {
  for (const auto counter : {reg::kWatchdogCounterProcessData, reg::kWatchdogCounterPdi}) {
    probe.write(0, 0x0F00, {0x03});
    probe.pass(200 * kMillisecond);
    EXPECT_EQ(expirations(), 1);
    EXPECT_EQ(probe.write(0, counter, {7}).wkc, 1);
    EXPECT_EQ(probe.read(0, reg::kWatchdogCounterProcessData, 2).value<std::uint16_t>(), 0);
  }
}

TEST_F(Outputs, FollowTheDividerAndStayWithoutAWatchdog) {
  probe.write(0, reg::kWatchdogProcessData, {10, 0});  // 1 ms
  probe.write(0, 0x0F00, {0x03});
  probe.pass(2 * kMillisecond);
  EXPECT_EQ(outputs(), 0x00);
  probe.write(0, reg::kWatchdogProcessData, {0, 0});
  probe.write(0, 0x0F00, {0x03});
  probe.pass(10 * kSecond);
  EXPECT_EQ(outputs(), 0x03);
  EXPECT_EQ(status(), 1) << "a watchdog that is off counts as well";
}

/// Its SYNC0 has gone on: wherever in the cycle its firmware goes on, it does not take the signal for lost.
TEST(FirmwareThatGoesOn, FindsItsSync0) {
  for (const std::string type : {"SL-SV7", "SL-XE2"}) {
    for (int phase = 0; phase < 20; ++phase) {
      FaultConfig hang;
      hang.kind = FaultKind::kStopApplication;
      hang.slave = 0;
      hang.at = 700 * kMillisecond;
      hang.until = 716 * kMillisecond + phase * 50 * kMicrosecond;
      DriveBed drive(type, {hang});
      drive.start_sync0(1'000'000);
      ASSERT_EQ(drive.to_op(), 8);
      const auto begin = drive.probe.now;
      while (drive.probe.now < begin + 300 * kMillisecond) {
        drive.frame(667 * kMicrosecond);
        for (int look = 0; look < 12; ++look) {
          drive.probe.pass(20 * kMicrosecond);
          ASSERT_EQ(drive.status(), 8) << type << ", phase " << phase << ", " << (drive.probe.now - begin) / 1000
                                       << " us, " << drive.probe.read(0, reg::kAlStatusCode, 2).value<std::uint16_t>();
        }
      }
    }
  }
}

/// A device whose firmware hangs from 10 ms until 400 ms after power-on.
class HungFirmware : public testing::Test {
 protected:
  HungFirmware() : probe(hanging()) {}
  static SimConfig hanging() {
    auto config = line({sim_slave("SL-SV7", "servo-y")});
    FaultConfig fault;
    fault.kind = FaultKind::kStopApplication;
    fault.slave = 0;
    fault.at = 10 * kMillisecond;
    fault.until = 400 * kMillisecond;
    config.faults.push_back(fault);
    return config;
  }
  bool pdi_fine() { return (probe.read(0, reg::kDlStatus, 2).value<std::uint16_t>() & 0x0002) != 0; }
  unsigned expirations() { return probe.read(0, reg::kWatchdogCounterPdi, 1).data[0]; }

  SimProbe probe;
};

TEST_F(HungFirmware, LetsThePdiWatchdogExpireOnceAndAnswersNoRequest) {
  probe.write(0, reg::kEcatEventMask, {0x04, 0x00});
  probe.pass(105 * kMillisecond);
  EXPECT_TRUE(pdi_fine()) << "100 ms since the last access";
  probe.set_sync_manager(0, 0, 0x1000, 128, 0x26);
  probe.set_sync_manager(0, 1, 0x1080, 128, 0x22);
  EXPECT_EQ(probe.request(0, 0x02) & 0x0F, 0x01) << "it does not even see the request";
  probe.pass(150 * kMillisecond);
  EXPECT_NE(probe.read(0, reg::kType, 1).irq & 0x0004, 0) << "the DL status has changed";
  EXPECT_FALSE(pdi_fine());
  EXPECT_EQ(expirations(), 1U);
  probe.pass(200 * kMillisecond);
  EXPECT_TRUE(pdi_fine());
  EXPECT_EQ(expirations(), 1U);
  EXPECT_EQ(probe.read(0, reg::kAlStatus, 2).data[0], 0x02) << "it goes on with what it finds";
}

TEST_F(HungFirmware, IsNotNoticedWithoutAWatchdogTime) {
  probe.write(0, reg::kWatchdogPdi, {0, 0});
  probe.pass(300 * kMillisecond);
  EXPECT_TRUE(pdi_fine());
  EXPECT_EQ(expirations(), 0U);
}

TEST(SimEsc, LacksWhatTheScenarioTakesAway) {
  auto slave = sim_slave("SL-1100");
  slave.logical_read_write = slave.physical_read_write = false;
  slave.fmmu_count = 3;
  slave.ram_kbytes = 1;
  SimProbe probe(line({slave}));
  EXPECT_EQ(probe.read(0, reg::kFmmuCount, 1).data[0], 3);
  EXPECT_EQ(probe.read(0, reg::kRamSize, 1).data[0], 1);
  EXPECT_EQ(probe.read(0, reg::kFeatures, 2).value<std::uint16_t>() & 0x0600, 0x0600);
  EXPECT_EQ(probe.read(0, reg::fmmu(2), 1).wkc, 1);
  EXPECT_EQ(probe.read(0, reg::fmmu(3), 1).wkc, 0);
  EXPECT_EQ(probe.read(0, 0x13FF, 1).wkc, 1);
  EXPECT_EQ(probe.read(0, 0x1400, 1).wkc, 0);
  EXPECT_EQ(probe.send(Command::kAprw, device_address(0, reg::kStationAddress), {1, 0}).wkc, 0);
  EXPECT_EQ(probe.send(Command::kBrw, device_address(0, reg::kStationAddress), {1, 0}).wkc, 0);
}

TEST(SimEsc, BuffersTwoAndThreeAreNotForTheMaster) {
  SimProbe probe(line({sim_slave("SL-SV7", "servo-y")}));
  probe.set_sync_manager(0, 2, 0x1100, 16, 0x64);
  EXPECT_EQ(probe.write(0, 0x1100, std::vector<std::uint8_t>(16)).wkc, 1);
  EXPECT_EQ(probe.read(0, 0x1110, 4).wkc, 0);
  EXPECT_EQ(probe.write(0, 0x112C, {1, 2, 3, 4}).wkc, 0);
  EXPECT_EQ(probe.read(0, 0x1130, 4).wkc, 1) << "behind the third";
}

TEST(SimEsc, EventRequestMirrorsTheMailboxes) {
  SimProbe probe(line({sim_slave("SL-SV7", "servo-y")}));
  probe.set_sync_manager(0, 0, 0x1000, 128, 0x26);
  const auto events = [&probe] { return probe.read(0, reg::kEcatEventRequest, 2).value<std::uint16_t>(); };
  EXPECT_EQ(events() & 0x0010, 0);
  probe.write(0, 0x1000, std::vector<std::uint8_t>(128));  // nobody fetches it in INIT
  EXPECT_EQ(events() & 0x0010, 0x0010);
}

}  // namespace
}  // namespace syncline::test
