// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "dc/sync0_arrival.h"
#include "support/types.h"

namespace syncline {
struct NetworkConfig;
}  // namespace syncline

namespace syncline::dc {

/// What one slave's cycle is made of, ns. Of a slave with SYNC0.
struct SlaveTiming {
  Nanoseconds bus_cycle = 0;           // > 0
  Nanoseconds set_value = 0;           // from the frame at the reference clock to the grid of SYNC0
  Nanoseconds delay = 0;               // from the reference clock to this slave
  Nanoseconds wire = 0;                // until the frame with its outputs has passed; 0: it has none
  Sync0Grid sync0{};                   // `first` from the grid on: the shift
  std::optional<Nanoseconds> sync1{};  // 0x09A4, >= 0: from a SYNC0 to SYNC1
  /// Its latch unit (0x09A8..0x09CF), where something is told of it.
  struct Latch {
    bool single = false;     // only the first edge until the time is read (0x09A8, 0x09A9)
    bool by_device = false;  // the device's own controller has the unit (AssignActivate, bits 4 and 5)
    bool in_frames = false;  // frames read the times
    bool operator==(const Latch&) const = default;
  };
  std::optional<Latch> latch{};
  std::optional<Nanoseconds> compute{};  // calculating and copying outputs (0x1C32:06); nothing: not known
  bool operator==(const SlaveTiming&) const = default;
};
/// Nothing without SYNC0. `delay` and `compute` of a slave that nobody has asked are to be filled in.
[[nodiscard]] std::optional<SlaveTiming> slave_timing(const NetworkConfig& config, std::size_t slave);

/// The stretch that repeats, from the moment at which a frame passes the reference clock. In order.
struct SyncTimeline {
  struct Span {
    Nanoseconds from = 0, to = 0;
    bool operator==(const Span&) const = default;
  };
  Nanoseconds length = 0;
  std::vector<Span> outputs;       // frames with its outputs, at the slave
  std::vector<Span> compute;       // behind each of them
  std::vector<Nanoseconds> sync0;  // edges, 0 <= edge < length
  std::vector<Nanoseconds> sync1;
  std::vector<Nanoseconds> latch_reads;  // a frame takes the latched times along
  /// The least time from outputs to the SYNC0 that uses them; nothing without outputs.
  std::optional<Nanoseconds> margin;
  bool operator==(const SyncTimeline&) const = default;
};
/// Pure. Of more than kMostEdges edges or frames the first are given.
inline constexpr std::size_t kMostEdges = 512;
[[nodiscard]] SyncTimeline sync_timeline(const SlaveTiming& timing);

/// From one SYNC1 to the next: an ESC gives one for each SYNC0 period that 0x09A4 does not reach beyond (ESC data
/// sheet I, 9.2.3: equal to the cycle of SYNC0 means half of its rate).
[[nodiscard]] constexpr Nanoseconds sync1_period(Nanoseconds sync0_period, Nanoseconds sync1) {
  return (sync1 / sync0_period + 1) * sync0_period;
}

}  // namespace syncline::dc
