// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "protocol/fmmu.h"
#include "sim/esc/esc.h"
#include "tests/core/sim/sim_probe.h"

/// Who may touch what: write protection, SyncManagers that the PDI locks, buffers while they are read.
namespace syncline::test {
namespace {

using testing::Each;
using testing::ElementsAre;

constexpr std::array<std::uint8_t, 6> kMac{};

/// One frame with several datagrams; their working counters.
std::vector<std::uint16_t> send_all(SimProbe& probe,
                                    const std::vector<std::pair<std::uint16_t, std::vector<std::uint8_t>>>& writes) {
  FrameBuilder builder;
  builder.set_addresses(kMac, kMac);
  std::uint8_t index = 0;
  for (const auto& [ado, data] : writes) builder.add(Command::kApwr, index++, device_address(0, ado), data);
  const auto sent = builder.finish();
  std::vector<std::uint8_t> frame(sent.begin(), sent.end());
  EXPECT_FALSE(probe.bus->execute(frame, probe.now).lost);
  probe.now += 20 * kMicrosecond;
  std::vector<std::uint16_t> counters;
  FrameReader reader(frame);
  while (const auto datagram = reader.next()) counters.push_back(datagram->wkc());
  return counters;
}

TEST(SimWriteProtection, RegistersNeedTheEnableInTheSameFrame) {
  SimProbe probe(line({sim_slave("SL-SV7", "servo-y")}));
  EXPECT_EQ(probe.write(0, 0x0021, {1}).wkc, 1);
  EXPECT_EQ(probe.write(0, reg::kStationAddress, {0x11, 0x22}).wkc, 0);
  EXPECT_EQ(probe.write(0, 0x0020, {1}).wkc, 1);
  EXPECT_EQ(probe.write(0, reg::kStationAddress, {0x11, 0x22}).wkc, 0) << "the next frame is too late";
  EXPECT_EQ(probe.read(0, reg::kStationAddress, 2).wkc, 1) << "reading is free";
  EXPECT_EQ(probe.write(0, 0x1800, {5}).wkc, 1) << "so is the memory";
  EXPECT_THAT(
      send_all(probe, {{reg::kStationAddress, {0x11, 0x22}}, {0x0020, {0}}, {reg::kStationAddress, {0x33, 0x44}}}),
      ElementsAre(0, 1, 1));
  EXPECT_THAT(probe.read(0, reg::kStationAddress, 2).data, ElementsAre(0x33, 0x44));
  EXPECT_EQ(probe.write(0, 0x0021, {0}).wkc, 0) << "the protection protects itself";
  EXPECT_THAT(send_all(probe, {{0x0020, {0}}, {0x0021, {0}}}), ElementsAre(1, 1));
  EXPECT_EQ(probe.write(0, reg::kStationAddress, {0x55, 0x66}).wkc, 1);
}

TEST(SimWriteProtection, TheWholeEscCanBeProtected) {
  SimProbe probe(line({sim_slave("SL-SV7", "servo-y")}));
  EXPECT_EQ(probe.write(0, 0x0031, {1}).wkc, 1);
  EXPECT_EQ(probe.write(0, 0x1800, {5}).wkc, 0);
  EXPECT_EQ(probe.write(0, reg::kWatchdogPdi, {5, 0}).wkc, 0);
  Fmmu fmmu;
  fmmu.logical_start = 0x4000;
  fmmu.length = 1;
  fmmu.physical_start = 0x1800;
  fmmu.write = fmmu.active = true;
  const auto image = fmmu.encode();
  EXPECT_THAT(send_all(probe, {{0x0030, {1}}, {reg::fmmu(0), {image.begin(), image.end()}}, {0x1800, {7}}}), Each(1));
  EXPECT_EQ(probe.send(Command::kLwr, 0x4000, {9}).wkc, 0) << "neither through an FMMU";
  EXPECT_THAT(probe.bus->peek(0, 0x1800, 1), ElementsAre(7));
  EXPECT_THAT(send_all(probe, {{0x0030, {1}}, {0x0031, {0}}}), ElementsAre(1, 1));
  EXPECT_EQ(probe.send(Command::kLwr, 0x4000, {9}).wkc, 1);
}

TEST(SimMailboxState, AnFmmuBringsOneBitOf0x080d) {
  SimProbe probe(line({sim_slave("SL-SV7", "servo-y")}));
  probe.set_sync_manager(0, 0, 0x1000, 128, 0x26);
  probe.set_sync_manager(0, 1, 0x1080, 128, 0x22);
  ASSERT_EQ(probe.request(0, 2), 2);
  Fmmu fmmu;
  fmmu.logical_start = 0x4001;
  fmmu.length = 1;
  fmmu.logical_start_bit = fmmu.logical_stop_bit = 6;
  fmmu.physical_start = 0x080D;
  fmmu.physical_start_bit = 3;
  fmmu.read = fmmu.active = true;
  const auto image = fmmu.encode();
  probe.write(0, reg::fmmu(0), {image.begin(), image.end()});
  auto reply = probe.send(Command::kLrd, 0x4000, {0xFF, 0xFF, 0xFF});
  EXPECT_EQ(reply.wkc, 1);
  EXPECT_THAT(reply.data, ElementsAre(0xFF, 0xBF, 0xFF)) << "empty";
  std::vector<std::uint8_t> request(128);
  const std::vector<std::uint8_t> upload{10, 0, 0, 0, 0, 0x13, 0x00, 0x20, 0x40, 0x18, 0x10, 0x01};
  std::ranges::copy(upload, request.begin());
  ASSERT_EQ(probe.write(0, 0x1000, request).wkc, 1);
  probe.pass(kMillisecond);
  EXPECT_THAT(probe.send(Command::kLrd, 0x4000, {0, 0, 0}).data, ElementsAre(0, 0x40, 0)) << "the answer waits";
  EXPECT_EQ(probe.read(0, 0x1080, 128).wkc, 1);
  EXPECT_THAT(probe.send(Command::kLrd, 0x4000, {0, 0xFF, 0}).data, ElementsAre(0, 0xBF, 0));
}

/// An ESC alone, driven from both sides.
class SimBuffers : public testing::Test {
 protected:
  SimBuffers() : esc(sim_slave("SL-SV7"), std::vector<std::uint8_t>(256), sim::Esc::Options{}, 0, 1) {
    esc.memory().set<std::uint64_t>(reg::sync_manager(3), 0x0001'0020'0008'1400U);
    esc.memory().set<std::uint64_t>(reg::sync_manager(2), 0x0001'0024'0008'1100U);
  }
  std::vector<std::uint8_t> access(Command command, std::uint16_t ado, std::vector<std::uint8_t> data,
                                   std::uint16_t* wkc = nullptr) {
    FrameBuilder builder;
    builder.set_addresses(kMac, kMac);
    builder.add(command, 1, device_address(0, ado), data);
    const auto sent = builder.finish();
    std::vector<std::uint8_t> frame(sent.begin(), sent.end());
    sim::PassingFrame passing;
    EXPECT_EQ(passing.arrive(frame), sim::PassingFrame::Kind::kEtherCat);
    EXPECT_TRUE(esc.process(passing, now));
    esc.frame_end(now += 20 * kMicrosecond);
    const auto& datagram = passing.datagrams().front();
    if (wkc != nullptr) *wkc = datagram.wkc;
    return {datagram.data.begin(), datagram.data.end()};
  }
  std::vector<std::uint8_t> read(std::uint16_t ado, std::size_t length) {
    return access(Command::kAprd, ado, std::vector<std::uint8_t>(length));
  }
  std::uint16_t write(std::uint16_t ado, std::size_t length) {
    std::uint16_t wkc = 0;
    access(Command::kApwr, ado, std::vector<std::uint8_t>(length), &wkc);
    return wkc;
  }
  void inputs(std::uint8_t value) { esc.put_buffer(3, std::vector<std::uint8_t>(8, value)); }

  sim::Esc esc;
  Nanoseconds now = 0;
};

TEST_F(SimBuffers, ATransferInPartsSeesOneBuffer) {
  inputs(1);
  EXPECT_THAT(read(0x1400, 3), Each(1));
  inputs(2);
  inputs(3);
  EXPECT_THAT(read(0x1403, 3), Each(1)) << "the buffer that was opened";
  EXPECT_THAT(read(0x1406, 2), Each(1)) << "the last byte lets it go";
  EXPECT_THAT(read(0x1400, 8), Each(3));
  inputs(4);
  EXPECT_THAT(read(0x1400, 8), Each(4)) << "whole transfers are always fresh";
  EXPECT_THAT(read(0x1400, 3), Each(4));
  inputs(5);
  EXPECT_THAT(read(0x1400, 3), Each(5)) << "beginning again opens the newest";
}

TEST_F(SimBuffers, ThePdiLocksASyncManager) {
  EXPECT_EQ(write(0x1100, 8), 1);
  esc.deactivate_sync_manager(2, true);
  EXPECT_EQ(write(0x1100, 8), 0);
  EXPECT_EQ(read(reg::sync_manager(2) + 7, 1)[0] & 0x01, 0x01) << "the master can see why";
  EXPECT_EQ(write(0x1000, 8), 1) << "other memory is open";
  esc.deactivate_sync_manager(2, false);
  EXPECT_EQ(write(0x1100, 8), 1);
}

}  // namespace
}  // namespace syncline::test
