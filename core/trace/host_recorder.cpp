// SPDX-License-Identifier: Apache-2.0
#include "trace/host_recorder.h"

#include <algorithm>
#include <array>

#include "channels/cycle_sample.h"
#include "protocol/al_state.h"
#include "support/jitter_profile.h"

namespace syncline {
namespace {

constexpr std::array kParts{0.0, 0.01, 0.1, 0.25, 0.5, 0.75, 0.9, 0.95, 0.99, 0.995, 0.999, 0.9995, 0.9999, 1.0};

/// As many points as the number of observations can tell apart.
template <class At>
QuantileCurve curve(std::uint64_t count, At at) {
  std::vector<QuantileCurve::Point> points;
  if (count == 0) return {};
  double highest = 0;
  for (const double part : kParts) {
    if (part < 1 && (1 - part) * static_cast<double>(count) < 1) continue;
    highest = std::max(highest, static_cast<double>(at(part)));
    points.push_back({part, highest});
  }
  return {std::move(points)};
}

QuantileCurve curve(const Histogram& histogram, std::int64_t less = 0) {
  return curve(histogram.count(),
               [&](double part) { return (part <= 0 ? histogram.min() : histogram.percentile(part)) - less; });
}

}  // namespace

void HostRecorder::add(std::span<const CycleSample> samples) {
  for (const auto& sample : samples) {
    if (!has_process_data_communication(static_cast<AlState>(sample.master_state))) continue;
    if (last_ != 0) {
      const auto gap = sample.send_time - last_;
      if (gap > cycle_time_ + cycle_time_ / 2) stalls_.add(gap - cycle_time_);
    }
    if (first_ == 0) first_ = sample.send_time;
    last_ = sample.send_time;
    wake_up_.add(sample.wake_lateness_ns);
    if (sample.round_trip_ns > 0) round_trip_.add(sample.round_trip_ns);
    if ((sample.flags & CycleSample::kReferenceValid) != 0) add_reading(sample.reference_time - sample.send_time);
  }
}

void HostRecorder::add_reading(Nanoseconds reference_less_send) {
  constexpr std::size_t kWindow = 2 * kNeighbours + 1;
  if (readings_.size() == kWindow) readings_.erase(readings_.begin());
  readings_.push_back(reference_less_send);
  if (readings_.size() < kWindow) return;
  auto sorted = readings_;
  std::ranges::nth_element(sorted, sorted.begin() + kNeighbours);
  const auto error = std::clamp<Nanoseconds>(readings_[kNeighbours] - sorted[kNeighbours], INT32_MIN, INT32_MAX);
  stamp_errors_.push_back(static_cast<std::int32_t>(error));
}

JitterProfile HostRecorder::profile() const {
  JitterProfile profile;
  profile.wake_up = curve(wake_up_);
  if (!stamp_errors_.empty()) {
    auto sorted = stamp_errors_;
    std::ranges::sort(sorted);
    const auto at = [&](double part) {
      return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(part * static_cast<double>(sorted.size())))];
    };
    // No frame leaves before its stamp: the earliest are those that left at once. A few readings may be wrong the other
    // way.
    const auto earliest = at(0.001);
    profile.stamp_error = curve(sorted.size(), [&](double part) { return std::max(0, at(part) - earliest); });
  } else {
    profile.stamp_error = curve(round_trip_, round_trip_.min());
  }
  if (stalls_.count() > 0 && last_ > first_) {
    profile.stalls_per_second = static_cast<double>(stalls_.count()) * 1e9 / static_cast<double>(last_ - first_);
    profile.stall = curve(stalls_);
  }
  return profile;
}

}  // namespace syncline
