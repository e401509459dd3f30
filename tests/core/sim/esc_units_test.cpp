// SPDX-License-Identifier: Apache-2.0
// The small units of an ESC, each with nothing but its registers.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "protocol/registers.h"
#include "sim/esc/al_registers.h"
#include "sim/esc/event_requests.h"
#include "sim/esc/frame_writes.h"
#include "sim/esc/pdi_watchdog.h"
#include "sim/esc/process_data_watchdog.h"
#include "sim/esc/reset_sequence.h"
#include "sim/esc/station_addresses.h"
#include "sim/registers/esc_memory.h"

namespace syncline::sim {
namespace {

class EscUnit : public testing::Test {
 protected:
  EscMemory memory_{0x1000};
};

TEST_F(EscUnit, EventRequestsSayWhetherTheyAreOthersThanBefore) {
  EventRequests requests(memory_);
  requests.implement_registers();
  EXPECT_TRUE(requests.none_is_told());
  EXPECT_TRUE(requests.raise(0x0004));
  EXPECT_FALSE(requests.raise(0x0004));
  EXPECT_TRUE(requests.raise(0x000C)) << "one of them is new";
  EXPECT_EQ(memory_.u16(0x0210), 0x000C);
  EXPECT_EQ(requests.told(), 0) << "masked";
  memory_.set<std::uint16_t>(0x0200, 0x0008);
  EXPECT_FALSE(requests.none_is_told());
  EXPECT_EQ(requests.told(), 0x0008);
  EXPECT_TRUE(requests.clear(0x0008));
  EXPECT_FALSE(requests.clear(0x0008));
  EXPECT_EQ(requests.requested(), 0x0004);
}

TEST_F(EscUnit, ThePdiAcknowledgesItsOwnRequests) {
  EventRequests requests(memory_);
  requests.raise_al(0x0103);
  requests.acknowledge_al(0x0002);
  EXPECT_EQ(requests.al_requested(), 0x0101U);
  EXPECT_EQ(memory_.u16(0x0210), 0) << "the master has others";
  EXPECT_EQ(memory_.u32(0x0220), 0x0101U);
}

TEST_F(EscUnit, AStationHasItsAliasWhenThatIsSwitchedOn) {
  StationAddresses addresses(memory_);
  addresses.implement_registers();
  memory_.set<std::uint16_t>(0x0010, 1001);
  memory_.set<std::uint16_t>(0x0012, 77);
  EXPECT_TRUE(addresses.has(1001));
  EXPECT_FALSE(addresses.has(77));
  EXPECT_EQ(addresses.of(1).station, 1001U);
  EXPECT_EQ(addresses.of(1).alias, PassingFrame::kNoStation);
  memory_.set<std::uint8_t>(0x0103, 0x01);
  EXPECT_TRUE(addresses.has(77));
  EXPECT_EQ(addresses.of(1).alias, PassingFrame::kNoStation) << "of these settings";
  EXPECT_EQ(addresses.of(2).alias, 77U);
}

TEST_F(EscUnit, WritesStandInTheirOrderUntilTheEndOfTheFrame) {
  FrameWrites writes;
  EXPECT_TRUE(writes.empty());
  writes.add(0x0910, std::array<std::uint8_t, 8>{1, 2, 3, 4, 5, 6, 7, 8});
  EXPECT_TRUE(writes.only_system_time());
  writes.add(0x0120, std::array<std::uint8_t, 2>{9, 10});
  EXPECT_FALSE(writes.only_system_time());
  std::vector<std::vector<std::uint8_t>> seen;
  std::vector<std::uint16_t> places;
  writes.for_each([&](const FrameWrites::Write& write, std::span<const std::uint8_t> bytes) {
    places.push_back(write.address);
    seen.emplace_back(bytes.begin(), bytes.end());
  });
  EXPECT_EQ(places, (std::vector<std::uint16_t>{0x0910, 0x0120}));
  EXPECT_EQ(seen, (std::vector<std::vector<std::uint8_t>>{{1, 2, 3, 4, 5, 6, 7, 8}, {9, 10}}));
  writes.clear();
  EXPECT_TRUE(writes.empty());
  writes.add(0x0400, std::array<std::uint8_t, 1>{11});
  writes.for_each([&](const FrameWrites::Write&, std::span<const std::uint8_t> bytes) { EXPECT_EQ(bytes[0], 11); });
}

TEST_F(EscUnit, ASystemTimeThatReachesFurtherIsMoreThanThat) {
  FrameWrites writes;
  writes.add(0x0914, std::array<std::uint8_t, 8>{});
  EXPECT_FALSE(writes.only_system_time());
}

TEST_F(EscUnit, TheAlStateIsInitAtPowerOnAndThenWhatTheDeviceSays) {
  AlRegisters al(memory_);
  al.implement_registers();
  EXPECT_EQ(al.control(), 1);
  EXPECT_EQ(al.status(), 1);
  EXPECT_EQ(memory_.rights(0x0130), EscMemory::kRead);
  al.set_status(0x0012);
  al.set_code(0x001D);
  EXPECT_EQ(memory_.u16(0x0130), 0x0012);
  EXPECT_EQ(memory_.u16(0x0134), 0x001D);
  EXPECT_EQ(al.control(), 1) << "the master's";
}

TEST_F(EscUnit, BothWatchdogsExpireOnceWhenTheirTimeIsOver) {
  memory_.set<std::uint16_t>(0x0400, 2498);  // 100 us
  memory_.set<std::uint16_t>(0x0440, 1);
  memory_.set<std::uint16_t>(0x0110, 0x0002);
  ProcessDataWatchdog outputs(memory_);
  outputs.implement_registers();
  PdiWatchdog pdi(memory_);
  pdi.implement_registers();
  outputs.trigger(0);
  pdi.pdi_stops(0);
  EXPECT_EQ(outputs.deadline(), 100 * kMillisecond);
  EXPECT_FALSE(outputs.advance_to(99 * kMillisecond));
  EXPECT_TRUE(outputs.advance_to(100 * kMillisecond));
  EXPECT_FALSE(outputs.advance_to(200 * kMillisecond));
  EXPECT_EQ(memory_.u16(0x0440), 0);
  EXPECT_EQ(memory_.u8(0x0442), 1);
  EXPECT_TRUE(pdi.advance_to(100 * kMillisecond));
  EXPECT_EQ(memory_.u8(0x0443), 1);
  EXPECT_EQ(memory_.u16(0x0110) & 0x0002, 0);
  EXPECT_TRUE(pdi.pdi_works());
  EXPECT_EQ(memory_.u16(0x0110) & 0x0002, 0x0002);
}

TEST_F(EscUnit, AResetNeedsItsThreeLettersInThreeFrames) {
  ResetSequence reset(memory_);
  reset.implement_registers();
  EXPECT_EQ(memory_.rights(0x0040), EscMemory::kReadWrite);
  for (const char letter : std::string("RES")) {
    EXPECT_FALSE(reset.complete());
    memory_.set<std::uint8_t>(0x0040, static_cast<std::uint8_t>(letter));
    reset.end_of_frame(true);
    EXPECT_TRUE(reset.begun());
  }
  EXPECT_TRUE(reset.complete());
}

TEST_F(EscUnit, AFrameBetweenTheLettersEndsTheReset) {
  ResetSequence reset(memory_);
  memory_.set<std::uint8_t>(0x0040, 'R');
  reset.end_of_frame(true);
  reset.end_of_frame(false);
  EXPECT_FALSE(reset.begun());
}

TEST_F(EscUnit, MemoryKnowsWhatIsThere) {
  memory_.implement(0x0100, 4, EscMemory::kRead);
  EXPECT_TRUE(memory_.is_readable(0x0100, 4));
  EXPECT_FALSE(memory_.is_readable(0x0100, 5));
  EXPECT_FALSE(memory_.is_readable(0x0100, 0));
  EXPECT_TRUE(memory_.any_have(EscMemory::kRead, 0x00FC, 5));
  EXPECT_FALSE(memory_.any_have(EscMemory::kWrite, 0x0100, 4));
  EXPECT_TRUE(memory_.is_readable(0x1000, 0x1000));
  EXPECT_FALSE(memory_.is_readable(0x1000, 0x1001));
}

}  // namespace
}  // namespace syncline::sim
