// SPDX-License-Identifier: Apache-2.0
// The initialisation of the clocks against the simulated segment, whose delays and clocks are known.
#include "master/clocks/dc_setup.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdlib>

#include "findings/error_text.h"
#include "protocol/delay_difference.h"
#include "sim/sim_bus.h"
#include "support/random.h"
#include "tests/support/clock_bed.h"
#include "tests/support/swapped_network.h"

namespace syncline {
namespace {

using test::ClockBed;
using test::random_tree;
using test::SimulatedNetwork;

/// Largest difference of what was recovered and what is built in, of slaves that have receive times.
std::int64_t worst_delay_error(const ClockBed& bed, const DcNetwork& network) {
  std::int64_t worst = 0;
  const auto origin = bed.bus().true_delay_ns(network.reference_clock);
  for (std::size_t i = 0; i < network.slaves.size(); ++i) {
    if (!network.slaves[i].synchronised) continue;
    const auto truth = std::llround(bed.bus().true_delay_ns(i) - origin);
    worst = std::max<std::int64_t>(worst, std::abs(truth - std::int64_t{network.slaves[i].delay_ns}));
  }
  return worst;
}

/// What the master's settings say, then what a slave's element DC says, then the first one with clocks.
TEST(ConfiguredReferenceClock, IsTheOneThatIsNamedFirst) {
  NetworkConfig config;
  config.slaves.resize(5);
  config.dc.enabled = true;
  EXPECT_EQ(configured_reference_clock(config), std::nullopt);
  for (const std::size_t slave : {1U, 2U, 4U}) config.slaves[slave].dc.emplace();
  EXPECT_EQ(configured_reference_clock(config), 1);
  config.slaves[2].dc->reference_clock = true;
  EXPECT_EQ(configured_reference_clock(config), 2);
  config.dc.reference_clock = 4;
  EXPECT_EQ(configured_reference_clock(config), 4);
  config.dc.enabled = false;
  EXPECT_EQ(configured_reference_clock(config), std::nullopt);
}

TEST(DcSetup, RecoversTheDelaysOfRandomTreesWithin20ns) {
  EXPECT_TRUE(rc::check([] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const auto size = *rc::gen::inRange<std::size_t>(1, 40);
    ClockBed bed(random_tree(size, seed, false));
    const auto network = bed.set_up();
    RC_ASSERT(network.has_value());
    RC_ASSERT(worst_delay_error(bed, *network) <= 20);
    RC_ASSERT(network->findings.empty());
  }));
}

TEST(DcSetup, RecoversTheDelaysBehindSlavesWithoutClocksToo) {
  EXPECT_TRUE(rc::check([] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    ClockBed bed(random_tree(*rc::gen::inRange<std::size_t>(2, 40), seed, true));
    const auto network = bed.set_up();
    RC_ASSERT(network.has_value());
    RC_ASSERT(worst_delay_error(bed, *network) <= 20);
  }));
}

/// A coupler without receive times, ten terminals at its port D, and five drives in a line at its port B, which all had
/// a delay of 0: from one branch to the other nobody's times say how far it is, but for two cables all is known.
TEST(DcSetup, MeasuresBranchesOfASlaveWithoutReceiveTimes) {
  for (const bool leads_line : {false, true}) {
    SimulatedNetwork network;
    for (int i = 0; i < 16; ++i) network.add(test::io8());
    network.sim.slaves[0].dc.system_time = network.sim.slaves[0].dc.receive_times = false;
    network.project.slaves[0].dc.op_mode = "";
    network.sim.slaves[1].parent_port = 3;
    network.project.slaves[1].previous = PreviousPort{0, 3};
    network.sim.slaves[11].parent = 0;
    network.project.slaves[11].previous = PreviousPort{0, 1};
    for (auto& slave : network.sim.slaves) slave.cable_m = 20;
    network.project.master.dc.reference_clock = leads_line ? 11 : 1;
    ClockBed bed(network);
    const auto clocks = bed.set_up();
    ASSERT_TRUE(clocks) << describe(clocks.error());
    EXPECT_LE(worst_delay_error(bed, *clocks), leads_line ? 20 : 500);
    const auto told =
        std::ranges::count(clocks->findings, dc::DelayWarning::kUnmeasuredWay, &dc::DelayFinding::warning);
    EXPECT_EQ(told, leads_line ? 0 : 1) << "all who follow the drive are measured from it";
  }
}

