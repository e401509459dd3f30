// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "channels/cycle_sample.h"
#include "trace/signals.h"

/// What the source of an imported run does not tell of a cycle. Bits of CycleSample::flags that the master never sets:
/// what they are of has no value, instead of a zero.
namespace syncline {

class SampleStore;

enum UntoldFlag : std::uint16_t {
  kStateUntold = 16,         // master_state; the run is judged as one in OP
  kExpectedUntold = 32,      // wkc_expected
  kLearnedUntold = 64,       // dcm_output_sum_ns, dcm_output_total_ns
  kLatenessUntold = 8192,    // wake_lateness_ns, skipped_cycles
  kRoundTripUntold = 16384,  // round_trip_ns
  kFramesUntold = 32768,     // whether frames came back, and working counters
};

[[nodiscard]] constexpr bool is_told(const CycleSample& sample, UntoldFlag what) { return (sample.flags & what) == 0; }

/// The signal that has a value in each cycle whose frame came back: the round trip, or where no cycle tells that, the
/// controller's error or the deviation.
[[nodiscard]] Signal answered_signal(const SampleStore& store);

}  // namespace syncline
