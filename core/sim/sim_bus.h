// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "support/result.h"
#include "support/types.h"

namespace syncline {
struct SimConfig;
}  // namespace syncline

namespace syncline::sim {

struct PinEdge;

/// A segment of simulated ESCs. Frames are executed byte by byte in wire order; time is true time
/// (the host clock's) given by the caller and must not step back. Single-threaded, deterministic.
class SimBus {
 public:
  /// How slaves do what is the same in every cycle.
  enum class Work : std::uint8_t {
    kAtOnce,  // they remember what a frame does to them, and count what nobody looks at
    kEach,    // each datagram and each SYNC signal by itself, which is the same and slower
  };
  /// `start`: true time of power-on.
  [[nodiscard]] static Result<std::unique_ptr<SimBus>> create(const SimConfig& config, Nanoseconds start,
                                                              Work work = Work::kAtOnce);
  ~SimBus();

  struct Returned {
    bool lost = false;             // nothing comes back
    Nanoseconds arrival_time = 0;  // at the master's port
  };
  /// Sends `frame` (Ethernet frame without FCS) into the segment at `send_time`; on return the buffer
  /// holds what comes back.
  Returned execute(std::span<std::uint8_t> frame, Nanoseconds send_time);

  /// Lets the devices' applications, oscillators and SYNC units run up to `time` without a frame.
  void advance_to(Nanoseconds time);

  /// The level at a slave's LATCH input (0, 1), from now on; false: no time taken (see Esc::latch_input).
  bool latch_input(std::size_t position, unsigned number, bool level);

  // What tests and plots may look at, never the master.
  [[nodiscard]] std::size_t slave_count() const;
  /// PDI view of the system time (local + offset) of a slave at its current time.
  [[nodiscard]] std::uint64_t system_time(std::size_t position) const;
  /// True one-way delay from where frames enter the segment to this slave's processing unit, ns.
  [[nodiscard]] double true_delay_ns(std::size_t position) const;
  /// Edges of a device's output pin (from 1) so far, oldest first; empty when it has none.
  [[nodiscard]] std::vector<PinEdge> pin_edges(std::size_t position, unsigned pin) const;
  [[nodiscard]] std::vector<std::uint8_t> peek(std::size_t position, std::uint16_t address, std::size_t length) const;

 private:
  struct Impl;
  explicit SimBus(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace syncline::sim
