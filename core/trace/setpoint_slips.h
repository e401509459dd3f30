// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dc/sync0_arrival.h"
#include "trace/sync0_slaves.h"

namespace syncline {

struct CycleSample;
struct Snapshot;

/// Setpoint slips: SYNC0 periods of a slave in OP into which no frame brought its outputs, or more than are due (two,
/// where SYNC0 comes with every bus cycle). Driven by samples and snapshots in their order; what is not known for sure
/// ends a count, and the next one begins at 0: cycles missing in the stream, another state, base or delay, a frame
/// that came back after its deadline (nobody knows when it passed), a frame without the reference clock's time, a step
/// of that clock. A frame that did not come back has brought nothing.
class SetpointSlips {
 public:
  /// Nothing is counted of slaves without SYNC0, or whose SYNC0 is no multiple of the bus cycle.
  SetpointSlips(std::span<const Sync0Slave> slaves, Nanoseconds cycle_time);

  struct Count {
    std::uint32_t empty = 0;    // periods in which no frame came; told with the frame behind them
    std::uint32_t crowded = 0;  // periods in which more came than are due
    [[nodiscard]] std::uint32_t total() const { return empty + crowded; }
    bool operator==(const Count&) const = default;
  };
  /// True: some count is another one, or none any more.
  bool observe(const CycleSample& sample);
  bool observe(const Snapshot& snapshot);
  /// Cycles are missing.
  void begin_anew();
  /// Nothing where it is not known.
  [[nodiscard]] std::optional<Count> count(std::size_t slave) const;

 private:
  struct Slave {
    dc::Sync0Grid grid;  // with the base
    Sync0Slave sync0;
    std::optional<Nanoseconds> delay;  // of propagation, once it is in OP
    std::optional<Count> count;        // once a frame has come
    Nanoseconds end = 0;               // of the period that is running
    int frames = 0;                    // in it
  };
  /// True: its count is another one.
  static bool arrive(Slave& slave, Nanoseconds time);
  [[nodiscard]] bool clock_stepped(const CycleSample& sample) const;

  Nanoseconds cycle_time_;
  std::vector<Slave> slaves_;
  bool any_ = false;  // somebody is counted
  std::optional<Nanoseconds> base_;
  Nanoseconds last_send_ = 0, last_reference_ = 0;  // of the last frame; 0: none
};

}  // namespace syncline
