// SPDX-License-Identifier: Apache-2.0
#include "master/scan/topology.h"

#include <algorithm>
#include <bit>
#include <compare>
#include <utility>

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

  /// A closed ring brings another master's frame to a port, whose time is none of ours. It shows by what cannot be, and
  /// is taken out where what is left contradicts itself less and explains as much.
  void forget_foreign_times() {
    std::vector<bool> given_up(slaves_.size());
    while (tries_ < kMostTries && unexplained(wiring_) > 0) {
      const auto at = contradiction(given_up);
      if (!at) return;
      if (!forget_one_of(suspects(*at))) given_up[*at] = true;
    }
  }

  /// The one that leaves the fewest contradictions, and of several the one with which the longest hop is the shortest:
  /// who is put where he is not leaves a gap where he is. False where none does any good.
  bool forget_one_of(const std::vector<Change>& suspects) {
    const auto most = unexplained(wiring_);
    auto least = Doubts{contradictions(entries_, wiring_), 0};  // fewer of them, whatever the hops
    std::optional<std::pair<std::vector<Entry>, std::vector<SlaveWiring>>> best;
    for (const auto& suspect : suspects) {
      ++tries_;
      auto entries = entries_;
      auto& entry = entries[suspect.slave];
      entry.foreign |= 1U << suspect.port;
      const auto others = left(suspect.slave, entries);
      if (others == 0) continue;
      if (suspect.port == entry.port) entry.port = first_of(others, *slaves_[suspect.slave].receive_times);
      auto wiring = Builder(slaves_, entries).take();
      const Doubts doubts{contradictions(entries, wiring), longest_hop(entries, wiring)};
      if (unexplained(wiring) > most || doubts >= least) continue;
      least = doubts;
      best.emplace(std::move(entries), std::move(wiring));
    }
    if (!best) return false;
    entries_ = std::move(best->first);
    wiring_ = std::move(best->second);
    return true;
  }

  /// Ports that are open and have a time of ours, as far as is known.
  [[nodiscard]] unsigned left(std::size_t i, std::span<const Entry> entries) const {
    return open_ports(slaves_[i].dl_status) & ~entries[i].foreign;
  }

  /// Whoever hangs between the entry and port 0 comes before the slave, and would be in the list.
  [[nodiscard]] bool lacks_others_before(std::size_t i, std::span<const Entry> entries,
                                         std::span<const SlaveWiring> wiring) const {
    return slaves_[i].receive_times &&
           std::ranges::any_of(ways_of(left(i, entries), entries[i].port).before,
                               [&](auto port) { return holds(wiring[i].unexplained_ports, port); });
  }

  struct Doubts {
    std::size_t contradictions = 0;
    std::int32_t longest_hop = 0;
    auto operator<=>(const Doubts&) const = default;
  };

  /// A frame's way between a slave and the nearest one above it that has times, there and back, ns: for how much longer
  /// it was away from that one than the slave kept it.
  [[nodiscard]] std::optional<std::int32_t> hop(std::size_t i, std::span<const Entry> entries,
                                                std::span<const SlaveWiring> wiring) const {
    auto above = wiring[i].previous;
    while (above && !slaves_[above->position].receive_times) above = wiring[above->position].previous;
    if (!above) return std::nullopt;
    const auto inside = time_behind(slaves_[i], entries[i], std::nullopt);
    const auto away = time_behind(slaves_[above->position], entries[above->position], above->port);
    if (!inside || !away) return std::nullopt;
    return static_cast<std::int32_t>(*away - *inside);
  }

  [[nodiscard]] std::int32_t longest_hop(std::span<const Entry> entries, std::span<const SlaveWiring> wiring) const {
    std::int32_t longest = 0;
    for (std::size_t i = 0; i < slaves_.size(); ++i) longest = std::max(longest, hop(i, entries, wiring).value_or(0));
    return longest;
  }

  /// Nobody keeps a frame for longer than it was away from whoever he hangs at.
  [[nodiscard]] bool keeps_too_long(std::size_t i, std::span<const Entry> entries,
                                    std::span<const SlaveWiring> wiring) const {
    return hop(i, entries, wiring).value_or(0) < 0;
  }

  [[nodiscard]] bool contradicts(std::size_t i, std::span<const Entry> entries,
                                 std::span<const SlaveWiring> wiring) const {
    return lacks_others_before(i, entries, wiring) || keeps_too_long(i, entries, wiring);
  }

  [[nodiscard]] std::size_t contradictions(std::span<const Entry> entries, std::span<const SlaveWiring> wiring) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < slaves_.size(); ++i) count += contradicts(i, entries, wiring) ? 1 : 0;
    return count;
  }

  /// The last one: what is wrong there makes those before it look wrong, too.
  [[nodiscard]] std::optional<std::size_t> contradiction(const std::vector<bool>& given_up) const {
    for (std::size_t i = slaves_.size(); i-- > 0;) {
      if (!given_up[i] && contradicts(i, entries_, wiring_)) return i;
    }
    return std::nullopt;
  }

  /// Ports whose times would explain it: the slave's own, and the one that it hangs at.
  [[nodiscard]] std::vector<Change> suspects(std::size_t i) const {
    std::vector<Change> found;
    if (lacks_others_before(i, entries_, wiring_)) found.push_back({i, entries_[i].port});
    if (!keeps_too_long(i, entries_, wiring_)) return found;
    for (std::uint8_t port = 0; port < kPortCount; ++port) {
      if (holds(left(i, entries_), port) && port != entries_[i].port) found.push_back({i, port});
    }
    const auto& previous = *wiring_[i].previous;
    if (previous.port != entries_[previous.position].port) found.push_back({previous.position, previous.port});
    return found;
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
