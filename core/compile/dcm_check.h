// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "findings/finding.h"
#include "support/result.h"

namespace syncline {

struct NetworkConfig;

/// What keeps the DCM of a configuration from working, known before anything is sent.
struct DcmProblem {
  Finding finding;         // with the setting that cures it, value and allowed range
  std::uint32_t code = 0;  // DCM error code; 0: a parameter is outside its range
};

/// The cyclic frames carry a write of the reference clock's system time (0x0910), so that a mode which steers that
/// clock is possible (emDcmGetBusShiftConfigured).
[[nodiscard]] bool bus_shift_configured(const NetworkConfig& config);

/// Smallest distance from sending the cyclic frames to SYNC0 at which all outputs are there before it: the frames' time
/// on the wire and the way to the last slave, ns.
[[nodiscard]] Nanoseconds least_set_value(const NetworkConfig& config, Nanoseconds propagation_delay);

[[nodiscard]] std::vector<DcmProblem> dcm_problems(const NetworkConfig& config, Nanoseconds propagation_delay = 0);

/// The first problem as kBadValue (subject = key, received = DCM error code).
[[nodiscard]] Status check_dcm(const NetworkConfig& config);

}  // namespace syncline
