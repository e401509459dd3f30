// SPDX-License-Identifier: Apache-2.0
#include "dc/propagation_delay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "segment_truth.h"

namespace syncline::dc {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::IsEmpty;
using ::testing::SizeIs;

DelayNode node(std::optional<std::uint16_t> parent, std::uint8_t parent_port,
               std::initializer_list<std::pair<unsigned, std::uint32_t>> times, DcKind kind = DcKind::kFull) {
  DelayNode result;
  result.kind = kind;
  result.parent = parent;
  result.parent_port = parent_port;
  result.receive_time.fill(1'819'436'374);  // seen on unused ports of real slaves
  for (const auto& [port, time] : times) {
    result.active[port] = true;
    result.receive_time[port] = time;
  }
  return result;
}

/// Those that are connected to the one before them by E-bus.
std::vector<DelayNode> at_ebus(std::vector<DelayNode> nodes, std::initializer_list<std::size_t> which) {
  for (const auto i : which) nodes[i].ebus[0] = true;
  return nodes;
}

TEST(PropagationDelay, LineOfThree) {
  const std::vector nodes{node({}, 0, {{0, 648'892'279}, {1, 648'894'639}}),
                          node(0, 1, {{0, 2'796'742'688}, {1, 2'796'744'288}}), node(1, 1, {{0, 2'302'596'891}})};
  const auto result = propagation_delays(nodes);
  EXPECT_THAT(result.delay_ns, ElementsAre(0, 400, 1200));
  EXPECT_THAT(result.findings, IsEmpty());
}

TEST(PropagationDelay, LineWithoutTDiffIsWrongByHalfOfItAHop) {
  const std::vector nodes{node({}, 0, {{0, 648'892'279}, {1, 648'894'639}}),
                          node(0, 1, {{0, 2'796'742'688}, {1, 2'796'744'288}}), node(1, 1, {{0, 2'302'596'891}})};
  EXPECT_THAT(propagation_delays(nodes, {.t_diff_ns = 0}).delay_ns, ElementsAre(0, 380, 1180));
}

/// A millisecond from slave to slave is no cable; what is measured wrongly is left out.
TEST(PropagationDelay, AHopHasALimit) {
  const auto hop = [](std::uint32_t round_trip) {
    const std::vector nodes{node({}, 0, {{0, 0}, {1, round_trip}}), node(0, 1, {{0, 9}})};
    return propagation_delays(nodes, {.t_diff_ns = 0});
  };
  EXPECT_THAT(hop(2'000'000).delay_ns, ElementsAre(0, 1'000'000));
  EXPECT_THAT(hop(2'000'000).findings, IsEmpty());
  EXPECT_THAT(hop(2'000'002).delay_ns, ElementsAre(0, 0));
  EXPECT_THAT(hop(2'000'002).findings, testing::Not(IsEmpty()));
}

TEST(PropagationDelay, TreeOfTheDataSheet) {
  const std::vector nodes{node({}, 0, {{0, 1000}, {1, 5680}}),
                          node(0, 1, {{0, 7000}, {1, 9260}, {2, 10'920}}),
                          node(1, 1, {{0, 50}, {1, 750}}),
                          node(2, 1, {{0, 9}}),
                          node(1, 2, {{0, 4'294'967'000}, {1, 444}}),
                          node(4, 1, {{0, 77}})};
  EXPECT_THAT(propagation_delays(nodes).delay_ns, ElementsAre(0, 400, 1200, 1550, 3120, 3490));
}

TEST(PropagationDelay, StarOnAJunction) {
  const std::vector nodes{node({}, 0, {{0, 648'892'279}, {3, 648'892'959}, {1, 648'893'639}, {2, 648'894'359}}),
                          node(0, 3, {{0, 1}}), node(0, 1, {{0, 2}}), node(0, 2, {{0, 3}})};
  EXPECT_THAT(propagation_delays(nodes).delay_ns, ElementsAre(0, 340, 1000, 1700));
}

TEST(PropagationDelay, SlaveWithoutDcInBetweenCountsAsWire) {
  // A - M (no DC) - C - D, wires 100, 100, 50: the rule is to give C exactly 800.
  SegmentTruth segment;
  segment.add({}, 0, 0);
  segment.add(0, 1, 100, DcKind::kNone);
  segment.add(1, 1, 100);
  segment.add(2, 1, 50);
  segment.walk();
  const auto result = propagation_delays(segment.nodes());
  EXPECT_THAT(result.delay_ns, ElementsAre(0, std::nullopt, 800, 1150));
}

TEST(PropagationDelay, CouplerAndTerminalsAsCaptured) {
  const std::vector nodes{node({}, 0, {{0, 1'013'059'410}, {1, 1'013'060'010}}),
                          node(0, 1, {{0, 1'024'186'030}, {1, 1'024'186'340}}, DcKind::kReceiveTimesOnly),
                          node(1, 1, {{0, 5}})};
  // The master of that capture left tDiff out.
  EXPECT_THAT(propagation_delays(nodes, {.t_diff_ns = 0}).delay_ns, ElementsAre(0, 145, 300));
  EXPECT_THAT(propagation_delays(at_ebus(nodes, {1, 2})).delay_ns, ElementsAre(0, 155, 310)) << "hops are the same";
}

TEST(PropagationDelay, ForkAtACouplerAsReadFromHardware) {
  // A coupler with terminals at port 1 and a second branch at port 2; published with the delays without tDiff.
  const std::vector nodes{node({}, 0, {{0, 3'380'373'882}, {1, 3'380'374'482}, {2, 3'380'375'762}}),
                          node(0, 1, {{0, 3'384'116'362}, {2, 3'384'116'672}}), node(1, 2, {{0, 7}}),
                          node(0, 2, {{0, 3'373'883'962}, {1, 3'373'884'272}}), node(3, 1, {{0, 8}})};
  EXPECT_THAT(propagation_delays(nodes, {.t_diff_ns = 0}).delay_ns, ElementsAre(0, 145, 300, 1085, 1240));
  EXPECT_THAT(propagation_delays(at_ebus(nodes, {1, 2, 4})).delay_ns, ElementsAre(0, 155, 310, 1085, 1240));
}

TEST(PropagationDelay, TwoSlavesOnOneCableAsCaptured) {
  const std::vector nodes{node({}, 0, {{0, 100}, {1, 1540}}), node(0, 1, {{0, 4}})};
  EXPECT_THAT(propagation_delays(nodes).delay_ns, ElementsAre(0, 720));
}

TEST(PropagationDelay, ClockThatWrapsBetweenPortsIsNoReversedCable) {
  const std::vector nodes{node({}, 0, {{0, 4'294'967'196}, {1, 2'260}}), node(0, 1, {{0, 4}})};
  const auto result = propagation_delays(nodes);
  EXPECT_THAT(result.entry_port, ElementsAre(0, 0));
  EXPECT_THAT(result.delay_ns, ElementsAre(0, 1180));
  EXPECT_THAT(result.findings, IsEmpty());
}

TEST(PropagationDelay, FirstSlaveWithReceiveTimesIsTheOrigin) {
  SegmentTruth segment;
  segment.add({}, 0, 0, DcKind::kNone);
  segment.add(0, 1, 100);
  segment.add(1, 1, 100);
  segment.walk();
  EXPECT_THAT(propagation_delays(segment.nodes()).delay_ns, ElementsAre(std::nullopt, 0, 400));
}

TEST(PropagationDelay, ReversedCableIsToldAndMeasured) {
  SegmentTruth segment;
  segment.add({}, 0, 0);
  segment.add(0, 1, 100);
  segment.slaves[1].entry = 1;
  segment.add(1, 0, 80);
  segment.add(2, 1, 60);
  segment.walk();
  const auto result = propagation_delays(segment.nodes());
  EXPECT_THAT(result.entry_port, ElementsAre(0, 1, 0, 0));
  ASSERT_THAT(result.findings, SizeIs(1));
  EXPECT_EQ(result.findings[0].position, 1);
  EXPECT_EQ(result.findings[0].warning, DelayWarning::kReversedCable);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(result.delay_ns[i], segment.delay(i)) << i;
}

TEST(PropagationDelay, SubtreeLongerThanItsRoundTripIsNoUnderflow) {
  // B says that what hangs on it takes longer than A saw it take: noise or a wrong topology.
  const std::vector nodes{node({}, 0, {{0, 0}, {1, 500}}), node(0, 1, {{0, 0}, {1, 700}}), node(1, 1, {{0, 0}})};
  const auto result = propagation_delays(nodes);
  ASSERT_TRUE(result.delay_ns[1]);
  EXPECT_EQ(*result.delay_ns[1], 0U);
  EXPECT_THAT(result.findings, ElementsAre(Field(&DelayFinding::warning, DelayWarning::kNegativeHop),
                                           Field(&DelayFinding::warning, DelayWarning::kNotIncreasing)));
}

TEST(PropagationDelay, ANegativeHopCountsAsNone) {
  // C says 700 ns below it, B saw 500: C is taken to stand where B stands, not before it.
  const std::vector nodes{node({}, 0, {{0, 0}, {1, 1300}}), node(0, 1, {{0, 0}, {1, 500}}),
                          node(1, 1, {{0, 0}, {1, 700}}), node(2, 1, {{0, 0}})};
  const auto result = propagation_delays(nodes);
  EXPECT_EQ(result.delay_ns[1], 420U);
  EXPECT_EQ(result.delay_ns[2], 420U);
}

TEST(PropagationDelay, HopOfMoreThanAMillisecondIsToldAndNotUsed) {
  const std::vector nodes{node({}, 0, {{0, 0}, {1, 3'000'000}}), node(0, 1, {{0, 0}})};
  const auto result = propagation_delays(nodes);
  ASSERT_THAT(result.findings, ElementsAre(Field(&DelayFinding::warning, DelayWarning::kImplausibleHop),
                                           Field(&DelayFinding::warning, DelayWarning::kNotIncreasing)));
  EXPECT_EQ(result.findings[0].value_ns, 1'500'000);
  EXPECT_LT(result.delay_ns[1].value_or(UINT32_MAX), 1'000U);
}

/// A coupler without receive times, with a branch of two at port D in front of a line of three at port B: the line's
/// own cables are measured, and how far behind the branch it is can be told but for two cables.
TEST(PropagationDelay, BranchesOfASlaveWithoutReceiveTimesFollowOneAnother) {
  const std::vector nodes{node({}, 0, {{0, 0}, {3, 0}, {1, 0}}, DcKind::kNone),
                          node(0, 3, {{0, 700'000}, {1, 701'000}}),
                          node(1, 1, {{0, 90'000}}),
                          node(0, 1, {{0, 5'000}, {1, 7'000}}),
                          node(3, 1, {{0, 40'000}, {1, 40'700}}),
                          node(4, 1, {{0, 1'000'000}})};
  const auto result = propagation_delays(nodes);
  const std::uint32_t line = 1'000 + 600;
  EXPECT_THAT(result.delay_ns, ElementsAre(std::nullopt, 0, 500, line, line + 670, line + 670 + 350));
  ASSERT_THAT(result.findings, SizeIs(1));
  EXPECT_EQ(result.findings[0].position, 3);
  EXPECT_EQ(result.findings[0].warning, DelayWarning::kUnmeasuredWay);
  EXPECT_EQ(result.findings[0].value_ns, line);
}

TEST(PropagationDelay, NothingForNoSlaves) { EXPECT_THAT(propagation_delays({}).delay_ns, IsEmpty()); }

}  // namespace
}  // namespace syncline::dc
