// SPDX-License-Identifier: Apache-2.0
#include "master/scan/wiring_tree_builder.h"

#include <bit>
#include <utility>

#include "protocol/first_port.h"

namespace syncline::wiring {
namespace {

/// A slave and the ports behind it that nobody was found for yet.
struct Branching {
  std::uint16_t position = 0;
  std::vector<std::uint8_t> ports;  // in frame order
};

class Builder {
 public:
  Builder(std::span<const PortReport> slaves, std::span<const Entry> entries)
      : slaves_(slaves), entries_(entries), wiring_(slaves.size()) {
    for (std::uint16_t i = 0; i < static_cast<std::uint16_t>(slaves.size()); ++i) {
      wiring_[i].entry_port = entries[i].port;
      wiring_[i].unexplained_ports = static_cast<std::uint8_t>(entries[i].foreign);
      wiring_[i].untimed_ports = static_cast<std::uint8_t>(entries[i].untimed);
      auto ways = ways_of(open_ports(slaves[i].dl_status) & ~entries[i].foreign, entries[i].port);
      for (std::size_t n = ways.before.size(); n-- > 0;) adopt(i, ways.before[n]);
      seen_.push_back({i, std::move(ways.behind)});
    }
    const auto roots = join(seen_);
    if (!roots.empty()) wiring_[roots.front()].root = true;
  }
  std::vector<SlaveWiring> take() { return std::move(wiring_); }

 private:
  /// The last complete subtree hangs at this port of a slave that comes after it.
  void adopt(std::uint16_t position, std::uint8_t port) {
    const auto begin = last_subtree(time_behind(slaves_[position], entries_[position], port));
    if (!begin) return mark(position, port);
    const auto roots = join(std::span(seen_).subspan(*begin));
    wiring_[roots.front()].previous = PreviousPort{position, port};
    seen_.resize(*begin);
  }

  /// Where the subtree at the end of the list begins. Ports alone leave open how far it reaches up; a frame
  /// cannot have been longer in it than `away` from the slave that it hangs at.
  [[nodiscard]] std::optional<std::size_t> last_subtree(std::optional<std::uint32_t> away) const {
    std::optional<std::size_t> found;
    std::size_t whole = 0;
    for (std::size_t i = seen_.size(); i-- > 0;) {
      if (seen_[i].ports.size() > whole) break;  // still waits for slaves
      whole = whole - seen_[i].ports.size() + 1;
      if (whole != 1) continue;
      const auto inside = time_behind(slaves_[seen_[i].position], entries_[seen_[i].position], std::nullopt);
      if (found && (!away || !inside || *inside > *away)) break;
      found = i;
    }
    return found;
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

  std::span<const PortReport> slaves_;
  std::span<const Entry> entries_;
  std::vector<SlaveWiring> wiring_;
  std::vector<Branching> seen_;
};

}  // namespace

unsigned open_ports(const DlStatus& status) {
  unsigned ports = 0;
  for (unsigned port = 0; port < kPortCount; ++port) ports |= status.active(port) ? 1U << port : 0;
  return ports;
}

std::uint8_t first_of(unsigned ports, const std::array<std::uint32_t, kPortCount>& times) {
  std::array<bool, kPortCount> open{};
  for (unsigned port = 0; port < kPortCount; ++port) open[port] = holds(ports, port);
  return static_cast<std::uint8_t>(first_port(open, times).value_or(0));
}

Ways ways_of(unsigned open, std::uint8_t entry) {
  Ways ways;
  std::size_t at = 0;
  while (kPortOrder[at] != entry) ++at;
  bool processed = entry == 0;
  for (std::size_t step = 1; step < kPortOrder.size(); ++step) {
    const auto port = static_cast<std::uint8_t>(kPortOrder[(at + step) % kPortOrder.size()]);
    if (holds(open, port)) (processed ? ways.behind : ways.before).push_back(port);
    if (port == 0) processed = true;
  }
  return ways;
}

std::optional<std::uint32_t> time_behind(const PortReport& slave, const Entry& entry,
                                         std::optional<std::uint8_t> port) {
  if (!slave.receive_times) return std::nullopt;
  const auto open = open_ports(slave.dl_status) & ~entry.foreign;
  std::size_t at = 0;
  while (kPortOrder[at] != entry.port) ++at;
  auto before = entry.port, last = entry.port;
  for (std::size_t step = 1; step < kPortOrder.size(); ++step) {
    const auto next = static_cast<std::uint8_t>(kPortOrder[(at + step) % kPortOrder.size()]);
    if (!holds(open, next)) continue;
    before = last;
    last = next;
    if (port == next) break;
  }
  if (!port) before = entry.port;
  if (holds(entry.untimed, before) || holds(entry.untimed, last)) return std::nullopt;
  return (*slave.receive_times)[last] - (*slave.receive_times)[before];
}

std::vector<SlaveWiring> tree_of(std::span<const PortReport> slaves, std::span<const Entry> entries) {
  return Builder(slaves, entries).take();
}

std::size_t unexplained(std::span<const SlaveWiring> wiring) {
  std::size_t count = 0;
  for (const auto& slave : wiring) {
    count +=
        static_cast<std::size_t>(std::popcount(slave.unexplained_ports)) + (!slave.previous && !slave.root ? 1 : 0);
  }
  return count;
}

}  // namespace syncline::wiring
