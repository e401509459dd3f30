// SPDX-License-Identifier: Apache-2.0
#include "dc/outlier_gate.h"

#include <algorithm>
#include <cmath>

namespace syncline::dc {
namespace {

constexpr double kScatters = 7.5;  // six standard deviations of a normal distribution
constexpr double kMemory = 0.02;
constexpr int kOutliersAreTrue = 20;  // so many in a row

}  // namespace

double OutlierGate::gate() const { return std::max(limit_, kScatters * scatter_); }

bool OutlierGate::is_far(double surprise) const { return std::abs(surprise) > gate(); }

OutlierGate::Verdict OutlierGate::judge(double surprise, bool trusted) {
  const double size = std::abs(surprise);
  if (trusted && is_far(surprise)) {
    // Where they are no exceptions the host is that bad, and the gate opens.
    scatter_ += kMemory / 4 * (gate() - scatter_);
    if (++outliers_ < kOutliersAreTrue) return Verdict::kOutlier;
    outliers_ = 0;
    return Verdict::kStep;
  }
  outliers_ = 0;
  scatter_ += kMemory * (std::min(size, gate()) - scatter_);
  return Verdict::kValid;
}

}  // namespace syncline::dc
