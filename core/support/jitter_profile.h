// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/quantile_curve.h"

namespace syncline {

/// What a host does to the times of a master, as measured on real hosts (docs/scenarios.md says which and how).
struct JitterProfile {
  QuantileCurve wake_up;         // how late a wake-up is, ns
  QuantileCurve stamp_error;     // from the moment that software takes for that of sending until the frame leaves, ns
  double stalls_per_second = 0;  // the host does nothing at all ...
  QuantileCurve stall;           // ... for so long, ns

  bool operator==(const JitterProfile&) const = default;
  /// Always on time.
  static JitterProfile none() { return {}; }
  /// A quiet computer: real-time priority, awake before each deadline.
  static JitterProfile quiet();
  /// One with real-time priority that sleeps until the deadline.
  static JitterProfile desktop();
  /// A virtual machine under load: sleeps until the deadline, and loses the processor for milliseconds now and then.
  static JitterProfile bad();
};

}  // namespace syncline