/// Whether each slave whose cables are swapped is told, and nobody else.
bool told_as_swapped(const SimulatedNetwork& network, const DcNetwork& clocks) {
  for (std::size_t i = 0; i < network.sim.slaves.size(); ++i) {
    const bool told = std::ranges::any_of(clocks.findings, [i](const auto& finding) {
      return finding.position == i && finding.warning == dc::DelayWarning::kReversedCable;
    });
    if (told != (network.sim.slaves[i].entry_port != 0)) return false;
  }
  return true;
}

TEST(DcSetup, RecoversTheDelaysOfSlavesThatAreEnteredByAnyPort) {
  EXPECT_TRUE(rc::check([] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const auto network = test::swapped_network(*rc::gen::inRange<std::size_t>(1, 40), seed);
    ClockBed bed(network);
    const auto clocks = bed.set_up();
    RC_ASSERT(clocks.has_value());
    RC_ASSERT(worst_delay_error(bed, *clocks) <= 20);
    RC_ASSERT(told_as_swapped(network, *clocks));
    RC_ASSERT(bed.largest_clock_difference() < 100);
  }));
}

/// Couplers at port C of one another over cables, each with a row of terminals at its port B.
SimulatedNetwork rows_of_terminals(std::uint64_t seed, bool with_clocks_everywhere) {
  SimulatedNetwork network;
  Random random(seed);
  std::uint16_t coupler = 0;
  const auto add = [&](const char* physics, std::uint16_t parent, std::uint8_t port) {
    const auto position = static_cast<std::uint16_t>(network.sim.slaves.size());
    network.add(test::io8());
    auto& slave = network.sim.slaves.back();
    slave.device.physics = physics;
    slave.oscillator.ppm = random.uniform() * 100 - 50;
    if (position > 0) {
      slave.parent = parent;
      slave.parent_port = port;
      network.project.slaves.back().previous = PreviousPort{parent, port};
    }
    return position;
  };
  for (int k = 0; k < 4; ++k) {
    coupler = add("YKY", coupler, 2);
    network.sim.slaves.back().cable_m = random.uniform() * 50;
    auto last = coupler;
    const auto terminals = static_cast<int>(random.uniform() * 30);
    for (int i = 0; i < terminals; ++i) {
      last = add("KK", last, 1);
      auto& slave = network.sim.slaves.back();
      slave.cable_m = 0;
      if (with_clocks_everywhere || random.uniform() < 0.5) continue;
      slave.dc.system_time = false;
      slave.dc.receive_times = random.uniform() < 0.3;
      network.project.slaves.back().dc.op_mode.clear();
    }
  }
  return network;
}

TEST(DcSetup, RecoversTheDelaysOfTerminalsAtEbusBehindCouplers) {
  EXPECT_TRUE(rc::check([] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    ClockBed bed(rows_of_terminals(seed, *rc::gen::arbitrary<bool>()));
    const auto network = bed.set_up();
    RC_ASSERT(network.has_value());
    RC_ASSERT(worst_delay_error(bed, *network) <= 20);
  }));
}

TEST(DcSetup, OneDelayDifferenceForCablesAndEbusWouldBeWrong) {
  auto network = rows_of_terminals(3, true);
  network.project.master.dc.delay_difference = kUsualDelayDifference;
  ClockBed bed(network);
  const auto wrong = bed.set_up();
  ASSERT_TRUE(wrong);
  EXPECT_GT(worst_delay_error(bed, *wrong), 100);  // 10 ns a terminal
}

TEST(DcSetup, NoiseOfTheStampsStaysSmallWherePortAIsClosed) {
  // A line whose last slave is entered by port B: the medians must not be taken against a port that no frame passes.
  auto network = test::SimulatedNetwork();
  for (int i = 0; i < 3; ++i) network.add(test::io8());
  network.sim.slaves[2].entry_port = 1;
  network.sim.slaves[2].oscillator.start_offset =
      2'147'483'648 - 30 * kMillisecond;  // half of the range is passed meanwhile
  network.sim.bus.latch_noise_ns = 40;
  ClockBed bed(std::move(network));
  const auto clocks = bed.set_up();
  ASSERT_TRUE(clocks);
  EXPECT_LE(worst_delay_error(bed, *clocks), 60);
}

TEST(DcSetup, RecoversTheDelaysOfTwoHundredSlaves) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    ClockBed bed(random_tree(200, seed, seed == 3));
    const auto network = bed.set_up();
    ASSERT_TRUE(network);
    EXPECT_LE(worst_delay_error(bed, *network), 20) << "seed " << seed;
  }
}

