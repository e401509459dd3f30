// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "channels/values/bus_scan.h"
#include "master/scan/scan_findings.h"
#include "master/scan/topology.h"
#include "support/random.h"

namespace syncline {
namespace {

DlStatus with_open(unsigned ports) {
  std::uint16_t value = 0x0001;
  for (unsigned port = 0; port < kPortCount; ++port) {
    const bool open = ((ports >> port) & 1U) != 0;
    value =
        static_cast<std::uint16_t>(value | (open ? (1U << (9 + 2 * port)) | (1U << (4 + port)) : 1U << (8 + 2 * port)));
  }
  return {value};
}

/// A tree with any ports, and what its slaves would report: the truth to compare with.
struct Tree {
  struct Node {
    int parent = -1;
    std::uint8_t parent_port = 0, entry = 0;
    std::array<int, 4> child{-1, -1, -1, -1};
    std::array<std::uint32_t, 4> times{};
    int position = -1;
  };
  std::vector<Node> nodes;
  std::vector<int> order;  // by position
  std::uint32_t now = 0;

  explicit Tree(std::uint8_t entry) { nodes.push_back({.entry = entry}); }
  int add(int parent, std::uint8_t parent_port, std::uint8_t entry) {
    const auto index = static_cast<int>(nodes.size());
    nodes[static_cast<std::size_t>(parent)].child[parent_port] = index;
    nodes.push_back({.parent = parent, .parent_port = parent_port, .entry = entry});
    return index;
  }
  void walk(std::uint32_t start) {
    now = start;
    visit(0);
  }
  std::vector<PortReport> reports() const {
    std::vector<PortReport> result;
    for (const auto index : order) {
      const auto& node = nodes[static_cast<std::size_t>(index)];
      unsigned open = 1U << node.entry;
      for (unsigned port = 0; port < 4; ++port) open |= node.child[port] >= 0 ? 1U << port : 0U;
      result.push_back({with_open(open), node.times});
    }
    return result;
  }
  std::optional<PreviousPort> previous(std::size_t position) const {
    const auto& node = nodes[static_cast<std::size_t>(order[position])];
    if (node.parent < 0) return std::nullopt;
    return PreviousPort{static_cast<std::uint16_t>(nodes[static_cast<std::size_t>(node.parent)].position),
                        node.parent_port};
  }

