// SPDX-License-Identifier: Apache-2.0
#include "master/scan/foreign_times.h"

#include <algorithm>
#include <compare>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

namespace syncline::wiring {
namespace {

/// Through two ESCs and back, ns: 270 by E-bus, 520 by cables (kEbusDelays and kCableDelays in config/sim_config.h,
/// which says from what), less what latches are off by.
constexpr std::int32_t kShortestHop = 200;
constexpr std::int32_t kLongestHop = 2'000'000;  // there and back; no cable is so long

/// How far a tree is from what can be; the least is the best. Nobody is taken for turned round, nor a time for nothing,
/// where anything else explains as much.
struct Doubts {
  std::size_t unexplained = 0, contradictions = 0, turned = 0, untimed = 0, unknown_hops = 0, short_hops = 0;
  std::vector<std::int32_t> hops;  // the longest first
  auto operator<=>(const Doubts&) const = default;
};

class Explanation {
 public:
  Explanation(std::span<const PortReport> slaves, std::vector<Entry> entries)
      : slaves_(slaves), entries_(std::move(entries)), tree_(tree_of(slaves_, entries_)), suspects_(slaves.size()) {
    doubts_.unexplained = unexplained(tree_);
    suspect_unexplained();
    for (std::size_t i = 0; i < slaves_.size(); ++i) {
      const auto way = hop(i);
      doubts_.turned += entries_[i].port != 0 ? 1 : 0;
      doubts_.untimed += entries_[i].untimed != 0 ? 1 : 0;
      doubts_.short_hops += way && *way < kShortestHop ? 1 : 0;
      if (way) doubts_.hops.push_back(*way);
      doubts_.unknown_hops += way ? 0 : 1;
      if (!lacks_others_before(i) && (!way || (*way >= 0 && *way <= kLongestHop))) continue;
      ++doubts_.contradictions;
      suspects_[i] = true;
      if (const auto above = nearest_above(i)) suspects_[above->position] = true;
    }
    std::ranges::sort(doubts_.hops, std::greater{});
  }
  [[nodiscard]] const Doubts& doubts() const { return doubts_; }
  /// A time of this slave may be what is wrong.
  [[nodiscard]] bool suspects(std::size_t slave) const { return suspects_[slave]; }
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }

 private:
  /// Whoever hangs between the entry and port 0 comes before the slave, and would be in the list.
  [[nodiscard]] bool lacks_others_before(std::size_t i) const {
    if (!slaves_[i].receive_times) return false;
    const auto left = open_ports(slaves_[i].dl_status) & ~entries_[i].foreign;
    return std::ranges::any_of(ways_of(left, entries_[i].port).before,
                               [&](auto port) { return holds(tree_[i].unexplained_ports, port); });
  }

  /// Who comes before the first port with nobody behind it does not hang there, unless it is entered by another one
  /// than port 0; where somebody has no place at all, nothing is known of that.
  void suspect_unexplained() {
    std::size_t first = slaves_.size();
    for (std::size_t i = slaves_.size(); i-- > 0;) {
      const bool has_place = tree_[i].root || tree_[i].previous;
      if (tree_[i].unexplained_ports != 0) first = tree_[i].entry_port == 0 ? i : 0;
      if (!has_place) first = 0;
      if (first == 0) break;
    }
    for (std::size_t i = first; i < slaves_.size(); ++i) suspects_[i] = true;
  }

  /// Where a slave hangs, those without times being but a piece of cable.
  [[nodiscard]] std::optional<PreviousPort> nearest_above(std::size_t i) const {
    auto above = tree_[i].previous;
    while (above && !slaves_[above->position].receive_times) above = tree_[above->position].previous;
    return above;
  }

  /// A frame's way between a slave and the nearest one above it that has times, there and back, ns: for how much longer
  /// it was away from that one than the slave kept it.
  [[nodiscard]] std::optional<std::int32_t> hop(std::size_t i) const {
    const auto above = nearest_above(i);
    if (!above) return std::nullopt;
    const auto inside = time_behind(slaves_[i], entries_[i], std::nullopt);
    const auto away = time_behind(slaves_[above->position], entries_[above->position], above->port);
    if (!inside || !away) return std::nullopt;
    return static_cast<std::int32_t>(*away - *inside);
  }

  std::span<const PortReport> slaves_;
  std::vector<Entry> entries_;
  std::vector<SlaveWiring> tree_;
  std::vector<bool> suspects_;
  Doubts doubts_;
};

/// Without this port, or without its time, if that leaves the slave any by which frames may come.
std::optional<std::vector<Entry>> without(std::span<const PortReport> slaves, const std::vector<Entry>& entries,
                                          std::size_t slave, std::uint8_t port, unsigned Entry::*what) {
  const auto open = open_ports(slaves[slave].dl_status) & ~entries[slave].foreign & ~entries[slave].untimed;
  const auto left = open & ~(1U << port);
  const bool entered = entries[slave].port == port, timed = slaves[slave].receive_times.has_value();
  if (!holds(open, port) || left == 0 || (!timed && (entered || what == &Entry::untimed))) return std::nullopt;
  auto fewer = entries;
  fewer[slave].*what |= 1U << port;
  if (entered) fewer[slave].port = first_of(left, *slaves[slave].receive_times);
  return fewer;
}

}  // namespace

void forget_foreign_times(std::span<const PortReport> slaves, std::vector<Entry>& entries, int& tries) {
  Explanation best(slaves, entries);
  for (bool better = true; better;) {
    better = false;
    const auto known = best;
    for (std::size_t i = 0; i < slaves.size(); ++i) {
      for (std::uint8_t port = 0; known.suspects(i) && port < kPortCount; ++port) {
        for (const auto what : {&Entry::foreign, &Entry::untimed}) {
          auto fewer = tries > 0 ? without(slaves, known.entries(), i, port, what) : std::nullopt;
          if (!fewer) continue;
          --tries;
          Explanation explanation(slaves, std::move(*fewer));
          if (explanation.doubts() >= best.doubts()) continue;
          best = std::move(explanation);
          better = true;
        }
      }
    }
  }
  entries = best.entries();
}

}  // namespace syncline::wiring
