// SPDX-License-Identifier: Apache-2.0
#include "dc/propagation_delay.h"

#include <algorithm>

#include "protocol/delay_difference.h"
#include "protocol/dl_status.h"
#include "protocol/first_port.h"

namespace syncline::dc {
namespace {

constexpr std::int64_t kMaxHopNs = 1'000'000;
constexpr std::int64_t kMaxRoundTripNs = 100'000'000;  // of the longest segment, generously

/// Difference of two 32-bit stamps that are less than 2.1 s apart, whatever wrap lies between.
std::int64_t difference(std::uint32_t a, std::uint32_t b) { return static_cast<std::int32_t>(a - b); }

std::size_t ring_index(unsigned port) {
  return static_cast<std::size_t>(std::find(kPortOrder.begin(), kPortOrder.end(), port) - kPortOrder.begin());
}

/// The frame's way through the ports is the ring 0-3-1-2; between port 0 and the next one lies the
/// processing unit. True when the way from `from` (inclusive) to `to` (exclusive) passes it; from a
/// port to itself is the whole ring.
bool passes_processing_unit(unsigned from, unsigned to) {
  auto index = ring_index(from);
  do {
    if (kPortOrder[index] == 0) return true;
    index = (index + 1) % kPortOrder.size();
  } while (kPortOrder[index] != to);
  return false;
}

std::uint8_t first_timed_port(const DelayNode& node) {
  auto ports = node.active;
  for (unsigned port = 0; port < ports.size(); ++port) ports[port] = ports[port] && !node.untimed[port];
  return static_cast<std::uint8_t>(first_port(ports, node.receive_time).value_or(0));
}

/// Active ports in the order in which the frame reaches them, the entry first.
std::vector<unsigned> ports_in_frame_order(const DelayNode& node, unsigned entry) {
  std::vector<unsigned> ports{entry};
  for (std::size_t i = 1; i < kPortOrder.size(); ++i) {
    const auto port = kPortOrder[(ring_index(entry) + i) % kPortOrder.size()];
    if (node.active[port]) ports.push_back(port);
  }
  return ports;
}

class Measurement {
 public:
  Measurement(std::span<const DelayNode> nodes, const DelayOptions& options) : nodes_(nodes), options_(options) {
    arrival_.resize(nodes.size());
    result_.entry_port.resize(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      result_.entry_port[i] = has_times(i) ? first_timed_port(nodes[i]) : nodes[i].entry_port & 3U;
      if (result_.entry_port[i] != 0) report(i, DelayWarning::kReversedCable, result_.entry_port[i]);
      ports_.push_back(ports_in_frame_order(nodes[i], result_.entry_port[i]));
    }
  }

  DelayResult run() {
    std::optional<std::size_t> root;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!has_times(i)) continue;
      if (root) measure(i);
      if (arrival_[i]) continue;
      arrival_[i] = root ? behind(*root) : 0;
      if (root) report(i, DelayWarning::kUnmeasuredWay, *arrival_[i]);
      root = i;
    }
    take_delays();
    return std::move(result_);
  }

