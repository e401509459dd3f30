// SPDX-License-Identifier: Apache-2.0
// The scan of slaves whose EEPROMs take their time, all of them or one: what it costs, and that it reads what is there.
#include <gtest/gtest.h>

#include "master/scan/bus_scanner.h"
#include "sim/device/sii_from_device.h"
#include "tests/support/scan_bed.h"

namespace syncline {
namespace {

using test::SimulatedNetwork;

struct Cost {
  std::size_t frames = 0;
  Nanoseconds time = 0;
};

Cost cost_of_scan(const SimulatedNetwork& network) {
  VirtualClock clock;
  test::CountingLink link(network.link(clock));
  FrameExchange exchange(link, clock);
  Bus bus(exchange, clock);
  const auto begin = clock.now();
  const auto scan = scan_slaves(bus);
  EXPECT_TRUE(scan);
  for (std::size_t i = 0; scan && i < scan->slaves.size(); ++i) {
    const auto& slave = network.sim.slaves[i];
    const auto truth = sii::decode(sii::encode(sim::sii_from_device(slave.device, slave.alias, slave.serial_no)));
    EXPECT_TRUE(truth && scan->slaves[i].sii == *truth) << i;
  }
  return {link.frames, clock.now() - begin};
}

SimulatedNetwork slow(SimulatedNetwork network, Nanoseconds all, Nanoseconds one) {
  for (auto& slave : network.sim.slaves) slave.sii.read_time = all;
  network.sim.slaves[7].sii.read_time = one;
  return network;
}

class ScanSlow : public ::testing::TestWithParam<double> {
 protected:
  Nanoseconds read = static_cast<Nanoseconds>(GetParam() * 1e6);
  void tell(const char* what, const Cost& cost) {
    std::printf("read in %.1f ms, %s: %zu frames, %.1f ms\n", GetParam(), what, cost.frames,
                static_cast<double>(cost.time) / 1e6);
  }
};

TEST_P(ScanSlow, AllOfAHundredIdenticalOnes) {
  const auto cost = cost_of_scan(slow(test::identical_slaves(100), read, read));
  tell("100 identical", cost);
  EXPECT_LE(cost.frames, 42U);
  EXPECT_LE(cost.time, 15 * kMillisecond + 14 * read);
}

TEST_P(ScanSlow, OneOfAHundredIdenticalOnesKeepsNobodyWaiting) {
  const auto cost = cost_of_scan(slow(test::identical_slaves(100), 0, read));
  tell("one of 100 identical", cost);
  EXPECT_LE(cost.frames, 45U);
  EXPECT_LE(cost.time, 15 * kMillisecond + 5 * read);  // its own four pieces
}

TEST_P(ScanSlow, OneOfAHundredDifferentOnesIsNotAskedAllTheTime) {
  const auto cost = cost_of_scan(slow(test::different_slaves(100), 0, read));
  tell("one of 100 different", cost);
  EXPECT_LE(cost.frames, 330U);
}

INSTANTIATE_TEST_SUITE_P(ReadTimes, ScanSlow, ::testing::Values(0.2, 0.7, 1.0, 2.0, 3.0, 5.0, 10.0));

}  // namespace
}  // namespace syncline
