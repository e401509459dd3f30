// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "support/types.h"

namespace syncline::dc {

/// Rate of the reference clock against the host clock, from blocks of cycles: the slope between the
/// ends of a block is exact to the stamps' noise divided by its length, and in the mean of adjoining blocks
/// the noise of their common ends cancels.
class DriftEstimator {
 public:
  explicit DriftEstimator(Nanoseconds block = 100 * kMillisecond) : block_(block) {}
  void start() { *this = DriftEstimator(block_); }
  /// Returns true when a block was completed and ppm() is new.
  bool observe(Nanoseconds host_time, Nanoseconds reference_time);
  /// Reference clock's rate minus host's; 0 until the first block is complete.
  [[nodiscard]] double ppm() const { return ppm_; }
  /// Of the last block alone.
  [[nodiscard]] double last_block_ppm() const { return last_ppm_; }
  [[nodiscard]] bool valid() const { return blocks_ > 0; }

 private:
  Nanoseconds block_;
  std::optional<Nanoseconds> host_, reference_;
  double ppm_ = 0, last_ppm_ = 0;
  int blocks_ = 0;
};

}  // namespace syncline::dc
