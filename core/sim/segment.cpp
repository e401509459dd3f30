// SPDX-License-Identifier: Apache-2.0
#include "sim/segment.h"

#include <algorithm>
#include <utility>

#include "protocol/dl_status.h"

namespace syncline::sim {
namespace {

constexpr double kNsPerMetre = 5.0;

double way_out(const SimSlaveConfig& slave) { return slave.cable_m * kNsPerMetre + slave.asymmetry_ns / 2; }
double way_back(const SimSlaveConfig& slave) { return slave.cable_m * kNsPerMetre - slave.asymmetry_ns / 2; }

class Walk {
 public:
  Walk(std::span<const SimSlaveConfig> slaves, const Wiring& wiring, std::span<const PortState> ports)
      : slaves_(slaves), wiring_(wiring), ports_(ports) {}

  SegmentPath run() {
    if (!slaves_.empty()) path_.return_ns = enter(0, way_out(slaves_[0])) + way_back(slaves_[0]);
    for (auto& passage : path_.passages) passage.offset = static_cast<Nanoseconds>(passage.time_ns + 0.5);
    return std::move(path_);
  }

 private:
  /// The frame comes to a slave at `time`; gives the time at which it leaves by the same port again.
  double enter(std::size_t i, double time) {
    const auto entry = wiring_.entry(i);
    if (ports_[i].link[entry] && ports_[i].open[entry]) return visit(i, entry, time);
    path_.swallowed = true;
    if (ports_[i].link[entry]) path_.closed_entry = static_cast<std::uint16_t>(i);
    return time;
  }

  double visit(std::size_t i, std::uint8_t entry, double time) {
    receive(i, entry, time, true);
    double out = time + delay_behind(i, entry);
    const auto begin = static_cast<std::size_t>(std::ranges::find(kPortOrder, entry) - kPortOrder.begin());
    for (std::size_t step = 1; step < kPortOrder.size() && !path_.swallowed; ++step) {
      const auto port = static_cast<std::uint8_t>(kPortOrder[(begin + step) % kPortOrder.size()]);
      if (ports_[i].open[port]) {
        out = leave(i, port, out);
      } else if (port == 0) {
        path_.passages.push_back({static_cast<std::uint16_t>(i), 0, true, false, true, out, 0});
        out += static_cast<double>(slaves_[i].processing_delay_ns) - slaves_[i].forwarding_delay_ns;
      }
    }
    return out;
  }

  /// The frame leaves by an open port; when it is through with that port.
  double leave(std::size_t i, std::uint8_t port, double out) {
    if (const auto* ring =
            wiring_.ring_at(i, port)) {  // the host takes this frame, and another one goes on in its place
      receive(i, port, ring->time_ns, false);
      return out;
    }
    const auto child = wiring_.child(i, port);
    if (!child || !ports_[i].link[port]) {
      path_.swallowed = true;
      return out;
    }
    const double back = enter(*child, out + way_out(slaves_[*child])) + way_back(slaves_[*child]);
    if (path_.swallowed) return out;
    receive(i, port, back, false);
    return back + delay_behind(i, port);
  }

  void receive(std::size_t i, std::uint8_t port, double time, bool first) {
    path_.passages.push_back({static_cast<std::uint16_t>(i), port, port == 0, first, false, time, 0});
  }
  [[nodiscard]] double delay_behind(std::size_t i, std::uint8_t port) const {
    return port == 0 ? slaves_[i].processing_delay_ns : slaves_[i].forwarding_delay_ns;
  }

  std::span<const SimSlaveConfig> slaves_;
  const Wiring& wiring_;
  std::span<const PortState> ports_;
  SegmentPath path_;
};

}  // namespace

Wiring::Wiring(std::span<const SimSlaveConfig> slaves) : children_(slaves.size()) {
  for (const auto& slave : slaves) entries_.push_back(slave.entry_port);
  for (std::size_t i = 1; i < slaves.size(); ++i) {
    const auto& slave = slaves[i];
    if (!slave.parent || *slave.parent >= i || slave.parent_port >= 4) continue;
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