TEST(DcSetup, ClocksShowTheTimeOfTheReferenceWhenTheLastSlaveIsFarAway) {
  // Without the delay in the offset the last slave would start its own delay behind: 60 us here.
  auto network = random_tree(1, 1, false);
  for (int i = 1; i < 200; ++i) network.add(test::io8());
  for (auto& slave : network.sim.slaves) slave.oscillator.ppm = 0;
  for (auto& slave : network.sim.slaves) slave.device.physics = "YY";
  network.project.master.dc.burst_total = 1;
  network.project.master.dc.burst_ends_early = false;
  ClockBed bed(std::move(network));
  ASSERT_TRUE(bed.set_up());
  EXPECT_GT(bed.bus().true_delay_ns(199), 59'000);
  EXPECT_LT(bed.largest_clock_difference(), 100);
}

TEST(DcSetup, ClocksOf32And64BitsShowTheSameTime) {
  auto network = random_tree(12, 7, false);
  for (std::size_t i = 0; i < 12; ++i) {
    network.sim.slaves[i].dc.is_64bit = i % 3 != 0;
    network.sim.slaves[i].oscillator.start_offset = 4'294'967'296 - 20 * kMillisecond;  // wraps while it is measured
  }
  ClockBed bed(std::move(network));
  ASSERT_TRUE(bed.set_up());
  EXPECT_LT(bed.largest_clock_difference(), 100);
}

TEST(DcSetup, ProcessingDifferenceOfOtherEscsCanBeSet) {
  auto network = random_tree(1, 1, false);
  for (int i = 1; i < 20; ++i) network.add(test::io8());
  for (auto& slave : network.sim.slaves) slave.delays = EscDelays{300, 200};
  network.project.master.dc.delay_difference = 100;
  ClockBed bed(network);
  const auto right = bed.set_up();
  ASSERT_TRUE(right);
  EXPECT_LE(worst_delay_error(bed, *right), 20);
  network.project.master.dc.delay_difference = 0;
  ClockBed other(network);
  const auto wrong = other.set_up();
  ASSERT_TRUE(wrong);
  EXPECT_GT(worst_delay_error(other, *wrong), 500);  // half of it a hop
}

class Burst : public ::testing::TestWithParam<DcmMode> {};

TEST_P(Burst, EndsWhenAllClocksAreNear) {
  auto network = random_tree(20, 5, false);
  for (std::size_t i = 0; i < 20; ++i) network.sim.slaves[i].oscillator.ppm = i % 2 == 0 ? 50 : -50;
  network.project.master.dc.dcm.mode = GetParam();
  ClockBed bed(std::move(network));
  const auto clocks = bed.set_up();
  ASSERT_TRUE(clocks);
  EXPECT_TRUE(clocks->settled);
  EXPECT_LT(bed.largest_clock_difference(), 100);
  if (GetParam() == DcmMode::kMasterShift) {
    EXPECT_LT(clocks->burst_frames, 3000U);
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, Burst, ::testing::Values(DcmMode::kMasterShift, DcmMode::kBusShift));

TEST(DcSetup, BurstSendsWhatItIsToldWhenItMayNotEndEarly) {
  auto network = random_tree(5, 5, false);
  auto& dc = network.project.master.dc;
  dc.burst_total = 1000;
  dc.burst_bulk = 7;
  dc.burst_ends_early = false;
  ClockBed bed(network);
  const auto begin = bed.clock.now();
  const auto clocks = bed.set_up();
  ASSERT_TRUE(clocks);
  EXPECT_EQ(clocks->burst_frames, 1000U);
  EXPECT_GE(bed.clock.now() - begin, 1000 / 7 * kMillisecond);
  EXPECT_LT(bed.clock.now() - begin, 1000 / 6 * kMillisecond);
}

/// In the pace of such cycles it would take 33 s in bus shift; and near they are all the same.
TEST(DcSetup, BurstDoesNotWaitForLongCycles) {
  auto network = random_tree(20, 5, false);
  network.project.master.cycle_time = 20 * kMillisecond;
  for (std::size_t i = 0; i < 20; ++i) network.sim.slaves[i].oscillator.ppm = i % 2 == 0 ? 50 : -50;
  for (const auto mode : {DcmMode::kMasterShift, DcmMode::kBusShift}) {
    network.project.master.dc.dcm.mode = mode;
    ClockBed bed(network);
    const auto begin = bed.clock.now();
    const auto clocks = bed.set_up();
    ASSERT_TRUE(clocks);
    EXPECT_LT(bed.largest_clock_difference(), 100);
    EXPECT_LT(bed.clock.now() - begin, 4 * kSecond);
    const auto cycles = clocks->burst_frames / 12;
    EXPECT_GE(bed.clock.now() - begin, cycles * 2 * kMillisecond) << "a tenth of the cycle";
  }
}

TEST(DcSetup, WithoutABurstTheReferenceClockIsAskedAllTheSame) {
  auto network = random_tree(5, 5, false);
  network.project.master.dc.burst_total = 0;
  network.project.master.dc.burst_ends_early = false;
  ClockBed bed(network);
  const auto clocks = bed.set_up();
  ASSERT_TRUE(clocks) << describe(clocks.error());
  EXPECT_EQ(clocks->burst_frames, 1U);
  EXPECT_FALSE(clocks->settled);
  EXPECT_NE(clocks->reference_time, 0);
}

TEST(DcSetup, LoopsGetTheStartValuesThatAreSet) {
  auto network = random_tree(4, 5, false);
  auto& dc = network.project.master.dc;
  dc.dcm.mode = DcmMode::kMasterShift;
  dc.loop = {0x0800, std::uint8_t{3}, std::uint8_t{11}};
  ClockBed bed(std::move(network));
  ASSERT_TRUE(bed.set_up());
  EXPECT_EQ(bed.bus().peek(1, 0x0930, 2), (std::vector<std::uint8_t>{0x00, 0x08}));
  EXPECT_EQ(bed.bus().peek(1, 0x0934, 2), (std::vector<std::uint8_t>{3, 11}));
}

TEST(DcSetup, FirstSlaveWithASystemTimeLeadsByOverride) {
  auto network = random_tree(1, 1, false);
  for (int i = 1; i < 5; ++i) network.add(test::io8());
  network.sim.slaves[0].dc.system_time = false;  // its feature bits say otherwise
  network.project.master.dc.reference_clock = 3;
  ClockBed configured(network);
  auto clocks = configured.set_up();
  ASSERT_TRUE(clocks);
  EXPECT_EQ(clocks->reference_clock, 3);
  EXPECT_FALSE(clocks->slaves[1].synchronised);  // in front of it
  network.project.master.dc.first_slave_is_reference_clock = true;
  ClockBed overridden(network);
  clocks = overridden.set_up();
  ASSERT_TRUE(clocks);
  EXPECT_EQ(clocks->reference_clock, 1);
  EXPECT_TRUE(clocks->slaves[4].synchronised);
}

TEST(DcSetup, ReplacesAReferenceClockWithoutSystemTimeByTheNextOne) {
  auto network = random_tree(1, 1, false);
  for (int i = 1; i < 3; ++i) network.add(test::io8());
  network.sim.slaves[1].dc.system_time = false;
  network.project.master.dc.reference_clock = 1;
  ClockBed bed(network);
  auto clocks = bed.set_up();
  ASSERT_TRUE(clocks);
  EXPECT_EQ(clocks->without_time, 1);
  EXPECT_EQ(clocks->reference_clock, 2);
  EXPECT_EQ(clocks->home, 2);

  network.sim.slaves[2].dc.system_time = false;
  ClockBed nobody(std::move(network));
  clocks = nobody.set_up();
  ASSERT_FALSE(clocks);
  EXPECT_EQ(clocks.error().code, ErrorCode::kDcSetup);
  EXPECT_NE(clocks.error().subject.find("slave 1"), std::string::npos);
}

/// A terminal, and four more behind it, of which some keep their clocks as they are.
SimulatedNetwork with_stubborn(std::vector<int> slaves) {
  SimulatedNetwork network;
  for (int i = 0; i < 5; ++i) network.add(test::io8());
  for (const auto slave : slaves) {
    FaultConfig fault;
    fault.kind = FaultKind::kIgnoredClockWrites;
    fault.slave = slave;
    network.sim.faults.push_back(fault);
  }
  return network;
}

TEST(DcSetup, NamesTheClocksThatDoNotTakeTheirOffset) {
  ClockBed bed(with_stubborn({2, 4}));
  const auto network = bed.set_up();
  ASSERT_FALSE(network);
  EXPECT_EQ(network.error().code, ErrorCode::kDcSetup);
  const auto& subject = network.error().subject;
  EXPECT_NE(subject.find("slave 2"), std::string::npos) << subject;
  EXPECT_NE(subject.find("slave 4"), std::string::npos) << subject;
  EXPECT_EQ(subject.find("slave 3"), std::string::npos) << subject;
  const auto why = network.error().detail.text();
  EXPECT_NE(why.find("2 of the clocks"), std::string::npos) << why;
  EXPECT_NE(why.find("0x0920"), std::string::npos) << why;
}

TEST(DcSetup, ClocksThatNobodyUsesMayStayAsTheyAre) {
  auto network = with_stubborn({0});
  network.project.master.dc.reference_clock = 1;
  ClockBed bed(network);
  const auto result = bed.set_up();
  EXPECT_TRUE(result) << result.error().detail.text();
}

}  // namespace
}  // namespace syncline
