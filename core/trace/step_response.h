// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "support/types.h"

namespace syncline {

/// How an error comes back after a step: of the clock, of the set value, of the controller's gains. Values in the unit
/// of the error.
struct StepResponse {
  struct Sample {
    Nanoseconds time = 0;  // host clock, rising
    double value = 0;
  };
  double step = 0;   // the first error less where it ended
  double final = 0;  // where it ended: the median of the last tenth
  double noise = 0;  // standard deviation there, as its quartiles tell it
  double band = 0;   // what counts as settled about `final`: a twentieth of the step, three times the noise at least
  /// The largest error on the other side of `final`, as a part of the step; 0 where it is within the noise.
  double overshoot = 0;
  std::optional<Nanoseconds> rise;     // from the first sample until a tenth of the step was left
  std::optional<Nanoseconds> settled;  // ... until it stayed within the band; nothing: not in this stretch
};

/// Of the samples from the step on. Single samples that lie outside for one cycle alone, as a late stamp does, do not
/// unsettle it. Nothing where they are fewer than twenty, or where no step is seen: the first two must be further away
/// than kClearly times the noise.
inline constexpr double kClearly = 6;
[[nodiscard]] std::optional<StepResponse> step_response(std::span<const StepResponse::Sample> samples);

}  // namespace syncline
