// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/evidence_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <span>
#include <tuple>
#include <vector>

#include "channels/master_channels.h"
#include "master/exchange/run_state.h"
#include "protocol/registers.h"
#include "tests/support/event_match.h"

namespace syncline {
namespace {

/// Two slaves, the second with a clock, and their registers.
class EvidenceReaderTest : public ::testing::Test {
 protected:
  NetworkConfig config;
  MasterChannels channels;
  std::unique_ptr<RunState> run;
  std::unique_ptr<EvidenceReader> reader;
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::uint8_t> registers;  // station, address
  Nanoseconds now = kSecond;
  std::size_t most_datagrams = 0;
  std::vector<std::tuple<std::uint16_t, std::uint16_t, std::size_t>> cleared;  // station, address, length

  void SetUp() override {
    config.slaves.resize(2);
    config.slaves[0].station_address = 1001;
    config.slaves[1].station_address = 1002;
    run = std::make_unique<RunState>(config, channels);
    run->snapshot.slaves.resize(2);
    for (auto& slave : run->snapshot.slaves) slave.present = true;
    run->snapshot.slaves[1].dc_enabled = true;
    reader = std::make_unique<EvidenceReader>(config, run->snapshot, run->teller);
  }
  void cycle(bool lost = false) {
    now += kMillisecond;
    PendingFrame frame;
    auto* asked = reader->next(now);
    if (asked != nullptr) frame.add(*asked);
    most_datagrams = std::max(most_datagrams, frame.datagrams().size());
    for (auto* datagram : frame.datagrams()) {
      const auto station = static_cast<std::uint16_t>(datagram->address & 0xFFFF);
      const auto address = static_cast<std::uint16_t>(datagram->address >> 16);
      if (datagram->command == Command::kFpwr) clear(station, address, datagram->data);
      for (std::size_t i = 0; i < datagram->data.size(); ++i) {
        datagram->data[i] = registers[{station, static_cast<std::uint16_t>(address + i)}];
      }
      datagram->answered = !lost;
      datagram->wkc = lost ? 0 : 1;
    }
    if (asked != nullptr) reader->take(now);
  }
  /// As it came in, unless its slave takes none.
  void clear(std::uint16_t station, std::uint16_t address, std::span<const std::uint8_t> data) {
    EXPECT_TRUE(std::ranges::all_of(data, [](std::uint8_t byte) { return byte == 0; }));
    cleared.push_back({station, address, data.size()});
    for (std::size_t i = 0; i < data.size(); ++i) registers[{station, static_cast<std::uint16_t>(address + i)}] = 0;
  }
  void sweep() {
    for (int i = 0; i < 5; ++i) cycle();
  }
  [[nodiscard]] const SlaveEvidence& evidence(std::size_t slave) const { return run->snapshot.slaves[slave].evidence; }
};

TEST_F(EvidenceReaderTest, AsksForOneThingACycle) {
  for (int i = 0; i < 50; ++i) cycle();
  EXPECT_EQ(most_datagrams, 1U);
  EXPECT_GT(evidence(0).ports_time, 0);
  EXPECT_TRUE(evidence(1).pdi_watchdog.valid());
  EXPECT_EQ(evidence(0).speed_counter_time, 0) << "it has no clock";
  EXPECT_GT(evidence(1).speed_counter_time, 0);
}

TEST_F(EvidenceReaderTest, CountsFromWhatItFindsAndTellsWhatComesOnTop) {
  registers[{1002, 0x0300}] = 7;
  sweep();
  EXPECT_EQ(evidence(1).ports[0].invalid_frames, 0U) << "before our time";
  registers[{1002, 0x0300}] = 9;
  registers[{1002, 0x0309}] = 4;  // forwarded, port B: somebody else's
  registers[{1002, 0x0311}] = 1;
  sweep();
  EXPECT_EQ(evidence(1).ports[0].invalid_frames, 2U);
  EXPECT_EQ(evidence(1).ports[1].forwarded_errors, 4U);
  EXPECT_EQ(evidence(1).ports[1].lost_links, 1U);
  const auto events = channels.events.drain();
  ASSERT_EQ(events.size(), 2U);
  ASSERT_TRUE(events[0].is<events::PortErrors>() && events[1].is<events::PortErrors>());
  EXPECT_EQ(events[0].slave, 1);
  EXPECT_EQ(events[0].as<events::PortErrors>()->port, 0);
  EXPECT_EQ(events[0].as<events::PortErrors>()->damaged_frames, 2U);
  EXPECT_EQ(events[1].as<events::PortErrors>()->port, 1);
  EXPECT_EQ(events[1].as<events::PortErrors>()->lost_links, 1U);
}

/// An invalid frame has receive errors in it; a receive error alone lies between two frames.
TEST_F(EvidenceReaderTest, DamagedFramesAreThoseOfThePortThatSawThem) {
  for (std::uint16_t port = 0; port < 4; ++port) {
    SCOPED_TRACE(port);
    sweep();
    (void)channels.events.drain();
    registers[{1001, static_cast<std::uint16_t>(0x0301 + 2 * port)}] = static_cast<std::uint8_t>(3 + port);
    sweep();
    const auto told = channels.events.drain();
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].as<events::PortErrors>()->port, port);
    EXPECT_EQ(told[0].as<events::PortErrors>()->damaged_frames, 3U + port);
  }
}

