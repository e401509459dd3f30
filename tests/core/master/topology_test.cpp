// SPDX-License-Identifier: Apache-2.0
#include "master/scan/topology.h"

#include <gtest/gtest.h>

#include "dl_status_of.h"

namespace syncline {
namespace {

/// DL status with these ports open and communicating, all others closed.
using test::open_ports;

/// Of slaves that have no receive times.
std::vector<std::optional<PreviousPort>> predecessors(const std::vector<DlStatus>& slaves) {
  std::vector<PortReport> reports;
  for (const auto& status : slaves) reports.push_back({status, {}});
  std::vector<std::optional<PreviousPort>> previous;
  for (const auto& wiring : find_wiring(reports)) previous.push_back(wiring.previous);
  return previous;
}

TEST(Topology, FollowsALine) {
  const std::vector<DlStatus> slaves{open_ports({0, 1}), open_ports({0, 1}), open_ports({0})};
  const auto previous = predecessors(slaves);
  EXPECT_FALSE(previous[0]);
  EXPECT_EQ(previous[1], (PreviousPort{0, 1}));
  EXPECT_EQ(previous[2], (PreviousPort{1, 1}));
}

TEST(Topology, WalksBranchesInPortOrder) {
  // A junction whose branches leave at 3, 1 and 2; the one at 1 is two slaves long.
  const std::vector<DlStatus> slaves{open_ports({0, 1, 2, 3}), open_ports({0}), open_ports({0, 1}), open_ports({0}),
                                     open_ports({0})};
  const auto previous = predecessors(slaves);
  EXPECT_EQ(previous[1], (PreviousPort{0, 3}));
  EXPECT_EQ(previous[2], (PreviousPort{0, 1}));
  EXPECT_EQ(previous[3], (PreviousPort{2, 1}));
  EXPECT_EQ(previous[4], (PreviousPort{0, 2}));
}

TEST(Topology, SaysNothingWhereThePortsExplainNothing) {
  const std::vector<DlStatus> slaves{open_ports({0}), open_ports({0})};
  EXPECT_FALSE(predecessors(slaves)[1]);
}

}  // namespace
}  // namespace syncline
