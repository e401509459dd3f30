// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/clock_step_detector.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace syncline::dc {
namespace {

/// Gains of the line that follows the readings, critically damped.
constexpr double kLevelGain = 0.1, kRateGain = 0.0053;
constexpr int kLearning = 50;          // readings until the line is trusted
constexpr double kStepScatters = 7.5;  // six standard deviations of a normal distribution
constexpr double kStepMemory = 0.02;
/// An ESC that is led back to its place after a step moves no faster: its speed counter ends at 763 ppm.
constexpr double kFastestRate = 1e-3;
/// Readings until frames go to the clock that leads now, and its loop has been told that it leads.
constexpr int kUnsettled = 8;
constexpr int kLost = 20;   // strange readings in a row that do not agree: the line is begun anew
constexpr int kHeldUp = 8;  // frames in a row: then there are no others

}  // namespace

ClockStepDetector::Reading ClockStepDetector::observe(Nanoseconds host_time, Nanoseconds reference_time,
                                                      Nanoseconds doubt) {
  if (unsettled_ > 0) {
    --unsettled_;
    return {};
  }
  const double gate = std::max(limit_, kStepScatters * scatter_), later = static_cast<double>(doubt);
  if (spoils_line(later, gate)) return {};
  if (!started_) {
    started_ = true;
    host_ = host_time;
    reference_ = reference_time;
    return {};
  }
  const auto passed = host_time - host_;
  if (passed <= 0) return {};
  const double surprise =
      static_cast<double>(reference_time - reference_ - passed) - rate_ * static_cast<double>(passed) - fraction_;
  if (readings_ >= kLearning && std::abs(surprise) > gate) {
    if (take_held(surprise, later, gate)) return {{}, std::max(surprise, later)};
    const auto step = sure_step({host_time, surprise}, gate);
    if (!step && strange_ < kLost) return {};
    const auto size = step ? std::optional(static_cast<Nanoseconds>(std::llround(*step))) : std::nullopt;
    const auto keep = *this;
    start();
    started_ = true;
    host_ = host_time;
    reference_ = reference_time;
    if (!size) return {};
    // The clock is another one, its rate and the host's stamps are not.
    rate_ = keep.rate_;
    scatter_ = keep.scatter_;
    readings_ = kLearning;
    return {size, 0};
  }
  strange_ = 0;
  held_.reset();
  // Frames that wait for those of others on the wire, one after the other, do not take the line with them: it would be
  // found in the wrong place when they no longer do.
  const double unremarkable = gate / 4;
  const bool explained = surprise > unremarkable && surprise - later <= unremarkable;
  if (readings_ >= kLearning && explained) return {};
  readings_ = std::min(readings_ + 1, kLearning);
  scatter_ += std::max(kStepMemory, 1.0 / readings_) * (std::min(std::abs(surprise), gate) - scatter_);
  follow(surprise, static_cast<double>(passed));
  return {};
}

void ClockStepDetector::look_elsewhere() {
  start();
  unsettled_ = kUnsettled;
}

/// One of fifty would draw the line away by a tenth and more of what its stamp was wrong, and all that follow would
/// look like a step.
bool ClockStepDetector::spoils_line(double doubt, double gate) {
  if (readings_ >= kLearning || doubt <= gate) {
    spoiling_ = 0;
    return false;
  }
  return ++spoiling_ < kHeldUp;
}

/// Whoever measures how much later frames come back gets used to it in time; so what has begun as a held frame stays
/// one while it is as late as before and still comes back later.
bool ClockStepDetector::take_held(double surprise, double doubt, double gate) {
  const bool explained = surprise > 0 && surprise - doubt <= gate;
  const bool as_before = held_ && std::abs(surprise - *held_) <= gate / 2 && surprise <= 2 * doubt;
  if (!explained && !as_before) {
    held_.reset();
    return false;
  }
  held_ = surprise;
  return true;
}

/// Begins as a line through all readings.
void ClockStepDetector::follow(double surprise, double passed) {
  const double n = readings_ + 1;  // with the one that began it
  const double level = readings_ < kLearning ? std::max(kLevelGain, 2 * (2 * n - 1) / (n * (n + 1))) : kLevelGain;
  const double rate = readings_ < kLearning ? std::max(kRateGain, 6 / (n * (n + 1))) : kRateGain;
  const double moved = rate_ * passed + fraction_ + std::min(level, 1.0) * surprise;
  const double whole = std::floor(moved);
  reference_ += static_cast<Nanoseconds>(passed) + static_cast<Nanoseconds>(whole);
  fraction_ = moved - whole;
  host_ += static_cast<Nanoseconds>(passed);
  rate_ += std::min(rate, 1.0) * surprise / passed;
}

std::optional<double> ClockStepDetector::sure_step(const Strange& reading, double gate) {
  std::shift_left(last_strange_.begin(), last_strange_.end(), 1);
  last_strange_.back() = reading;
  if (++strange_ < kSure) return std::nullopt;
  const auto [low, high] = std::ranges::minmax(last_strange_, {}, &Strange::surprise);
  const double spread = high.surprise - low.surprise;
  const double led = kFastestRate * static_cast<double>(reading.host_time - last_strange_.front().host_time);
  const bool comes_back =
      std::ranges::is_sorted(last_strange_, std::greater{}, [](const Strange& one) { return std::abs(one.surprise); });
  if (spread > gate / 2 + (comes_back ? led : 0)) return std::nullopt;
  return low.surprise + spread / 2;
}

}  // namespace syncline::dc
