// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "protocol/dl_status.h"
#include "protocol/fmmu.h"
#include "protocol/sync_manager.h"
#include "tests/core/sim/sim_probe.h"

/// Rules of the ESC data sheet that a master notices only when something goes wrong.
namespace syncline::test {
namespace {

using testing::ElementsAre;

void broadcast(SimProbe& probe, std::uint16_t ado, std::vector<std::uint8_t> data) {
  probe.send(Command::kBwr, device_address(0, ado), std::move(data));
}

// ---- SyncManagers ---------------------------------------------------------------------------------

TEST(SimSyncManager, KeepsItsPlaceWhileItIsEnabled) {
  SimProbe probe(line({sim_slave("SL-SV7", "servo-y")}));
  const auto registers = [&probe] { return probe.read(0, reg::sync_manager(2), SyncManager::kSize).data; };
  probe.set_sync_manager(0, 2, 0x1100, 16, 0x64);
  EXPECT_EQ(probe.write(0, reg::sync_manager(2), {0x00, 0x14, 20, 0, 0x20}).wkc, 1) << "it counts";
  auto now = SyncManager::decode(std::span<const std::uint8_t, SyncManager::kSize>(registers()));
  EXPECT_EQ(now.start, 0x1100) << "and changes nothing";
  EXPECT_EQ(now.length, 16);
  EXPECT_EQ(now.control, 0x64);
  probe.write(0, reg::sync_manager(2), std::vector<std::uint8_t>(SyncManager::kSize));
  now = SyncManager::decode(std::span<const std::uint8_t, SyncManager::kSize>(registers()));
  EXPECT_FALSE(now.enabled()) << "which it is switched off by all the same";
  EXPECT_EQ(now.start, 0x1100);
  probe.write(0, reg::sync_manager(2), {0x00, 0x14, 20, 0, 0x20});
  now = SyncManager::decode(std::span<const std::uint8_t, SyncManager::kSize>(registers()));
  EXPECT_EQ(now.start, 0x1400);
  EXPECT_EQ(now.length, 20);
}

TEST(SimSyncManager, StatusAndWhatBelongsToThePdiAreNotWritten) {
  SimProbe probe(line({sim_slave("SL-SV7", "servo-y")}));
  const auto status = static_cast<std::uint16_t>(reg::sync_manager(0) + 5);
  const auto pdi = static_cast<std::uint16_t>(reg::sync_manager(0) + 7);
  const auto before = probe.read(0, status, 1).data;
  EXPECT_EQ(probe.write(0, status, {0xFF}).wkc, 0);
  EXPECT_EQ(probe.read(0, status, 1).data, before);
  EXPECT_EQ(probe.write(0, pdi, {0x03}).wkc, 0);
  EXPECT_THAT(probe.read(0, pdi, 1).data, ElementsAre(0));
}

TEST(SimSyncManager, ThereAreAsManyAsTheSlaveHas) {
  auto slave = sim_slave("SL-1100");
  slave.sync_manager_count = 3;
  slave.fmmu_count = 2;
  SimProbe probe(line({slave}));
  EXPECT_EQ(probe.read(0, reg::kSyncManagerCount, 1).data[0], 3);
  for (std::uint16_t byte = 0; byte < 8; ++byte) {
    EXPECT_EQ(probe.read(0, static_cast<std::uint16_t>(reg::sync_manager(2) + byte), 1).wkc, 1) << byte;
    EXPECT_EQ(probe.read(0, static_cast<std::uint16_t>(reg::sync_manager(3) + byte), 1).wkc, 0) << byte;
  }
  EXPECT_EQ(probe.read(0, reg::fmmu(1), 16).wkc, 1);
  EXPECT_EQ(probe.read(0, reg::fmmu(2), 1).wkc, 0);
}

/// A mailbox that was full when it was switched off is empty when it is switched on again.
TEST(SimSyncManager, IsEmptyWhenItIsSwitchedOnAgain) {
  SimProbe probe(line({sim_slave("SL-SV7", "servo-y")}));
  const auto full = [&probe] {
    return (probe.read(0, reg::sync_manager(0) + 5, 1).data[0] & SyncManager::kStatusMailboxFull) != 0;
  };
  probe.set_sync_manager(0, 0, 0x1000, 128, 0x26);  // in INIT nobody empties it
  probe.write(0, 0x1000, std::vector<std::uint8_t>(128));
  ASSERT_TRUE(full());
  probe.set_sync_manager(0, 0, 0x1000, 128, 0x26);
  EXPECT_FALSE(full());
}

// ---- distributed clocks ---------------------------------------------------------------------------

TEST(SimLatch, OnlyBwrAndFpwrLatchThePorts) {
  SimProbe probe(line({sim_slave("SL-1100"), sim_slave("SL-1100")}));
  probe.write(0, reg::kStationAddress, {0xE9, 0x03});
  const auto port0 = [&probe] { return probe.read(0, reg::kReceiveTimePort0, 4).value<std::uint32_t>(); };
  const auto unit = [&probe] { return probe.read(0, reg::kReceiveTimeProcessingUnit, 8).value<std::uint64_t>(); };
  broadcast(probe, reg::kReceiveTimePort0, {0, 0, 0, 0});
  auto latched = port0();
  EXPECT_EQ(static_cast<std::uint32_t>(unit()), latched) << "the entry port is where the processing unit is";

  const auto unit_before = unit();
  EXPECT_EQ(probe.write(0, reg::kReceiveTimePort0, {0, 0, 0, 0}).wkc, 1) << "APWR counts";
  EXPECT_EQ(port0(), latched) << "but does not latch the ports";
  EXPECT_GT(unit(), unit_before) << "any write latches the processing unit's time";

  EXPECT_EQ(probe.send(Command::kFpwr, device_address(1001, reg::kReceiveTimePort0), {0, 0, 0, 0}).wkc, 1);
  EXPECT_NE(port0(), latched);
  latched = port0();
  EXPECT_EQ(probe.send(Command::kFprw, device_address(1001, reg::kReceiveTimePort0), {0, 0, 0, 0}).wkc, 3);
  EXPECT_EQ(port0(), latched);
}

TEST(SimLatch, PortsThatWereNotPassedShowGarbageThatTheSeedRepeats) {
  const auto latched = [](std::uint64_t seed) {
    auto config = line({sim_slave("SL-1100"), sim_slave("SL-1100")});
    config.seed = seed;
    SimProbe probe(config);
    broadcast(probe, reg::kReceiveTimePort0, {0, 0, 0, 0});
    return probe.read(1, reg::kReceiveTimePort0, 16).data;
  };
  const auto times = latched(1);
  const auto others = latched(2);
  for (std::size_t port = 1; port < 4; ++port) {
    EXPECT_GT(load_le<std::uint32_t>(std::span(times).subspan(4 * port)), 0U) << port;
    EXPECT_FALSE(std::ranges::equal(std::span(times).subspan(4 * port, 4), std::span(others).subspan(4 * port, 4)));
  }
  EXPECT_EQ(times, latched(1));
}

TEST(SimSync, ACycleOfZeroIsASingleShot) {
  SimProbe probe(line({sim_slave("SL-SV7", "servo-y")}));
  const auto start = probe.read(0, reg::kSystemTime, 8).value<std::uint64_t>() + 5 * kMillisecond;
  const auto pending = [&probe] { return probe.read(0, reg::kActivationStatus, 1).data[0] & 1; };
  probe.write(0, reg::kSync0CycleTime, le_bytes(std::uint32_t{0}));
  probe.write(0, reg::kStartTimeCyclicOperation, le_bytes(start));
  probe.write(0, reg::kCyclicUnitControl, {0x00, 0x03});
  EXPECT_EQ(pending(), 1);
  probe.pass(10 * kMillisecond);
  EXPECT_EQ(pending(), 0) << "it has fired";
  EXPECT_EQ(probe.read(0, reg::kStartTimeCyclicOperation, 8).value<std::uint64_t>(), start)
      << "and there is no next one";
}

class SimLateStart : public testing::TestWithParam<bool> {};

TEST_P(SimLateStart, AStartTimeThatHasPassedFiresOnlyWhenTheCounterComesRound) {
  const bool wide = GetParam();
  auto slave = sim_slave("SL-SV7", "servo-y");
  slave.dc.is_64bit = wide;
  slave.oscillator.start_offset = 100 * kMillisecond;
  SimProbe probe(line({slave}));
  const auto now = probe.read(0, reg::kSystemTime, 4).value<std::uint32_t>();
  probe.write(0, reg::kSync0CycleTime, le_bytes(std::uint32_t{1'000'000}));
  const std::uint64_t start = now - kMillisecond;
  probe.write(0, reg::kStartTimeCyclicOperation, wide ? le_bytes(start) : le_bytes(static_cast<std::uint32_t>(start)));
  probe.write(0, reg::kCyclicUnitControl, {0x00, 0x03});
  const auto pending = [&probe] { return (probe.read(0, reg::kActivationStatus, 1).data[0] & 1) != 0; };
  EXPECT_TRUE(pending());
  probe.pass(100 * kMillisecond);
  EXPECT_TRUE(pending());
  probe.pass(4'100 * kMillisecond);  // 4.295 s is the period of 32 bit
  EXPECT_TRUE(pending());
  probe.pass(100 * kMillisecond);
  EXPECT_EQ(pending(), wide) << "32 bit have come round, 64 bit take 584 years";
}
INSTANTIATE_TEST_SUITE_P(Widths, SimLateStart, testing::Bool());

TEST(SimSync, CycleTimesAreLockedWhileTheUnitRuns) {
  SimProbe probe(line({sim_slave("SL-SV7", "servo-y")}));
  const auto now = probe.read(0, reg::kSystemTime, 8).value<std::uint64_t>();
  const auto start = now + 5 * kMillisecond;
  probe.write(0, reg::kSync0CycleTime, le_bytes(std::uint32_t{1'000'000}));
  probe.write(0, reg::kStartTimeCyclicOperation, le_bytes(start));
  probe.write(0, reg::kCyclicUnitControl, {0x00, 0x03});
  probe.write(0, reg::kSync0CycleTime, le_bytes(std::uint32_t{250'000}));
  probe.write(0, reg::kStartTimeCyclicOperation, le_bytes(start + 77));
  EXPECT_EQ(probe.read(0, reg::kSync0CycleTime, 4).value<std::uint32_t>(), 1'000'000U);
  EXPECT_EQ(probe.read(0, reg::kStartTimeCyclicOperation, 8).value<std::uint64_t>(), start);
  probe.pass(20 * kMillisecond);
  const auto next = probe.read(0, reg::kStartTimeCyclicOperation, 8).value<std::uint64_t>();
  EXPECT_EQ((next - start) % 1'000'000, 0U) << "the grid is the one that was started";
  EXPECT_GT(next, start + 14 * kMillisecond);
}

// ---- data link -----------------------------------------------------------------------------------

TEST(SimDataLink, ACutCableIsCountedAndReportedWhereItHappened) {
  auto config = line({sim_slave("SL-1100"), sim_slave("SL-2002"), sim_slave("SL-1002")});
  config.faults.push_back({FaultKind::kCableBreak, 2, 20 * kMillisecond, 30 * kMillisecond});
  SimProbe probe(config);
  const auto event = [&probe] { return probe.send(Command::kBrd, device_address(0, reg::kType), {0}).irq; };
  const auto lost = [&probe](std::uint16_t i) { return probe.read(i, reg::kLostLinkCounter, 4).data; };
  broadcast(probe, reg::kEcatEventMask, {0x04, 0x00});
  for (std::uint16_t i = 0; i < 3; ++i) probe.read(i, reg::kDlStatus, 2);
  EXPECT_EQ(event(), 0) << "reading 0x0110 acknowledges";
  probe.pass(21 * kMillisecond);
  EXPECT_EQ(event(), 4);
  EXPECT_THAT(lost(0), ElementsAre(0, 0, 0, 0)) << "nothing happened at the first slave";
  EXPECT_THAT(lost(1), ElementsAre(0, 1, 0, 0));
  probe.read(1, reg::kDlStatus, 2);
  EXPECT_EQ(event(), 0);
  probe.pass(10 * kMillisecond);
  EXPECT_EQ(event(), 4) << "the link is back";
  EXPECT_THAT(lost(1), ElementsAre(0, 1, 0, 0));
  EXPECT_THAT(lost(2), ElementsAre(1, 0, 0, 0)) << "the other end lost it, too";
  probe.write(1, reg::kLostLinkCounter, {0});
  EXPECT_THAT(lost(1), ElementsAre(0, 0, 0, 0)) << "any write clears all";
}

TEST(SimDataLink, OneReadOfBothStatusRegistersAcknowledgesBoth) {
  SimProbe probe(line({sim_slave("SL-SV7", "servo-y")}));
  probe.request(0, 8);  // refused: AL status changes
  EXPECT_EQ(probe.read(0, reg::kEcatEventRequest, 2).value<std::uint16_t>() & 0x08, 0);
  probe.write(0, reg::kAlControl, {0x11, 0});
  probe.pass(kMillisecond);
  EXPECT_EQ(probe.read(0, reg::kEcatEventRequest, 2).value<std::uint16_t>() & 0x0C, 0x0C);
  probe.read(0, reg::kDlStatus, 0x22);
  EXPECT_EQ(probe.read(0, reg::kEcatEventRequest, 2).value<std::uint16_t>() & 0x0C, 0);
}

// ---- SyncManagers and FMMUs ------------------------------------------------------------------------

TEST(SimSyncManager, ATransferStartsAtTheFirstByteAndEndsAtTheLast) {
  SimProbe probe(line({sim_slave("SL-SV7", "servo-y")}));
  probe.set_sync_manager(0, 0, 0x1000, 128, 0x26);
  const auto full = [&probe] { return (probe.read(0, 0x0805, 1).data[0] & 0x08) != 0; };
  EXPECT_EQ(probe.write(0, 0x1040, std::vector<std::uint8_t>(64)).wkc, 0) << "not begun";
  EXPECT_FALSE(full());
  EXPECT_EQ(probe.write(0, 0x1000, std::vector<std::uint8_t>(16)).wkc, 1);
  EXPECT_FALSE(full());
  EXPECT_EQ(probe.write(0, 0x107F, {0}).wkc, 1) << "begun, so the last byte may come alone";
  EXPECT_TRUE(full());
}

TEST(SimFmmu, AlignedAndShiftedMappingsMoveTheSameBits) {
  for (const std::uint8_t shift : {std::uint8_t{0}, std::uint8_t{3}}) {
    SimProbe probe(line({sim_slave("SL-SV7", "servo-y")}));
    Fmmu out;
    out.logical_start = 0x2000;
    out.length = static_cast<std::uint16_t>(shift == 0 ? 5 : 6);
    out.logical_start_bit = shift;
    out.logical_stop_bit = static_cast<std::uint8_t>((shift + 7) % 8);
    out.physical_start = 0x1800;
    out.write = out.active = true;
    auto in = out;
    in.write = false;
    in.read = true;
    in.physical_start = 0x1900;
    const auto out_image = out.encode();
    const auto in_image = in.encode();
    probe.write(0, reg::fmmu(0), {out_image.begin(), out_image.end()});
    probe.write(0, reg::fmmu(1), {in_image.begin(), in_image.end()});
    probe.write(0, 0x1900, {0x11, 0x22, 0x33, 0x44, 0x55});
    // The datagram covers a byte before and a byte behind the mapping.
    const std::uint64_t value = 0xA1B2'C3D4'E5U;
    std::vector<std::uint8_t> data(8, 0xFF);
    for (unsigned bit = 0; bit < 40; ++bit) {
      const auto mask = static_cast<std::uint8_t>(1U << ((bit + shift) % 8));
      if (((value >> bit) & 1U) == 0) data[1 + (bit + shift) / 8] &= static_cast<std::uint8_t>(~mask);
    }
    const auto reply = probe.send(Command::kLrw, 0x1FFF, data);
    EXPECT_EQ(reply.wkc, 3);
    EXPECT_THAT(probe.bus->peek(0, 0x1800, 5), ElementsAre(0xE5, 0xD4, 0xC3, 0xB2, 0xA1));
    std::uint64_t read = 0;
    for (unsigned bit = 0; bit < 40; ++bit) {
      read |= static_cast<std::uint64_t>((reply.data[1 + (bit + shift) / 8] >> ((bit + shift) % 8)) & 1U) << bit;
    }
    EXPECT_EQ(read, 0x55'4433'2211U);
    EXPECT_EQ(reply.data[0], 0xFF) << "bytes that are not mapped stay";
    EXPECT_EQ(reply.data[7], 0xFF);
  }
}

// ---- AL state machine ------------------------------------------------------------------------------

TEST(SimAlState, ProcessDataAtTheWrongPlaceIsAnInvalidSyncManager) {
  SimProbe probe(line({sim_slave("SL-SV7", "servo-y")}));
  probe.set_sync_manager(0, 0, 0x1000, 128, 0x26);
  probe.set_sync_manager(0, 1, 0x1080, 128, 0x22);
  ASSERT_EQ(probe.request(0, 2), 2);
  probe.set_sync_manager(0, 2, 0x1180, 16, 0x64);
  probe.set_sync_manager(0, 3, 0x1400, 20, 0x20);
  EXPECT_EQ(probe.request(0, 4), 0x12);
  EXPECT_EQ(probe.al_code(0), 0x0017) << "start address";
  ASSERT_EQ(probe.request(0, 0x12), 2);
  probe.set_sync_manager(0, 2, 0x1100, 16, 0x60);
  EXPECT_EQ(probe.request(0, 4), 0x12);
  EXPECT_EQ(probe.al_code(0), 0x0017) << "direction";
  ASSERT_EQ(probe.request(0, 0x12), 2);
  probe.set_sync_manager(0, 2, 0x1100, 16, 0x64);
  EXPECT_EQ(probe.request(0, 4), 4);
}

}  // namespace
}  // namespace syncline::test
