// SPDX-License-Identifier: Apache-2.0
#include "dc/reference_line.h"

#include <algorithm>
#include <cmath>

namespace syncline::dc {
namespace {

constexpr double kPlaceGain = 1.0 / 32;  // of a surprise, when settled; critically damped with the rate's
constexpr Nanoseconds kRecent = 20 * kMillisecond;
constexpr int kTrusted = 100;  // readings
constexpr double kMaxRate = 1e-3;

}  // namespace

void ReferenceLine::start(Nanoseconds host_time, Nanoseconds reference_time) {
  *this = {};
  host_ = host_time;
  reference_ = reference_time;
}

Nanoseconds ReferenceLine::at(Nanoseconds host_time, double ppm) const {
  const auto passed = host_time - host_;
  const double rate = std::abs(passed) <= kRecent && readings_ >= kTrusted ? rate_ : ppm * 1e-6;
  return reference_ + passed + static_cast<Nanoseconds>(std::llround(fraction_ + static_cast<double>(passed) * rate));
}

void ReferenceLine::observe(Nanoseconds host_time, Nanoseconds reference_time) {
  if (!place_known_) {
    const double rate = rate_;
    start(host_time, reference_time);
    rate_ = rate;
    return;
  }
  const auto passed = static_cast<double>(host_time - host_);
  const double place = fraction_ + passed * rate_;
  const auto whole = static_cast<Nanoseconds>(std::floor(place));
  reference_ += host_time - host_ + whole;
  fraction_ = place - static_cast<double>(whole);
  host_ = host_time;
  const double surprise = static_cast<double>(reference_time - reference_) - fraction_;
  const auto verdict = gate_.judge(surprise, readings_ >= kTrusted);
  if (verdict == OutlierGate::Verdict::kOutlier) return;
  if (verdict == OutlierGate::Verdict::kStep) {
    place_known_ = false;
    return observe(host_time, reference_time);
  }
  const double gain = std::max(kPlaceGain, 2.0 / (readings_ + 2));
  fraction_ += gain * surprise;
  if (passed > 0) rate_ = std::clamp(rate_ + gain * gain / 4 * surprise / passed, -kMaxRate, kMaxRate);
  readings_ = std::min(readings_ + 1, kTrusted);
}

}  // namespace syncline::dc
