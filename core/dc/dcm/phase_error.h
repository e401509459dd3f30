// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dc/clock_registers.h"
#include "dc/dcm/dcm_controller.h"

namespace syncline::dc {

/// Where frames are to pass the reference clock: base - set_value, every cycle.
struct PhaseTarget {
  Nanoseconds base = 0;
  Nanoseconds set_value = 0;
  Nanoseconds cycle = kMillisecond;

  /// How late in the SYNC grid the *schedule* is. What the host is known to have been late is taken
  /// out: wake-up delay is one-sided, and a loop that saw it would centre its mean on the target.
  [[nodiscard]] Nanoseconds error(const DcmObservation& o) const {
    return wrap_to_half(*o.reference_time - (o.send_time - o.scheduled_time) - (base - set_value), cycle);
  }

  /// The place in the grid nearest to a time: a clock that is to be led there is never asked to jump.
  [[nodiscard]] Nanoseconds nearest(Nanoseconds reference_time) const {
    return reference_time - wrap_to_half(reference_time - (base - set_value), cycle);
  }
};

}  // namespace syncline::dc
