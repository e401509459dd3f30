// SPDX-License-Identifier: Apache-2.0
#include "master/topology.h"

#include <cstdint>
#include <vector>

namespace syncline {
namespace {

/// A slave whose branches have not all been walked yet.
struct Branching {
  std::uint16_t position = 0;
  std::vector<std::uint8_t> ports;  // still to be walked, the next one last
};

Branching branches_of(std::uint16_t position, const DlStatus& status) {
  Branching branching{position, {}};
  for (std::size_t i = kPortOrder.size(); i-- > 1;) {
    if (status.active(kPortOrder[i])) branching.ports.push_back(static_cast<std::uint8_t>(kPortOrder[i]));
  }
  return branching;
}

}  // namespace

std::vector<std::optional<PreviousPort>> find_topology(std::span<const DlStatus> slaves) {
  std::vector<std::optional<PreviousPort>> previous(slaves.size());
  std::vector<Branching> path;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    while (!path.empty() && path.back().ports.empty()) path.pop_back();
    if (!path.empty()) {
      previous[i] = PreviousPort{path.back().position, path.back().ports.back()};
      path.back().ports.pop_back();
    }
    path.push_back(branches_of(static_cast<std::uint16_t>(i), slaves[i]));
  }
  return previous;
}

}  // namespace syncline