 private:
  void visit(int index) {
    auto at = [&]() -> Node& { return nodes[static_cast<std::size_t>(index)]; };
    at().times[at().entry] = now;
    std::size_t step = 0;
    while (kPortOrder[step] != at().entry) ++step;
    const auto process = [&] {
      at().position = static_cast<int>(order.size());
      order.push_back(index);
    };
    if (at().entry == 0) process();
    for (std::size_t n = 1; n < 4; ++n) {
      const auto port = kPortOrder[(step + n) % 4];
      if (at().child[port] >= 0) {
        now += 500;
        visit(at().child[port]);
        now += 500;
        at().times[port] = now;
      }
      if (port == 0) process();
    }
  }
};

TEST(Wiring, ASlaveConnectedByPortBWithTwoBranches) {
  Tree tree(0);
  const auto turned = tree.add(0, 1, 1);
  tree.add(turned, 2, 0);
  tree.add(turned, 0, 0);
  tree.walk(1000);
  // Both branches are processed before the slave they hang at.
  ASSERT_EQ(tree.order, (std::vector<int>{0, 2, 3, 1}));
  const auto wiring = find_wiring(tree.reports());
  EXPECT_EQ(wiring[3].entry_port, 1);
  EXPECT_EQ(wiring[3].previous, (PreviousPort{0, 1}));
  EXPECT_EQ(wiring[1].previous, (PreviousPort{3, 2}));
  EXPECT_EQ(wiring[2].previous, (PreviousPort{3, 0}));
}

TEST(Wiring, ReceiveTimesMayWrap) {
  Tree tree(0);
  const auto turned = tree.add(0, 3, 2);
  tree.add(turned, 0, 0);
  tree.walk(0xFFFF'FF00U);
  const auto wiring = find_wiring(tree.reports());
  EXPECT_EQ(wiring[2].entry_port, 2);
  EXPECT_EQ(wiring[1].previous, (PreviousPort{2, 0}));
}

/// A tree of up to 40 slaves, each connected by port A, or by any port.
Tree random_tree(std::uint64_t seed, bool upright) {
  Random random(seed);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random.uniform() * static_cast<double>(n)); };
  Tree tree(0);
  const auto size = 1 + below(40);
  while (tree.nodes.size() < size) {
    const auto parent = below(tree.nodes.size());
    const auto port = static_cast<std::uint8_t>(below(4));
    if (port == tree.nodes[parent].entry || tree.nodes[parent].child[port] >= 0) continue;
    tree.add(static_cast<int>(parent), port, upright ? std::uint8_t{0} : static_cast<std::uint8_t>(below(4)));
  }
  return tree;
}

TEST(Wiring, EveryTreeIsFoundAgain) {
  for (const bool upright : {true, false}) {
    EXPECT_TRUE(rc::check([upright](std::uint64_t seed, std::uint32_t start) {
      auto tree = random_tree(seed, upright);
      tree.walk(start);
      const auto wiring = find_wiring(tree.reports());
      for (std::size_t i = 0; i < wiring.size(); ++i) {
        RC_ASSERT(wiring[i].previous == tree.previous(i));
        RC_ASSERT(wiring[i].unexplained_ports == 0);
      }
    }));
  }
}

TEST(Wiring, ASlaveWithoutReceiveTimesIsTakenAsExplainsTheOrder) {
  Tree tree(0);
  const auto turned = tree.add(0, 1, 1);
  tree.add(turned, 0, 0);
  tree.walk(1000);
  ASSERT_EQ(tree.order, (std::vector<int>{0, 2, 1}));
  auto reports = tree.reports();
  reports[2].receive_times.reset();
  const auto wiring = find_wiring(reports);
  for (std::size_t i = 0; i < wiring.size(); ++i) EXPECT_EQ(wiring[i].previous, tree.previous(i)) << i;
  EXPECT_EQ(wiring[2].entry_port, 1);
}

TEST(Wiring, TheLastSlaveWithoutReceiveTimesIsEnteredByItsOnlyOpenPort) {
  Tree tree(0);
  tree.add(0, 1, 1);
  tree.walk(1000);
  auto reports = tree.reports();
  reports[1].receive_times.reset();
  const auto wiring = find_wiring(reports);
  EXPECT_EQ(wiring[1].entry_port, 1);
  EXPECT_EQ(wiring[1].previous, (PreviousPort{0, 1}));
}

/// The last slave's port B leads to the host's other adapter, whose frame comes there first: nobody has swapped cables.
TEST(Wiring, ATimeOfAClosedRingTurnsNobodyRound) {
  for (const std::uint8_t closed : {1, 2, 3}) {
    Tree tree(0);
    const auto middle = tree.add(0, 1, 0);
    tree.add(middle, 1, 0);
    tree.walk(1000);
    auto reports = tree.reports();
    reports[2].dl_status = with_open(1U | 1U << closed);
    (*reports[2].receive_times)[closed] = (*reports[2].receive_times)[0] - 700;
    const auto wiring = find_wiring(reports);
    for (std::size_t i = 0; i < wiring.size(); ++i) EXPECT_EQ(wiring[i].previous, tree.previous(i)) << i;
    EXPECT_EQ(wiring[2].entry_port, 0);
    EXPECT_EQ(wiring[2].unexplained_ports, 1U << closed);
  }
}

/// Others hang at the end of the line: they are behind their own port, not behind the one of the ring, whose frame
/// comes before the master's, or before that one is back from them.
TEST(Wiring, ATimeOfAClosedRingTakesNobodysPort) {
  for (const int after : {-700, 300}) {
    Tree tree(0);
    const auto last = tree.add(0, 1, 0);
    const auto branch = tree.add(last, 2, 0);
    tree.add(branch, 1, 0);
    tree.walk(1000);
    auto reports = tree.reports();
    reports[1].dl_status = with_open(0b111);
    auto& times = *reports[1].receive_times;
    times[1] = times[0] + static_cast<std::uint32_t>(after);
    const auto wiring = find_wiring(reports);
    for (std::size_t i = 0; i < wiring.size(); ++i)
      EXPECT_EQ(wiring[i].previous, tree.previous(i)) << i << " " << after;
    EXPECT_EQ(wiring[1].unexplained_ports, 0b10U) << after;
  }
}

/// A branch further up is not behind the ring's port, and its own is not without slaves.
TEST(Wiring, ATimeOfAClosedRingTakesNoBranchFromOthers) {
  // Also so late that the slave seems to have had the frame for longer than the one in front of it was without.
  for (const std::optional<int> after :
       {std::optional(-700), std::optional(300), std::optional(1'200), std::optional(3'500), std::optional<int>()}) {
    Tree tree(0);
    const auto middle = tree.add(0, 1, 0);
    tree.add(middle, 1, 0);
    const auto branch = tree.add(0, 2, 0);
    tree.add(tree.add(branch, 1, 0), 1, 0);
    tree.walk(1000);
    auto reports = tree.reports();
    reports[2].dl_status = with_open(0b11);
    if (after) {
      auto& times = *reports[2].receive_times;
      times[1] = times[0] + static_cast<std::uint32_t>(*after);
    } else {
      reports[2].receive_times.reset();  // the one in front of it has some
    }
    const auto wiring = find_wiring(reports);
    for (std::size_t i = 0; i < wiring.size(); ++i) EXPECT_EQ(wiring[i].previous, tree.previous(i)) << i;
    EXPECT_EQ(wiring[2].unexplained_ports, 0b10U) << after.value_or(0);
    EXPECT_EQ(wiring[0].unexplained_ports, 0U) << after.value_or(0);
  }
}

/// Upright slaves, some without receive times: nobody is taken for swapped.
TEST(Wiring, UprightSlavesWithoutReceiveTimesStayUpright) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    auto tree = random_tree(seed, true);
    tree.walk(77);
    auto reports = tree.reports();
    Random random(seed);
    for (auto& report : reports) {
      if (random.uniform() < 0.5) report.receive_times.reset();
    }
    for (const auto& slave : find_wiring(reports)) RC_ASSERT(slave.entry_port == 0);
  }));
}

