// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/drift_estimator.h"

namespace syncline::dc {
namespace {

constexpr int kMemory = 20;  // blocks

}  // namespace

bool DriftEstimator::observe(Nanoseconds host_time, Nanoseconds reference_time) {
  if (!host_) {
    host_ = host_time;
    reference_ = reference_time;
    return false;
  }
  const auto host_span = host_time - *host_;
  if (host_span < block_) return false;
  const auto reference_span = reference_time - *reference_;
  last_ppm_ = static_cast<double>(reference_span - host_span) / static_cast<double>(host_span) * 1e6;
  // The plain mean of the first blocks, afterwards one that forgets.
  if (blocks_ < kMemory) ++blocks_;
  ppm_ += (last_ppm_ - ppm_) / blocks_;
  host_ = host_time;
  reference_ = reference_time;
  return true;
}

}  // namespace syncline::dc
