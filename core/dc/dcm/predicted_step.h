// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "support/types.h"

namespace syncline {
struct DcmSettings;
}  // namespace syncline

namespace syncline::dc {

/// What the error of the schedule would do, cycle by cycle from the moment on at which the reference clock steps by
/// `step` ns, with these settings and clocks and stamps without noise: the first entry is the error as it is seen
/// first. It runs the controller itself, which was settled before. Empty where the mode does not move the host's timer,
/// or leaves it to others: in bus shift the ESC's own loop is part of it.
[[nodiscard]] std::vector<double> predicted_step(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds step,
                                                 std::size_t cycles);

}  // namespace syncline::dc
