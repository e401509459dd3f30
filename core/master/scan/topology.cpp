// SPDX-License-Identifier: Apache-2.0
#include "master/scan/topology.h"

#include <algorithm>
#include <bit>

#include "config/device_description.h"
#include "protocol/first_port.h"

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

/// For how long a frame was away from a slave, in ns of its own clock: behind one port, or behind all of
/// them. Nothing without receive times.
std::optional<std::uint32_t> time_behind(const PortReport& slave, std::uint8_t entry,
                                         std::optional<std::uint8_t> port) {
  if (!slave.receive_times) return std::nullopt;
  std::size_t at = 0;
  while (kPortOrder[at] != entry) ++at;
  auto before = entry, last = entry;
  for (std::size_t step = 1; step < kPortOrder.size(); ++step) {
    const auto next = static_cast<std::uint8_t>(kPortOrder[(at + step) % kPortOrder.size()]);
    if (!slave.dl_status.active(next)) continue;
    before = last;
    last = next;
    if (port == next) break;
  }
  return (*slave.receive_times)[last] - (*slave.receive_times)[port ? before : entry];
}

class Builder {
 public:
  Builder(std::span<const PortReport> slaves, std::span<const std::uint8_t> entries)
      : slaves_(slaves), wiring_(slaves.size()) {
    for (std::uint16_t i = 0; i < static_cast<std::uint16_t>(slaves.size()); ++i) {
      wiring_[i].entry_port = entries[i];
      auto ways = ways_of(slaves[i].dl_status, wiring_[i].entry_port);
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
    const auto begin = last_subtree(time_behind(slaves_[position], wiring_[position].entry_port, port));
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
      const auto inside = time_behind(slaves_[seen_[i].position], wiring_[seen_[i].position].entry_port, std::nullopt);
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
  std::vector<SlaveWiring> wiring_;
  std::vector<Branching> seen_;
};

/// Slaves whose place nothing explains, and ports behind which nobody was found.
std::size_t unexplained(std::span<const SlaveWiring> wiring) {
  std::size_t count = 0;
  for (const auto& slave : wiring) {
    count +=
        static_cast<std::size_t>(std::popcount(slave.unexplained_ports)) + (!slave.previous && !slave.root ? 1 : 0);
  }
  return count;
}

/// Entries of slaves without receive times, when port 0 does not explain the order.
class EntrySearch {
 public:
  EntrySearch(std::span<const PortReport> slaves, std::vector<std::uint8_t> entries)
      : slaves_(slaves), entries_(std::move(entries)), wiring_(Builder(slaves_, entries_).take()) {}

  std::vector<SlaveWiring> run() {
    for (auto left = unexplained(wiring_); left > 0; left = unexplained(wiring_)) {
      const auto best = best_changes(left);
      if (best.size() != 1) break;  // the ports that nothing explains are named
      entries_[best.front().slave] = best.front().port;
      wiring_ = Builder(slaves_, entries_).take();
    }
    return std::move(wiring_);
  }

 private:
  struct Change {
    std::size_t slave = 0;
    std::uint8_t port = 0;
  };
  static constexpr int kMostTries = 2000;  // together: a search goes over all slaves each time

  /// Those after which least is unexplained, and less than now.
  std::vector<Change> best_changes(std::size_t least) {
    std::vector<Change> best;
    for (std::size_t i = 0; i < slaves_.size(); ++i) {
      if (slaves_[i].receive_times) continue;
      for (std::uint8_t port = 0; port < kPortCount; ++port) {
        if (port == entries_[i] || !slaves_[i].dl_status.active(port) || ++tries_ > kMostTries) continue;
        auto entries = entries_;
        entries[i] = port;
        const auto left = unexplained(Builder(slaves_, entries).take());
        if (left < least) best.clear();
        if (left < least || (left == least && !best.empty())) best.push_back({i, port});
        least = std::min(least, left);
      }
    }
    return best;
  }

  std::span<const PortReport> slaves_;
  std::vector<std::uint8_t> entries_;
  std::vector<SlaveWiring> wiring_;
  int tries_ = 0;
};

}  // namespace

std::uint8_t entry_port(const PortReport& slave) {
  std::array<bool, kPortCount> active{};
  for (unsigned port = 0; port < kPortCount; ++port) active[port] = slave.dl_status.active(port);
  const auto first = slave.receive_times ? first_port(active, *slave.receive_times) : std::nullopt;
  if (first) return static_cast<std::uint8_t>(*first);
  const auto any = std::ranges::find(active, true);
  return any == active.end() ? std::uint8_t{0} : static_cast<std::uint8_t>(any - active.begin());
}

std::vector<SlaveWiring> find_wiring(std::span<const PortReport> slaves) {
  std::vector<std::uint8_t> entries;
  for (const auto& slave : slaves) entries.push_back(entry_port(slave));
  return EntrySearch(slaves, std::move(entries)).run();
}

}  // namespace syncline
