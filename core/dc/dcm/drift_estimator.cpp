// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/drift_estimator.h"

namespace syncline::dc {

bool DriftEstimator::observe(Nanoseconds host_time, Nanoseconds reference_time) {
  if (!host_) {
    host_ = host_time;
    reference_ = reference_time;
    return false;
  }
  const auto host_span = host_time - *host_;
  if (host_span < block_) return false;
  const auto reference_span = reference_time - *reference_;
  const double slope = static_cast<double>(reference_span - host_span) / static_cast<double>(host_span) * 1e6;
  // Blocks are averaged, with more weight to the new one while there are few.
  ppm_ = valid_ ? ppm_ + 0.3 * (slope - ppm_) : slope;
  valid_ = true;
  host_ = host_time;
  reference_ = reference_time;
  return true;
}

}  // namespace syncline::dc
