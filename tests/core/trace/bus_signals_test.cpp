// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdint>
#include <optional>

#include "channels/cycle_sample.h"
#include "trace/signals.h"

namespace syncline {
namespace {

/// What a cycle tells of one slave, the first of the bus among them; of none it tells nothing.
TEST(BusSignals, ReadingsOfASlaveAreThoseOfThatCycle) {
  constexpr Signal kDeviation[] = {Signal::kSlave, Signal::kSlaveReading, Signal::kSlaveFollows};
  constexpr Signal kMisses[] = {Signal::kSm2Slave, Signal::kSm2Reading, Signal::kSm2IntegratorReading};
  const auto there = [](const Signal& signal, const CycleSample& sample) {
    return info(signal).of_cycle(sample).has_value();
  };
  for (const int position : {-1, 0, 1, 300}) {
    CycleSample deviation, misses;
    deviation.slave_position = misses.sm2_position = static_cast<std::int16_t>(position);
    deviation.sm2_position = misses.slave_position = -1;
    for (const auto signal : kDeviation) {
      EXPECT_EQ(there(signal, deviation), position >= 0) << position;
      EXPECT_FALSE(there(signal, misses));
    }
    for (const auto signal : kMisses) {
      EXPECT_EQ(there(signal, misses), position >= 0) << position;
      EXPECT_FALSE(there(signal, deviation));
    }
  }
}

/// Zero is a distance, too.
TEST(BusSignals, TheExternalClockHasAValueWhereThereIsOne) {
  const auto& external = info(Signal::kExternalError);
  CycleSample sample;
  EXPECT_EQ(external.of_cycle(sample), std::nullopt);
  for (const std::int32_t apart : {0, -16'000}) {
    sample.external_error_ns = apart;
    EXPECT_EQ(external.of_cycle(sample), std::optional(SignalNumber(std::int64_t{apart})));
  }
}

}  // namespace
}  // namespace syncline
