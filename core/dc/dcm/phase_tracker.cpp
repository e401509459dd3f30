// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/phase_tracker.h"

#include <algorithm>
#include <cmath>

namespace syncline::dc {
namespace {

constexpr double kReading = 1'000;        // ns; a send stamp's error where nothing is known of it
constexpr double kDriftAtStart = 200e-6;  // of the cycle
constexpr double kMaxDrift = 1'000e-6;    // of the cycle; what is reported as too high is still balanced
constexpr double kLean = 16;              // readings that say whether they lean to one side,
constexpr double kUsual = 512;            // ... and those that say how they are at other times
constexpr double kLeans = 6;              // times what they do then: where one is off as those before it were, and
constexpr double kStrays = 2;             // times what one is off that mean: where a few are off by very much
constexpr double kLeastLean = 1.0 / 8;    // of nMaxValidVal: one reading, however far it may be off, is no lean

double square(double x) { return x * x; }

}  // namespace

PhaseTracker::PhaseTracker(Gains settled, double cycle_ns, double max_valid_ns)
    : settled_(settled), cycle_(cycle_ns), max_valid_(max_valid_ns), gate_(max_valid_ns) {
  start();
}

void PhaseTracker::start() {
  phase_ = drift_ = 0;
  forget_phase();
}

void PhaseTracker::forget_phase() {
  gate_.start();
  readings_ = 0;
  lean_ = usual_lean_ = stray_ = 0;
  p11_ = square(cycle_ / kReading);
  p12_ = 0;
  p22_ = square(kDriftAtStart * cycle_ / kReading);
}

double PhaseTracker::wrapped(double value) const { return value - cycle_ * std::round(value / cycle_); }

void PhaseTracker::advance(double cycles, double moved) {
  phase_ = wrapped(phase_ + cycles * drift_ + moved);
  p11_ += 2 * cycles * p12_ + square(cycles) * p22_;
  p12_ += cycles * p22_;
}

bool PhaseTracker::update(double phase) {
  double surprise = wrapped(phase - phase_);
  switch (gate_.judge(surprise, settled())) {
    case OutlierGate::Verdict::kOutlier:
      return false;
    case OutlierGate::Verdict::kStep:
      forget_phase();
      break;
    case OutlierGate::Verdict::kValid:
      break;
  }
  const double phase_gain = std::max(p11_ / (p11_ + 1), settled_.phase);
  const double drift_gain = std::max(p12_ / (p11_ + 1), settled_.drift);
  const double k1 = p11_ / (p11_ + 1), k2 = p12_ / (p11_ + 1);
  p22_ = std::max(p22_ - k2 * p12_, 0.0);
  p12_ *= 1 - k1;
  p11_ *= 1 - k1;
  phase_ = wrapped(phase_ + phase_gain * surprise);
  drift_ = std::clamp(drift_ + drift_gain * surprise, -kMaxDrift * cycle_, kMaxDrift * cycle_);
  readings_ = std::min(readings_ + 1, kTrusted);
  doubt_rate(surprise);
  return true;
}

void PhaseTracker::doubt_rate(double surprise) {
  lean_ += (surprise - lean_) / kLean;
  usual_lean_ += (std::abs(lean_) - usual_lean_) / kUsual;
  stray_ += (std::abs(surprise - lean_) - stray_) / kUsual;
  const double usual = std::max({kLeans * usual_lean_, kStrays * stray_, kLeastLean * max_valid_});
  if (!settled() || std::abs(lean_) < usual) return;
  p11_ += square(lean_ / kReading);
  p22_ += square(lean_ / kLean / kReading);
  lean_ = 0;
}

}  // namespace syncline::dc
