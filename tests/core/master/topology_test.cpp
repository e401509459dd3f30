// SPDX-License-Identifier: Apache-2.0
#include "master/scan/topology.h"

#include <gtest/gtest.h>

namespace syncline {
namespace {

/// DL status with these ports open and communicating, all others closed.
DlStatus open_ports(std::initializer_list<unsigned> ports) {
  std::uint16_t value = 0x0001;
  for (unsigned port = 0; port < kPortCount; ++port) value |= static_cast<std::uint16_t>(1U << (8 + 2 * port));
  for (const auto port : ports) {
    value = static_cast<std::uint16_t>(value & ~(1U << (8 + 2 * port)));
    value = static_cast<std::uint16_t>(value | (1U << (9 + 2 * port)) | (1U << (4 + port)));
  }
  return {value};
}

TEST(Topology, FollowsALine) {
  const std::vector<DlStatus> slaves{open_ports({0, 1}), open_ports({0, 1}), open_ports({0})};
  const auto previous = find_topology(slaves);
  EXPECT_FALSE(previous[0]);
  EXPECT_EQ(previous[1], (PreviousPort{0, 1}));
  EXPECT_EQ(previous[2], (PreviousPort{1, 1}));
}

TEST(Topology, WalksBranchesInPortOrder) {
  // A junction whose branches leave at 3, 1 and 2; the one at 1 is two slaves long.
  const std::vector<DlStatus> slaves{open_ports({0, 1, 2, 3}), open_ports({0}), open_ports({0, 1}), open_ports({0}),
                                     open_ports({0})};
  const auto previous = find_topology(slaves);
  EXPECT_EQ(previous[1], (PreviousPort{0, 3}));
  EXPECT_EQ(previous[2], (PreviousPort{0, 1}));
  EXPECT_EQ(previous[3], (PreviousPort{2, 1}));
  EXPECT_EQ(previous[4], (PreviousPort{0, 2}));
}

TEST(Topology, SaysNothingWhereThePortsExplainNothing) {
  const std::vector<DlStatus> slaves{open_ports({0}), open_ports({0})};
  EXPECT_FALSE(find_topology(slaves)[1]);
}

}  // namespace
}  // namespace syncline
