// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/write_forecast.h"

#include <algorithm>
#include <cmath>

#include "dc/dcm/dcm_controller.h"

namespace syncline::dc {
namespace {

constexpr double kWayMemory = 0.05, kWayChange = 1'000;  // ns

}  // namespace

void WriteForecast::start() {
  last_.reset();
  gate_.start();
}

Nanoseconds WriteForecast::usual_way() const { return static_cast<Nanoseconds>(std::llround(way_out_)); }

/// By how much the frame left later than its stamp, as usual, says. Seen in the reading where the stamp is all that is
/// known, else in the way out.
double WriteForecast::strayed(const DcmObservation& observation, double surprise) const {
  return surprise + (static_cast<double>(observation.way_out) - way_out_);
}

void WriteForecast::count_from(const DcmObservation& observation) {
  last_ = Reading{observation.send_time - observation.way_out + usual_way(), *observation.reference_time};
}

OutlierGate::Verdict WriteForecast::take(const DcmObservation& observation, double surprise, bool trusted) {
  const auto verdict = gate_.judge(strayed(observation, surprise), trusted);
  count_from(observation);
  const double way = static_cast<double>(observation.way_out) - way_out_;
  way_out_ += kWayMemory * std::clamp(way, -kWayChange, kWayChange);
  return verdict;
}

bool WriteForecast::take_again(const DcmObservation& observation, double surprise) {
  if (!observation.reference_time) return false;
  const double strayed_by = strayed(observation, surprise);
  count_from(observation);
  return gate_.is_far(strayed_by);
}

std::optional<Nanoseconds> WriteForecast::at(Nanoseconds stamp, double ppm) const {
  if (!last_) return std::nullopt;
  const auto passed = static_cast<double>(stamp + usual_way() - last_->host_time);
  return last_->reference_time + static_cast<Nanoseconds>(std::llround(passed * (1 + ppm * 1e-6)));
}

}  // namespace syncline::dc
