// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/written_clock.h"

#include "config/dcm_settings.h"

namespace syncline::dc {

WrittenClock::WrittenClock(Time time, const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value,
                           Nanoseconds least)
    : time_(time), target_{0, set_value, cycle_time}, monitor_(settings, cycle_time, set_value, least) {}

void WrittenClock::start(Nanoseconds base, Nanoseconds first_reference_time, Nanoseconds first_send_time) {
  target_.base = base;
  monitor_.start(first_send_time);
  state_ = {};
  host_ = first_send_time;
  reference_ = target_.nearest(first_reference_time);
}

std::optional<Nanoseconds> WrittenClock::reference_write(Nanoseconds send_time, Nanoseconds scheduled_time) {
  return wanted_at(time_ == Time::kNominal ? scheduled_time : send_time);
}

DcmAction WrittenClock::observe(const DcmObservation& observation) {
  Nanoseconds lag = 0;
  if (observation.reference_time) lag = *observation.reference_time - wanted_at(observation.send_time);
  monitor_.observe(observation, lag);
  monitor_.report(state_);
  return {};
}

}  // namespace syncline::dc
