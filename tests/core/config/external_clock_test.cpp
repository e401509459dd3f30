// SPDX-License-Identifier: Apache-2.0
#include "config/external_clock.h"

#include <gtest/gtest.h>

#include "config/network_config.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr std::uint16_t kTimes = 0x10F4;

PdoEntry entry(std::uint16_t index, std::uint8_t sub_index, std::uint16_t bits) {
  PdoEntry made;
  made.index = index;
  made.sub_index = sub_index;
  made.bit_length = bits;
  return made;
}

/// A slave whose inputs begin at a bit and are these entries.
SlaveConfig bridge(std::uint32_t bit_start, std::vector<PdoEntry> entries) {
  SlaveConfig slave;
  slave.receive.emplace().bit_start = bit_start;
  auto& configured = slave.pdos.emplace_back();
  configured.direction = PdoDirection::kTx;
  configured.pdo.sync_manager = 3;
  configured.pdo.entries = std::move(entries);
  return slave;
}

TEST(ExternalClock, IsWhereASlaveMapsBothTimes) {
  NetworkConfig config;
  config.slaves.push_back(bridge(0, {entry(0x6000, 1, 64)}));
  config.slaves.push_back(bridge(80, {entry(0x6000, 1, 8), entry(kTimes, 0x11, 64), entry(kTimes, 0x12, 64)}));
  const auto place = find_external_clock(config);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->slave, 1U);
  EXPECT_EQ(place->internal_byte, 11U);
  EXPECT_EQ(place->external_byte, 19U);
}

/// One time alone, one that is no 64 bits, lies across bytes, is an output or is not mapped, is none.
TEST(ExternalClock, IsNothingLess) {
  const std::vector<PdoEntry> both{entry(kTimes, 0x11, 64), entry(kTimes, 0x12, 64)};
  const auto found = [](SlaveConfig slave) {
    NetworkConfig config;
    config.slaves.push_back(std::move(slave));
    return find_external_clock(config).has_value();
  };
  EXPECT_TRUE(found(bridge(0, both)));
  EXPECT_FALSE(found(bridge(1, both)));
  EXPECT_FALSE(found(bridge(0, {both[0]})));
  EXPECT_FALSE(found(bridge(0, {both[1]})));
  EXPECT_FALSE(found(bridge(0, {both[0], entry(kTimes, 0x12, 32)})));
  EXPECT_FALSE(found(bridge(0, {entry(0x10F5, 0x11, 64), both[1]})));
  auto unmapped = bridge(0, both);
  unmapped.pdos[0].pdo.sync_manager.reset();
  EXPECT_FALSE(found(unmapped));
  auto outputs = bridge(0, both);
  outputs.pdos[0].direction = PdoDirection::kRx;
  EXPECT_FALSE(found(outputs));
  auto silent = bridge(0, both);
  silent.receive.reset();
  EXPECT_FALSE(found(silent));
}

TEST(ExternalClock, TheDifferenceIsExternalTimeMinusInternalTime) {
  std::vector<std::uint8_t> inputs(20);
  store_le(std::span(inputs).subspan(2, 8), std::uint64_t{5'000});
  store_le(std::span(inputs).subspan(12, 8), std::uint64_t{4'000});
  EXPECT_EQ(external_clock_times({0, 2, 12}, inputs).value_or(ExternalClockTimes{}).difference(), -1'000);
  EXPECT_EQ(external_clock_times({0, 12, 2}, inputs).value_or(ExternalClockTimes{}).difference(), 1'000);
  EXPECT_FALSE(external_clock_times({0, 2, 13}, inputs)) << "beyond the inputs";
  EXPECT_FALSE(external_clock_times({0, 30, 2}, inputs));
  store_le(std::span(inputs).subspan(12, 8), std::uint64_t{0});
  EXPECT_FALSE(external_clock_times({0, 2, 12}, inputs)) << "nobody gives the time";
}

}  // namespace
}  // namespace syncline
