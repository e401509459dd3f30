// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline::dc {

/// Tells readings that cannot be true from those that are only noisy. A reading is invalid when it is further from
/// what was expected than the limit (nMaxValidVal), or than six times the usual scatter where that is more: a host
/// whose stamps are worse than the limit would otherwise never be heard. Outliers widen the scatter, too: where every
/// second reading is one, they are soon none. What stays away is true: the clock has stepped.
class OutlierGate {
 public:
  enum class Verdict { kValid, kOutlier, kStep };

  explicit OutlierGate(double limit_ns) : limit_(limit_ns) {}
  void start() { *this = OutlierGate(limit_); }
  /// `surprise`: reading less expectation, ns. While not `trusted` the expectation is no measure, and all is valid.
  Verdict judge(double surprise, bool trusted);
  /// The same of a reading that is not counted.
  [[nodiscard]] bool is_far(double surprise) const;

 private:
  [[nodiscard]] double gate() const;

  double limit_;
  double scatter_ = 0;
  int outliers_ = 0;
};

}  // namespace syncline::dc
