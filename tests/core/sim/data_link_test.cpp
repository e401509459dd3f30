// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/dl_status.h"
#include "sim/esc/esc.h"
#include "tests/core/sim/sim_probe.h"

/// Loop control, DL status, forwarding rule, ESC reset and error counters (ESC data sheet I, 3.2 and 14).
namespace syncline::test {
namespace {

using testing::ElementsAre;

SimConfig three() { return line({sim_slave("SL-1100"), sim_slave("SL-2002"), sim_slave("SL-1002")}); }
std::uint16_t slaves_on(SimProbe& probe) { return probe.send(Command::kBrd, device_address(0, reg::kType), {0}).wkc; }
DlStatus dl_status(SimProbe& probe, std::uint16_t position) {
  return DlStatus{probe.read(position, reg::kDlStatus, 2).value<std::uint16_t>()};
}
constexpr std::uint8_t kAutoCloseB = 0x04, kOpenB = 0x08, kClosedB = 0x0C, kAutoCloseA = 0x01, kClosedA = 0x03;

TEST(SimLoopControl, AClosedPortIsNotPassed) {
  SimProbe probe(three());
  ASSERT_EQ(slaves_on(probe), 3);
  EXPECT_TRUE(dl_status(probe, 1).active(1));
  probe.write(1, reg::kDlControlLoop, {kClosedB});
  EXPECT_EQ(slaves_on(probe), 2);
  const auto closed = dl_status(probe, 1);
  EXPECT_TRUE(closed.loop_closed(1));
  EXPECT_FALSE(closed.communication(1));
  EXPECT_TRUE(closed.physical_link(1)) << "the cable is still there";
  EXPECT_THAT(probe.read(1, reg::kLostLinkCounter, 4).data, ElementsAre(0, 0, 0, 0));
  probe.write(1, reg::kDlControlLoop, {0});
  EXPECT_EQ(slaves_on(probe), 3);
  EXPECT_EQ(dl_status(probe, 1).value, 0x5A33) << "as on hardware with two ports in use";
}

TEST(SimLoopControl, APortHeldOpenWithoutALinkSwallowsFramesBehindItsSlave) {
  SimProbe probe(three());
  probe.write(2, reg::kDlControlLoop, {kOpenB});
  EXPECT_TRUE(probe.send(Command::kBwr, device_address(0, reg::kStationAddress), {0x77, 0x00}).lost);
  EXPECT_THAT(probe.bus->peek(2, reg::kStationAddress, 2), ElementsAre(0x77, 0x00)) << "the slaves have executed it";
  EXPECT_EQ(DlStatus{load_le<std::uint16_t>(probe.bus->peek(2, reg::kDlStatus, 2))}.value & 0x0C20, 0)
      << "open, no link";
}

TEST(SimLoopControl, ATemporarySettingEndsAfterASecond) {
  SimProbe probe(three());
  probe.write(0, reg::kDlControl, {0x03, kClosedB, 0x07, 0x00});
  EXPECT_EQ(slaves_on(probe), 1);
  probe.pass(990 * kMillisecond);
  EXPECT_EQ(slaves_on(probe), 1);
  probe.pass(20 * kMillisecond);
  EXPECT_EQ(slaves_on(probe), 3);
}

TEST(SimLoopControl, AutoCloseWaitsForTheMasterWhenTheLinkIsBack) {
  auto config = three();
  config.faults.push_back({FaultKind::kCableBreak, 2, 10 * kMillisecond, 20 * kMillisecond});
  SimProbe probe(config);
  probe.write(1, reg::kDlControlLoop, {kAutoCloseB});
  ASSERT_EQ(slaves_on(probe), 3) << "the link is there, so writing it opens the port";
  probe.pass(30 * kMillisecond);
  EXPECT_EQ(slaves_on(probe), 2);
  EXPECT_TRUE(dl_status(probe, 1).physical_link(1));
  EXPECT_TRUE(dl_status(probe, 1).loop_closed(1));
  EXPECT_EQ(probe.read(1, reg::kLostLinkCounter, 4).data[1], 1);
  probe.write(1, reg::kDlControlLoop, {kAutoCloseB});
  EXPECT_EQ(slaves_on(probe), 3);
}

TEST(SimLoopControl, AutoCloseOpensForAValidFrameFromOutside) {
  auto config = three();
  config.faults.push_back({FaultKind::kCableBreak, 2, 10 * kMillisecond, 20 * kMillisecond});
  SimProbe probe(config);
  probe.write(2, reg::kDlControlLoop, {kAutoCloseA});
  ASSERT_EQ(slaves_on(probe), 3);
  probe.pass(15 * kMillisecond);
  EXPECT_EQ(slaves_on(probe), 2);
  probe.pass(15 * kMillisecond);
  EXPECT_TRUE(probe.send(Command::kNop, 0, {0}).lost) << "this frame comes to the closed port";
  EXPECT_EQ(slaves_on(probe), 3) << "and opens it for the next";
}

TEST(SimLoopControl, AClosedEntrySwallowsWhatTheMasterSends) {
  SimProbe probe(three());
  probe.write(1, reg::kDlControl, {0x03, kClosedA, 0x07, 0x00});
  EXPECT_TRUE(probe.send(Command::kNop, 0, {0}).lost);
  EXPECT_TRUE(probe.send(Command::kNop, 0, {0}).lost) << "a frame does not open it";
  probe.pass(1'010 * kMillisecond);
  EXPECT_EQ(slaves_on(probe), 3) << "closed for a while only: otherwise a power cycle would be the way out";
}

TEST(SimForwarding, TheSourceAddressIsMarkedByTheRuleOnly) {
  SimProbe probe(three());
  EXPECT_EQ(probe.send(Command::kNop, 0, {0}).source_mac0, 0x02);
  probe.send(Command::kBwr, device_address(0, reg::kDlControl), {0x00});
  EXPECT_EQ(probe.send(Command::kNop, 0, {0}).source_mac0, 0x00);
  probe.write(2, reg::kDlControl, {0x01});
  EXPECT_EQ(probe.send(Command::kNop, 0, {0}).source_mac0, 0x02);
}

TEST(SimForwarding, ForeignFramesAreDestroyedAndCountedUnlessTheRuleIsOff) {
  SimProbe probe(three());
  std::vector<std::uint8_t> foreign(60, 0x55);
  EXPECT_TRUE(probe.bus->execute(foreign, probe.now).lost);
  const auto errors = [&probe](std::uint16_t i) { return probe.read(i, reg::kProcessingUnitErrorCounter, 1).data[0]; };
  EXPECT_EQ(errors(0), 1);
  EXPECT_EQ(errors(1), 0) << "it does not get that far";
  EXPECT_EQ(probe.read(1, reg::kForwardedErrorCounter, 1).data[0], 1) << "only the marked rest of it does";
  probe.write(0, reg::kProcessingUnitErrorCounter, {0});
  EXPECT_EQ(errors(0), 0);
  EXPECT_EQ(probe.read(1, reg::kForwardedErrorCounter, 1).data[0], 1) << "counters are cleared slave by slave";
  probe.send(Command::kBwr, device_address(0, reg::kDlControl), {0x00});
  const auto returned = probe.bus->execute(foreign, probe.now);
  EXPECT_FALSE(returned.lost);
  EXPECT_THAT(foreign, testing::Each(0x55));
  const auto sent = probe.now;
  probe.send(Command::kNop, 0, std::vector<std::uint8_t>(32));  // as long, and ours
  EXPECT_EQ(returned.arrival_time, probe.arrival) << "from " << sent;
}

TEST(SimForwarding, TheAliasAnswersOnlyWhereItIsEnabled) {
  auto config = three();
  config.slaves[1].alias = 0x0456;
  SimProbe probe(config);
  EXPECT_EQ(probe.read(1, reg::kStationAlias, 2).value<std::uint16_t>(), 0x0456);
  const auto by_alias = [&probe] { return probe.send(Command::kFprd, device_address(0x0456, reg::kType), {0}).wkc; };
  EXPECT_EQ(by_alias(), 0);
  probe.send(Command::kBwr, device_address(0, reg::kDlControlAlias), {0x01});
  EXPECT_EQ(by_alias(), 1);
}

/// Port 0 without a link: only a segment that has lost its master sees that.
TEST(SimForwarding, ACirculatingFrameDiesAtItsSecondTurn) {
  SimSlaveConfig config;
  sim::Esc esc(config, {}, {}, 0, 1);
  esc.ports().set_link(1, true);
  FrameBuilder builder;
  builder.add_zeros(Command::kBrd, 1, device_address(0, reg::kType), 1);
  const auto sent = builder.finish();
  std::vector<std::uint8_t> frame(sent.begin(), sent.end());
  const auto pass = [&] {
    sim::PassingFrame passing;
    EXPECT_EQ(passing.arrive(frame), sim::PassingFrame::Kind::kEtherCat);
    const bool passed = esc.process(passing, 1000);
    passing.leave();
    return passed;
  };
  EXPECT_TRUE(pass());
  FrameReader reader(frame);
  const auto marked = reader.next();
  EXPECT_TRUE(marked->header.circulating);
  EXPECT_EQ(marked->wkc(), 1);
  EXPECT_FALSE(pass());
  EXPECT_EQ(esc.memory().u8(reg::kProcessingUnitErrorCounter), 1);
  esc.ports().set_link(0, true);
  EXPECT_TRUE(pass()) << "where the master is, the bit means nothing";
}

TEST(SimReset, NeedsThreeFramesInARow) {
  SimProbe probe(three());
  const auto address = [&probe] { return probe.read(1, reg::kStationAddress, 2).value<std::uint16_t>(); };
  probe.write(1, reg::kStationAddress, {0xE9, 0x03});
  for (const char letter : {'R', 'E'}) probe.write(1, reg::kEscReset, {static_cast<std::uint8_t>(letter)});
  EXPECT_EQ(probe.read(1, reg::kEscReset, 1).data[0], 2) << "how far it is";
  probe.write(1, reg::kEscReset, {'S'});
  EXPECT_EQ(address(), 0x03E9) << "a frame came between";
  for (const char letter : {'R', 'E', 'S'}) probe.write(1, reg::kEscReset, {static_cast<std::uint8_t>(letter)});
  EXPECT_EQ(address(), 0);
  EXPECT_EQ(slaves_on(probe), 3);
  EXPECT_EQ(probe.read(0, reg::kStationAddress, 2).wkc, 1);
}

TEST(SimLineFaults, ABurstIsCountedWhereItHitsAndForwardedBehind) {
  auto config = three();
  FaultConfig fault{FaultKind::kBitErrors, 1, 0, 0, 3};
  config.faults.push_back(fault);
  SimProbe probe(config);
  for (std::uint8_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(probe.send(Command::kBwr, device_address(0, reg::kWatchdogPdi), {i, 0x07}).lost);
  }
  EXPECT_THAT(probe.read(0, reg::kWatchdogPdi, 2).data, ElementsAre(2, 7)) << "here the frames were still good";
  EXPECT_THAT(probe.read(1, reg::kWatchdogPdi, 2).data, ElementsAre(0xE8, 3)) << "here they were not";
  EXPECT_THAT(probe.read(2, reg::kWatchdogPdi, 2).data, ElementsAre(0xE8, 3));
  EXPECT_THAT(probe.read(0, reg::kRxErrorCounter, 12).data, ElementsAre(0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0))
      << "they come back through port 1 as damaged before";
  EXPECT_THAT(probe.read(1, reg::kRxErrorCounter, 12).data, ElementsAre(3, 3, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0));
  EXPECT_THAT(probe.read(2, reg::kRxErrorCounter, 12).data, ElementsAre(0, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0));
  probe.write(1, 0x0307, {0});
  EXPECT_THAT(probe.read(1, reg::kRxErrorCounter, 12).data, testing::Each(0)) << "any write clears all";
}

TEST(SimLineFaults, OnTheWayBackTheSlavesHaveExecutedTheFrame) {
  auto config = three();
  FaultConfig fault{FaultKind::kBitErrors, 1, 0, kMillisecond};
  fault.port = 1;
  config.faults.push_back(fault);
  SimProbe probe(config);
  EXPECT_TRUE(probe.send(Command::kBwr, device_address(0, reg::kWatchdogPdi), {1, 2}).lost);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_THAT(probe.bus->peek(i, reg::kWatchdogPdi, 2), ElementsAre(1, 2));
  probe.pass(2 * kMillisecond);
  EXPECT_THAT(probe.read(1, reg::kRxErrorCounter, 8).data, ElementsAre(0, 0, 1, 1, 0, 0, 0, 0));
  EXPECT_EQ(slaves_on(probe), 3) << "the burst is over";
}

/// The length of the EtherCAT header is nothing that an ESC looks at (ESC data sheet I, 2.3): the datagrams' own count.
TEST(SimFrame, IsServedByItsDatagramsWhateverItsHeaderSays) {
  for (const std::uint16_t length : {std::uint16_t{0}, std::uint16_t{13}, std::uint16_t{15}, std::uint16_t{0x7FF}}) {
    SimProbe probe(three());
    FrameBuilder builder;
    builder.add(Command::kBrd, 1, device_address(0, reg::kType), std::vector<std::uint8_t>{0});
    const auto sent = builder.finish();
    std::vector<std::uint8_t> frame(sent.begin(), sent.end());
    store_le(std::span(frame).subspan(kEthernetHeaderSize), static_cast<std::uint16_t>(0x1000 | length));
    ASSERT_FALSE(probe.bus->execute(frame, probe.now).lost) << length;
    FrameReader reader(frame, FrameReader::LengthField::kIgnored);
    EXPECT_EQ(reader.next()->wkc(), 3) << length;
    EXPECT_EQ(load_le<std::uint16_t>(std::span(frame).subspan(kEthernetHeaderSize)), 0x1000 | length)
        << "left as it is";
  }
}

TEST(SimLineFaults, AFrameLostAtASlaveHasReachedThoseBefore) {
  auto config = three();
  config.faults.push_back({FaultKind::kLoseFrames, 1, 0, 0, 1});
  SimProbe probe(config);
  EXPECT_TRUE(probe.send(Command::kBwr, device_address(0, reg::kStationAddress), {9, 0}).lost);
  EXPECT_THAT(probe.bus->peek(0, reg::kStationAddress, 2), ElementsAre(9, 0));
  EXPECT_THAT(probe.bus->peek(1, reg::kStationAddress, 2), ElementsAre(0, 0));
  EXPECT_EQ(slaves_on(probe), 3);
}

/// Whatever is written (ESC data sheet II, 0x0300 to 0x0313).
TEST(SimLineFaults, AWriteClearsTheCountersOfItsGroup) {
  constexpr std::uint16_t kGroups[] = {reg::kRxErrorCounter, reg::kProcessingUnitErrorCounter, reg::kPdiErrorCounter,
                                       reg::kLostLinkCounter, reg::kWatchdogCounterProcessData};
  SimSlaveConfig config;
  sim::Esc esc(config, {}, {}, 0, 1);
  for (const auto counter : kGroups) esc.memory().set<std::uint8_t>(counter, 7);
  for (const auto counter : kGroups) {
    EXPECT_EQ(esc.memory().u8(counter), 7) << counter;
    FrameBuilder builder;
    std::vector<std::uint8_t> data{0x55};
    builder.add(Command::kBwr, 1, device_address(0, counter), data);
    const auto sent = builder.finish();
    std::vector<std::uint8_t> frame(sent.begin(), sent.end());
    sim::PassingFrame passing;
    ASSERT_EQ(passing.arrive(frame), sim::PassingFrame::Kind::kEtherCat);
    EXPECT_TRUE(esc.process(passing, 1000));
    passing.leave();
    esc.frame_end(2000);
    EXPECT_EQ(esc.memory().u8(counter), 0) << counter;
  }
}

TEST(SimLineFaults, CountersStopAtTheirEnd) {
  auto config = three();
  config.faults.push_back({FaultKind::kBitErrors, 2, 0, 0, 300});
  SimProbe probe(config);
  for (int i = 0; i < 300; ++i) EXPECT_TRUE(probe.send(Command::kNop, 0, {0}).lost);
  EXPECT_EQ(probe.read(2, reg::kRxErrorCounter, 1).data[0], 0xFF);
}

}  // namespace
}  // namespace syncline::test
