// SPDX-License-Identifier: Apache-2.0
#include "master/exchange/acyclic_window.h"

#include <gtest/gtest.h>

#include "link/fault_link.h"
#include "master/exchange/bus.h"
#include "tests/support/simulated_segment.h"

namespace syncline {
namespace {

constexpr std::size_t kSlaves = 40;

class AcyclicWindowTest : public ::testing::Test {
 protected:
  VirtualClock clock;
  test::SimulatedSegment* segment = nullptr;
  std::unique_ptr<FaultLink> link;
  std::unique_ptr<FrameExchange> exchange;
  std::unique_ptr<Bus> bus;

  void open(const LinkFaults& faults) {
    auto config = test::terminals(kSlaves);
    for (auto& slave : config.slaves) slave.ram_kbytes = 8;
    auto inner = std::make_unique<test::SimulatedSegment>(clock, config);
    segment = inner.get();
    test::give_addresses(*segment, kSlaves);
    for (std::uint16_t i = 0; i < kSlaves; ++i) {
      for (std::uint16_t n = 0; n < 64; ++n) {
        ASSERT_TRUE(segment->set<std::uint32_t>(i, static_cast<std::uint16_t>(0x1000 + 4 * n), i * 1000U + n));
      }
    }
    link = std::make_unique<FaultLink>(std::move(inner), clock, faults);
    exchange = std::make_unique<FrameExchange>(*link, clock);
    bus = std::make_unique<Bus>(*exchange, clock);
  }
  /// Every slave's 64 words, each with a datagram of its own; the values say who answered.
  void read_all_and_check() {
    std::vector<std::array<std::uint8_t, 4>> bytes(kSlaves * 64);
    std::vector<Datagram> reads;
    for (std::uint16_t i = 0; i < kSlaves; ++i) {
      for (std::uint16_t n = 0; n < 64; ++n) {
        reads.push_back(
            {Command::kFprd,
             device_address(static_cast<std::uint16_t>(1001 + i), static_cast<std::uint16_t>(0x1000 + 4 * n)),
             bytes[i * 64U + n]});
      }
    }
    const auto status = bus->transact(reads);
    ASSERT_TRUE(status);
    for (std::uint32_t k = 0; k < bytes.size(); ++k) {
      ASSERT_TRUE(reads[k].answered);
      ASSERT_EQ(load_le<std::uint32_t>(bytes[k]), k / 64 * 1000 + k % 64) << k;
    }
  }
};

TEST_F(AcyclicWindowTest, SendsManyFramesBeforeTheFirstIsBack) {
  open({});
  segment->record = true;
  const auto begin = clock.now();
  read_all_and_check();
  Nanoseconds wire = 0;
  for (const auto& frame : segment->sent) wire += wire_time_ns(frame.size());
  const auto way = static_cast<Nanoseconds>(2 * segment->bus().true_delay_ns(kSlaves - 1));
  ASSERT_GT(segment->sent.size(), 25U);
  ASSERT_GT(way, 10 * kMicrosecond);
  // One after the other each would cost its way, too.
  EXPECT_LE(clock.now() - begin, wire + 2 * way);
}

TEST_F(AcyclicWindowTest, LossesReorderingAndDuplicatesCostTimeOnly) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    open({.lose_request = 0.01, .lose_reply = 0.01, .duplicate = 0.05, .reorder = 0.05, .seed = seed});
    for (int round = 0; round < 5; ++round) read_all_and_check();
    EXPECT_EQ(exchange->lost_frames(), link->injected().lost) << "seed " << seed;
  }
}

TEST_F(AcyclicWindowTest, ALateFrameIsAStrayAndNeverTakenForAnother) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    open({.late = 0.05, .late_by = 35 * kMillisecond, .seed = seed});
    for (int round = 0; round < 20; ++round) {
      // Values change, so that an old answer would be seen.
      for (std::uint16_t i = 0; i < kSlaves; ++i) {
        segment->set(i, 0x1000, static_cast<std::uint32_t>(round) * 1000U + i);
      }
      std::vector<std::array<std::uint8_t, 4>> bytes(kSlaves);
      std::vector<std::array<std::uint8_t, 1000>> ballast(kSlaves);  // a frame of its own for every slave
      std::vector<Datagram> reads;
      for (std::uint16_t i = 0; i < kSlaves; ++i) {
        reads.push_back({Command::kFprd, device_address(static_cast<std::uint16_t>(1001 + i), 0x1000), bytes[i]});
        reads.push_back({Command::kFprd, device_address(static_cast<std::uint16_t>(1001 + i), 0x2000), ballast[i]});
      }
      ASSERT_TRUE(bus->transact(reads));
      for (std::uint32_t i = 0; i < kSlaves; ++i) {
        ASSERT_EQ(load_le<std::uint32_t>(bytes[i]), static_cast<std::uint32_t>(round) * 1000U + i);
      }
    }
    EXPECT_GT(link->injected().late, 0U);
    EXPECT_GT(exchange->stray_frames(), 0U);
    EXPECT_LE(exchange->stray_frames(), link->injected().late);
  }
}

TEST_F(AcyclicWindowTest, RepeatsNothingThatMustNotBeExecutedTwice) {
  open({.lose_reply = 1});
  std::array<std::uint8_t, 4> once_bytes{}, armw_bytes{};
  std::array<Datagram, 2> datagrams{{{Command::kFpwr, device_address(1001, 0x1000), once_bytes},
                                     {Command::kArmw, device_address(0, 0x2000), armw_bytes}}};
  datagrams[0].once = true;
  ASSERT_TRUE(bus->transact(datagrams));
  EXPECT_FALSE(datagrams[0].answered);
  EXPECT_FALSE(datagrams[1].answered);
  EXPECT_EQ(datagrams[0].times_sent, 1);
  EXPECT_EQ(link->injected().sent, 1U);
}

TEST_F(AcyclicWindowTest, TellsHowOftenADatagramWasSent) {
  open({});
  segment->lose(2);
  std::array<std::uint8_t, 4> bytes{};
  Datagram read{Command::kFprd, device_address(1001, 0x1000), bytes};
  ASSERT_TRUE(bus->transact(read));
  EXPECT_EQ(read.times_sent, 3);
}

TEST_F(AcyclicWindowTest, EndsOnADeadBus) {
  open({.lose_reply = 1});
  std::array<std::uint8_t, 4> bytes{};
  Datagram read{Command::kFprd, device_address(1001, 0x1000), bytes};
  const auto begin = clock.now();
  const auto status = bus->transact(read);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kNoResponse);
  EXPECT_LT(clock.now() - begin, kSecond);
}

TEST_F(AcyclicWindowTest, RefusesWhatFitsNoFrame) {
  open({});
  std::vector<std::uint8_t> bytes(kMaxDatagramData + 1);
  Datagram read{Command::kFprd, device_address(1001, 0x1000), bytes};
  const auto status = bus->transact(read);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kMalformedData);
}

/// More frames than there are indexes, while lost ones still rest.
TEST_F(AcyclicWindowTest, IndexesLimitNothing) {
  open({.lose_request = 0.05, .seed = 5});
  for (int round = 0; round < 40; ++round) read_all_and_check();
  EXPECT_GT(link->injected().sent, 1000U);
}

}  // namespace
}  // namespace syncline
