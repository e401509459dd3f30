// SPDX-License-Identifier: Apache-2.0
#include "trace/step_response.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace syncline {
namespace {

constexpr std::size_t kFewestOfStep = 20;
constexpr double kBandOfStep = 1.0 / 20, kBandOfNoise = 3;
constexpr double kQuartilesToDeviation = 1.349;  // of a normal distribution
constexpr std::size_t kAlone = 2;                // so many in a row unsettle it

double at_part(std::vector<double>& values, double part) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace

std::optional<StepResponse> step_response(std::span<const StepResponse::Sample> samples) {
  if (samples.size() < kFewestOfStep) return std::nullopt;
  const auto last = samples.last(std::max<std::size_t>(samples.size() / 10, kFewestOfStep / 2));
  std::vector<double> ended;
  for (const auto& sample : last) ended.push_back(sample.value);
  StepResponse response;
  response.final = at_part(ended, 0.5);
  response.noise = (at_part(ended, 0.75) - at_part(ended, 0.25)) / kQuartilesToDeviation;
  response.step = samples.front().value - response.final;
  const double size = std::abs(response.step);
  response.band = std::max(kBandOfStep * size, kBandOfNoise * response.noise);
  // A single one may be a late stamp.
  const double next = std::abs(samples[1].value - response.final);
  if (size == 0 || std::min(size, 2 * next) <= kClearly * response.noise || next < size / 4) return std::nullopt;
  const double side = response.step > 0 ? 1 : -1;
  double beyond = 0;
  std::size_t outside = 0;
  bool is_settled = false;
  for (const auto& sample : samples) {
    const double left = side * (sample.value - response.final);
    beyond = std::max(beyond, -left);
    if (!response.rise && left <= size / 10) response.rise = sample.time - samples.front().time;
    outside = std::abs(left) > response.band ? outside + 1 : 0;
    const bool counts = !is_settled ? outside > 0 : outside >= kAlone;
    if (counts) {
      is_settled = false;
    } else if (outside == 0) {
      if (!is_settled) response.settled = sample.time - samples.front().time;
      is_settled = true;
    }
  }
  if (!is_settled) response.settled.reset();
  response.overshoot = beyond > kBandOfNoise * response.noise ? beyond / size : 0;
  return response;
}

}  // namespace syncline
