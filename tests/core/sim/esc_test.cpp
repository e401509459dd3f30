// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/fmmu.h"
#include "protocol/sii.h"
#include "tests/core/sim/sim_probe.h"

namespace syncline::test {
namespace {

using testing::ElementsAre;

SimConfig three_terminals() {
  auto config = line({sim_slave("SL-1100"), sim_slave("SL-2002"), sim_slave("SL-1002")});
  config.slaves[1].dc = {false, true, true};  // receive times only
  config.slaves[2].dc = {false, false, false};
  return config;
}

TEST(SimEsc, BroadcastCountsAndOrsAndAdvancesThePosition) {
  SimProbe probe(three_terminals());
  const auto reply = probe.send(Command::kBrd, device_address(0, reg::kAlStatus), {0, 0});
  EXPECT_EQ(reply.wkc, 3);
  EXPECT_EQ(reply.adp, 3);
  EXPECT_THAT(reply.data, ElementsAre(1, 0));
  probe.write(1, reg::kAlControl, {2, 0});
  EXPECT_THAT(probe.send(Command::kBrd, device_address(0, reg::kAlStatus), {0, 0}).data, ElementsAre(3, 0));
}

TEST(SimEsc, EveryFrameComesBackWithTheLocallyAdministeredBit) {
  SimProbe probe(three_terminals());
  EXPECT_EQ(probe.send(Command::kNop, 0, {0}).source_mac0, 0x02);
}

TEST(SimEsc, PositionAndStationAddressReachOneSlave) {
  SimProbe probe(three_terminals());
  EXPECT_EQ(probe.write(1, reg::kStationAddress, {0xE9, 0x03}).wkc, 1);
  const auto reply = probe.send(Command::kFprd, device_address(1001, reg::kStationAddress), {0, 0});
  EXPECT_EQ(reply.wkc, 1);
  EXPECT_EQ(reply.adp, 1001) << "fixed addressing leaves the address alone";
  EXPECT_EQ(probe.send(Command::kFprd, device_address(1002, reg::kStationAddress), {0, 0}).wkc, 0);
}

TEST(SimEsc, ReadWriteCountsThreeAndGivesTheOldValue) {
  SimProbe probe(three_terminals());
  probe.write(0, reg::kStationAddress, {0x11, 0x22});
  const auto reply = probe.send(Command::kAprw, device_address(0, reg::kStationAddress), {0x33, 0x44});
  EXPECT_EQ(reply.wkc, 3);
  EXPECT_THAT(reply.data, ElementsAre(0x11, 0x22));
  EXPECT_THAT(probe.read(0, reg::kStationAddress, 2).data, ElementsAre(0x33, 0x44));
}

TEST(SimEsc, WhatIsNotImplementedOrReadOnlyCountsNothing) {
  SimProbe probe(three_terminals());
  // As captured on real buses: system time on one of three, receive times on two, 0x092C is read only.
  EXPECT_EQ(probe.send(Command::kBwr, device_address(0, reg::kReceiveTimePort0), {0, 0, 0, 0}).wkc, 2);
  EXPECT_EQ(probe.send(Command::kBwr, device_address(0, reg::kSystemTime), {0, 0, 0, 0}).wkc, 1);
  EXPECT_EQ(probe.send(Command::kBwr, device_address(0, reg::kSystemTimeDifference), {0, 0, 0, 0}).wkc, 0);
  EXPECT_EQ(probe.send(Command::kBwr, device_address(0, reg::kSystemTime), std::vector<std::uint8_t>(32)).wkc, 1);
  EXPECT_EQ(probe.read(1, reg::kSystemTime, 4).wkc, 0);
  EXPECT_EQ(probe.read(0, 0x0E00, 4).wkc, 0);
}

TEST(SimEsc, ReadMultipleWriteReadsOneAndWritesTheOthers) {
  SimProbe probe(three_terminals());
  for (std::uint16_t i = 0; i < 3; ++i) probe.write(i, reg::kStationAlias, {0, 0});
  probe.write(0, reg::kWatchdogPdi, {0x55, 0x01});
  const auto reply = probe.send(Command::kArmw, device_address(0, reg::kWatchdogPdi), {0, 0});
  EXPECT_EQ(reply.wkc, 3);
  EXPECT_THAT(reply.data, ElementsAre(0x55, 0x01));
  EXPECT_THAT(probe.read(2, reg::kWatchdogPdi, 2).data, ElementsAre(0x55, 0x01));
}

TEST(SimEsc, LogicalCommandsTouchOnlyTheMappedBits) {
  SimProbe probe(three_terminals());
  Fmmu out;
  out.logical_start = 0x10000;
  out.length = 1;
  out.logical_start_bit = 2;
  out.logical_stop_bit = 3;
  out.physical_start = 0x0F00;
  out.write = true;
  out.active = true;
  const auto image = out.encode();
  probe.write(1, reg::fmmu(0), {image.begin(), image.end()});
  probe.set_sync_manager(1, 0, 0x0F00, 1, 0x44);
  const auto reply = probe.send(Command::kLrw, 0x10000, {0xFF});
  EXPECT_EQ(reply.wkc, 2);
  EXPECT_THAT(reply.data, ElementsAre(0xFF));
  EXPECT_EQ(probe.bus->peek(1, 0x0F00, 1)[0], 0x03);
  EXPECT_EQ(probe.send(Command::kLrd, 0x10000, {0}).wkc, 0) << "a write FMMU is no read FMMU";
  EXPECT_EQ(probe.send(Command::kLwr, 0x10001, {0xFF}).wkc, 0);
}

TEST(SimEsc, RegistersShowTheOldValueUntilTheFrameIsOver) {
  SimProbe probe(three_terminals());
  FrameBuilder builder;
  const std::array<std::uint8_t, 2> value{0x34, 0x12};
  builder.add(Command::kApwr, 1, device_address(0, reg::kStationAddress), value);
  builder.add_zeros(Command::kAprd, 1, device_address(0, reg::kStationAddress), 2);
  const auto sent = builder.finish();
  std::vector<std::uint8_t> frame(sent.begin(), sent.end());
  ASSERT_FALSE(probe.bus->execute(frame, probe.now).lost);
  FrameReader reader(frame);
  (void)reader.next();
  const auto read = reader.next();
  EXPECT_EQ(load_le<std::uint16_t>(read->data), 0);
  EXPECT_THAT(probe.read(0, reg::kStationAddress, 2).data, ElementsAre(0x34, 0x12));
}

TEST(SimEsc, ShortFramesAreAnsweredAndBrokenOnesAreNot) {
  SimProbe probe(three_terminals());
  FrameBuilder builder;
  builder.add_zeros(Command::kBrd, 1, device_address(0, reg::kType), 1);
  const auto sent = builder.finish();
  std::vector<std::uint8_t> unpadded(sent.begin(), sent.begin() + 14 + 2 + 13);
  EXPECT_FALSE(probe.bus->execute(unpadded, probe.now).lost);
  std::vector<std::uint8_t> cut(sent.begin(), sent.begin() + 20);
  EXPECT_TRUE(probe.bus->execute(cut, probe.now).lost);
  std::vector<std::uint8_t> foreign(sent.begin(), sent.end());
  foreign[12] = 0x08;
  EXPECT_TRUE(probe.bus->execute(foreign, probe.now).lost);
}

TEST(SimSii, HoldsTheEsisIdentitySyncManagersAndPdos) {
  for (const char* type : {"SL-1100", "SL-1002", "SL-2002", "SL-SV7", "SL-XE2"}) {
    const auto slave = sim_slave(type);
    SimProbe probe(line({slave}));
    std::vector<std::uint8_t> bytes;
    for (std::uint32_t word = 0; word < slave.device.eeprom.byte_size / 2; word += 4) {
      std::vector<std::uint8_t> command;
      ByteWriter(command).u16(0x0100).u32(word);
      probe.write(0, reg::kSiiControl, command);
      const auto data = probe.read(0, reg::kSiiData, 8).data;
      bytes.insert(bytes.end(), data.begin(), data.end());
    }
    const auto image = sii::decode(bytes);
    ASSERT_TRUE(image) << type;
    EXPECT_TRUE(image->checksum_ok);
    EXPECT_EQ(image->vendor_id, slave.device.identity.vendor_id);
    EXPECT_EQ(image->product_code, slave.device.identity.product_code);
    EXPECT_EQ(image->sync_managers.size(), slave.device.sync_managers.size());
    ASSERT_EQ(image->rx_pdos.size(), slave.device.rx_pdos.size());
    ASSERT_EQ(image->tx_pdos.size(), slave.device.tx_pdos.size());
    for (std::size_t i = 0; i < image->rx_pdos.size(); ++i) {
      EXPECT_EQ(image->rx_pdos[i].index, slave.device.rx_pdos[i].index);
      EXPECT_EQ(image->rx_pdos[i].entries.size(), slave.device.rx_pdos[i].entries.size());
    }
  }
}

TEST(SimSii, WritingNeedsTheEnableBit) {
  SimProbe probe(line({sim_slave("SL-1100")}));
  std::vector<std::uint8_t> command;
  ByteWriter(command).u16(0x0200).u32(4).u16(0x0007);
  probe.write(0, reg::kSiiControl, command);
  EXPECT_NE(probe.read(0, reg::kSiiControl, 2).value<std::uint16_t>() & 0x4000, 0);
}

}  // namespace
}  // namespace syncline::test