 private:
  /// From the arrivals at the entries to those at the processing units.
  void take_delays() {
    std::optional<std::int64_t> least;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!arrival_[i]) continue;
      *arrival_[i] += to_processing_unit(i);
      least = std::min(least.value_or(*arrival_[i]), *arrival_[i]);
    }
    for (const auto& arrival : arrival_) {
      result_.delay_ns.emplace_back();
      if (arrival) result_.delay_ns.back() = static_cast<std::uint32_t>(*arrival - *least);
    }
  }

  /// How long a frame takes from a slave's entry to its processing unit. With port 0 open that is when it comes back
  /// there; without, only 0x0918 can say.
  [[nodiscard]] std::int64_t to_processing_unit(std::size_t i) const {
    const auto& node = nodes_[i];
    const unsigned entry = ports_[i].front();
    if (entry == 0) return 0;
    std::int64_t way = 0;
    if (node.active[0]) {
      way = span(i, 0, entry);
    } else if (node.processing_time) {
      way = difference(*node.processing_time, node.receive_time[entry]);
    }
    return way > 0 && way <= kMaxRoundTripNs ? way : 0;
  }

  /// Where no time is known of the slave at which two branches part: the frame was through with one when it came to the
  /// other. What it spent on both their cables is guessed.
  [[nodiscard]] std::int64_t behind(std::size_t root) const {
    constexpr std::int64_t kUsualHop = 300;
    return *arrival_[root] + inside(root) + 2 * kUsualHop;
  }
  [[nodiscard]] bool has_times(std::size_t i) const { return nodes_[i].kind != DcKind::kNone; }
  void report(std::size_t i, DelayWarning warning, std::int64_t value) {
    result_.findings.push_back({static_cast<std::uint16_t>(i), warning, value});
  }
  [[nodiscard]] std::int64_t span(std::size_t i, unsigned later, unsigned earlier) const {
    return difference(nodes_[i].receive_time[later], nodes_[i].receive_time[earlier]);
  }
  /// For how long the frame was in a slave and behind it.
  [[nodiscard]] std::int64_t inside(std::size_t i) const { return span(i, ports_[i].back(), ports_[i].front()); }

  /// When the frame was back at the port at `place` of a slave's, from its entry. Where no time says it the cables are
  /// left out, a few hundred ns.
  [[nodiscard]] std::int64_t back_at(std::size_t i, std::size_t place) const {
    std::int64_t back = 0;
    for (std::size_t k = 1; k <= place; ++k) {
      const auto port = ports_[i][k];
      if (!nodes_[i].untimed[port]) {
        back = span(i, port, ports_[i].front());
        continue;
      }
      for (auto child = i + 1; child < nodes_.size(); ++child) {
        if (nodes_[child].parent == i && branch_port(i, child) == port && has_times(child)) back += inside(child);
      }
    }
    return back;
  }

  /// Port of `parent` that leads to `child`: the children in frame order hang on the ports in frame order.
  [[nodiscard]] unsigned branch_port(std::size_t parent, std::size_t child) const {
    std::size_t order = 1;
    for (std::size_t i = parent + 1; i < child; ++i) {
      if (nodes_[i].parent == static_cast<std::uint16_t>(parent)) ++order;
    }
    return order < ports_[parent].size() ? ports_[parent][order] : nodes_[child].parent_port;
  }

  /// What processing costs more than forwarding where frames leave for `child`, or leave it for its parent.
  [[nodiscard]] std::int64_t t_diff(std::size_t child) const {
    const bool ebus = nodes_[child].ebus[result_.entry_port[child]];
    return options_.t_diff_ns.value_or(ebus ? kEbusDelayDifference : kUsualDelayDifference);
  }

  void measure(std::size_t i) {
    std::size_t branch = i;  // child of the DC ancestor on the way to i
    // What the way out costs more than the way back: on each cable the processing unit is passed before it on the way
    // out, or on the way back, or both, or never.
    std::int64_t correction = 0;
    auto ancestor = nodes_[i].parent;
    while (ancestor && !has_times(*ancestor)) {
      correction += result_.entry_port[*ancestor] == 0 ? t_diff(branch) : -t_diff(*ancestor);
      branch = *ancestor;
      ancestor = nodes_[*ancestor].parent;
    }
    if (!ancestor || !arrival_[*ancestor]) return;  // nobody on the way to it has receive times

    const std::size_t a = *ancestor;
    const auto& ports = ports_[a];
    const unsigned port = branch_port(a, branch);
    const auto place = std::find(ports.begin(), ports.end(), port);
    if (place == ports.begin() || place == ports.end()) return;
    const unsigned previous = *(place - 1);

    const auto round_trip = span(a, port, previous);
    const auto before = back_at(a, static_cast<std::size_t>(place - ports.begin()) - 1);
    const unsigned entry = ports_[i].front();
    const unsigned last = ports_[i].back();
    if (passes_processing_unit(previous, port)) correction += t_diff(branch);
    if (passes_processing_unit(last, entry)) correction -= t_diff(i);
    auto hop = (round_trip - inside(i) + correction) / 2;
    if (hop < 0) {
      report(i, DelayWarning::kNegativeHop, hop);
      hop = 0;
    } else if (hop > kMaxHopNs || nodes_[a].untimed[port] || nodes_[a].untimed[previous] || nodes_[i].untimed[last]) {
      report(i, DelayWarning::kImplausibleHop, hop);
      hop = 0;  // a few hundred ns wrong at most, where what was measured is wrong by all of it
    }
    const auto delay = *arrival_[a] + before + hop;
    if (delay <= *arrival_[a]) report(i, DelayWarning::kNotIncreasing, delay);
    arrival_[i] = std::max<std::int64_t>(delay, 0);
  }

  std::span<const DelayNode> nodes_;
  DelayOptions options_;
  std::vector<std::vector<unsigned>> ports_;
  std::vector<std::optional<std::int64_t>> arrival_;  // at the entry, from the first slave's
  DelayResult result_;
};

}  // namespace

DelayResult propagation_delays(std::span<const DelayNode> nodes, const DelayOptions& options) {
  return Measurement(nodes, options).run();
}

}  // namespace syncline::dc