TEST(Wiring, AnyReportsAreSurvived) {
  EXPECT_TRUE(rc::check([](const std::vector<std::uint16_t>& statuses, const std::vector<std::uint32_t>& times) {
    std::vector<PortReport> reports;
    for (std::size_t i = 0; i < statuses.size(); ++i) {
      PortReport report{{statuses[i]}, {}};
      if (i + 4 <= times.size()) report.receive_times = {times[i], times[i + 1], times[i + 2], times[i + 3]};
      reports.push_back(report);
    }
    const auto wiring = find_wiring(reports);
    RC_ASSERT(wiring.size() == reports.size());
    for (const auto& slave : wiring) {
      // The macro evaluates both sides of what it is given.
      const bool there = !slave.previous || slave.previous->position < reports.size();
      RC_ASSERT(there);
    }
  }));
}

TEST(ScanFindings, NameWhatIsUnusual) {
  BusScan scan;
  scan.slaves.resize(2);
  scan.slaves[1].position = 1;
  scan.slaves[0].dl_status = with_open(0b0011);
  scan.slaves[1].dl_status = with_open(0b0011);
  scan.slaves[0].alias = scan.slaves[1].alias = 7;
  scan.slaves[0].sii.emplace().alias = 9;
  std::vector<SlaveWiring> wiring(2);
  wiring[0].root = true;
  wiring[1] = {PreviousPort{0, 1}, 1, false, 0b0001};
  add_scan_findings(wiring, scan);
  ASSERT_EQ(scan.findings.size(), 4U);
  EXPECT_EQ(
      describe(scan.findings[0]),
      "The EEPROM of slave 0 has the alias 9, its ESC has 7 until the next power-on. Switch the slave off and on.");
  EXPECT_EQ(facts_text(scan.findings[1]), "Frames enter slave 1 by port B instead of port A.");
  EXPECT_EQ(facts_text(scan.findings[2]), "Port A of slave 1 is open, but no slave answers behind it.");
  EXPECT_EQ(facts_text(scan.findings[3]), "slave 1 has the alias 7, which slave 0 has as well.");
  EXPECT_EQ(scan.findings[3].place.slave, 1);
}

}  // namespace
}  // namespace syncline
