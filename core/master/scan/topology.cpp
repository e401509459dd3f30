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

unsigned open_ports(const DlStatus& status) {
  unsigned ports = 0;
  for (unsigned port = 0; port < kPortCount; ++port) ports |= status.active(port) ? 1U << port : 0;
  return ports;
}

bool holds(unsigned ports, unsigned port) { return (ports >> port & 1U) != 0; }

/// Where the master's frames come in, and the open ports behind which there is something else than slaves.
struct Entry {
  std::uint8_t port = 0;
  unsigned foreign = 0;  // a bit each
};

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

/// A slave and the ports behind it that nobody was found for yet.
struct Branching {
  std::uint16_t position = 0;
  std::vector<std::uint8_t> ports;  // in frame order
};

/// For how long a frame was away from a slave, in ns of its own clock: behind one port, or behind all of
/// them. Nothing without receive times.
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
  return (*slave.receive_times)[last] - (*slave.receive_times)[port ? before : entry.port];
}

class Builder {
 public:
  Builder(std::span<const PortReport> slaves, std::span<const Entry> entries)
      : slaves_(slaves), entries_(entries), wiring_(slaves.size()) {
    for (std::uint16_t i = 0; i < static_cast<std::uint16_t>(slaves.size()); ++i) {
      wiring_[i].entry_port = entries[i].port;
      wiring_[i].unexplained_ports = static_cast<std::uint8_t>(entries[i].foreign);
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

/// Of these ports the one with the earliest time; there is one at least.
std::uint8_t first_of(unsigned ports, const std::array<std::uint32_t, kPortCount>& times) {
  std::array<bool, kPortCount> open{};
  for (unsigned port = 0; port < kPortCount; ++port) open[port] = holds(ports, port);
  return static_cast<std::uint8_t>(first_port(open, times).value_or(0));
}

/// Slaves whose place nothing explains, and ports behind which nobody was found.
std::size_t unexplained(std::span<const SlaveWiring> wiring) {
  std::size_t count = 0;
  for (const auto& slave : wiring) {
    count +=
        static_cast<std::size_t>(std::popcount(slave.unexplained_ports)) + (!slave.previous && !slave.root ? 1 : 0);
  }
  return count;
}

/// Entries of slaves without receive times, when port 0 does not explain the order, and of those with one that means
/// nothing.
class EntrySearch {
 public:
  EntrySearch(std::span<const PortReport> slaves, std::vector<Entry> entries)
      : slaves_(slaves), entries_(std::move(entries)), wiring_(Builder(slaves_, entries_).take()) {}

  std::vector<SlaveWiring> run() {
    forget_foreign_times();
    for (auto left = unexplained(wiring_); left > 0; left = unexplained(wiring_)) {
      const auto best = best_changes(left);
      if (best.size() != 1) break;  // the ports that nothing explains are named
      entries_[best.front().slave].port = best.front().port;
      wiring_ = Builder(slaves_, entries_).take();
    }
    return std::move(wiring_);
  }

 private:
  static constexpr int kMostTries = 2000;  // together: a search goes over all slaves each time

  /// A port of a slave.
  struct Change {
    std::size_t slave = 0;
    std::uint8_t port = 0;
  };

  /// A closed ring brings another master's frame to a port, whose time is none of ours: taken out, where what is left
  /// explains as much.
  void forget_foreign_times() {
    std::vector<unsigned> refused(slaves_.size());
    for (; tries_ < kMostTries && unexplained(wiring_) > 0; ++tries_) {
      const auto found = foreign_time(refused);
      if (!found) return;
      auto entries = entries_;
      auto& entry = entries[found->slave];
      entry.foreign |= 1U << found->port;
      if (found->port == entry.port)
        entry.port = first_of(left(found->slave) & ~(1U << found->port), *slaves_[found->slave].receive_times);
      auto wiring = Builder(slaves_, entries).take();
      if (unexplained(wiring) > unexplained(wiring_)) {
        refused[found->slave] |= 1U << found->port;
        continue;
      }
      entries_ = std::move(entries);
      wiring_ = std::move(wiring);
    }
  }

  /// Ports that are open and have a time of ours, as far as is known.
  [[nodiscard]] unsigned left(std::size_t i) const { return open_ports(slaves_[i].dl_status) & ~entries_[i].foreign; }

  /// A time that cannot be of our frame, the last of them: what is wrong there makes those before it look wrong, too.
  [[nodiscard]] std::optional<Change> foreign_time(std::span<const unsigned> refused) const {
    for (std::size_t i = slaves_.size(); i-- > 0;) {
      if (!slaves_[i].receive_times) continue;
      // Whoever hangs between the entry and port 0 comes before the slave, and would be in the list.
      const auto& entry = entries_[i];
      const auto alone = [&](auto port) { return holds(wiring_[i].unexplained_ports, port); };
      if (std::ranges::any_of(ways_of(left(i), entry.port).before, alone) && !holds(refused[i], entry.port))
        return Change{i, entry.port};
      // Nobody keeps a frame for longer than it was away.
      const auto& previous = wiring_[i].previous;
      if (!previous || holds(refused[previous->position], previous->port)) continue;
      const auto inside = time_behind(slaves_[i], entry, std::nullopt);
      auto above = previous;
      while (above && !slaves_[above->position].receive_times) above = wiring_[above->position].previous;
      const auto away =
          above ? time_behind(slaves_[above->position], entries_[above->position], above->port) : std::nullopt;
      if (inside && away && static_cast<std::int32_t>(*inside) > static_cast<std::int32_t>(*away))
        return Change{previous->position, previous->port};
    }
    return std::nullopt;
  }

  /// Those after which least is unexplained, and less than now.
  std::vector<Change> best_changes(std::size_t least) {
    std::vector<Change> best;
    for (std::size_t i = 0; i < slaves_.size(); ++i) {
      if (slaves_[i].receive_times) continue;
      for (std::uint8_t port = 0; port < kPortCount; ++port) {
        if (port == entries_[i].port || !slaves_[i].dl_status.active(port) || ++tries_ > kMostTries) continue;
        auto entries = entries_;
        entries[i].port = port;
        const auto left = unexplained(Builder(slaves_, entries).take());
        if (left < least) best.clear();
        if (left < least || (left == least && !best.empty())) best.push_back({i, port});
        least = std::min(least, left);
      }
    }
    return best;
  }

  std::span<const PortReport> slaves_;
  std::vector<Entry> entries_;
  std::vector<SlaveWiring> wiring_;
  int tries_ = 0;
};

}  // namespace

std::uint8_t entry_port(const PortReport& slave) {
  const auto ports = open_ports(slave.dl_status);
  if (ports == 0) return 0;
  return slave.receive_times ? first_of(ports, *slave.receive_times)
                             : static_cast<std::uint8_t>(std::countr_zero(ports));
}

std::vector<SlaveWiring> find_wiring(std::span<const PortReport> slaves) {
  std::vector<Entry> entries;
  for (const auto& slave : slaves) entries.push_back({entry_port(slave)});
  return EntrySearch(slaves, std::move(entries)).run();
}

}  // namespace syncline
