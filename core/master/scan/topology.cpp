// SPDX-License-Identifier: Apache-2.0
#include "master/scan/topology.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "master/scan/foreign_times.h"
#include "master/scan/wiring_tree_builder.h"

namespace syncline {
namespace {

using wiring::Entry;
using wiring::tree_of;
using wiring::unexplained;

/// Entries of slaves without receive times, when port 0 does not explain the order.
class EntrySearch {
 public:
  EntrySearch(std::span<const PortReport> slaves, std::vector<Entry> entries)
      : slaves_(slaves), entries_(std::move(entries)) {}

  std::vector<SlaveWiring> run() {
    wiring::forget_foreign_times(slaves_, entries_, tries_);
    auto tree = tree_of(slaves_, entries_);
    for (auto left = unexplained(tree); left > 0; left = unexplained(tree)) {
      const auto best = best_changes(left);
      if (best.size() != 1) break;  // the ports that nothing explains are named
      entries_[best.front().slave].port = best.front().port;
      tree = tree_of(slaves_, entries_);
    }
    return tree;
  }

 private:
  /// A port of a slave.
  struct Change {
    std::size_t slave = 0;
    std::uint8_t port = 0;
  };

  /// Those after which least is unexplained, and less than now.
  std::vector<Change> best_changes(std::size_t least) {
    std::vector<Change> best;
    for (std::size_t i = 0; i < slaves_.size(); ++i) {
      if (slaves_[i].receive_times) continue;
      for (std::uint8_t port = 0; port < kPortCount; ++port) {
        if (port == entries_[i].port || !slaves_[i].dl_status.active(port) || tries_ == 0) continue;
        --tries_;
        auto entries = entries_;
        entries[i].port = port;
        const auto left = unexplained(tree_of(slaves_, entries));
        if (left < least) best.clear();
        if (left < least || (left == least && !best.empty())) best.push_back({i, port});
        least = std::min(least, left);
      }
    }
    return best;
  }

  std::span<const PortReport> slaves_;
  std::vector<Entry> entries_;
  int tries_ = 2000;  // together: a search goes over all slaves each time
};

}  // namespace

std::uint8_t entry_port(const PortReport& slave) {
  const auto ports = wiring::open_ports(slave.dl_status);
  if (ports == 0) return 0;
  return slave.receive_times ? wiring::first_of(ports, *slave.receive_times)
                             : static_cast<std::uint8_t>(std::countr_zero(ports));
}

std::vector<SlaveWiring> find_wiring(std::span<const PortReport> slaves) {
  std::vector<Entry> entries;
  for (const auto& slave : slaves) entries.push_back({entry_port(slave)});
  return EntrySearch(slaves, std::move(entries)).run();
}

}  // namespace syncline
