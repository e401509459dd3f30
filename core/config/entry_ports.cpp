// SPDX-License-Identifier: Apache-2.0
#include "config/entry_ports.h"

#include <algorithm>
#include <array>

#include "config/previous_port.h"
#include "protocol/dl_status.h"

namespace syncline {
namespace {

struct Branch {
  std::uint8_t port = 0;
  std::size_t first = 0;  // position of the first slave in it
};

struct Slave {
  std::vector<std::size_t> children;
  std::size_t first = 0;  // of it and all behind it
  bool reached = false;   // from a slave that hangs at nobody
};

bool hangs(std::span<const std::optional<PreviousPort>> previous, std::size_t i) {
  return previous[i] && previous[i]->position != i && previous[i]->position < previous.size();
}

std::vector<Slave> tree_of(std::span<const std::optional<PreviousPort>> previous) {
  std::vector<Slave> slaves(previous.size());
  std::vector<std::size_t> open, order;
  for (std::size_t i = 0; i < previous.size(); ++i) {
    if (hangs(previous, i)) slaves[previous[i]->position].children.push_back(i);
    if (!previous[i]) open.push_back(i);
  }
  while (!open.empty()) {
    const auto i = open.back();
    open.pop_back();
    order.push_back(i);
    slaves[i].reached = true;
    slaves[i].first = i;
    open.insert(open.end(), slaves[i].children.begin(), slaves[i].children.end());
  }
  for (auto i = order.rbegin(); i != order.rend(); ++i) {
    for (const auto child : slaves[*i].children) slaves[*i].first = std::min(slaves[*i].first, slaves[child].first);
  }
  return slaves;
}

/// Whether a frame that comes in at `entry` passes the processing unit behind those branches that stand before the
/// slave and before the others; `exact`: and the branches in their order.
bool explains(std::uint8_t entry, std::span<const Branch> branches, std::size_t own, bool exact) {
  const auto begin = static_cast<std::size_t>(std::ranges::find(kPortOrder, entry) - kPortOrder.begin());
  bool processed = entry == 0;
  std::size_t last = 0;
  for (std::size_t step = 1; step <= kPortOrder.size(); ++step) {
    const auto port = kPortOrder[(begin + step) % kPortOrder.size()];
    for (const auto& branch : branches) {
      if (branch.port != port) continue;
      if (step == kPortOrder.size() || (branch.first < own) == processed || (exact && branch.first < last))
        return false;
      last = branch.first;
    }
    processed = processed || port == 0;
  }
  return true;
}

std::optional<std::uint8_t> entry_of(std::span<const Branch> branches, std::size_t own) {
  for (const bool exact : {true, false}) {
    for (std::uint8_t entry = 0; entry < kPortCount; ++entry) {
      if (explains(entry, branches, own, exact)) return entry;
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::optional<std::uint8_t>> entry_ports(std::span<const std::optional<PreviousPort>> previous) {
  const auto slaves = tree_of(previous);
  std::vector<std::optional<std::uint8_t>> result(previous.size());
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    if (!slaves[i].reached) continue;
    std::vector<Branch> branches;
    for (const auto child : slaves[i].children) branches.push_back({previous[child]->port, slaves[child].first});
    result[i] = entry_of(branches, i);
  }
  return result;
}

}  // namespace syncline
