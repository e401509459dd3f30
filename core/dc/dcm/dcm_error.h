// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "dc/dcm/dcm_controller.h"
#include "dc/dcm/drift_estimator.h"
#include "dc/dcm/sync_judge.h"

namespace syncline::dc {

/// Drift that no controller can balance: an ESC's loop reaches some 760 ppm, and needs some of it itself.
inline constexpr double kMaxDriftPpm = 600;

/// The code that a controller reports: drift too high comes before its consequence, out of limit.
[[nodiscard]] inline std::uint32_t dcm_error_code(const DriftEstimator& drift, const SyncJudge& judge) {
  if (drift.valid() && std::abs(drift.ppm()) > kMaxDriftPpm) return kDcmErrorDriftTooHigh;
  return judge.was_in_sync() && !judge.in_sync() ? kDcmErrorOutOfLimit : 0;
}

}  // namespace syncline::dc
