// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "dc/propagation_delay.h"
#include "support/random.h"

namespace syncline::dc {

/// A segment whose delays are known because a frame is walked through it: wires, processing and
/// forwarding latencies, free-running 32-bit clocks. Ports behind the processing unit are passed in the
/// order 3, 1, 2.
class SegmentTruth {
 public:
  struct Slave {
    DcKind kind = DcKind::kFull;
    std::uint32_t clock_offset = 0;  // local time when the frame reaches the first slave
    std::uint32_t garbage = 0;       // what inactive ports show
    std::uint32_t processing = 300, forwarding = 260;
    std::uint32_t wire = 0;  // to the parent
    std::optional<std::uint16_t> parent;
    unsigned parent_port = 0;
    unsigned entry = 0;  // the port at which the cable to the parent is plugged
    std::array<std::optional<std::uint16_t>, 4> child{};
  };

  /// Slaves must be added with each behind its parent, and children in frame order. Returns the position.
  std::uint16_t add(std::optional<std::uint16_t> parent, unsigned parent_port, std::uint32_t wire,
                    DcKind kind = DcKind::kFull, std::uint32_t clock_offset = 0) {
    const auto position = static_cast<std::uint16_t>(slaves.size());
    Slave slave;
    slave.kind = kind;
    slave.clock_offset = clock_offset;
    slave.wire = wire;
    slave.parent = parent;
    slave.parent_port = parent_port;
    slaves.push_back(slave);
    if (parent) slaves[*parent].child[parent_port] = position;
    return position;
  }

  /// Walks a frame through; afterwards arrival() is the truth and nodes() what the slaves latched.
  void walk() {
    arrivals_.assign(slaves.size(), {});
    nodes_.clear();
    for (const auto& slave : slaves) {
      DelayNode node;
      node.kind = slave.kind;
      node.receive_time.fill(slave.garbage);
      node.parent = slave.parent;
      node.parent_port = static_cast<std::uint8_t>(slave.parent_port);
      node.entry_port = slave.kind == DcKind::kNone ? static_cast<std::uint8_t>(slave.entry) : 0;
      nodes_.push_back(node);
    }
    visit(0, 0);
  }
  [[nodiscard]] const std::vector<DelayNode>& nodes() const { return nodes_; }
  /// True time between the processing units, from the first one of a slave with receive times.
  [[nodiscard]] std::int64_t delay(std::size_t position) const {
    auto first = INT64_MAX;
    for (std::size_t i = 0; i < slaves.size(); ++i) {
      if (slaves[i].kind != DcKind::kNone) first = std::min(first, arrivals_[i]);
    }
    return arrivals_[position] - first;
  }

  std::vector<Slave> slaves;

 private:
  /// Way through one slave, ring 0-3-1-2 from the entry on; the processing unit lies behind port 0.
  std::int64_t visit(std::uint16_t position, std::int64_t time) {
    const auto& slave = slaves[position];
    latch(position, slave.entry, time);
    if (slave.entry == 0) process(position, time);
    unsigned last = slave.entry;
    for (unsigned port = next(slave.entry); port != slave.entry; port = next(port)) {
      if (port == 0 && !slave.child[0]) process(position, time + slave.forwarding);
      if (!slave.child[port]) continue;
      time += latency(slave, last, port);
      const auto child = *slave.child[port];
      time = visit(child, time + slaves[child].wire) + slaves[child].wire;
      latch(position, port, time);
      if (port == 0) process(position, time);
      last = port;
    }
    return time + latency(slave, last, slave.entry);
  }
  void process(std::uint16_t position, std::int64_t time) {
    arrivals_[position] = time;
    if (slaves[position].kind != DcKind::kFull) return;
    nodes_[position].processing_time = slaves[position].clock_offset + static_cast<std::uint32_t>(time);
  }
  static unsigned next(unsigned port) {
    constexpr std::array<unsigned, 4> kNext{3, 2, 0, 1};
    return kNext[port];
  }
  static std::int64_t latency(const Slave& slave, unsigned from, unsigned to) {
    for (unsigned port = from;; port = next(port)) {
      if (port == 0) return slave.processing;
      if (next(port) == to) return slave.forwarding;
    }
  }
  void latch(std::uint16_t position, unsigned port, std::int64_t time) {
    auto& node = nodes_[position];
    node.active[port] = true;
    node.receive_time[port] = slaves[position].clock_offset + static_cast<std::uint32_t>(time);
  }

  std::vector<std::int64_t> arrivals_;
  std::vector<DelayNode> nodes_;
};

}  // namespace syncline::dc
