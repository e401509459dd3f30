// SPDX-License-Identifier: Apache-2.0
#include "master/clocks/clock_segment.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "dl_status_of.h"

namespace syncline {
namespace {

/// DL status with these ports open and communicating, all others closed.
using test::open_ports;

dc::DelayNode node(const DlStatus& status, std::initializer_list<std::pair<unsigned, std::uint32_t>> times) {
  dc::DelayNode result;
  result.kind = dc::DcKind::kFull;
  result.receive_time.fill(1'819'436'374);
  for (unsigned port = 0; port < kPortCount; ++port) result.active[port] = status.active(port);
  for (const auto& [port, time] : times) result.receive_time[port] = time;
  return result;
}

bool has(const dc::DelayResult& result, dc::DelayWarning warning, std::uint16_t position) {
  return std::ranges::any_of(result.findings, [&](const dc::DelayFinding& finding) {
    return finding.warning == warning && finding.position == position;
  });
}

TEST(SegmentDelays, SlaveConnectedByItsPort1HasItsTrueDelayAndAWarning) {
  // A - B - C with wires of 100 and 200 ns, tP 300, tF 260; B's cables are swapped: the frame comes in at port 1,
  // passes no processing unit on its way out by port 0, and is processed on its way back, behind C.
  const std::vector status{open_ports({0, 1}), open_ports({0}), open_ports({0, 1})};
  // Frame: A in 0, out 300, B in 400 (port 1), out 660, C in 860, out 1160, B in 1360 (port 0), out 1660, A in 1760.
  const std::vector nodes{node(status[0], {{0, 5'000}, {1, 6'760}}), node(status[1], {{0, 77}}),
                          node(status[2], {{1, 400}, {0, 1'360}})};
  const auto result = segment_delays(nodes, segment_wiring(nodes, status), false, {});
  ASSERT_TRUE(result.delay_ns[1] && result.delay_ns[2]);
  EXPECT_EQ(*result.delay_ns[2], 1'360U);
  EXPECT_EQ(*result.delay_ns[1], 860U);
  EXPECT_TRUE(has(result, dc::DelayWarning::kReversedCable, 2));
}

TEST(SegmentDelays, ClosedRingIsLeftOutWithAWarning) {
  // The last slave's port 1 leads to another port of the master: it latches nothing there.
  const std::vector status{open_ports({0, 1}), open_ports({0, 1})};
  const std::vector nodes{node(status[0], {{0, 1'000}, {1, 2'440}}), node(status[1], {{0, 9'000}})};
  const auto result = segment_delays(nodes, segment_wiring(nodes, status), false, {});
  ASSERT_TRUE(result.delay_ns[1]);
  EXPECT_EQ(*result.delay_ns[1], 720U);
  EXPECT_TRUE(has(result, dc::DelayWarning::kUnexplainedPort, 1));
}

TEST(SegmentDelays, SlavesThatNobodyAskedAboutAreNoRing) {
  // The frame came back at port 1 after 800 ns: something hangs there.
  const std::vector status{open_ports({0, 1}), open_ports({0, 1})};
  const std::vector nodes{node(status[0], {{0, 1'000}, {1, 3'240}}), node(status[1], {{0, 9'000}, {1, 9'800}})};
  const auto result = segment_delays(nodes, segment_wiring(nodes, status), false, {.t_diff_ns = 0});
  ASSERT_TRUE(result.delay_ns[1]);
  EXPECT_EQ(*result.delay_ns[1], 720U);
  EXPECT_TRUE(result.findings.empty());
}

/// The other adapter's frame comes to the last slave's port 1 before the master's own comes to port 0, or some time
/// after it. Where nobody else is on the bus that time is of no frame of the master's.
TEST(SegmentDelays, TheTimeOfAClosedRingIsNoTimeOfOurFrame) {
  const std::vector status{open_ports({0, 1}), open_ports({0, 1})};
  for (const std::int32_t after : {-400, 300, 5'000}) {
    const auto ring = static_cast<std::uint32_t>(9'000 + after);
    const std::vector nodes{node(status[0], {{0, 1'000}, {1, 2'440}}), node(status[1], {{0, 9'000}, {1, ring}})};
    const auto result = segment_delays(nodes, segment_wiring(nodes, status), true, {.t_diff_ns = 0});
    ASSERT_TRUE(result.delay_ns[1]);
    EXPECT_EQ(*result.delay_ns[1], 720U) << after;
    EXPECT_EQ(result.entry_port[1], 0) << after;
    ASSERT_EQ(result.findings.size(), 1U) << after;
    EXPECT_TRUE(has(result, dc::DelayWarning::kUnexplainedPort, 1)) << after;
  }
}

}  // namespace
}  // namespace syncline
