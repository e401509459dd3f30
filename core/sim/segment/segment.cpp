// SPDX-License-Identifier: Apache-2.0
#include "sim/segment/segment.h"

#include <algorithm>
#include <utility>

#include "config/port_kind.h"
#include "config/sim_config.h"
#include "protocol/dl_status.h"

namespace syncline::sim {
namespace {

double way_out(const SimSlaveConfig& slave) { return slave.cable_m * kCableNsPerMetre + slave.asymmetry_ns / 2; }
double way_back(const SimSlaveConfig& slave) { return slave.cable_m * kCableNsPerMetre - slave.asymmetry_ns / 2; }

class Walk {
 public:
  Walk(std::span<const SimSlaveConfig> slaves, const Wiring& wiring, std::span<const PortState> ports)
      : slaves_(slaves), wiring_(wiring), ports_(ports) {}

  SegmentPath run() {
    if (!slaves_.empty()) enter(wiring_.first(), way_out(slaves_[wiring_.first()]));
    while (!inside_.empty() && !path_.swallowed) go_on();
    for (auto& passage : path_.passages) passage.offset = static_cast<Nanoseconds>(passage.time_ns + 0.5);
    return std::move(path_);
  }

 private:
  /// A slave that the frame is in, or behind. A list of them and no recursion: a line has thousands.
  struct Visit {
    std::size_t slave = 0;
    std::size_t begin = 0;    // of the entry in the order of the ports
    std::size_t step = 1;     // the next port, from there
    std::uint8_t behind = 0;  // the port that the frame has left by
    double came = 0;          // when it was received last
    bool processed = false;   // and has to pass the processing unit before it leaves
  };

  /// The frame comes to a slave at `time`.
  void enter(std::size_t i, double time) {
    const auto entry = wiring_.entry(i);
    if (!ports_[i].link[entry] || !ports_[i].open[entry]) {
      path_.swallowed = true;
      if (ports_[i].link[entry]) path_.closed_entry = static_cast<std::uint16_t>(i);
      return;
    }
    receive(i, entry, time, true);
    const auto begin = static_cast<std::size_t>(std::ranges::find(kPortOrder, entry) - kPortOrder.begin());
    inside_.push_back({i, begin, 1, 0, time, entry == 0});
  }

  /// The innermost slave's next port, or the way back to the one before it.
  void go_on() {
    auto& visit = inside_.back();
    if (visit.step == kPortOrder.size()) return come_back();
    const auto i = visit.slave;
    const auto port = static_cast<std::uint8_t>(kPortOrder[(visit.begin + visit.step++) % kPortOrder.size()]);
    if (ports_[i].open[port]) {
      leave(visit, port);
    } else if (port == 0) {
      const auto there = visit.came + delays(i, way_on(visit)).forwarding;
      path_.passages.push_back({static_cast<std::uint16_t>(i), 0, true, false, true, there, 0});
      visit.processed = true;
    }
  }

  /// The frame leaves by an open port.
  void leave(Visit& visit, std::uint8_t port) {
    if (const auto* ring =
            wiring_.ring_at(visit.slave, port)) {  // the host takes this frame, and another one goes on in its place
      return receive(visit.slave, port, ring->time_ns, false);
    }
    const auto child = wiring_.child(visit.slave, port);
    if (!child || !ports_[visit.slave].link[port]) {
      path_.swallowed = true;
      return;
    }
    visit.behind = port;
    enter(*child, leaves(visit, *child) + way_out(slaves_[*child]));  // `visit` may have moved
  }

  /// Out of the innermost slave by its entry.
  void come_back() {
    const auto from = inside_.back().slave;
    const double back = leaves(inside_.back(), from) + way_back(slaves_[from]);
    inside_.pop_back();
    if (inside_.empty()) {
      path_.return_ns = back;
      return;
    }
    auto& visit = inside_.back();
    receive(visit.slave, visit.behind, back, false);
    visit.came = back;
    visit.processed = visit.behind == 0;
  }

  void receive(std::size_t i, std::uint8_t port, double time, bool first) {
    path_.passages.push_back({static_cast<std::uint16_t>(i), port, port == 0, first, false, time, 0});
  }
  /// Who is on the cable by which the frame leaves next: a child, or the slave itself on its way back.
  [[nodiscard]] std::size_t way_on(const Visit& visit) const {
    for (auto step = visit.step; step < kPortOrder.size(); ++step) {
      const auto port = kPortOrder[(visit.begin + step) % kPortOrder.size()];
      if (!ports_[visit.slave].open[port]) continue;
      if (const auto child = wiring_.child(visit.slave, port)) return *child;
    }
    return visit.slave;
  }
  /// Of a slave where frames leave it for `child`, or leave `child`, which may be itself, for its parent.
  [[nodiscard]] EscDelays delays(std::size_t slave, std::size_t child) const {
    const bool ebus = port_kind(slaves_[child].device, wiring_.entry(child)) == PortKind::kEbus;
    return slaves_[slave].delays.value_or(ebus ? kEbusDelays : kCableDelays);
  }
  /// When the frame leaves a slave on that way.
  [[nodiscard]] double leaves(const Visit& visit, std::size_t child) const {
    const auto delays = this->delays(visit.slave, child);
    return visit.came + (visit.processed ? delays.processing : delays.forwarding);
  }

  std::span<const SimSlaveConfig> slaves_;
  const Wiring& wiring_;
  std::span<const PortState> ports_;
  SegmentPath path_;
  std::vector<Visit> inside_;
};

}  // namespace

Wiring::Wiring(std::span<const SimSlaveConfig> slaves) : children_(slaves.size()) {
  for (const auto& slave : slaves) entries_.push_back(slave.entry_port);
  const auto first = std::ranges::find_if(slaves, [](const auto& slave) { return !slave.parent; });
  if (first != slaves.end()) first_ = static_cast<std::size_t>(first - slaves.begin());
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    const auto& slave = slaves[i];
    if (!slave.parent || *slave.parent >= slaves.size() || *slave.parent == i || slave.parent_port >= 4) continue;
    auto& place = children_[*slave.parent][slave.parent_port];
    if (!place) place = static_cast<std::uint16_t>(i);
  }
}

void Wiring::reverse(std::size_t slave, std::uint8_t port) {
  std::swap(children_[slave][port], children_[slave][entries_[slave]]);
  entries_[slave] = port;
}

SegmentPath segment_path(std::span<const SimSlaveConfig> slaves, const Wiring& wiring,
                         std::span<const PortState> ports) {
  return Walk(slaves, wiring, ports).run();
}

std::vector<PortState> all_connected(std::span<const SimSlaveConfig> slaves, const Wiring& wiring) {
  std::vector<PortState> ports(slaves.size());
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    for (unsigned port = 0; port < 4; ++port) {
      ports[i].link[port] = ports[i].open[port] = port == wiring.entry(i) || wiring.child(i, port).has_value();
    }
  }
  return ports;
}

}  // namespace syncline::sim
