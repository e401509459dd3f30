// SPDX-License-Identifier: Apache-2.0
#include "master/scan/topology.h"

#include <gtest/gtest.h>

#include "dl_status_of.h"

namespace syncline {
namespace {

/// DL status with these ports open and communicating, all others closed.
using test::open_ports;

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
