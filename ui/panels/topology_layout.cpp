// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/topology_layout.h"

#include <algorithm>

#include "config/wiring_tree.h"

namespace syncline::ui {
namespace {

using Port = TopologyPlace::Port;

/// Every slave behind the one that it hangs at.
std::vector<std::size_t> fromTheMaster(const WiringTree& tree) {
  std::vector<std::size_t> order, open;
  for (std::size_t i = tree.slaves().size(); i-- > 0;) {
    if (!tree.previous(i)) open.push_back(i);
  }
  while (!open.empty()) {
    const auto slave = open.back();
    open.pop_back();
    order.push_back(slave);
    open.insert(open.end(), tree.behind(slave).begin(), tree.behind(slave).end());
  }
  return order;
}

std::array<Port, 4> portsOf(const WiringTree& tree, std::size_t slave) {
  std::array<Port, 4> ports{};
  const auto next = tree.next(slave);
  for (std::size_t place = 0; place < ports.size(); ++place) {
    const auto port = static_cast<std::uint8_t>(place);
    const auto there = tree.at_port(slave, port);
    if (port == tree.slaves()[slave].entry) {
      ports[port] = Port::kEntry;
    } else if (there) {
      ports[port] = there == next ? Port::kWayOn : Port::kBranch;
    } else if (tree.is_free(slave, port)) {
      ports[port] = Port::kFree;
    }
  }
  return ports;
}

}  // namespace

TopologyLayout layoutOf(const WiringTree& tree) {
  const auto order = fromTheMaster(tree);
  const auto count = tree.slaves().size();
  std::vector<int> own(count, 1),
      line(count, 1);  // rows of a slave with its branches, of all from it to the line's end
  for (auto slave = order.rbegin(); slave != order.rend(); ++slave) {
    const auto next = tree.next(*slave);
    int branches = 0;
    for (const auto one : tree.behind(*slave)) branches += one == next ? 0 : line[one];
    own[*slave] = std::max(1, branches);
    line[*slave] = own[*slave] + (next ? line[*next] : 0);
  }
  TopologyLayout layout;
  layout.slaves.resize(count);
  layout.rows = 1;
  for (const auto slave : order) {
    auto& place = layout.slaves[slave];
    place.previous = tree.slaves()[slave].previous;
    place.ports = portsOf(tree, slave);
    if (!place.previous) {
      place.row = layout.rows;
      layout.rows += line[slave];
    }
    const auto next = tree.next(slave);
    place.next = next ? static_cast<int>(*next) : -1;
    int row = place.row;
    for (const auto one : tree.behind(slave)) {
      auto& other = layout.slaves[one];
      other.goes_on = one == next;
      other.row = other.goes_on ? place.row + own[slave] : row;
      other.column = place.column + (other.goes_on ? 0 : 1);
      other.from = other.goes_on ? place.from : static_cast<int>(slave);
      other.before = static_cast<int>(slave);
      if (other.goes_on) continue;
      if (place.first_branch < 0) place.first_branch = static_cast<int>(one);
      row += line[one];
    }
    layout.columns = std::max(layout.columns, place.column + 1);
  }
  return layout;
}

}  // namespace syncline::ui
