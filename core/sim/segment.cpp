// SPDX-License-Identifier: Apache-2.0
#include "sim/segment.h"

#include "protocol/dl_status.h"

namespace syncline::sim {
namespace {

constexpr double kNsPerMetre = 5.0;

class Walk {
 public:
  Walk(std::span<const SimSlaveConfig> slaves, const Wiring& wiring, std::span<const PortState> ports)
      : slaves_(slaves), wiring_(wiring), ports_(ports) {}

  SegmentPath run() {
    if (!slaves_.empty()) {
      const double cable = slaves_[0].cable_m * kNsPerMetre;
      path_.return_ns = enter(0, cable) + cable;
    }
    for (auto& passage : path_.passages) passage.offset = static_cast<Nanoseconds>(passage.time_ns + 0.5);
    return std::move(path_);
  }

 private:
  /// The frame comes to port 0 of a slave at `time`; gives the time at which it leaves that port again.
  double enter(std::size_t i, double time) {
    if (ports_[i].link[0] && ports_[i].open[0]) return visit(i, time);
    path_.swallowed = true;
    if (ports_[i].link[0]) path_.closed_entry = static_cast<std::uint16_t>(i);
    return time;
  }

  double visit(std::size_t i, double time) {
    path_.passages.push_back({static_cast<std::uint16_t>(i), 0, true, time, 0});
    double out = time + slaves_[i].processing_delay_ns;
    for (std::size_t order = 1; order < kPortOrder.size() && !path_.swallowed; ++order) {
      const auto port = kPortOrder[order];
      if (!ports_[i].open[port]) continue;
      const auto child = wiring_.child(i, port);
      if (!child || !ports_[i].link[port]) {
        path_.swallowed = true;
        break;
      }
      const double cable = slaves_[*child].cable_m * kNsPerMetre;
      const double back = enter(*child, out + cable) + cable;
      if (path_.swallowed) break;
      path_.passages.push_back({static_cast<std::uint16_t>(i), static_cast<std::uint8_t>(port), false, back, 0});
      out = back + slaves_[i].forwarding_delay_ns;
    }
    return out;
  }

  std::span<const SimSlaveConfig> slaves_;
  const Wiring& wiring_;
  std::span<const PortState> ports_;
  SegmentPath path_;
};

}  // namespace

Wiring::Wiring(std::span<const SimSlaveConfig> slaves) : children_(slaves.size()) {
  for (std::size_t i = 1; i < slaves.size(); ++i) {
    const auto& slave = slaves[i];
    if (!slave.parent || *slave.parent >= i || slave.parent_port >= 4) continue;
    auto& place = children_[*slave.parent][slave.parent_port];
    if (!place) place = static_cast<std::uint16_t>(i);
  }
}

SegmentPath segment_path(std::span<const SimSlaveConfig> slaves, const Wiring& wiring,
                         std::span<const PortState> ports) {
  return Walk(slaves, wiring, ports).run();
}

std::vector<PortState> all_connected(std::span<const SimSlaveConfig> slaves, const Wiring& wiring) {
  std::vector<PortState> ports(slaves.size());
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    for (unsigned port = 0; port < 4; ++port) {
      ports[i].link[port] = ports[i].open[port] = port == 0 || wiring.child(i, port).has_value();
    }
  }
  return ports;
}

}  // namespace syncline::sim
