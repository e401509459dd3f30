// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "channels/values/delay_warning.h"
#include "channels/values/sync_obstacle.h"
#include "support/types.h"

/// Distributed clocks, and the two verdicts on synchronisation (docs/distributed-clocks.md).
namespace syncline::events {

struct DcInitialised {
  std::size_t slaves = 0;    // with distributed clocks that are there
  int reference_clock = -1;  // position
};

/// Of the event's slave.
struct ReferenceClockChanged {
  enum class What : std::uint8_t {
    kLost,
    kPresent,
    kTookOver,      // from the one that was lost
    kNoSystemTime,  // 0x0910 does not answer: the next one leads in its place
  };
  What what = What::kPresent;
};

/// All that follow are within the sync window; of a slave: it was away and is within again.
struct SlavesInSync {
  std::int64_t deviation_ns = 0;  // the largest, magnitude
};

/// The slave is the one furthest over the limit by its own reading, -1 without one. Without one and with a count, all
/// that follow are off to the same side, and about as far: the reference clock has moved.
struct SlavesOutOfSync {
  std::int64_t deviation_ns = 0;  // the largest, magnitude
  std::size_t over_limit = 0;     // slaves, by their own readings
};

/// The event's slave went or came back, and the frames' way to those behind it is another one than when their delays
/// (0x0928) were measured: those are off by the difference, and soon do not show it in their own readings.
struct FramesWayChanged {
  std::int64_t deviation_ns = 0;  // the largest, magnitude
  std::size_t slaves = 0;         // over the limit, by their own readings
};

struct SlavesNotMonitored {};

/// Nobody leads, or the readings are too old to say anything.
struct SlavesSyncUnknown {
  Nanoseconds oldest_reading = 0;  // its age; 0: nobody follows
};

struct MasterInSync {
  Nanoseconds error = 0;  // signed
};

struct MasterOutOfSync {
  Nanoseconds error = 0;  // signed; the size of the step, when a clock has stepped
  dc::SyncObstacle obstacle = dc::SyncObstacle::kNone;
};

/// The controller gave up.
struct DcmError {
  std::uint32_t code = 0;      // DCM_E_..., protocol/dcm_error.h
  std::int64_t drift_ppm = 0;  // host clock against reference clock
};

/// What the delay measurement stumbled over at the slave.
struct DelayFinding {
  dc::DelayWarning warning = dc::DelayWarning::kNegativeHop;
  std::int64_t value = 0;  // ns, or a port: see DelayWarning
};

/// Again, while the bus runs.
struct DelaysMeasured {
  std::size_t corrected = 0;    // slaves whose delay is being corrected
  std::int64_t largest_ns = 0;  // change among them, signed
};

}  // namespace syncline::events
