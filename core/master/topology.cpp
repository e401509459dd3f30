// SPDX-License-Identifier: Apache-2.0
#include "master/topology.h"

#include <algorithm>

namespace syncline {
namespace {

/// Active ports of one slave as a frame from the master leaves by them, before and behind the processing
/// unit, which lies between port 0 and port 3.
struct Ways {
  std::vector<std::uint8_t> before, behind;
};

Ways ways_of(const DlStatus& status, std::uint8_t entry) {
  Ways ways;
  std::size_t at = 0;
  while (kPortOrder[at] != entry) ++at;
  bool processed = entry == 0;
  for (std::size_t step = 1; step < kPortOrder.size(); ++step) {
    const auto port = static_cast<std::uint8_t>(kPortOrder[(at + step) % kPortOrder.size()]);
    if (status.active(port)) (processed ? ways.behind : ways.before).push_back(port);
    if (port == 0) processed = true;
  }
  return ways;
}

/// A slave and the ports behind it that nobody was found for yet.
struct Branching {
  std::uint16_t position = 0;
  std::vector<std::uint8_t> ports;  // in frame order
};

class Builder {
 public:
  explicit Builder(std::span<const PortReport> slaves) : wiring_(slaves.size()) {
    for (std::uint16_t i = 0; i < slaves.size(); ++i) {
      wiring_[i].entry_port = entry_port(slaves[i]);
      auto ways = ways_of(slaves[i].dl_status, wiring_[i].entry_port);
      adopt(i, ways.before);
      seen_.push_back({i, std::move(ways.behind)});
    }
    const auto roots = join(seen_);
    if (!roots.empty()) wiring_[roots.front()].root = true;
  }
  std::vector<SlaveWiring> take() { return std::move(wiring_); }

 private:
  /// The last complete subtrees hang at these ports of a slave that comes after them.
  void adopt(std::uint16_t position, std::span<const std::uint8_t> ports) {
    if (ports.empty()) return;
    const auto begin = last_subtrees(ports.size());
    if (!begin) {
      for (const auto port : ports) mark(position, port);
      return;
    }
    const auto roots = join(std::span(seen_).subspan(*begin));
    for (std::size_t n = 0; n < roots.size(); ++n) wiring_[roots[n]].previous = PreviousPort{position, ports[n]};
    seen_.resize(*begin);
  }

  /// Where the shortest end of the list begins that is made of `wanted` whole subtrees.
  [[nodiscard]] std::optional<std::size_t> last_subtrees(std::size_t wanted) const {
    std::size_t whole = 0;
    for (std::size_t i = seen_.size(); i-- > 0;) {
      if (seen_[i].ports.size() > whole) return std::nullopt;  // still waits for slaves
      whole = whole - seen_[i].ports.size() + 1;
      if (whole == wanted) return i;
    }
    return std::nullopt;
  }

  /// Every slave hangs at the next free port of the nearest one before it that has any; those without
  /// are the roots.
  std::vector<std::uint16_t> join(std::span<Branching> list) {
    std::vector<std::uint16_t> roots;
    std::vector<Branching*> path;
    for (auto& slave : list) {
      while (!path.empty() && path.back()->ports.empty()) path.pop_back();
      if (path.empty()) {
        roots.push_back(slave.position);
      } else {
        auto& parent = *path.back();
        wiring_[slave.position].previous = PreviousPort{parent.position, parent.ports.front()};
        parent.ports.erase(parent.ports.begin());
      }
      path.push_back(&slave);
    }
    for (const auto& slave : list) {
      for (const auto port : slave.ports) mark(slave.position, port);
    }
    return roots;
  }

  void mark(std::uint16_t position, std::uint8_t port) {
    wiring_[position].unexplained_ports = static_cast<std::uint8_t>(wiring_[position].unexplained_ports | (1U << port));
  }

  std::vector<SlaveWiring> wiring_;
  std::vector<Branching> seen_;
};

}  // namespace

std::uint8_t entry_port(const PortReport& slave) {
  if (!slave.receive_times) return 0;
  std::optional<std::uint8_t> first;
  for (std::uint8_t port = 0; port < kPortCount; ++port) {
    if (!slave.dl_status.active(port)) continue;
    const auto ahead = first ? static_cast<std::int32_t>((*slave.receive_times)[port] - (*slave.receive_times)[*first]) : -1;
    if (ahead < 0) first = port;
  }
  return first.value_or(0);
}

std::vector<SlaveWiring> find_wiring(std::span<const PortReport> slaves) { return Builder(slaves).take(); }

std::vector<std::optional<PreviousPort>> find_topology(std::span<const DlStatus> slaves) {
  std::vector<PortReport> reports;
  for (const auto& status : slaves) reports.push_back({status, {}});
  std::vector<std::optional<PreviousPort>> previous;
  for (const auto& wiring : find_wiring(reports)) previous.push_back(wiring.previous);
  return previous;
}

}  // namespace syncline
