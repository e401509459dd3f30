// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "config/previous_port.h"
#include "protocol/dl_status.h"
#include "support/random.h"

namespace syncline::test {

/// A slave of a tree in which cables are plugged into any ports. Frame order.
struct SwappedSlave {
  std::optional<PreviousPort> previous;
  std::uint8_t entry = 0;
};

/// Up to `size` slaves, a third of them entered by another port than A. One at most has nothing at port A then.
inline std::vector<SwappedSlave> swapped_tree(std::size_t size, std::uint64_t seed) {
  struct Node {
    int parent = -1;
    std::uint8_t port = 0, entry = 0;
    std::array<int, kPortCount> child{-1, -1, -1, -1};
  };
  Random random(seed);
  const auto below = [&random](std::size_t n) {
    return static_cast<std::size_t>(random.uniform() * static_cast<double>(n));
  };
  const auto any_entry = [&] { return static_cast<std::uint8_t>(random.uniform() < 0.33 ? 1 + below(3) : 0); };
  std::vector<Node> nodes{{.entry = any_entry()}};
  const auto wanted = 1 + below(size);
  while (nodes.size() < wanted) {
    const auto parent = below(nodes.size());
    const auto port = static_cast<std::uint8_t>(below(kPortCount));
    if (port == nodes[parent].entry || nodes[parent].child[port] >= 0) continue;
    nodes[parent].child[port] = static_cast<int>(nodes.size());
    nodes.push_back({.parent = static_cast<int>(parent), .port = port, .entry = any_entry()});
  }
  // A second slave with nothing at port A would destroy all frames: the first marks them as circulating.
  bool marked = false;
  for (auto& node : nodes) {
    if (node.entry == 0 || node.child[0] >= 0) continue;
    if (marked) node.entry = 0;
    marked = true;
  }
  std::vector<std::size_t> order, place(nodes.size());
  const auto process = [&](std::size_t i) {
    place[i] = order.size();
    order.push_back(i);
  };
  const auto visit = [&](const auto& self, std::size_t i) -> void {
    const auto& node = nodes[i];
    const auto begin = static_cast<std::size_t>(std::ranges::find(kPortOrder, node.entry) - kPortOrder.begin());
    if (node.entry == 0) process(i);
    for (std::size_t step = 1; step < kPortOrder.size(); ++step) {
      const auto port = kPortOrder[(begin + step) % kPortOrder.size()];
      if (node.child[port] >= 0) self(self, static_cast<std::size_t>(node.child[port]));
      if (port == 0) process(i);
    }
  };
  visit(visit, 0);
  std::vector<SwappedSlave> slaves;
  for (const auto i : order) {
    slaves.push_back({{}, nodes[i].entry});
    if (nodes[i].parent < 0) continue;
    slaves.back().previous =
        PreviousPort{static_cast<std::uint16_t>(place[static_cast<std::size_t>(nodes[i].parent)]), nodes[i].port};
  }
  return slaves;
}

}  // namespace syncline::test
