// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "support/types.h"

namespace syncline::dc {

/// Rate of the reference clock against the host clock. A block of cycles gives one point, its median: what single send
/// stamps are wrong by, however far, does not count. A straight line through the points of the last seconds is the
/// rate. A step of one of the clocks between two points is no rate, and is left out. Allocates nothing.
class DriftEstimator {
 public:
  explicit DriftEstimator(Nanoseconds block = 100 * kMillisecond) : block_(block) {}
  void start() { *this = DriftEstimator(block_); }
  /// What comes next is not held against what was: neither the block that is open nor the last point.
  void leave_gap() {
    sample_count_ = 0;
    has_point_ = false;
  }
  /// Returns true when a block was completed and ppm() is new.
  bool observe(Nanoseconds host_time, Nanoseconds reference_time);
  /// Reference clock's rate minus host's; 0 until the second block is complete.
  [[nodiscard]] double ppm() const { return ppm_; }
  /// Half of the 95 % interval of ppm(): of the mean rate over the blocks that it is made of. Nothing with fewer than
  /// six points, and where the rate has just become another one.
  [[nodiscard]] std::optional<double> half_width_ppm() const { return half_width_ppm_; }
  /// Of the last block alone.
  [[nodiscard]] double last_block_ppm() const { return last_ppm_; }
  [[nodiscard]] bool valid() const { return slope_count_ > 0; }
  /// So many blocks agree that the rate is no accident.
  [[nodiscard]] bool proven() const { return slope_count_ >= kProven; }

 private:
  static constexpr std::size_t kSamples = 64;  // of a block
  static constexpr std::size_t kWindow = 40;   // blocks
  static constexpr std::size_t kProven = 4;
  struct Point {
    Nanoseconds host = 0, offset = 0;  // offset: reference time minus host time
  };
  struct Slope {
    double ppm = 0, span = 0;  // ns
  };

  void close_block();
  [[nodiscard]] Point median_sample();
  void add_slope(const Slope& slope);
  [[nodiscard]] bool rate_has_changed(double median, double gate) const;
  void draw_line(double median, double gate);

  Nanoseconds block_;
  std::array<Point, kSamples> samples_{};
  std::size_t sample_count_ = 0;
  Nanoseconds block_begin_ = 0;
  Point last_point_;
  bool has_point_ = false;
  std::array<Slope, kWindow> slopes_{};  // oldest first
  std::size_t slope_count_ = 0;
  double ppm_ = 0, last_ppm_ = 0;
  std::optional<double> half_width_ppm_;
};

}  // namespace syncline::dc
