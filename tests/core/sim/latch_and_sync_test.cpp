// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "sim/esc/esc.h"
#include "tests/core/sim/sim_probe.h"

/// Latch units and SYNC signals of an ESC: registers 0x0980 to 0x09CF.
namespace syncline::test {
namespace {

using testing::ElementsAre;

constexpr std::array<std::uint8_t, 6> kNoMac{};

class SimLatchUnit : public testing::Test {
 protected:
  SimLatchUnit() : probe(line({sim_slave("SL-SV7", "servo-y")})) { probe.write(0, reg::kEcatEventMask, {0x01, 0x00}); }

  /// The level at LATCH0 after a millisecond; the time that the slave's clock shows then.
  std::uint64_t edge(bool level, unsigned number = 0) {
    probe.pass(kMillisecond);
    probe.bus->latch_input(0, number, level);
    return probe.bus->system_time(0);
  }
  std::uint64_t time(std::uint16_t ado) { return probe.read(0, ado, 8).value<std::uint64_t>(); }
  unsigned status(std::uint16_t ado = reg::kLatch0Status) { return probe.read(0, ado, 1).data[0]; }
  bool event() { return (probe.read(0, reg::kType, 1).irq & 0x01) != 0; }

  SimProbe probe;
};

TEST_F(SimLatchUnit, EachEdgeHasItsTimeAndReadingAcknowledgesIt) {
  EXPECT_FALSE(event());
  const auto rise = edge(true);
  EXPECT_EQ(status(), 0x05U) << "positive event, pin high";
  EXPECT_TRUE(event());
  const auto fall = edge(false);
  EXPECT_EQ(status(), 0x03U) << "both events, pin low";
  EXPECT_EQ(time(reg::kLatch0PositiveEdge), rise);
  EXPECT_EQ(status(), 0x02U);
  EXPECT_TRUE(event()) << "the other edge has not been read";
  EXPECT_EQ(time(reg::kLatch0NegativeEdge), fall);
  EXPECT_EQ(status(), 0x00U);
  EXPECT_FALSE(event());
  EXPECT_EQ(time(reg::kLatch0PositiveEdge), rise) << "the time itself stays";
  const auto other = edge(true, 1);
  EXPECT_EQ(status(), 0x00U);
  EXPECT_EQ(status(reg::kLatch1Status), 0x05U);
  EXPECT_EQ(time(reg::kLatch1PositiveEdge), other);
}

TEST(SimLatchPulses, ComeWhenTheScenarioSaysSo) {
  auto config = line({sim_slave("SL-SV7", "servo-y")});
  config.latch_pulses.push_back({0, 1, 2 * kMillisecond, 100 * kMicrosecond, 3 * kMillisecond, 2});
  SimProbe probe(config);
  const auto edge_time = [&probe](std::uint16_t ado) { return probe.read(0, ado, 8).value<std::uint64_t>(); };
  probe.pass(kMillisecond);
  EXPECT_EQ(edge_time(reg::kLatch1PositiveEdge), 0U);
  probe.pass(2 * kMillisecond);
  const auto first = edge_time(reg::kLatch1PositiveEdge);
  EXPECT_NEAR(static_cast<double>(edge_time(reg::kLatch1NegativeEdge) - first), 100'000, 20);
  EXPECT_EQ(edge_time(reg::kLatch0PositiveEdge), 0U) << "the other input";
  probe.pass(10 * kMillisecond);
  EXPECT_NEAR(static_cast<double>(edge_time(reg::kLatch1PositiveEdge) - first), 3e6, 20);
  const auto last = edge_time(reg::kLatch1PositiveEdge);
  probe.pass(20 * kMillisecond);
  EXPECT_EQ(edge_time(reg::kLatch1PositiveEdge), last) << "two pulses";
}

TEST_F(SimLatchUnit, ContinuousModeShowsTheLastEdgeAndSingleEventModeTheFirst) {
  edge(true);
  edge(false);
  const auto second = edge(true);
  EXPECT_EQ(time(reg::kLatch0PositiveEdge), second);
  probe.write(0, reg::kLatch0Control, {0x01});
  edge(false);
  const auto first = edge(true);
  edge(false);
  edge(true);
  const auto last_fall = edge(false);
  EXPECT_EQ(time(reg::kLatch0NegativeEdge), last_fall) << "negative edges are still continuous";
  EXPECT_EQ(time(reg::kLatch0PositiveEdge), first);
  const auto armed = edge(true);
  EXPECT_EQ(time(reg::kLatch0PositiveEdge), armed) << "reading arms it again";
}

TEST_F(SimLatchUnit, TheFirstByteFreezesTheOthers) {
  probe.pass(50 * kMillisecond);
  const auto first = edge(true);
  EXPECT_EQ(probe.read(0, reg::kLatch0PositiveEdge, 1).data[0], first & 0xFF);
  edge(false);
  probe.pass(100 * kMillisecond);
  const auto later = edge(true);
  ASSERT_NE(first >> 8, later >> 8);
  auto upper = probe.read(0, reg::kLatch0PositiveEdge + 1, 7).data;
  upper.push_back(0);
  EXPECT_EQ(load_le<std::uint64_t>(upper), first >> 8);
  EXPECT_EQ(time(reg::kLatch0PositiveEdge), later);
}

TEST_F(SimLatchUnit, AUnitOfThePdiIsNeitherArmedNorAcknowledgedByTheMaster) {
  EXPECT_EQ(probe.write(0, reg::kCyclicUnitControl, {0x10}).wkc, 1);
  EXPECT_EQ(probe.write(0, reg::kLatch0Control, {0x01}).wkc, 0) << "latch 0 is the PDI's";
  EXPECT_EQ(probe.write(0, reg::kLatch1Control, {0x01}).wkc, 1);
  const auto rise = edge(true);
  EXPECT_FALSE(event());
  EXPECT_EQ(probe.read(0, reg::kAlEventRequest, 4).value<std::uint32_t>() & 0x02U, 0x02U) << "the PDI's event";
  EXPECT_EQ(time(reg::kLatch0PositiveEdge), rise);
  EXPECT_EQ(status(), 0x05U);
  probe.write(0, reg::kCyclicUnitControl, {0x01});
  EXPECT_EQ(probe.write(0, reg::kActivation, {0x03}).wkc, 0) << "so is the cyclic unit";
  EXPECT_EQ(probe.write(0, reg::kSync0CycleTime, {0, 0, 0, 1}).wkc, 0);
  EXPECT_EQ(probe.write(0, reg::kStartTimeCyclicOperation, {1}).wkc, 0);
  probe.write(0, reg::kCyclicUnitControl, {0x00});
  EXPECT_EQ(probe.write(0, reg::kActivation, {0x00}).wkc, 1);
}

TEST(SimLatchPin, APinThatIsASyncOutputTakesNoEdge) {
  auto slave = sim_slave("SL-SV7", "servo-y");
  slave.device.eeprom.config_data.at(3) = 0x04;  // SYNC0 out, LATCH1 in
  SimProbe probe(line({slave}));
  EXPECT_FALSE(probe.bus->latch_input(0, 0, true));
  EXPECT_TRUE(probe.bus->latch_input(0, 1, true));
  EXPECT_EQ(probe.read(0, reg::kLatch0Status, 2).value<std::uint16_t>(), 0x0500);
}

// ---- SYNC signals -------------------------------------------------------------------------------------

/// An ESC whose PDI notes when the signals come and reads nothing.
class SimSyncSignals : public testing::Test, public sim::Esc::Listener {
 protected:
  void make(std::uint16_t pulse_length, bool wide = true) {
    auto slave = sim_slave("SL-SV7", "servo-y");
    slave.dc.is_64bit = wide;
    std::vector<std::uint8_t> sii(256);
    store_le(std::span(sii).subspan(4, 2), pulse_length);
    sii[3] = 0x88;
    sii[14] = checksum(sii);
    esc.emplace(slave, sii, sim::Esc::Options{}, 0, 1);
    esc->set_listener(this);
  }
  static std::uint8_t checksum(std::span<const std::uint8_t> sii) {
    std::uint8_t crc = 0xFF;
    for (std::size_t i = 0; i < 14; ++i) {
      crc ^= sii[i];
      for (int bit = 0; bit < 8; ++bit) crc = static_cast<std::uint8_t>((crc & 0x80) != 0 ? crc << 1 ^ 0x07 : crc << 1);
    }
    return crc;
  }
  void write(std::uint16_t ado, std::vector<std::uint8_t> data) {
    FrameBuilder builder;
    builder.set_addresses(kNoMac, kNoMac);
    builder.add(Command::kBwr, 1, device_address(0, ado), data);
    const auto sent = builder.finish();
    std::vector<std::uint8_t> frame(sent.begin(), sent.end());
    sim::PassingFrame passing;
    ASSERT_EQ(passing.arrive(frame), sim::PassingFrame::Kind::kEtherCat);
    ASSERT_TRUE(esc->process(passing, now));
    esc->frame_end(now);
  }
  void start(std::uint32_t cycle0, std::uint32_t cycle1, std::uint64_t time, std::uint8_t activation) {
    write(reg::kSync0CycleTime, le_bytes(cycle0));
    write(reg::kSync1CycleTime, le_bytes(cycle1));
    write(reg::kStartTimeCyclicOperation, le_bytes(time));
    write(reg::kActivation, {activation});
  }
  unsigned activation_status() {
    esc->dc().refresh_registers();
    return esc->memory().u8(reg::kActivationStatus);
  }

  void al_control_written(Nanoseconds) override {}
  void sync_manager_written(unsigned, Nanoseconds) override {}
  void sync_manager_read(unsigned, Nanoseconds) override {}
  void sync_manager_set(unsigned, Nanoseconds) override {}
  void process_data_watchdog_expired(Nanoseconds) override {}
  void sync_signal(sim::SyncGenerator::Signal signal, Nanoseconds time) override {
    (signal == sim::SyncGenerator::Signal::kSync0 ? sync0 : sync1).push_back(time);
  }

  std::optional<sim::Esc> esc;
  Nanoseconds now = 0;
  std::vector<Nanoseconds> sync0, sync1;
};

TEST_F(SimSyncSignals, Sync1BelongsToTheFirstSync0BehindItsPredecessor) {
  struct Row {
    std::uint32_t cycle1;
    std::vector<Nanoseconds> expected;  // us behind the start
  };
  for (const auto& row : {Row{0, {0, 250, 500, 750}}, Row{100, {100, 350, 600, 850}}, Row{250, {250, 750, 1250, 1750}},
                          Row{300, {300, 800, 1300, 1800}}, Row{750, {750, 1750, 2750, 3750}}}) {
    make(1000);
    sync0.clear();
    sync1.clear();
    start(250'000, row.cycle1 * 1000, 1'000'000, 0x07);
    esc->advance_to(6 * kMillisecond);
    ASSERT_GE(sync1.size(), 4U) << row.cycle1;
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(sync1[i], kMillisecond + row.expected[i] * kMicrosecond) << row.cycle1;
    EXPECT_EQ(sync0.size(), 21U) << "SYNC0 goes on in between";
  }
}

TEST_F(SimSyncSignals, ANewActivationDoesNotWaitForTheOldCycle) {
  make(1000);
  start(100'000'000, 0, 1'000'000, 0x03);
  esc->advance_to(2 * kMillisecond);
  ASSERT_EQ(sync0.size(), 1U);
  now = 2 * kMillisecond;
  write(reg::kActivation, {0x00});
  sync0.clear();
  start(1'000'000, 0, 4'000'000, 0x03);
  esc->advance_to(4'500'000);
  ASSERT_EQ(sync0.size(), 1U);
  EXPECT_EQ(sync0[0], 4 * kMillisecond);
}

TEST_F(SimSyncSignals, InAcknowledgeModeASignalStaysUntilThePdiReadsIt) {
  make(0);
  start(250'000, 0, 1'000'000, 0x03);
  esc->advance_to(3 * kMillisecond);
  EXPECT_EQ(sync0.size(), 1U) << "no edge without an acknowledgement";
  EXPECT_EQ(esc->memory().u8(reg::kSync0Status), 1);
  EXPECT_EQ(esc->memory().u32(reg::kAlEventRequest) & 0x04U, 0x04U);
  esc->acknowledge_sync(sim::SyncGenerator::Signal::kSync0);
  EXPECT_EQ(esc->memory().u8(reg::kSync0Status), 0);
  EXPECT_EQ(esc->memory().u32(reg::kAlEventRequest) & 0x04U, 0U);
  esc->advance_to(4 * kMillisecond);
  EXPECT_EQ(sync0.size(), 2U);
  make(1000);
  sync0.clear();
  start(250'000, 0, 1'000'000, 0x03);
  esc->advance_to(3 * kMillisecond);
  EXPECT_EQ(sync0.size(), 9U) << "pulses end by themselves";
  EXPECT_EQ(esc->memory().u8(reg::kSync0Status), 0);
}

TEST_F(SimSyncSignals, TheStartTimeCanBeChecked) {
  now = 10 * kMillisecond;
  make(1000);
  esc->advance_to(now);
  start(250'000, 0, 5'000'000, 0x03);
  EXPECT_EQ(activation_status(), 0x05U) << "pending, and outside the near future";
  esc->advance_to(now += kMillisecond);
  EXPECT_TRUE(sync0.empty());
  write(reg::kActivation, {0});
  EXPECT_EQ(activation_status(), 0U);
  write(reg::kActivation, {0x23});
  esc->advance_to(now += kMillisecond);
  EXPECT_EQ(sync0.size(), 5U) << "fires at once with the check on";
  EXPECT_EQ(activation_status(), 0x04U);
  write(reg::kActivation, {0});
  sync0.clear();
  const auto far = static_cast<std::uint64_t>(now) + 3'000'000'000U;
  start(250'000, 0, far, 0x23);
  EXPECT_EQ(activation_status(), 0x01U) << "3 s are near in half of 64 bit";
  write(reg::kActivation, {0});
  start(250'000, 0, far, 0x63);
  EXPECT_EQ(activation_status() & 0x04U, 0x04U) << "but not within 2.1 s";
}

TEST_F(SimSyncSignals, AStartTimeOfHalfTheWidthCanBeExtendedAndCanActivate) {
  make(1000);
  now = 5'000 * kMillisecond;  // 32 bit have come round
  esc->advance_to(now);
  write(reg::kSync0CycleTime, le_bytes(std::uint32_t{250'000}));
  write(reg::kActivation, {0x1A});  // SYNC0, auto activation, extension
  const auto wanted = now + kMillisecond;
  write(reg::kStartTimeCyclicOperation, le_bytes(static_cast<std::uint32_t>(wanted)));
  EXPECT_EQ(esc->memory().u8(reg::kActivation), 0x1B);
  esc->advance_to(now + 2 * kMillisecond);
  ASSERT_FALSE(sync0.empty());
  EXPECT_EQ(sync0[0], wanted);
}

TEST_F(SimSyncSignals, ACycleThatIsShorterThanAnyPulseIsOneLevel) {
  make(1000);
  start(1, 0, 1'000'000, 0x03);
  esc->advance_to(100 * kMillisecond);
  EXPECT_EQ(sync0.size(), 1U);
}

TEST_F(SimSyncSignals, AStartTimeInTheFarFutureIsWaitedForAndNeverReached) {
  make(1000);
  write(reg::kSpeedCounterStart, le_bytes(std::uint16_t{0x0080}));
  write(reg::kSystemTime, le_bytes(std::uint32_t{123'456}));  // the loop corrects, as far as it can
  for (const auto time :
       {0x7000'0000'0000'0000U, 0x7FFF'FFFF'FFFF'FFFFU, 0x8000'0000'0000'0000U, 0xFFFF'FFFF'FFFF'FFF0U}) {
    start(250'000, 0, time, 0x03);
    now += 10 * kMillisecond;
    esc->advance_to(now);
    EXPECT_TRUE(sync0.empty()) << time;
    write(reg::kActivation, {0x00});
  }
}

TEST_F(SimSyncSignals, WhoLooksAfterAYearSeesTheLastSignals) {
  make(1000);
  start(1'000, 700, 1'000'000, 0x07);
  now = 365 * 86'400 * kSecond;
  esc->advance_to(now);
  ASSERT_FALSE(sync0.empty());
  EXPECT_LE(sync0.size(), 200'001U);
  EXPECT_LE(now - sync0.back(), 1'000);
  EXPECT_EQ(sync0.back() - sync0.front(), static_cast<Nanoseconds>(sync0.size() - 1) * 1'000);
}

TEST_F(SimSyncSignals, AClockThatJumpsLosesTheSignalsInBetween) {
  make(1000);
  start(250'000, 0, 1'000'000, 0x03);
  esc->advance_to(10 * kMillisecond);
  const auto before = sync0.size();
  esc->dc().step_clock(30 * 86'400 * kSecond, 10 * kMillisecond);
  esc->advance_to(11 * kMillisecond);
  EXPECT_LE(sync0.size() - before, 5U);
  EXPECT_GE(sync0.size() - before, 3U);
}

TEST_F(SimSyncSignals, A32BitUnitSeesTheLowWordOfAnOffsetThatWraps) {
  make(1000, false);
  write(reg::kSystemTimeOffset, le_bytes(std::uint32_t{0xFFFF'FF00}));
  start(1'000'000, 0, 1'000'000, 0x03);  // 1 ms and 256 ns on
  esc->advance_to(10 * kMillisecond);
  const auto before = sync0.size();
  ASSERT_GE(before, 8U);
  now = 10 * kMillisecond;
  write(reg::kSystemTimeOffset, le_bytes(std::uint32_t{0x0000'0100}));  // 512 ns ahead by its word
  esc->advance_to(20 * kMillisecond);
  EXPECT_GE(sync0.size(), before + 9);
}

}  // namespace
}  // namespace syncline::test
