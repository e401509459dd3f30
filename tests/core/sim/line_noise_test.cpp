// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/esc/esc_types.h"
#include "tests/core/sim/sim_probe.h"

/// What the line and the clocks do all the time: loss by chance, asymmetric cables, noise of the receive times, ramps.
namespace syncline::test {
namespace {

SimConfig with_servo() { return line({sim_slave("SL-1100"), sim_slave("SL-SV7", "servo-y"), sim_slave("SL-1002")}); }

std::vector<int> lost_of(const SimConfig& config, int frames) {
  SimProbe probe(config);
  std::vector<int> lost;
  for (int i = 0; i < frames; ++i) {
    if (probe.read(0, reg::kType, 1).lost) lost.push_back(i);
  }
  return lost;
}

TEST(LineNoise, FramesAreLostByChanceAndTheSameForTheSameSeed) {
  auto config = with_servo();
  config.bus.loss = 0.01;
  const auto first = lost_of(config, 20'000);
  EXPECT_NEAR(static_cast<double>(first.size()), 200, 50);
  EXPECT_EQ(first, lost_of(config, 20'000));
  config.seed = 2;
  EXPECT_NE(first, lost_of(config, 20'000));
}

TEST(LineNoise, ALossBehindASlaveHasBeenExecutedByIt) {
  auto config = with_servo();
  config.bus.loss = 0.5;
  SimProbe probe(config);
  int executed = 0, lost = 0;
  for (std::uint16_t i = 1; i <= 2'000; ++i) {
    if (!probe.write(0, reg::kStationAddress, le_bytes(i)).lost) continue;
    ++lost;
    executed += load_le<std::uint16_t>(probe.bus->peek(0, reg::kStationAddress, 2)) == i ? 1 : 0;
  }
  EXPECT_GT(lost, 900);
  EXPECT_NEAR(executed, lost * 4.0 / 5, 100) << "five receptions, the first of them at this slave";
}

TEST(LineNoise, BitErrorsWithAProbabilityAreCountedAtTheirPort) {
  auto config = with_servo();
  FaultConfig noise;
  noise.kind = FaultKind::kBitErrors;
  noise.slave = 2;
  noise.probability = 0.1;
  noise.until = 20 * kMillisecond;
  config.faults = {noise};
  SimProbe probe(config);
  int lost = 0;
  for (int i = 0; i < 1'000; ++i) lost += probe.read(0, reg::kType, 1).lost ? 1 : 0;  // one each 20 us
  EXPECT_NEAR(lost, 100, 30);
  EXPECT_EQ(probe.read(2, reg::kRxErrorCounter, 1).data[0], lost);
  EXPECT_EQ(probe.read(1, reg::kRxErrorCounter, 1).data[0], 0);
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(probe.read(0, reg::kType, 1).lost);
}

std::int32_t round_trip(SimProbe& probe) {
  probe.send(Command::kBwr, device_address(0, reg::kReceiveTimePort0), {0, 0, 0, 0});
  const auto times = probe.read(0, reg::kReceiveTimePort0, 16).data;
  return static_cast<std::int32_t>(load_le<std::uint32_t>(std::span(times).subspan(4)) -
                                   load_le<std::uint32_t>(std::span(times)));
}

TEST(LineNoise, AnAsymmetricCableIsSeenByNobodyButMovesTheTruth) {
  auto config = line({sim_slave("SL-1100"), sim_slave("SL-SV7", "servo-y")});
  config.slaves[1].cable_m = 100;
  SimProbe even(config);
  config.slaves[1].asymmetry_ns = 200;
  SimProbe uneven(config);
  EXPECT_NEAR(round_trip(even), round_trip(uneven), 20);
  EXPECT_NEAR(uneven.bus->true_delay_ns(1) - even.bus->true_delay_ns(1), 100, 1);
}

TEST(LineNoise, ReceiveTimesAreNoisyByAtMostWhatIsSaid) {
  auto config = line({sim_slave("SL-1100"), sim_slave("SL-SV7", "servo-y")});
  SimProbe quiet(config);
  const auto right = round_trip(quiet);
  config.bus.latch_noise_ns = 40;
  SimProbe noisy(config);
  std::int32_t least = right, most = right;
  for (int i = 0; i < 200; ++i) {
    const auto seen = round_trip(noisy);
    least = std::min(least, seen);
    most = std::max(most, seen);
  }
  EXPECT_LT(least, right - 20);
  EXPECT_GT(most, right + 20);
  EXPECT_GE(least, right - 60);
  EXPECT_LE(most, right + 60);
}

TEST(LineNoise, EscTypesDiffer) {
  const auto difference = [](const sim::EscType* type) { return type->delays.processing - type->delays.forwarding; };
  EXPECT_EQ(difference(sim::find_esc_type("et1100")), 40U);
  EXPECT_NE(difference(sim::find_esc_type("ip-core")), 40U);
  EXPECT_EQ(sim::find_esc_type("et2000"), nullptr);
}

/// Local time of a slave against true time, ppm over the second that follows.
double rate(SimProbe& probe, std::uint16_t slave) {
  probe.pass(0);
  const auto begin = probe.bus->system_time(slave);
  probe.pass(kSecond);
  return (static_cast<double>(probe.bus->system_time(slave) - begin) - 1e9) / 1e3;
}

TEST(LineNoise, AQuartzThatWarmsUpStaysWhereItCameTo) {
  auto config = with_servo();
  FaultConfig ramp;
  ramp.kind = FaultKind::kTemperatureRamp;
  ramp.slave = 1;
  ramp.at = 2 * kSecond;
  ramp.until = 12 * kSecond;
  ramp.ppm = 20;
  config.faults = {ramp};
  SimProbe probe(config);
  EXPECT_NEAR(rate(probe, 1), 0, 0.1);
  probe.pass(6 * kSecond);
  EXPECT_NEAR(rate(probe, 1), 11, 0.5);  // from 7 s to 8 s
  probe.pass(10 * kSecond);
  EXPECT_NEAR(rate(probe, 1), 20, 0.1);
  EXPECT_NEAR(rate(probe, 0), 0, 0.1);
}

TEST(LineNoise, AHostThatWarmsUpIsAllSlavesTheOtherWayRound) {
  auto config = with_servo();
  FaultConfig ramp;
  ramp.kind = FaultKind::kTemperatureRamp;
  ramp.slave = -1;
  ramp.until = kSecond;
  ramp.ppm = 5;
  config.faults = {ramp};
  SimProbe probe(config);
  probe.pass(2 * kSecond);
  EXPECT_NEAR(rate(probe, 0), -5, 0.1);
  EXPECT_NEAR(rate(probe, 1), -5, 0.1);
}

TEST(LineNoise, AHostWhoseTimeServiceSlewsItsClockIsOffUntilItIsThrough) {
  auto config = with_servo();
  FaultConfig slew;
  slew.kind = FaultKind::kClockSlew;
  slew.slave = -1;
  slew.at = kSecond;
  slew.value_ns = 2 * kMillisecond;
  slew.ppm = 500;  // takes 4 s
  config.faults = {slew};
  SimProbe probe(config);
  const auto begin = probe.bus->system_time(0);
  EXPECT_NEAR(rate(probe, 0), 0, 0.1);
  EXPECT_NEAR(rate(probe, 0), -500, 1);
  probe.pass(4 * kSecond);
  EXPECT_NEAR(rate(probe, 0), 0, 0.1);
  EXPECT_NEAR(static_cast<double>(probe.bus->system_time(0) - begin), 7e9 - 2e6, 100);
}

}  // namespace
}  // namespace syncline::test
