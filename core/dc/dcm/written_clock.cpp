// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/written_clock.h"

#include <algorithm>
#include <cmath>

#include "config/dcm_settings.h"

namespace syncline::dc {
namespace {

/// Cycles over which the usual lateness is a mean; a single wake-up that is far off counts no more than this, ns.
constexpr int kLatenessMemory = 32;
constexpr double kLatenessChange = 2'000;

}  // namespace

WrittenClock::WrittenClock(Time time, const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value,
                           Nanoseconds least)
    : time_(time), target_{0, set_value, cycle_time}, monitor_(settings, cycle_time, set_value, least) {}

void WrittenClock::start(Nanoseconds base, Nanoseconds first_reference_time, Nanoseconds first_send_time) {
  target_.base = base;
  monitor_.start(first_send_time);
  state_ = {};
  usual_lateness_ = 0;
  observed_ = 0;
  host_ = first_send_time;
  reference_ = target_.nearest(first_reference_time);
}

std::optional<Nanoseconds> WrittenClock::reference_write(Nanoseconds send_time, Nanoseconds scheduled_time) {
  return wanted_at(time_ == Time::kNominal ? scheduled_time : send_time);
}

void WrittenClock::learn_lateness(const DcmObservation& observation) {
  if (time_ != Time::kNominal) return;
  const double change = static_cast<double>(observation.send_time - observation.scheduled_time) - usual_lateness_;
  if (observed_ < kLatenessMemory) {
    usual_lateness_ += change / ++observed_;
  } else {
    usual_lateness_ += std::clamp(change, -kLatenessChange, kLatenessChange) / kLatenessMemory;
  }
}

DcmAction WrittenClock::observe(const DcmObservation& observation) {
  Nanoseconds lag = 0;
  learn_lateness(observation);
  const auto usual = static_cast<Nanoseconds>(std::llround(usual_lateness_));
  if (observation.reference_time) lag = *observation.reference_time - wanted_at(observation.send_time - usual);
  monitor_.observe(observation, lag);
  monitor_.report(state_);
  state_.usual_lateness = usual;
  return {};
}

}  // namespace syncline::dc
