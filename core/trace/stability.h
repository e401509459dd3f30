// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// How a clock difference behaves over observation times: the figures of NIST Special Publication 1065 and ITU-T G.810.
/// They tell jitter, hunting and drift apart, which a maximum or a standard deviation cannot.
namespace syncline {

/// One observation time. A figure without a term is not a number: there were too few samples for it.
struct StabilityPoint {
  double tau = 0;         // s
  double adev = 0;        // overlapping Allan deviation, s/s
  double plain_adev = 0;  // the same of every m-th sample only (SP 1065, 5.2.1)
  double mdev = 0;        // modified Allan deviation, s/s
  double tdev = 0;        // time deviation, in the unit of the samples
  double tie_rms = 0;     // root mean square of x(t + tau) - x(t), in the unit of the samples
  double mtie = 0;        // largest peak-to-peak value in any window of tau, in the unit of the samples
  std::size_t terms = 0;  // of the overlapping Allan deviation
  /// Windows of tau that lie side by side in the stretches. Terms that overlap tell hardly more than these do.
  std::size_t windows = 0;
};
/// With fewer windows a figure is a matter of chance: it is not shown.
inline constexpr std::size_t kFewestWindows = 3;
/// So many make it a good one (ITU-T G.811 asks for a measurement of twelve times tau).
inline constexpr std::size_t kGoodWindows = 12;

/// Time errors at equal distances: stretches without a gap. No term reaches across two of them.
template <class Value>
using Stretches = std::span<const std::span<const Value>>;

/// Of observation times of 1, 2, 4 ... sampling intervals. `interval` in s; `unit`: of the samples in s (1e-9 for ns).
/// Works in double precision; takes about 0.1 us a sample, twice the memory of the samples, and no lock. Ends early,
/// with what it has, once `stop` is true; null: it does not.
[[nodiscard]] std::vector<StabilityPoint> stability_octaves(Stretches<float> stretches, double interval, double unit,
                                                            const std::atomic<bool>* stop = nullptr);
[[nodiscard]] std::vector<StabilityPoint> stability_octaves(Stretches<double> stretches, double interval, double unit,
                                                            const std::atomic<bool>* stop = nullptr);
/// Of one observation time of `m` sampling intervals, any m from 1 on.
[[nodiscard]] StabilityPoint stability_at(Stretches<double> stretches, std::size_t m, double interval, double unit);

/// The most that differences of a size of up to `limit` can show at `tau`: what a line in the plot stands for.
[[nodiscard]] StabilityPoint stability_bound(double limit, double tau, double unit);

/// What the slopes mean, over the observation times with enough terms and windows.
struct StabilityReading {
  /// Of the Allan deviation over its first and its last two octaves: -1 is white phase noise, +1 a steady change of the
  /// rate. Nothing where there are too few samples for a reading, and then none of the following is said.
  std::optional<double> short_slope, long_slope;
  bool jitter = false;  // falls with tau: the differences of neighbouring samples have nothing to do with each other
  bool drift = false;   // rises with tau to the end: the rates differ, and nobody takes it back
  double hunting_period = 0;  // s, about; 0: no hump
  double disturbed_for = 0;   // s: one disturbance is nearly all there is, within this, and the hump is its; 0: none
  double runs_away = 0;       // unit of the samples in a second: a rate that stays, which ADEV does not see; 0: none
};
[[nodiscard]] StabilityReading read_stability(const std::vector<StabilityPoint>& points);

}  // namespace syncline