TEST_F(EvidenceReaderTest, SaysAtLeastWhereACounterStandsStill) {
  sweep();
  registers[{1001, 0x0302}] = 0xFF;
  sweep();
  EXPECT_TRUE(evidence(0).ports[1].at_least);
  EXPECT_FALSE(evidence(0).ports[0].at_least);
  EXPECT_FALSE(evidence(0).processing_unit_errors.at_least) << "of another register";
}

TEST_F(EvidenceReaderTest, SaysAtLeastOfTheProcessingUnitAndThePdiToo) {
  registers[{1001, 0x030C}] = 5;
  sweep();
  EXPECT_EQ(evidence(0).processing_unit_errors.total, 0U) << "before our time";
  registers[{1001, 0x030C}] = 0xFF;
  registers[{1001, 0x030D}] = 3;
  sweep();
  EXPECT_EQ(evidence(0).processing_unit_errors.total, 250U);
  EXPECT_TRUE(evidence(0).processing_unit_errors.at_least);
  EXPECT_EQ(evidence(0).pdi_errors.total, 3U);
  EXPECT_FALSE(evidence(0).pdi_errors.at_least);
  EXPECT_EQ(evidence(0).pdi_errors.time, evidence(0).ports_time);
  EXPECT_FALSE(evidence(1).pdi_errors.at_least);
}

/// It would count no more; what still counts stays as it is, for whoever else reads it.
TEST_F(EvidenceReaderTest, ClearsWhatHasComeToItsEndStopAndNothingElse) {
  for (const std::uint16_t address : {0x0300, 0x0309, 0x030D, 0x0310, 0x0442}) registers[{1002, address}] = 0xFE;
  registers[{1002, 0x030C}] = 0xFF;
  registers[{1001, 0x0442}] = 0xFF;
  for (int i = 0; i < 4; ++i) sweep();
  EXPECT_THAT(cleared, testing::UnorderedElementsAre(std::tuple(1002, 0x030C, 1), std::tuple(1001, 0x0442, 2)));
  EXPECT_EQ(evidence(1).processing_unit_errors.total, 0U) << "before our time";
  EXPECT_TRUE(evidence(1).processing_unit_errors.at_least);
  registers[{1002, 0x030C}] = 4;
  sweep();
  EXPECT_EQ(evidence(1).processing_unit_errors.total, 4U);
  EXPECT_FALSE(evidence(1).pdi_errors.at_least);
  EXPECT_FALSE(evidence(1).ports[0].at_least);
  EXPECT_TRUE(evidence(0).process_data_watchdog.at_least);
}

TEST_F(EvidenceReaderTest, ClearsAllPlacesOneAfterTheOther) {
  for (const std::uint16_t address : {0x0307, 0x030C, 0x030D, 0x0313, 0x0443}) registers[{1001, address}] = 0xFF;
  for (int i = 0; i < 8; ++i) sweep();
  EXPECT_THAT(cleared, testing::UnorderedElementsAre(std::tuple(1001, 0x0300, 12), std::tuple(1001, 0x030C, 1),
                                                     std::tuple(1001, 0x030D, 1), std::tuple(1001, 0x0310, 4),
                                                     std::tuple(1001, 0x0442, 2)));
  registers[{1001, 0x0307}] = 2;
  sweep();
  sweep();
  EXPECT_EQ(evidence(0).ports[3].receive_errors, 2U);
}

TEST_F(EvidenceReaderTest, TellsOfWatchdogs) {
  sweep();
  registers[{1001, reg::kWatchdogCounterPdi}] = 1;
  sweep();
  EXPECT_EQ(evidence(0).pdi_watchdog.total, 1U);
  const auto events = channels.events.drain();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_TRUE(test::with(&events::WatchdogExpired::which, events::WatchdogExpired::Which::kPdi)(events[0]));
}

TEST_F(EvidenceReaderTest, AsksAgainForWhatWasLost) {
  cycle(true);
  EXPECT_EQ(evidence(0).ports_time, 0);
  cycle();
  EXPECT_GT(evidence(0).ports_time, 0);
}

TEST_F(EvidenceReaderTest, AsksNobodyWhoIsNotThere) {
  for (auto& slave : run->snapshot.slaves) slave.present = false;
  cycle();
  EXPECT_EQ(most_datagrams, 0U);
}

}  // namespace
}  // namespace syncline
