// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "support/types.h"

namespace syncline {
struct SimSlaveConfig;
}  // namespace syncline

namespace syncline::sim {

/// Who hangs at which port of whom, by position. Cables can be changed while the segment runs.
class Wiring {
 public:
  explicit Wiring(std::span<const SimSlaveConfig> slaves);
  [[nodiscard]] std::optional<std::uint16_t> child(std::size_t slave, unsigned port) const {
    return children_[slave][port];
  }
  /// Who is connected to the master.
  [[nodiscard]] std::size_t first() const { return first_; }
  /// Port at which the cable to the parent is.
  [[nodiscard]] std::uint8_t entry(std::size_t slave) const { return entries_[slave]; }
  /// The cable to the parent goes to `port`, and what was there to where that cable was.
  void reverse(std::size_t slave, std::uint8_t port);

  /// The segment's end leads back to the host, whose second adapter sends the frame in there so long after the first.
  struct Ring {
    std::uint16_t slave = 0;
    std::uint8_t port = 0;
    double time_ns = 0;
  };
  void close_ring(const std::optional<Ring>& ring) { ring_ = ring; }
  [[nodiscard]] const Ring* ring_at(std::size_t slave, unsigned port) const {
    return ring_ && ring_->slave == slave && ring_->port == port ? &*ring_ : nullptr;
  }

 private:
  std::vector<std::array<std::optional<std::uint16_t>, 4>> children_;
  std::vector<std::uint8_t> entries_;
  std::size_t first_ = 0;
  std::optional<Ring> ring_;
};

/// The way of a frame through a segment: every reception at a port, with the time since the master sent.
struct Passage {
  std::uint16_t slave = 0;
  std::uint8_t port = 0;   // where the frame is received
  bool processed = false;  // behind this port lies the processing unit
  bool first = false;      // of this slave
  bool looped = false;     // port 0 is closed: no reception, but the way through the processing unit all the same
  double time_ns = 0;      // since the frame's start left the master
  Nanoseconds offset = 0;  // the same, rounded
};

/// Ports of a slave as a frame finds them.
struct PortState {
  std::array<bool, 4> link{};
  std::array<bool, 4> open{};
};

struct SegmentPath {
  std::vector<Passage> passages;  // in the order of the way
  double return_ns = 0;           // until the frame's start is back at the master
  bool swallowed = false;         // the frame leaves a port that is open without a link, or comes to a closed one
  std::optional<std::uint16_t> closed_entry;  // slave to whose closed port it came
};

/// Depth first in port order 0-3-1-2-0 from where the frame comes in (ESC data sheet I, 3.2): the processing unit and
/// its delay lie behind port 0, the forwarding delay behind the others, both as a cable or E-bus
/// has them, what the child is entered by (EscDelays); 5 ns a metre of cable. Closed ports are passed over.
[[nodiscard]] SegmentPath segment_path(std::span<const SimSlaveConfig> slaves, const Wiring& wiring,
                                       std::span<const PortState> ports);

/// Everything is switched on and plugged in.
[[nodiscard]] std::vector<PortState> all_connected(std::span<const SimSlaveConfig> slaves, const Wiring& wiring);

}  // namespace syncline::sim
